//! The version of the solver in the keys of stores changes with what decides results, and with nothing else.

#[path = "../build/solver.rs"]
mod solver;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The text of a file of the package.
fn text(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

fn locked(lock: &str) -> String {
    solver::locked(lock, &solver::CRATES).unwrap()
}

/// What cargo writes for a crate.
fn entry(name: &str, version: &str, dependencies: &[&str]) -> String {
    let list: String = dependencies
        .iter()
        .map(|d| format!(" \"{d}\",\n"))
        .collect();
    format!(
        "\n[[package]]\nname = \"{name}\"\nversion = \"{version}\"\nsource = \"registry+https://a.b/index\"\n\
         checksum = \"00ff\"\ndependencies = [\n{list}]\n"
    )
}

#[test]
fn crates_of_the_command_line_and_of_python_leave_the_version() {
    let lock = text("Cargo.lock");
    let own = concat!(
        "name = \"slipgap\"\nversion = \"",
        env!("CARGO_PKG_VERSION"),
        "\""
    );
    let list = format!("{own}\ndependencies = [\n");
    assert!(lock.contains(&list));
    let python = entry("pyo3", "0.29.0", &["libm"]);
    let more = lock.replace(&list, &format!("{list} \"pyo3\",\n")) + &python;
    assert_eq!(locked(&more), locked(&lock));
    let newer = lock.replace(own, "name = \"slipgap\"\nversion = \"99.0.0\"");
    assert_ne!(newer, lock);
    assert_eq!(locked(&newer), locked(&lock));
    // The same crates from a mirror.
    let mirror = lock.replace(
        "https://github.com/rust-lang/crates.io-index",
        "https://a.b/index",
    );
    assert_ne!(mirror, lock);
    assert_eq!(locked(&mirror), locked(&lock));
    // A checkout with carriage returns.
    assert_eq!(locked(&lock.replace('\n', "\r\n")), locked(&lock));
}

#[test]
fn another_version_of_a_crate_that_computes_changes_the_version() {
    let lock = text("Cargo.lock");
    // libm is used by the solver; simba only by nalgebra, which uses it.
    for name in ["libm", "simba"] {
        let start = format!("name = \"{name}\"\nversion = \"");
        let other = lock.replace(&start, &format!("{start}9"));
        assert_ne!(other, lock);
        assert_ne!(locked(&other), locked(&lock), "{name}");
    }
    let (before, after) = lock.split_once("name = \"libm\"").unwrap();
    let other = after.replacen("checksum = \"", "checksum = \"0", 1);
    assert_ne!(
        locked(&format!("{before}name = \"libm\"{other}")),
        locked(&lock)
    );
}

#[test]
fn of_several_versions_the_one_that_is_used_counts() {
    let lock = entry("a", "1.0.0", &["b 2.0.0", "c"])
        + &entry("b", "1.0.0", &["d"])
        + &entry("b", "2.0.0", &[])
        + &entry("c", "1.0.0", &["a"])
        + &entry("d", "1.0.0", &[]);
    let lines = solver::locked(&lock, &["a"]).unwrap();
    assert_eq!(lines, "a 1.0.0 00ff\nb 2.0.0 00ff\nc 1.0.0 00ff\n");
    assert_eq!(solver::locked(&lock, &["a", "x"]), Err("x".into()));
}

#[test]
fn a_change_of_a_source_changes_the_version_and_one_of_a_test_does_not() {
    // The test vectors of Fowler, Noll and Vo for 64 bits.
    assert_eq!(solver::sum([""]), 0xcbf2_9ce4_8422_2325);
    assert_eq!(solver::sum(["foo", "bar"]), 0x8594_4171_f739_67e8);
    let code = "pub fn f() -> f64 {\n    1.0\n}\n";
    let tests = "\n#[cfg(test)]\nmod tests {\n    use super::*;\n}\n";
    let text = format!("{code}{tests}");
    assert_eq!(solver::without_tests(&text), code);
    assert_eq!(solver::without_tests(&text.replace('\n', "\r\n")), code);
    let changed = text.replace("1.0", "1.5");
    assert_ne!(
        solver::sum([&*solver::without_tests(&changed)]),
        solver::sum([&*solver::without_tests(&text)])
    );
}

/// The crates of the solver are those that its sources name. sha2 only makes a key, and another one would be noticed.
#[test]
fn the_list_of_crates_has_every_crate_that_the_solver_names() {
    let lock = text("Cargo.lock");
    let (_, own) = lock.split_once("name = \"slipgap\"").unwrap();
    let (own, _) = own.split_once(']').unwrap();
    let dependencies = own.lines().filter(|line| line.starts_with(" \""));
    let dependencies = dependencies.map(|line| line.split('"').nth(1).unwrap());
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = solver::files(root).unwrap();
    let sources: Vec<String> = files
        .iter()
        .map(|file| solver::without_tests(&fs::read_to_string(file).unwrap()))
        .collect();
    // Every folder has sources, and tests are not among them.
    for source in solver::SOURCES {
        assert!(
            files.iter().any(|file| file.starts_with(root.join(source))),
            "{source}"
        );
    }
    assert!(!sources.iter().any(|text| text.contains("#[test]\n")));
    let named = dependencies.filter(|name| {
        let path = name.replace('-', "_");
        let names = |line: &str| {
            let starts = |(at, _): (usize, &str)| {
                !line[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':')
            };
            let mut whole = [format!("{path}::"), format!("use {path};")].into_iter();
            whole.any(|form| line.match_indices(&form).any(starts))
        };
        let code = |line: &&str| !line.trim_start().starts_with("//");
        sources
            .iter()
            .any(|text| text.lines().filter(code).any(names))
    });
    let named: BTreeSet<&str> = named.collect();
    let mut known = BTreeSet::from(solver::CRATES);
    known.insert("sha2");
    assert_eq!(named, known);
}
