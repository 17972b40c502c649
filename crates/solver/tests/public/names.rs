//! The names that the crate shows are the reviewed ones: a new name is a promise, and one that goes breaks the programs of users. Each has
//! an example, which runs as a test of the documentation.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

fn source(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(file);
    fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

/// The name of an item after `pub`; `None` for the names of another file.
fn name(item: &str) -> Option<&str> {
    let (kind, rest) = item.split_once(' ')?;
    let name = match kind {
        "use" => rest.trim_end_matches(';').rsplit("::").next()?,
        _ => rest,
    };
    let end = name.find(|c: char| !c.is_alphanumeric() && c != '_');
    Some(&name[..end.unwrap_or(name.len())]).filter(|name| !name.is_empty())
}

/// The names of a file, each with its documentation.
fn names(text: &str) -> Vec<(String, String)> {
    let (mut names, mut above) = (Vec::new(), String::new());
    for line in text.lines() {
        if let Some(item) = line.strip_prefix("pub ") {
            names.extend(name(item).map(|name| (name.to_owned(), above.clone())));
        }
        match line.starts_with("///") || line.starts_with("#[") {
            true => above += line,
            false => above.clear(),
        }
    }
    names
}

/// The names of the module of laws, which documents them in one table.
fn laws() -> Vec<String> {
    let text = source("laws.rs");
    let after = text.split_once("contact::{").expect("a list").1;
    let list = after.split_once('}').expect("its end").0;
    let names = list.split(',').map(|name| name.trim().to_owned());
    names.filter(|name| !name.is_empty()).collect()
}

/// All names, with their documentation.
fn all() -> BTreeMap<String, String> {
    let files: Vec<String> = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("src"))
        .expect("files")
        .map(|file| file.expect("a file").file_name())
        .map(|file| file.into_string().expect("a name"))
        .filter(|file| file != "laws.rs")
        .collect();
    let mut sources: BTreeMap<_, _> = files.iter().flat_map(|file| names(&source(file))).collect();
    sources.insert("laws".to_owned(), source("laws.rs"));
    sources
}

#[test]
fn the_names_of_the_crate_are_the_reviewed_ones() {
    let mut public: Vec<String> = all().into_keys().collect();
    public.extend(laws().iter().map(|law| format!("laws::{law}")));
    public.sort();
    let reviewed: Vec<String> = include_str!("names.txt")
        .split_whitespace()
        .map(str::to_owned)
        .collect();
    assert_eq!(
        public,
        reviewed,
        "if each difference is right, names.txt becomes:\n{}",
        public.join("\n")
    );
}

#[test]
fn every_name_has_an_example() {
    let documented = all();
    assert!(documented.len() > 30);
    for (name, documentation) in documented {
        assert!(
            documentation.matches("```").count() >= 2,
            "{name} has no example"
        );
    }
}

#[test]
fn every_law_has_a_row_with_its_numbers_and_its_source() {
    let text = source("laws.rs");
    for law in laws() {
        let row = text
            .lines()
            .find(|line| line.starts_with(&format!("//! | [`{law}`] |")));
        let cells = row.map_or(0, |row| {
            row.split('|').filter(|cell| cell.len() > 2).count()
        });
        // The mark of a comment and four cells.
        assert_eq!(cells, 5, "{law}");
    }
}
