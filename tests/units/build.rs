//! What the crates' own build scripts give them. No unit test compares these hashes.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-env=SLIPGAP_CODE=unit tests");
    println!("cargo::rustc-env=SLIPGAP_READER=unit tests");
}
