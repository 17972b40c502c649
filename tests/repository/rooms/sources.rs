//! The crates of the workspace as modules with their text.

use super::imports::test_modules;
use std::fs;
use std::path::{Path, PathBuf};
use walkdir::WalkDir;

/// A crate.
pub struct Crate {
    /// Its folder from the root.
    pub name: String,
    /// Its modules.
    pub modules: Vec<Module>,
}

/// A file of a crate.
pub struct Module {
    /// Its path in the crate; empty for the root.
    pub path: Vec<String>,
    /// The file from the root.
    pub file: PathBuf,
    /// What is in it.
    pub text: String,
    /// Whether only tests have it.
    pub is_test: bool,
}

impl Crate {
    /// All crates under the root.
    pub fn all(root: &Path) -> Vec<Crate> {
        let mut folders = vec![root.to_owned()];
        for parent in [root, &root.join("crates")] {
            let entries = fs::read_dir(parent).into_iter().flatten();
            folders.extend(entries.map(|entry| entry.unwrap().path()));
        }
        // The package of tests has no room of the house: it is beside the crates as their own tests are.
        folders
            .retain(|folder| folder.join("Cargo.toml").is_file() && *folder != root.join("tests"));
        folders.sort();
        let crates = folders.iter().map(|folder| Crate::read(root, folder));
        crates.collect()
    }

    fn read(root: &Path, folder: &Path) -> Crate {
        // The files of a small crate are next to its manifest.
        let source = Some(folder.join("src"))
            .filter(|source| source.is_dir())
            .unwrap_or_else(|| folder.to_owned());
        let mut modules: Vec<Module> = Vec::new();
        for entry in WalkDir::new(&source).sort_by_file_name() {
            let entry = entry.unwrap();
            let file = entry.path();
            if file.extension().is_none_or(|end| end != "rs") {
                continue;
            }
            let relative = file.strip_prefix(&source).unwrap().with_extension("");
            let parts = relative
                .iter()
                .map(|part| part.to_string_lossy().into_owned());
            let mut path: Vec<String> = parts.collect();
            if ["mod", "lib", "main"].contains(&path[path.len() - 1].as_str()) {
                path.pop();
            }
            modules.push(Module {
                path,
                file: file.strip_prefix(root).unwrap().to_owned(),
                text: fs::read_to_string(file).unwrap(),
                is_test: false,
            });
        }
        let tests: Vec<Vec<String>> = modules.iter().flat_map(test_modules).collect();
        for module in &mut modules {
            module.is_test = tests.iter().any(|test| module.path.starts_with(test));
        }
        Crate {
            name: folder.strip_prefix(root).unwrap().display().to_string(),
            modules,
        }
    }

    /// The longest part of a path that is a module.
    pub fn module_of<'a>(&self, path: &'a [String]) -> &'a [String] {
        let is_module = |n: &usize| self.modules.iter().any(|module| module.path == path[..*n]);
        let known = (1..=path.len()).rev().find(is_module);
        &path[..known.unwrap_or(0)]
    }
}

/// The text before the first module of tests.
pub fn before_tests(text: &str) -> &str {
    let starts = text.match_indices("#[cfg(test)]\nmod ");
    let inline = |(start, _): &(usize, &str)| {
        let line = text[*start..].lines().nth(1).unwrap_or_default();
        line.ends_with('{')
    };
    let first = { starts }.find(inline);
    first.map_or(text, |(start, _)| &text[..start])
}

/// Number of lines before the tests that are neither empty nor comments.
pub fn lines_of_code(text: &str) -> usize {
    let lines = before_tests(text).lines().map(str::trim);
    lines
        .filter(|line| !line.is_empty() && !line.starts_with("//"))
        .count()
}
