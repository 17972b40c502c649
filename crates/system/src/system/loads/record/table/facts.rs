//! What the header of a table states: its time step, the number of its rows, and its unit.

use super::super::at2;
use super::super::fault::{LineFault, RecordCause, fault};
use super::super::fortran_number::{Stated, number};
use super::super::quantity::of_unit;
use crate::system::loads::Unit;

/// What a header states.
#[derive(Debug, Default)]
pub(super) struct Facts {
    pub step: Option<Stated>,
    pub count: Option<Stated>,
    pub unit: Option<Unit>,
}

/// Labels of a time step in s, longer ones first.
const STEPS: [&str; 9] = [
    "sampling interval s",
    "sampling interval",
    "sampling period",
    "sampling step",
    "time interval",
    "time step",
    "intervalo de muestreo",
    "delta t",
    "dt",
];

/// Labels of a number of samples per second.
const RATES: [&str; 10] = [
    "samples/sec",
    "samples/s",
    "samples per second",
    "samplerate",
    "sample rate",
    "sampling rate",
    "sampling frequency",
    "sampling freq",
    "vel. de muestreo",
    "frecuencia de muestreo",
];

/// Labels of a number of rows.
const COUNTS: [&str; 11] = [
    "ndata",
    "npts",
    "npoints",
    "no. of points",
    "no of points",
    "number of points",
    "no. of data",
    "number of data",
    "number of data points",
    "number of samples",
    "nsamples",
];

/// Labels of a unit.
const UNITS: [&str; 5] = [
    "units",
    "unit",
    "amplitudeunit",
    "unidades de los datos",
    "unidades",
];

impl Facts {
    /// Of the lines before the first row.
    ///
    /// # Errors
    /// The unit is that of a velocity or a displacement.
    pub(super) fn of(header: &[&str]) -> Result<Facts, LineFault> {
        let mut facts = Facts::default();
        if let Some((line, npts, dt)) = at2::stated(header) {
            facts.count = Some(Stated::new(npts, "NPTS", line));
            facts.step = Some(Stated::new(dt, "DT", line));
        }
        for (line, text) in header.iter().enumerate() {
            let plain = plain(text);
            let found = |labels: &[&str]| {
                let after = labels
                    .iter()
                    .find_map(|label| Some((*label, after(&plain, label)?)));
                let (label, rest) = after?;
                let (value, is_ms) = value(label, rest)?;
                Some((label.to_owned(), value, is_ms))
            };
            let of = |(by, value, _): (String, f64, bool)| Stated { value, by, line };
            if facts.count.is_none() {
                facts.count = found(&COUNTS)
                    .filter(|entry| entry.1.fract() == 0.0)
                    .map(of);
            }
            if facts.step.is_none() {
                let step = found(&STEPS).map(|(by, value, is_ms)| {
                    let value = if is_ms { value / 1000.0 } else { value };
                    of((by, value, is_ms))
                });
                // Below 1 the number may be the step itself.
                let rate = || {
                    let rate = found(&RATES).filter(|entry| entry.1 >= 1.0);
                    rate.map(|(by, value, is_ms)| of((by, 1.0 / value, is_ms)))
                };
                facts.step = step.or_else(rate).filter(|stated| stated.value > 0.0);
            }
            if facts.unit.is_none()
                && let Some(words) = UNITS.iter().find_map(|label| units(after(&plain, label)?))
            {
                facts.unit = words.iter().find_map(|word| Unit::spelled(word));
                // `Units: m, s` are those of something else.
                let is_own = |word: &&&str| words.len() == 1 || word.contains('/');
                let other = words.first().filter(is_own).and_then(|word| of_unit(word));
                if let (None, Some(other)) = (facts.unit, other) {
                    return Err(fault(line, RecordCause::Quantity(other)));
                }
            }
        }
        Ok(facts)
    }
}

/// The words behind a label of a unit: after a colon or the like.
fn units(rest: &str) -> Option<Vec<&str>> {
    let mut signs = [":", "=", " :", " =", " of ", " are ", " in "].into_iter();
    let rest = signs.find_map(|sign| rest.strip_prefix(sign))?;
    let words: Vec<&str> = rest
        .split([' ', ',', ';', '(', ')'])
        .filter(|word| !word.is_empty() && *word != "of")
        .collect();
    (!words.is_empty()).then_some(words)
}

/// A line in small letters with single blanks, also for underlines.
fn plain(line: &str) -> String {
    let line = line.to_lowercase().replace('_', " ");
    line.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What is behind a label, which is no part of a longer word.
fn after<'a>(line: &'a str, label: &str) -> Option<&'a str> {
    let (before, rest) = line.split_once(label)?;
    let is_whole =
        !before.ends_with(char::is_alphanumeric) && !rest.starts_with(char::is_alphabetic);
    is_whole.then_some(rest)
}

/// The number behind a label, and whether it is in ms: behind a colon or an equals sign, else the first word of all but the shortest
/// label.
fn value(label: &str, rest: &str) -> Option<(f64, bool)> {
    let (between, rest) = match rest.split_once([':', '=']) {
        Some(parts) => parts,
        None if label.len() > 4 => ("", rest),
        None => return None,
    };
    let mut words = rest
        .split([' ', '/', ',', ';'])
        .filter(|word| !word.is_empty());
    let word = words.next()?;
    let digits = word.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let value = number(digits).ok()?;
    let unit = [&word[digits.len()..], words.next().unwrap_or_default()];
    let is_ms = |text: &str| {
        let mut words = text.split(|c: char| !c.is_alphabetic());
        words.any(|word| matches!(word, "ms" | "msec" | "milliseconds"))
    };
    Some((value, is_ms(between) || unit.into_iter().any(is_ms)))
}
