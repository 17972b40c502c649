//! What a program of others writes: its first line, and its answers.

use super::json::{OfChannel, Raw, member};
use serde::Deserializer;
use serde::de::{DeserializeSeed, MapAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt::Formatter;

/// What is said of a line that is no JSON.
const BROKEN: &str = "its answer is not JSON; NaN and Infinity are none, null is no value";

/// Whether a line that cannot be read begins as the answer to a case: other lines are what an engine prints.
fn is_broken_answer(line: &str, case: u64) -> bool {
    let start = line.trim_start();
    let number = |rest: &str| {
        let digits = rest.trim_start().strip_prefix(':')?.trim_start();
        let end = digits
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(digits.len());
        digits[..end].parse::<u64>().ok()
    };
    let mut members = start.match_indices("\"case\"");
    start.starts_with('{')
        && members.any(|(at, key)| number(&start[at + key.len()..]) == Some(case))
}

/// The version of the format.
pub(super) const FORMAT: u64 = 1;

/// The first line of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hello {
    /// The name and version of the program: results of another one do not count.
    pub version: String,
    /// The laws of contacts that it has.
    pub laws: Vec<String>,
    /// Whether it reads and writes long lists in base64.
    pub base64: bool,
}

impl Hello {
    /// The first line; `None` for a line that is something else, such as a banner.
    ///
    /// # Errors
    /// Why it cannot be used.
    pub fn parse(line: &str) -> Option<Result<Hello, String>> {
        let first: Raw = serde_json::from_str(line).ok()?;
        let format: f64 = member(&first, "format")?;
        if format != FORMAT as f64 {
            return Some(Err(format!(
                "its first line has format {format}; allowed: {FORMAT}"
            )));
        }
        let [program, version] = ["program", "version"].map(|key| member::<String>(&first, key));
        let (Some(program), Some(version)) = (program, version) else {
            return Some(Err(
                "its first line needs \"program\" and \"version\"".into()
            ));
        };
        Some(Ok(Hello {
            version: format!("{program} {version}"),
            laws: member(&first, "laws").unwrap_or_default(),
            base64: member(&first, "arrays") == Some("base64"),
        }))
    }
}

/// The values of channels by their names.
type Channels = BTreeMap<String, Vec<f64>>;

/// An answer: the values of each channel at the instants, NaN for no value.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Answer {
    /// The channels with their names.
    pub channels: Channels,
    /// The program's own count of its work.
    pub cost: Option<f64>,
    /// What the program says about the case.
    pub notes: Vec<String>,
}

impl Answer {
    /// The answer to the request of a case; `None` for a line that is something else.
    ///
    /// # Errors
    /// The fault of the case.
    pub fn parse(line: &str, case: u64) -> Option<Result<Answer, String>> {
        let mut reader = serde_json::Deserializer::from_str(line);
        let read = reader.deserialize_map(Line);
        let (channels, others) = match read.and_then(|read| reader.end().map(|()| read)) {
            Ok(read) => read,
            Err(why) => {
                let fault = match why.is_data() {
                    true => format!("its answer: {why}"),
                    false => BROKEN.into(),
                };
                return is_broken_answer(line, case).then_some(Err(fault));
            }
        };
        if member(&others, "case") != Some(case) {
            return None;
        }
        if let Some(error) = member(&others, "error") {
            return Some(Err(error));
        }
        let mut values = channels.values().flatten();
        if values.any(|x| x.is_infinite()) {
            return Some(Err(BROKEN.into()));
        }
        Some(Ok(Answer {
            cost: member(&others, "cost"),
            notes: member(&others, "notes").unwrap_or_default(),
            channels,
        }))
    }

    /// The values of a channel.
    ///
    /// # Errors
    /// It is missing, or has another number of values.
    pub(super) fn take(&mut self, name: &str, count: usize) -> Result<Vec<f64>, String> {
        let found = self.channels.get_mut(name);
        let values = found.ok_or_else(|| format!("its answer has no channel {name}"))?;
        match values.len() {
            len if len == count => Ok(std::mem::take(values)),
            len => Err(format!(
                "channel {name} of its answer has {len} values; needed: {count}, at 0, dt, .. steps dt"
            )),
        }
    }
}

