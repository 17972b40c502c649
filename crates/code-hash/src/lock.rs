//! The lines of a `Cargo.lock` for crates and all on which they depend.

use std::collections::BTreeSet;

/// One line for each of `crates` and all crates on which they depend, by the text of a `Cargo.lock`: name, version and
/// checksum. The registry is left out: the same crate may come from a mirror.
///
/// # Errors
/// The name of a crate that is not in the text.
pub(crate) fn locked(lock: &str, crates: &[&str]) -> Result<String, String> {
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
