//! The rooms of the house are small, and imports point down: no circle of imports between the modules of a folder, no file above 300
//! lines before its tests, no folder above 15 entries, and a name has one meaning. Nothing is compiled: sources are read as text.

mod circles;
mod imports;
mod shadows;
mod sources;

use sources::Crate;
use std::fs;
use std::path::Path;
use walkdir::{DirEntry, WalkDir};

/// Most lines of a file before its tests.
const MOST_LINES: usize = 300;
/// Most files and folders in a folder.
const MOST_ENTRIES: usize = 15;
/// Most bindings that shadow the one of the statement just before.
const MOST_SHADOWS: usize = 20;

/// The folders with sources and tests.
const FOLDERS: [&str; 7] = [
    "src",
    "crates",
    "validation",
    "python",
    "tests",
    "benches",
    "examples",
];

/// Folders with more entries: the matrices and records of one data file, which a program writes side by side for studies that name
/// them without a folder.
const EXEMPT: [&str; 1] = ["tests/data/own_structure"];

/// The rooms of which a person holds one at a time, and their lines of code: without tests, comments and empty lines. What a feature adds
/// needs a limit that is raised with its reason; what goes lowers it.
const ROOMS: [(&str, &[&str], usize); 4] = [
    (
        "contact, system, motion",
        &["crates/contact", "crates/system", "crates/motion"],
        38_000,
    ),
    (
        "problem, cases, study",
        &["crates/problem", "crates/cases", "crates/study"],
        39_800,
    ),
    (
        "drawing, figures",
        &["crates/drawing", "crates/figures"],
        14_300,
    ),
    (
        "product",
        &[
            "",
            "crates/batch",
            "crates/pages",
            "crates/recommend",
            "crates/statistics",
            "validation",
            "python",
        ],
        24_050,
    ),
];

fn root() -> &'static Path {
    Path::new(env!("SLIPGAP_ROOT"))
}

/// Fails with a list of what offends.
fn assert_none(rule: &str, offences: &[String]) {
    let count = offences.len();
    assert!(
        count == 0,
        "{rule}, {count} times:\n{}\n",
        offences.join("\n")
    );
}

#[test]
fn no_modules_of_a_folder_import_one_another_in_a_circle() {
    let crates = Crate::all(root());
    assert!(!crates.is_empty());
    let offences: Vec<String> = crates.iter().flat_map(circles::of).collect();
    assert_none("imports in a circle", &offences);
}

#[test]
fn no_file_has_more_than_300_lines_before_its_tests() {
    let mut offences = Vec::new();
    for tree in Crate::all(root()) {
        for module in tree.modules.iter().filter(|module| !module.is_test) {
            let lines = sources::before_tests(&module.text).lines().count();
            if lines > MOST_LINES {
                offences.push(format!("{lines} {}", module.file.display()));
            }
        }
    }
    assert_none("more than 300 lines", &offences);
}

#[test]
fn a_room_has_no_more_lines_than_its_limit() {
    let crates = Crate::all(root());
    let mut offences = Vec::new();
    for (name, folders, limit) in ROOMS {
        let counted = crates
            .iter()
            .filter(|tree| folders.contains(&tree.name.as_str()));
        let modules = counted
            .flat_map(|tree| &tree.modules)
            .filter(|module| !module.is_test);
        let lines: usize = modules
            .map(|module| sources::lines_of_code(&module.text))
            .sum();
        // Far below it, the limit says nothing.
        if lines > limit || lines + 500 < limit {
            offences.push(format!("{name}: {lines} lines, limit {limit}"));
        }
    }
    assert_none("rooms beyond their limit, or far below it", &offences);
}

#[test]
fn no_folder_has_more_than_15_entries() {
    let mut offences = Vec::new();
    let folders = FOLDERS.iter().map(|name| root().join(name));
    for folder in folders.filter(|folder| folder.is_dir()) {
        let entries = WalkDir::new(folder)
            .into_iter()
            .filter_entry(is_source)
            .map(Result::unwrap);
        for folder in entries.filter(|entry| entry.file_type().is_dir()) {
            let inside = WalkDir::new(folder.path()).min_depth(1).max_depth(1);
            let count = inside.into_iter().filter_entry(is_source).count();
            let name = folder.path().strip_prefix(root()).unwrap();
            if count > MOST_ENTRIES && EXEMPT.iter().all(|exempt| Path::new(exempt) != name) {
                offences.push(format!("{count} {}", name.display()));
            }
        }
    }
    assert_none("more than 15 entries", &offences);
}

#[test]
fn few_bindings_shadow_the_one_just_before() {
    let text = "let a = f(\n    1,\n);\n// Twice.\nlet mut a: u32 = 2 * a;\nlet b = a;\ng();\nlet b = b;\n";
    assert_eq!(shadows::of(text), [5]);
    let mut offences = Vec::new();
    for folder in FOLDERS.iter().chain(&["build.rs"]) {
        let entries = WalkDir::new(root().join(folder)).sort_by_file_name();
        for entry in entries.into_iter().filter_entry(is_source) {
            let path = entry.as_ref().unwrap().path();
            if path.extension().is_some_and(|end| end == "rs") {
                let name = path.strip_prefix(root()).unwrap().display();
                let lines = shadows::of(&fs::read_to_string(path).unwrap());
                offences.extend(lines.iter().map(|line| format!("{name}:{line}")));
            }
        }
    }
    if offences.len() > MOST_SHADOWS {
        assert_none("a binding shadows the one just before", &offences);
    }
}

/// Whether an entry is a source, not something that was built.
fn is_source(entry: &DirEntry) -> bool {
    let name = entry.file_name().to_string_lossy();
    let built = ["target", "__pycache__"].contains(&&*name) || name.ends_with(".so");
    !built && !name.starts_with('.')
}
