//! The committed files of figures/, and the hashes of the others, compared with what a run writes now.

use crate::hashes::{self, hash, hashed_name};
use crate::pictures::{Picture, compare_pictures};
use std::fs;
use std::path::Path;

#[test]
#[ignore = "reads the results of every study; run by `make fresh`"]
fn committed_results_are_what_a_run_writes_now() {
    let (figures, now) = (crate::root().join("figures"), crate::results());
    let (committed, mut hashes) = (crate::committed(), hashes::read());
    let outputs = crate::outputs(&now);
    let mut differences: Vec<String> = Vec::new();
    for name in committed.difference(&outputs) {
        differences.push(format!("{name}: committed, but no study writes it"));
    }
    for name in &outputs {
        if committed.contains(name) {
            let (old, new) = (figures.join(name), now.join(name));
            let difference = match name.ends_with(".png") {
                true => compare_pictures(&Picture::read(&old), &Picture::read(&new)),
                false => compare_text(&old, &new),
            };
            differences.extend(difference.map(|what| format!("{name}: {what}")));
            continue;
        }
        let hashed = hashed_name(name);
        match hashes.remove(&hashed) {
            None => differences.push(format!(
                "{hashed}: written now, but not in {}, and {name} is not committed",
                hashes::FILE
            )),
            Some(old) if old == hash(&now.join(&hashed)) => {}
            Some(_) => differences.push(format!(
                "{hashed}: other bytes than those of {}",
                hashes::FILE
            )),
        }
    }
    for name in hashes.keys() {
        differences.push(format!(
            "{name}: in {}, but committed, or no study writes it",
            hashes::FILE
        ));
    }
    assert!(
        differences.is_empty(),
        "figures/ is not what `make evidence` writes now:\n  {}",
        differences.join("\n  ")
    );
}

/// Where two files differ first: they must be the same, byte for byte.
fn compare_text(old: &Path, new: &Path) -> Option<String> {
    let (old, new) = (fs::read(old).unwrap(), fs::read(new).unwrap());
    if old == new {
        return None;
    }
    let (old, new) = (String::from_utf8_lossy(&old), String::from_utf8_lossy(&new));
    let same = old
        .split('\n')
        .zip(new.split('\n'))
        .take_while(|(a, b)| a == b)
        .count();
    let line = |text: &str| text.split('\n').nth(same).unwrap_or("(ends)").to_owned();
    Some(format!(
        "line {}:\n    committed {}\n    now       {}",
        same + 1,
        line(&old),
        line(&new)
    ))
}
