//! What a program of others writes: its first line, and its answers.

use super::json::{Raw, member, values};
use serde_json::value::RawValue;

/// What is said of a line that is no JSON.
const BROKEN: &str = "its answer is not JSON; NaN and Infinity are none, null is no value";

/// Whether a line that is no JSON begins as the answer to a case: other lines are what an engine prints.
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

/// An answer: the values of each channel at the instants, NaN for no value.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Answer {
    /// The channels with their names.
    pub channels: Vec<(String, Vec<f64>)>,
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
        let Ok(given) = serde_json::from_str::<Raw>(line) else {
            return is_broken_answer(line, case).then(|| Err(BROKEN.into()));
        };
        if member(&given, "case") != Some(case) {
            return None;
        }
        if let Some(error) = member(&given, "error") {
            return Some(Err(error));
        }
        let channels = given
            .get("channels")
            .map_or("{}", |channels| channels.get());
        Some(Answer::of(&given, channels))
    }

    fn of(given: &Raw, channels: &str) -> Result<Answer, String> {
        let channels: Raw = serde_json::from_str(channels)
            .map_err(|_| "its \"channels\" must be an object".to_owned())?;
        let channel = |(name, list): (String, &RawValue)| match values(list) {
            Some(values) if values.iter().all(|x| !x.is_infinite()) => Ok((name, values)),
            Some(_) => Err(BROKEN.into()),
            None => Err(format!(
                "channel {name} of its answer must be a list of numbers or null"
            )),
        };
        Ok(Answer {
            channels: channels
                .into_iter()
                .map(channel)
                .collect::<Result<_, _>>()?,
            cost: member(given, "cost"),
            notes: member(given, "notes").unwrap_or_default(),
        })
    }

    /// The values of a channel.
    ///
    /// # Errors
    /// It is missing, or has another number of values.
    pub(super) fn take(&mut self, name: &str, count: usize) -> Result<Vec<f64>, String> {
        let found = self.channels.iter_mut().find(|channel| channel.0 == name);
        let (_, values) = found.ok_or_else(|| format!("its answer has no channel {name}"))?;
        match values.len() {
            len if len == count => Ok(std::mem::take(values)),
            len => Err(format!(
                "channel {name} of its answer has {len} values; needed: {count}, at 0, dt, .. steps dt"
            )),
        }
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
