//! The version of the solver in the keys of stores changes with what determines results, and with nothing else.

use super::{code, files, sum};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The crates that the solver computes with.
const CRATES: [&str; 8] = [
    "base64",
    "feral-amd",
    "libm",
    "multiversion",
    "nalgebra",
    "serde",
    "serde_json",
    "zmij",
];

/// The text of a file of the workspace.
fn text(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    fs::read_to_string(root.join(path)).unwrap()
}

fn locked(lock: &str) -> String {
    super::locked(lock, &CRATES).unwrap()
}

/// A text without spaces and the commas at the ends of lists.
fn tokens(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    text.replace(",)", ")").replace(",]", "]")
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
    let package = concat!(
        "name = \"slipgap\"\nversion = \"",
        env!("CARGO_PKG_VERSION"),
        "\""
    );
    let list = format!("{package}\ndependencies = [\n");
    assert!(lock.contains(&list));
    let python = entry("pyo3", "0.29.0", &["libm"]);
    let more = lock.replace(&list, &format!("{list} \"pyo3\",\n")) + &python;
    assert_eq!(locked(&more), locked(&lock));
    let newer = lock.replace(package, "name = \"slipgap\"\nversion = \"99.0.0\"");
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
    let lines = super::locked(&lock, &["a"]).unwrap();
    assert_eq!(lines, "a 1.0.0 00ff\nb 2.0.0 00ff\nc 1.0.0 00ff\n");
    assert_eq!(super::locked(&lock, &["a", "x"]), Err("x".to_owned()));
}

#[test]
fn code_changes_the_hash_and_comments_documentation_and_tests_do_not() {
    // The test vectors of Fowler, Noll and Vo for 64 bits.
    assert_eq!(sum([""]), 0xcbf2_9ce4_8422_2325);
    assert_eq!(sum(["foo", "bar"]), 0x8594_4171_f739_67e8);
    let plain = code("pub fn f() -> f64 { 1.0 }\nstruct S { x: f64 }").unwrap();
    let same = [
        "//! A page.\n\n/// Says what `f` is.\npub fn f() -> f64 {\n    1.0 // one\n}\nstruct S {\n    /// x\n    x: f64\n}\n",
        "pub fn f() -> f64 { 1.0 }\r\n/* old */ struct S { x: f64 }\r\n",
        "pub fn f() -> f64 { 1.0 } #[cfg(test)] mod tests { fn g() {} } struct S { x: f64 }",
        "#[cfg(test)] #[allow(unused)] use a::b; pub fn f() -> f64 { 1.0 } struct S { x: f64 }",
        "#[cfg(test)] mod tests; #[doc = \"f\"] pub fn f() -> f64 { 1.0 } struct S { x: f64 }",
        "pub fn f() -> f64 { 1.0 } struct S { #![doc = \"s\"] x: f64 }",
    ];
    for text in same {
        assert_eq!(code(text).unwrap(), plain, "{text}");
    }
    for (from, to) in [("1.0", "1.5"), ("pub fn", "fn"), ("x: f64", "x: f32")] {
        let text = "pub fn f() -> f64 { 1.0 }\nstruct S { x: f64 }".replace(from, to);
        assert_ne!(code(&text).unwrap(), plain, "{text}");
    }
    // An attribute that changes the code counts.
    let derived = code("#[derive(Clone)] struct S { x: f64 }").unwrap();
    assert!(derived.contains("Clone"), "{derived}");
    assert!(code("fn f( {").is_err());
}

/// The crates that determine a result, each with its folders.
const PARTS: [(&str, &[&str]); 5] = [
    ("notation", &[]),
    ("contact", &["contact"]),
    ("system", &["methods", "system"]),
    ("motion", &["exact", "solve", "textbook"]),
    ("problem", &["metrics", "problem"]),
];

#[test]
fn every_part_of_the_solver_has_a_hash_of_its_code_and_no_test_counts() {
    let mut crates = BTreeSet::new();
    for (part, folders) in PARTS {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(part);
        let files = files(&root.join("src")).unwrap();
        for folder in folders {
            let folder = root.join("src").join(folder);
            let has_code = files.iter().any(|file| file.starts_with(&folder));
            assert!(has_code, "{}", folder.display());
        }
        for file in files {
            let code = code(&fs::read_to_string(&file).unwrap()).unwrap();
            assert!(!code.contains("# [test]"), "{}", file.display());
        }
        // The crates of others below it compute for it, and its build script names them.
        let manifest = text(&format!("crates/{part}/Cargo.toml"));
        let (_, below) = manifest.split_once("[dependencies]\n").unwrap();
        let below: Vec<&str> = below
            .lines()
            .take_while(|line| !line.is_empty())
            .filter_map(|line| line.split('.').next())
            .filter(|name| !name.starts_with("slipgap-"))
            .collect();
        let script = text(&format!("crates/{part}/build.rs"));
        let named: Vec<String> = below.iter().map(|name| format!("\"{name}\"")).collect();
        let call = format!(
            "print(\"SLIPGAP_CODE\", &[\"src\"], &[{}])",
            named.join(", ")
        );
        assert!(tokens(&script).contains(&tokens(&call)), "{script}");
        crates.extend(below.into_iter().map(str::to_owned));
        // The keys of stores have it.
        let key = format!("slipgap_{part}::CODE_KEY");
        let keys = text("crates/solver/src/lib.rs") + &text("crates/batch/src/store/key.rs");
        assert!(keys.contains(&key), "{key}");
    }
    assert!(crates.iter().map(String::as_str).eq(CRATES));
}
