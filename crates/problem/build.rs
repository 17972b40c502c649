//! A hash of the code that determines results, so that no store of another solver is used.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    slipgap_code_hash::print(
        "SLIPGAP_CODE",
        &["src"],
        &[
            "base64",
            "libm",
            "multiversion",
            "nalgebra",
            "serde",
            "serde_json",
        ],
    )
}
