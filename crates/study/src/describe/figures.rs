//! The keys of figures on the reference page. A key that several kinds have with the same meaning is described once.

use super::reference::code;
use crate::figure::keys::{COMMON, Key, Takes};
use crate::figure::kinds::{KINDS, Kind};

/// The keys of all figures, those of several kinds, and the kinds.
pub(super) fn reference() -> String {
    let shared = shared();
    let common: Vec<String> = COMMON.iter().map(described).collect();
    let several = shared.iter().map(|(key, kinds)| {
        let same_name = shared.iter().filter(|other| other.0.name == key.name);
        match same_name.count() > 1 {
            true => format!("- `{}` of {}: {}", key.name, code(kinds), key.meaning),
            false => described(key),
        }
    });
    let several: Vec<String> = several.collect();
    let kinds: Vec<String> = KINDS.iter().map(|kind| section(kind, &shared)).collect();
    format!(
        "{}\n\nKeys of several kinds. Those that a kind needs are bold:\n\n{}\n- `x_scale`, `y_scale`, `z_scale`, `colour_scale`: linear or log; \
         if left out linear, in `front` log\n\n{}",
        common.join("\n"),
        several.join("\n"),
        kinds.join("\n\n")
    )
}

/// Keys that several kinds have with the same meaning, each with these kinds.
fn shared() -> Vec<(&'static Key, Vec<&'static str>)> {
    let mut found: Vec<(&Key, Vec<&str>)> = Vec::new();
    for kind in KINDS.iter() {
        for key in kind.keys {
            match found.iter_mut().find(|(other, _)| same(other, key)) {
                Some((_, kinds)) => kinds.push(kind.name),
                None => found.push((key, vec![kind.name])),
            }
        }
    }
    found.retain(|(key, kinds)| kinds.len() > 1 && !is_scale(key));
    found
}

/// Whether a key is the scale of an axis; the page describes all of these in one line.
fn is_scale(key: &Key) -> bool {
    matches!(key.takes, Takes::Scale | Takes::ScaleOrLog)
}

fn same(a: &Key, b: &Key) -> bool {
    (a.name, a.meaning) == (b.name, b.meaning)
}

/// A key as an item of a list.
fn described(key: &Key) -> String {
    format!("- `{}`: {}", key.name, key.meaning)
}

fn section(kind: &Kind, shared: &[(&Key, Vec<&str>)]) -> String {
    let mut letters = kind.meaning.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    let mut text = format!(
        "### {}\n\n{}{}.",
        kind.name,
        first.unwrap_or_default(),
        letters.as_str()
    );
    let name = |key: &Key| match key.required {
        true => format!("**`{}`**", key.name),
        false => format!("`{}`", key.name),
    };
    let is_above = |key: &Key| is_scale(key) || shared.iter().any(|(other, _)| same(other, key));
    let above: Vec<String> = kind
        .keys
        .iter()
        .filter(|key| is_above(key))
        .map(name)
        .collect();
    if !above.is_empty() {
        text += &format!(" Keys above: {}.", above.join(", "));
    }
    let own = kind.keys.iter().filter(|key| !is_above(key));
    let own: Vec<String> = own
        .map(|key| format!("- {}: {}", name(key), key.meaning))
        .collect();
    if !own.is_empty() {
        text += &format!("\n\n{}", own.join("\n"));
    }
    text
}
