//! JSON lines: numbers are written so that they read back the same, and long lists of them may be in base64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::de::{DeserializeSeed, Error, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::{Deserializer, Serialize};
use serde_json::value::RawValue;
use std::collections::BTreeMap;
use std::fmt::Formatter;

/// Writes a value: a number as the shortest text that reads back the same, `null` where it is not finite.
pub(super) fn value(text: &mut Vec<u8>, value: impl Serialize) {
    // Memory takes all bytes, and what a request has can be written.
    let _ = serde_json::to_writer(text, &value);
}

/// Numbers in a list; of more than [`LONG`] in base64 where that is wanted.
pub(super) fn numbers(text: &mut Vec<u8>, numbers: &[f64], base64: bool) {
    if base64 && numbers.len() > LONG {
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        return object(text, |members| {
            members.put("float64", STANDARD.encode(bytes))
        });
    }
    value(text, numbers);
}

/// Most numbers of a list that is text in any case.
const LONG: usize = 1000;

/// A list.
pub(super) fn list<T>(
    text: &mut Vec<u8>,
    items: impl IntoIterator<Item = T>,
    mut each: impl FnMut(&mut Vec<u8>, T),
) {
    text.push(b'[');
    for (i, item) in items.into_iter().enumerate() {
        if i > 0 {
            text.push(b',');
        }
        each(text, item);
    }
    text.push(b']');
}

/// An object under construction.
pub(super) struct Members<'a> {
    text: &'a mut Vec<u8>,
    first: bool,
}

/// An object with the members that `each` adds.
pub(super) fn object(text: &mut Vec<u8>, each: impl FnOnce(&mut Members)) {
    text.push(b'{');
    let mut members = Members { text, first: true };
    each(&mut members);
    text.push(b'}');
}

impl Members<'_> {
    /// Adds a member; `write` writes its value.
    pub(super) fn add(&mut self, key: &str, write: impl FnOnce(&mut Vec<u8>)) {
        if !std::mem::take(&mut self.first) {
            self.text.push(b',');
        }
        value(self.text, key);
        self.text.push(b':');
        write(self.text);
    }

    /// Adds an object with the members that `each` adds.
    pub(super) fn object(&mut self, key: &str, each: impl FnOnce(&mut Members)) {
        self.add(key, |text| object(text, each));
    }

    /// Adds a member with a value.
    pub(super) fn put(&mut self, key: &str, of_key: impl Serialize) {
        self.add(key, |text| value(text, of_key));
    }
}

/// The members of an object, not read yet. Of several with the same name the last one counts.
pub(super) type Raw<'a> = BTreeMap<String, &'a RawValue>;

/// A member of a type; `None` if it is missing or something else.
pub(super) fn member<'a, T: serde::Deserialize<'a>>(object: &Raw<'a>, key: &str) -> Option<T> {
    serde_json::from_str(object.get(key)?.get()).ok()
}

/// Reads the values of a channel with this name: a list of numbers with NaN for `null`, or `{"float64": "..."}`.
pub(super) struct OfChannel<'a>(pub &'a str);

impl<'de> DeserializeSeed<'de> for OfChannel<'_> {
    type Value = Vec<f64>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<f64>, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for OfChannel<'_> {
    type Value = Vec<f64>;

    fn expecting(&self, text: &mut Formatter) -> std::fmt::Result {
        write!(text, "a list of numbers or null for channel {}", self.0)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Vec<f64>, A::Error> {
        let mut values = Vec::new();
        // A number that serde_json reads may be one beside that of its text.
        while let Some(item) = items.next_element::<&RawValue>()? {
            values.push(match item.get() {
                "null" => f64::NAN,
                text => text
                    .parse()
                    .map_err(|_| A::Error::invalid_value(Unexpected::Other(text), &self))?,
            });
        }
        Ok(values)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut members: A) -> Result<Vec<f64>, A::Error> {
        let mut coded = "";
        while let Some((key, member)) = members.next_entry::<String, &RawValue>()? {
            if key == "float64" {
                coded = member.get();
            }
        }
        let bytes = coded
            .strip_prefix('"')
            .and_then(|rest| rest.strip_suffix('"'))
            .and_then(|inner| STANDARD.decode(inner).ok())
            .filter(|bytes| bytes.len().is_multiple_of(8))
            .ok_or_else(|| A::Error::invalid_type(Unexpected::Map, &self))?;
        let numbers = bytes.as_chunks().0.iter();
        Ok(numbers.map(|bytes| f64::from_le_bytes(*bytes)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Option<Vec<f64>> {
        let mut reader = serde_json::Deserializer::from_str(text);
        OfChannel("a").deserialize(&mut reader).ok()
    }

    #[test]
    fn numbers_read_back_the_same_as_text_and_in_base64() {
        let given: Vec<f64> = (0..2001).map(|i| f64::from(i).sqrt() - 7.0).collect();
        for base64 in [true, false] {
            let mut text = Vec::new();
            numbers(&mut text, &given, base64);
            assert_eq!(text[0] == b'{', base64);
            let text = str::from_utf8(&text).unwrap();
            assert_eq!(read(text), Some(given.clone()));
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
