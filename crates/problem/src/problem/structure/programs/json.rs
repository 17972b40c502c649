//! JSON lines: numbers are written so that they read back the same, and long lists of them may be in base64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::value::RawValue;
use std::collections::BTreeMap;

/// The text of a number: the shortest one that reads back the same, `null` where it is not finite.
pub(super) fn number(text: &mut String, x: f64) {
    use std::fmt::Write;
    match x.is_finite() {
        // A string never refuses.
        true => drop(write!(text, "{x:?}")),
        false => text.push_str("null"),
    }
}

/// A string in quotation marks.
pub(super) fn string(text: &mut String, s: &str) {
    text.push_str(&serde_json::Value::from(s).to_string());
}

/// Numbers in a list; of more than [`LONG`] in base64 where that is wanted.
pub(super) fn numbers(text: &mut String, numbers: &[f64], base64: bool) {
    if base64 && numbers.len() > LONG {
        text.push_str("{\"float64\":\"");
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        STANDARD.encode_string(bytes, text);
        text.push_str("\"}");
        return;
    }
    list(text, numbers, |text, x| number(text, *x));
}

/// Most numbers of a list that is text in any case.
const LONG: usize = 1000;

/// A list.
pub(super) fn list<T>(text: &mut String, items: &[T], mut each: impl FnMut(&mut String, &T)) {
    text.push('[');
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            text.push(',');
        }
        each(text, item);
    }
    text.push(']');
}

/// An object under construction.
pub(super) struct Members<'a> {
    text: &'a mut String,
    first: bool,
}

/// An object with the members that `each` adds.
pub(super) fn object(text: &mut String, each: impl FnOnce(&mut Members)) {
    text.push('{');
    let mut members = Members { text, first: true };
    each(&mut members);
    text.push('}');
}

impl Members<'_> {
    /// Adds a member; `value` writes its value.
    pub(super) fn add(&mut self, key: &str, value: impl FnOnce(&mut String)) {
        if !std::mem::take(&mut self.first) {
            self.text.push(',');
        }
        string(self.text, key);
        self.text.push(':');
        value(self.text);
    }
}

/// The members of an object, not read yet. Of several with the same name the last one counts.
pub(super) type Raw<'a> = BTreeMap<String, &'a RawValue>;

/// A member of a type; `None` if it is missing or something else.
pub(super) fn member<'a, T: serde::Deserialize<'a>>(object: &Raw<'a>, key: &str) -> Option<T> {
    serde_json::from_str(object.get(key)?.get()).ok()
}

/// A list of numbers, as text with NaN for `null`, or in base64; `None` if it is something else.
pub(super) fn values(list: &RawValue) -> Option<Vec<f64>> {
    let text = list.get();
    // The text is valid JSON, so that a split at commas has whole items.
    if let Some(items) = text
        .strip_prefix('[')
        .and_then(|rest| rest.strip_suffix(']'))
    {
        let number = |item: &str| match item.trim() {
            "null" => Some(f64::NAN),
            item => item.parse().ok(),
        };
        let is_empty = items.trim().is_empty();
        return items.split(',').filter(|_| !is_empty).map(number).collect();
    }
    let object: Raw = serde_json::from_str(text).ok()?;
    let bytes = STANDARD.decode(member::<&str>(&object, "float64")?).ok()?;
    let (numbers, rest) = bytes.as_chunks::<8>();
    let numbers = numbers.iter().map(|bytes| f64::from_le_bytes(*bytes));
    rest.is_empty().then(|| numbers.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Option<Vec<f64>> {
        values(serde_json::from_str(text).ok()?)
    }

    #[test]
    fn numbers_read_back_the_same_as_text_and_in_base64() {
        let given: Vec<f64> = (0..2001).map(|i| f64::from(i).sqrt() - 7.0).collect();
        for base64 in [true, false] {
            let mut text = String::new();
            numbers(&mut text, &given, base64);
            assert_eq!(text.starts_with('{'), base64);
            assert_eq!(read(&text), Some(given.clone()));
        }
        // 1.0 and -2.0 by Python's struct and base64.
        let coded = r#"{"float64": "AAAAAAAA8D8AAAAAAAAAwA=="}"#;
        assert_eq!(read(coded), Some(vec![1.0, -2.0]));
        let given = read(" [0.1, -1e-300, null ,1E3]").unwrap();
        assert_eq!(given[..2], [0.1, -1e-300]);
        assert!(given[2].is_nan() && given[3] == 1000.0);
        assert_eq!(read("[ ]"), Some(Vec::new()));
    }

    #[test]
    fn what_is_no_list_of_numbers_is_seen() {
        for text in [
            "[NaN]",
            "[1,]",
            "[1",
            "[a]",
            "{",
            "[1 2]",
            "[[1, 2]]",
            "[\"1\"]",
            "[true]",
            "3",
            r#"{"float64": "Zg=="}"#,
            r#"{"float64": "Z"}"#,
        ] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
