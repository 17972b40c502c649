//! The names that the crate shows are the reviewed ones: a new name is a promise, and one that goes breaks the programs of users.

use std::collections::BTreeSet;

/// The names after `pub use`, `pub fn`, `pub mod`, `pub struct` and `pub const` of a file without indented items.
fn names(text: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (i, _) in text.match_indices("pub use ") {
        let list = &text[i..];
        let list = &list[..list.find(';').expect("an end")];
        let last = list.rsplit("::").next().expect("a name");
        let last = last.trim_matches(['{', '}', '\n', ' ']);
        names.extend(last.split(',').map(|name| name.trim().to_owned()));
    }
    for word in ["pub mod ", "pub const "] {
        for (i, _) in text.match_indices(word) {
            let rest = text[i + word.len()..].chars();
            names.insert(
                rest.take_while(|c| c.is_alphanumeric() || *c == '_')
                    .collect(),
            );
        }
    }
    names.remove("");
    names
}

#[test]
fn the_names_of_the_crate_are_the_reviewed_ones() {
    let own = names(include_str!("../src/lib.rs"));
    let reviewed = include_str!("names.txt").split_whitespace();
    let reviewed: BTreeSet<String> = reviewed.map(str::to_owned).collect();
    let new: Vec<_> = own.difference(&reviewed).collect();
    let gone: Vec<_> = reviewed.difference(&own).collect();
    assert!(
        new.is_empty() && gone.is_empty(),
        "new: {new:?}, gone: {gone:?}"
    );
}
