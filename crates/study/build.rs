//! A hash of the code that reads structures: the numbers that it makes are not in the keys of stores.

use std::env;
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let hash = slipgap_code_hash::hash(&root, &["src/structure", "src/value.rs"], &[])?;
    println!("cargo::rustc-env=SLIPGAP_READER={hash}");
    Ok(())
}
