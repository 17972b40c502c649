//! The files of a folder, or of a pattern with one `*`.

use std::cmp::Ordering;
use std::path::{Path, is_separator};

/// Most files of an axis.
const MOST: usize = 10_000;

/// Files of an axis: what `*` is in the name of each, and its path in the study.
pub(super) type Found = Vec<(String, String)>;

/// The files that a folder or a pattern names, or why there are none.
pub(super) fn matching(pattern: &str, folder: &Path) -> Result<Found, String> {
    let is_folder = folder.join(pattern).is_dir();
    let (parent, name) = match pattern.rsplit_once(is_separator) {
        _ if is_folder => (pattern.trim_end_matches(is_separator), "*"),
        Some((parent, name)) => (parent, name),
        None => ("", pattern),
    };
    let Some((before, after)) = name
        .split_once('*')
        .filter(|(_, after)| !after.contains('*'))
    else {
        return Err("must be a folder, or a pattern with one * in the name of the files".into());
    };
    if parent.contains('*') {
        return Err("must have its * in the name of the files, not in that of a folder".into());
    }
    let folder = match pattern.starts_with(is_separator) && parent.is_empty() {
        true => Path::new("/").to_owned(),
        // A study without a folder in its path is in this one.
        false if folder.as_os_str().is_empty() => Path::new(".").join(parent),
        false => folder.join(parent),
    };
    let entries = std::fs::read_dir(&folder)
        .map_err(|why| format!("cannot read the folder {}: {why}", folder.display()))?;
    let mut found = Vec::new();
    for entry in entries {
        let entry =
            entry.map_err(|why| format!("cannot read the folder {}: {why}", folder.display()))?;
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        // Pages beside the records of a folder.
        if name.starts_with('.') || is_folder && name.to_ascii_lowercase().ends_with(".md") {
            continue;
        }
        let star = name
            .strip_prefix(before)
            .and_then(|rest| rest.strip_suffix(after));
        if let Some(star) = star
            && entry.path().is_file()
        {
            let path = match pattern.contains(is_separator) || is_folder {
                true => format!("{parent}/{name}"),
                false => name.clone(),
            };
            found.push((star.to_owned(), path));
        }
    }
    found.sort_by(|a, b| natural(&a.1, &b.1));
    match found.len() {
        0 => Err(format!("no file in {} has such a name", folder.display())),
        1..=MOST => Ok(found),
        many => Err(format!("{many} files; allowed: at most {MOST}")),
    }
}

/// The natural order of names: whole numbers by their values, so that `r_2` is before `r_10`; equal ones by their text.
fn natural(a: &str, b: &str) -> Ordering {
    let (mut left, mut right) = (a, b);
    while let (Some(first), Some(second)) = (left.chars().next(), right.chars().next()) {
        let (of_left, of_right) = (digits(left), digits(right));
        let order = match of_left.is_empty() || of_right.is_empty() {
            true => first.cmp(&second),
            false => {
                let [x, y] = [of_left, of_right].map(|digits| digits.trim_start_matches('0'));
                x.len().cmp(&y.len()).then_with(|| x.cmp(y))
            }
        };
        if order.is_ne() {
            return order;
        }
        let taken = |digits: &str, first: char| digits.len().max(first.len_utf8());
        left = &left[taken(of_left, first)..];
        right = &right[taken(of_right, second)..];
    }
    left.len().cmp(&right.len()).then_with(|| a.cmp(b))
}

/// The digits with which a text begins.
fn digits(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_digit());
    &text[..end.unwrap_or(text.len())]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_names_are_in_their_order() {
        let names = [
            "a/r.csv",
            "a/r_1.csv",
            "a/r_01.csv",
            "a/r_2.csv",
            "a/r_2_3.csv",
            "a/r_2_12.csv",
            "a/r_10.csv",
            "a/r_18446744073709551616.csv",
            "a/r_a.csv",
            "b/r_1.csv",
            "\u{e9}2",
            "\u{e9}10",
        ];
        let mut sorted = names;
        sorted.reverse();
        sorted.sort_by(|a, b| natural(a, b));
        // Equal numbers are in the order of their texts.
        let expected = [
            "a/r.csv",
            "a/r_01.csv",
            "a/r_1.csv",
            "a/r_2.csv",
            "a/r_2_3.csv",
            "a/r_2_12.csv",
            "a/r_10.csv",
            "a/r_18446744073709551616.csv",
            "a/r_a.csv",
            "b/r_1.csv",
            "\u{e9}2",
            "\u{e9}10",
        ];
        assert_eq!(sorted, expected);
        for a in names {
            for b in names {
                assert_eq!(natural(a, b), natural(b, a).reverse());
            }
        }
    }
}
