//! The keys of figures on the reference page. A key that several kinds have with the same meaning is described once.

use super::reference::code;
use crate::figure::keys::{COMMON, Key, Takes};
use crate::figure::kinds::{KINDS, Kind};

/// The keys of all figures, those of several kinds, and the kinds.
pub(super) fn reference() -> String {
    let shared = shared();
    let common: Vec<String> = COMMON.iter().map(described).collect();
    let several = shared.iter().map(|(key, kinds)| {
        let of = of_kinds(kinds);
        format!("- `{}` of {of}: {}", key.name, key.meaning)
    });
    let several: Vec<String> = several.collect();
    let kinds: Vec<String> = KINDS.iter().map(|kind| section(kind, &shared)).collect();
    let with_scales = KINDS.iter().filter(|kind| kind.keys.iter().any(is_scale));
    let scales = of_kinds(&with_scales.map(|kind| kind.name).collect::<Vec<_>>());
    format!(
        "{}\n\nKeys of several kinds:\n\n{}\n- `x_scale`, `y_scale`, `z_scale`, `colour_scale` of {scales}: linear or log; \
         default linear, in `front` log\n\nThe kinds, with their own keys; bold ones are required:\n\n{}",
        common.join("\n"),
        several.join("\n"),
        kinds.join("\n")
    )
}

/// The kinds that have a key; of a key of most kinds the schema has the list.
fn of_kinds(kinds: &[&str]) -> String {
    match kinds.len() * 2 > KINDS.len() {
        true => "most kinds".into(),
        false => code(kinds),
    }
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
    matches!(key.kind, Takes::Scale | Takes::ScaleOrLog)
}

fn same(a: &Key, b: &Key) -> bool {
    (a.name, a.meaning) == (b.name, b.meaning)
}

/// A key as an item of a list.
fn described(key: &Key) -> String {
    format!("- `{}`: {}", key.name, key.meaning)
}

/// The meaning of a key without the axis, which its name tells.
fn without_axis(meaning: &str) -> String {
    let meaning = meaning.replace(" along the horizontal axis", "");
    meaning.replace(" along the vertical axis", "")
}

/// A kind as an item of a list: what it shows, and its own keys.
fn section(kind: &Kind, shared: &[(&Key, Vec<&str>)]) -> String {
    let name = |key: &Key| match key.needed {
        true => format!("**`{}`**", key.name),
        false => format!("`{}`", key.name),
    };
    let is_above = |key: &Key| is_scale(key) || shared.iter().any(|(other, _)| same(other, key));
    let shown = kind.keys.iter().filter(|key| key.needed || !is_above(key));
    let described = shown.map(|key| match is_above(key) {
        true => name(key),
        false => format!("{} ({})", name(key), without_axis(key.meaning)),
    });
    let keys: Vec<String> = described.collect();
    match keys.is_empty() {
        true => format!("- `{}`: {}", kind.name, kind.meaning),
        false => format!(
            "- `{}`: {}. Keys: {}",
            kind.name,
            kind.meaning,
            keys.join(", ")
        ),
    }
}
