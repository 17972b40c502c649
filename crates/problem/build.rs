//! A hash of the code that determines results, so that no store of another solver is used.

use std::env;
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let hash = slipgap_code_hash::hash(
        &root,
        &["src"],
        &["libm", "multiversion", "nalgebra", "zmij"],
    )?;
    println!("cargo::rustc-env=SLIPGAP_CODE={hash}");
    Ok(())
}
