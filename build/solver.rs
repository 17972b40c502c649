//! What decides results: the solver's own sources, and the crates that it computes with.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The solver's sources. Command line, figures and claims decide no result. The values of parameters are in the keys of the
/// store; those of a structure are not, so that its expressions belong to the solver.
pub const SOURCES: [&str; 13] = [
    "src/contact",
    "src/exact",
    "src/history.rs",
    "src/lane.rs",
    "src/methods",
    "src/metrics",
    "src/problem",
    "src/solve",
    "src/study/expression",
    "src/study/structure",
    "src/study/value.rs",
    "src/system",
    "src/textbook",
];

/// The crates that the solver's sources compute with. Crates on which these depend count, too.
pub const CRATES: [&str; 3] = ["libm", "multiversion", "nalgebra"];

/// The solver's files, in order, without those of tests.
///
/// # Errors
/// A folder that cannot be read.
pub fn files(root: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for source in SOURCES {
        gather(&root.join(source), &mut files)?;
    }
    files.sort();
    Ok(files)
}

fn gather(path: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let is_test =
        |stem: &str| stem == "tests" || stem.ends_with("_tests") || stem.starts_with("tests_");
    if stem.is_some_and(is_test) {
        return Ok(());
    }
    if !path.is_dir() {
        files.push(path.to_owned());
        return Ok(());
    }
    for entry in fs::read_dir(path)? {
        gather(&entry?.path(), files)?;
    }
    Ok(())
}

/// A source without its tests, which are at its end, and without carriage returns, which depend on the checkout.
pub fn without_tests(text: &str) -> String {
    let text = text.replace('\r', "");
    match text.split_once("\n#[cfg(test)]\nmod tests {") {
        Some((code, _)) => code.to_owned(),
        None => text,
    }
}

/// One line for each of `crates` and all crates on which they depend, by the text of a `Cargo.lock`: name, version and
/// checksum. The registry is left out: the same crate may come from a mirror.
///
/// # Errors
/// The name of a crate that is not in the text.
pub fn locked(lock: &str, crates: &[&str]) -> Result<String, String> {
    let packages: Vec<Package> = lock.split("[[package]]").skip(1).map(package).collect();
    let mut wanted: Vec<&str> = crates.to_vec();
    let (mut seen, mut lines) = (BTreeSet::new(), BTreeSet::new());
    while let Some(dependency) = wanted.pop() {
        if !seen.insert(dependency) {
            continue;
        }
        // `name`, or `name version` if the text has several versions, or `name version (source)`.
        let mut words = dependency.split(' ');
        let (name, version) = (words.next().unwrap_or_default(), words.next());
        let is =
            |p: &&Package| p.name == name && version.is_none_or(|version| p.version == version);
        let found: Vec<&Package> = packages.iter().filter(is).collect();
        if found.is_empty() {
            return Err(dependency.to_owned());
        }
        for package in found {
            lines.insert(format!(
                "{} {} {}\n",
                package.name, package.version, package.checksum
            ));
            wanted.extend(&package.dependencies);
        }
    }
    Ok(lines.into_iter().collect())
}

#[derive(Default)]
struct Package<'a> {
    name: &'a str,
    version: &'a str,
    checksum: &'a str,
    dependencies: Vec<&'a str>,
}

/// The lines after `[[package]]`, as cargo writes them: `key = "value"`, and the dependencies one in a line.
fn package(text: &str) -> Package<'_> {
    let mut package = Package::default();
    for line in text.lines() {
        let value = line.split('"').nth(1).unwrap_or_default();
        match line.split('"').next().unwrap_or_default() {
            "name = " => package.name = value,
            "version = " => package.version = value,
            "checksum = " => package.checksum = value,
            " " => package.dependencies.push(value),
            _ => {}
        }
    }
    package
}

/// FNV-1a: it needs no dependency, and is the same everywhere.
pub fn sum<'a>(texts: impl IntoIterator<Item = &'a str>) -> u64 {
    let bytes = texts.into_iter().flat_map(str::bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