/// Reads a line: the channels with their values, and its other members.
struct Line;

impl<'de> Visitor<'de> for Line {
    type Value = (Channels, Raw<'de>);

    fn expecting(&self, text: &mut Formatter) -> std::fmt::Result {
        text.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut members: A) -> Result<Self::Value, A::Error> {
        let (mut channels, mut others) = (Channels::new(), Raw::new());
        while let Some(key) = members.next_key::<String>()? {
            match key == "channels" {
                true => channels = members.next_value_seed(OfChannels)?,
                false => drop(others.insert(key, members.next_value()?)),
            }
        }
        Ok((channels, others))
    }
}

/// Reads the channels of an answer.
struct OfChannels;

impl<'de> DeserializeSeed<'de> for OfChannels {
    type Value = Channels;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Channels, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for OfChannels {
    type Value = Channels;

    fn expecting(&self, text: &mut Formatter) -> std::fmt::Result {
        text.write_str("an object of channels")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut members: A) -> Result<Channels, A::Error> {
        let mut channels = Channels::new();
        while let Some(name) = members.next_key::<String>()? {
            let values = members.next_value_seed(OfChannel(&name))?;
            channels.insert(name, values);
        }
        Ok(channels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_are_no_answers_are_left() {
        for line in [
            "",
            "step 3",
            "{\"case\": 4, \"channels\": {}}",
            "{\"channels\": {\"a\": 3}, \"case\": 4}",
            "{\"a\": 1}",
            "[3]",
            "null",
        ] {
            assert_eq!(Answer::parse(line, 3), None, "{line}");
        }
        for line in ["banner", "{}", "{\"program\": \"a\"}"] {
            assert_eq!(Hello::parse(line), None, "{line}");
        }
    }

    #[test]
    fn an_answer_has_channels_or_says_what_is_wrong() {
        let line = r#"{"channels": {"a": [1, null]}, "case": 3, "cost": 7, "notes": ["x"], "more": [{"b": true}]}"#;
        let mut answer = Answer::parse(line, 3).unwrap().unwrap();
        assert_eq!(
            (answer.cost, &answer.notes[..]),
            (Some(7.0), &["x".to_owned()][..])
        );
        let values = answer.take("a", 2).unwrap();
        assert!(values[0] == 1.0 && values[1].is_nan());
        assert!(answer.take("b", 2).unwrap_err().contains("no channel b"));
        assert!(
            answer
                .take("a", 2)
                .unwrap_err()
                .contains("0 values; needed: 2")
        );
        for (line, part) in [
            (
                r#"{"case": 3, "error": "did not converge"}"#,
                "did not converge",
            ),
            (r#"{"case": 3, "channels": {"a": [NaN]}}"#, "NaN"),
            (
                r#"{"channels": {"a": [1, Infinity]}, "case": 3}"#,
                "Infinity",
            ),
            (r#"{"case": 3, "channels": {"a": [1,,2]}}"#, "not JSON"),
            (r#"{"case": 3, "channels": {"a": [1e999]}}"#, "Infinity"),
            (
                r#"{"channels": {"a": [1, "2"]}, "case": 3}"#,
                "expected a list of numbers or null for channel a",
            ),
            (
                r#"{"channels": {"a": 3}, "case": 3}"#,
                "expected a list of numbers or null for channel a",
            ),
            (
                r#"{"channels": 3, "case": 3}"#,
                "expected an object of channels at line 1 column 14",
            ),
        ] {
            let why = Answer::parse(line, 3).unwrap().unwrap_err();
            assert!(why.contains(part), "{why}");
        }
    }

    #[test]
    fn the_first_line_has_a_version() {
        let line = r#"{ "format": 1, "program": "p", "version": "3.8", "laws": ["impact"], "arrays": "base64" }"#;
        let hello = Hello::parse(line).unwrap().unwrap();
        assert_eq!((&*hello.version, hello.base64), ("p 3.8", true));
        assert_eq!(hello.laws, ["impact"]);
        for (line, part) in [
            (r#"{"format": 2}"#, "format 2; allowed: 1"),
            (r#"{"format": 1, "program": "p"}"#, "\"version\""),
        ] {
            assert!(Hello::parse(line).unwrap().unwrap_err().contains(part));
        }
    }
}
