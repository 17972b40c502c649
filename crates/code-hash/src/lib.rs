//! A hash of the code of a crate, for its build script: results in a store stay valid while the code that computed them is the
//! same. Comments, documentation, tests and formatting do not count.

mod code;
mod lock;

use code::code;
use lock::locked;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Prints for cargo the hash of the code in `folders` of the crate whose build script calls it, and of `crates` in the `Cargo.lock`, as
/// 16 hexadecimal digits: the value of the environment variable `name` while the crate is compiled. Prints also what the hash
/// depends on.
///
/// # Errors
/// A file that cannot be read or is not Rust; a crate that the `Cargo.lock` does not have.
pub fn print(name: &str, folders: &[&str], crates: &[&str]) -> Result<(), Box<dyn Error>> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let mut texts = Vec::new();
    for folder in folders {
        println!("cargo::rerun-if-changed={folder}");
        for file in files(&root.join(folder))? {
            let tokens = code(&fs::read_to_string(&file)?);
            texts.push(tokens.map_err(|why| format!("{}: {why}", file.display()))?);
        }
    }
    let lock = lock_file(&root).ok_or("no Cargo.lock in the folder of the crate or above it")?;
    println!("cargo::rerun-if-changed={}", lock.display());
    let lines = locked(&fs::read_to_string(&lock)?, crates);
    texts.push(lines.map_err(|missing| format!("{missing} is not in {}", lock.display()))?);
    let hash = sum(texts.iter().map(String::as_str));
    println!("cargo::rustc-env={name}={hash:016x}");
    Ok(())
}

/// The `Cargo.lock` of the crate or of its workspace. The package that cargo makes contains one.
fn lock_file(root: &Path) -> Option<PathBuf> {
    let mut locks = root.ancestors().map(|folder| folder.join("Cargo.lock"));
    locks.find(|lock| lock.is_file())
}

/// The files in a folder, in order, without those of tests.
///
/// # Errors
/// A folder that cannot be read.
fn files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    gather(folder, &mut files)?;
    files.sort();
    Ok(files)
}

fn gather(path: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let is_test =
        |stem: &str| stem == "tests" || stem.ends_with("_tests") || stem.starts_with("tests_");
    if stem.is_some_and(is_test) {
        return Ok(());
    }
    if !path.is_dir() {
        if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path.to_owned());
        }
        return Ok(());
    }
    for entry in fs::read_dir(path)? {
        gather(&entry?.path(), files)?;
    }
    Ok(())
}

/// FNV-1a: it needs no dependency, and is the same everywhere.
fn sum<'a>(texts: impl IntoIterator<Item = &'a str>) -> u64 {
    let bytes = texts.into_iter().flat_map(str::bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests;
