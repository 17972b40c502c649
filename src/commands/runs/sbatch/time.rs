//! Time limits as Slurm reads them.

use crate::commands::arguments::Expected;
use std::fmt;
use std::str::FromStr;

/// A time limit, as it was given.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TimeLimit {
    text: String,
    seconds: u64,
}

impl TimeLimit {
    /// The limit in seconds.
    pub fn seconds(&self) -> u64 {
        self.seconds
    }
}

impl FromStr for TimeLimit {
    type Err = Expected;

    /// Reads minutes, minutes:seconds, hours:minutes:seconds, days-hours, days-hours:minutes or days-hours:minutes:seconds.
    fn from_str(text: &str) -> Result<TimeLimit, Expected> {
        let seconds = seconds(text)
            .filter(|seconds| *seconds > 0)
            .ok_or(Expected(
                "a time > 0 as Slurm reads it: HH:MM:SS, D-HH:MM:SS, D-HH:MM, D-HH, MM:SS or MM"
                    .into(),
            ))?;
        let text = text.to_owned();
        Ok(TimeLimit { text, seconds })
    }
}

fn seconds(text: &str) -> Option<u64> {
    let number = |text: &str| -> Option<u64> {
        let digits = (1..=9).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit());
        text.parse().ok().filter(|_| digits)
    };
    let numbers = |text: &str| -> Option<Vec<u64>> { text.split(':').map(number).collect() };
    let [d, h, m, s] = match text.split_once('-') {
        Some((days, rest)) => match (number(days)?, &numbers(rest)?[..]) {
            (d, [h]) => [d, *h, 0, 0],
            (d, [h, m]) => [d, *h, *m, 0],
            (d, [h, m, s]) => [d, *h, *m, *s],
            _ => return None,
        },
        None => match numbers(text)?[..] {
            [m] => [0, 0, m, 0],
            [m, s] => [0, 0, m, s],
            [h, m, s] => [0, h, m, s],
            _ => return None,
        },
    };
    Some(((d * 24 + h) * 60 + m) * 60 + s)
}

impl fmt::Display for TimeLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_as_in_the_manual_of_sbatch() {
        let read = |text: &str| text.parse::<TimeLimit>().map(|time| time.seconds());
        assert_eq!(read("90"), Ok(5400));
        assert_eq!(read("1:30"), Ok(90));
        assert_eq!(read("01:00:00"), Ok(3600));
        assert_eq!(read("2-12"), Ok(216_000));
        assert_eq!(read("1-0:30"), Ok(88_200));
        assert_eq!(read("1-00:00:01"), Ok(86_401));
        for wrong in [
            "",
            "0",
            "0:0:0",
            "1h",
            "1:2:3:4",
            "-1",
            "1-",
            "1:",
            "1-2:3:4:5",
            "+5",
            "99999999999",
        ] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
        assert_eq!(
            "01:00:00".parse::<TimeLimit>().unwrap().to_string(),
            "01:00:00"
        );
    }
}
