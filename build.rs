//! Sums up what decides results, so that a store that another solver made is not taken for one of this solver.

#[path = "build/solver.rs"]
mod solver;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    for source in solver::SOURCES {
        println!("cargo::rerun-if-changed={source}");
    }
    let mut texts = Vec::new();
    for file in solver::files(&root)? {
        texts.push(solver::without_tests(&fs::read_to_string(&file)?));
    }
    let lock = lock(&root).ok_or("no Cargo.lock in the folder of the package or above it")?;
    println!("cargo::rerun-if-changed={}", lock.display());
    let crates = solver::locked(&fs::read_to_string(&lock)?, &solver::CRATES);
    texts.push(crates.map_err(|name| format!("{name} is not in {}", lock.display()))?);
    let sum = solver::sum(texts.iter().map(String::as_str));
    println!("cargo::rustc-env=SLIPGAP_SOLVER={sum:016x}");
    Ok(())
}

/// The `Cargo.lock` of the package or of its workspace. The package that cargo makes contains one.
fn lock(root: &Path) -> Option<PathBuf> {
    let mut locks = root.ancestors().map(|folder| folder.join("Cargo.lock"));
    locks.find(|lock| lock.is_file())
}
