//! The `slipgap` command line.
fn main() {}
