//! A hash of the code that reads structures: the numbers that it makes are not in the keys of stores.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    slipgap_code_hash::print("SLIPGAP_READER", &["src/structure", "src/value.rs"], &[])
}
