//! SMC of the U.S. Geological Survey: 11 lines of text, 48 whole numbers in 6 lines, 50 numbers in 10 lines, comments that begin
//! with `|`, then the accelerations in fields of ten characters.

use super::fault::{RecordCause, fault};
use super::fortran_number::{Stated, all, table};
use super::heading::{self, Heading, spaced};
use super::{Format, Parts, Record, Series, end};
use crate::system::loads::Unit;

/// The format.
pub(super) const FORMAT: Format = Format {
    name: "SMC",
    find: |lines| match quantity(lines) {
        Some(_) if has_mark(lines) => Ok(()),
        Some(_) => Err("no line of the first 11 is \"*\" or begins with \"station =\""),
        None => {
            Err("line 1 does not begin with a digit and \"CORRECTED ACCELEROGRAM\" or the like")
        }
    },
    read: |lines, _| read(lines),
    heading: |lines, _| heading(lines),
    parts: Parts::One,
};

/// Lines of text, of whole numbers and of numbers in the header.
const HEADER: [usize; 3] = [11, 6, 10];

/// Place of the number of values among the whole numbers, and of the sampling rate in 1/s among the numbers.
const PLACES: [usize; 2] = [16, 1];

/// The quantity that line 1 names, such as `2 CORRECTED ACCELEROGRAM`.
fn quantity(lines: &[&str]) -> Option<&'static str> {
    let line = lines.first()?.trim().to_ascii_uppercase();
    let named = line.strip_prefix(|c: char| c.is_ascii_digit())?.trim();
    const NAMES: [(&str, &str); 5] = [
        ("UNCORRECTED ACCEL", "acceleration"),
        ("CORRECTED ACCEL", "acceleration"),
        ("VELOCITY", "velocity"),
        ("DISPLACEMENT", "displacement"),
        ("RESPONSE SPECTRA", "response spectrum"),
    ];
    let known = NAMES.iter().find(|known| named.starts_with(known.0));
    known.map(|known| known.1)
}

/// Whether a line of the text is empty in the way of the format, or names the station.
fn has_mark(lines: &[&str]) -> bool {
    let mut text = lines.iter().take(HEADER[0]).map(|line| line.trim());
    text.any(|line| line == "*" || line.starts_with("station ="))
}

/// The record in cm/s2.
fn read(lines: &[&str]) -> Series {
    match quantity(lines) {
        None | Some("acceleration") => {}
        Some(other) => return Err(fault(0, RecordCause::Quantity(other))),
    }
    let [text, whole, numbers] = HEADER;
    let whole = table(lines, text, whole)?;
    let count_line = text + PLACES[0] / 8;
    let count = whole.get(PLACES[0]).copied().unwrap_or_default();
    if count < 2.0 || count.fract() != 0.0 {
        let cause = RecordCause::Count("whole number 17, the number of values,", count);
        return Err(fault(count_line, cause));
    }
    let from = text + HEADER[1];
    let numbers = table(lines, from, numbers)?;
    let rate = numbers.get(PLACES[1]).copied().unwrap_or_default();
    if rate <= 0.0 || !(count / rate).is_finite() {
        let cause = RecordCause::NotPositive("number 2, the samples per second,", rate);
        return Err(fault(from, cause));
    }
    let comments = from + HEADER[2];
    let is_comment = |line: &&&str| line.starts_with('|');
    let data = comments + lines.iter().skip(comments).take_while(is_comment).count();
    let source = format!("whole number 17 of the header, in line {}", count_line + 1);
    let values = all(lines, data.min(end(lines)), count, &source)?;
    let dt = 1.0 / rate;
    let step = Stated::new(dt, "the sampling rate (number 2 of the header)", from);
    let record = Record::even(values, dt, Some(Unit::CentimetrePerSecond2));
    Ok((record, Some(step)))
}

/// What lines 4 and 6 name, such as `1989  10  18    0004 Loma Prieta, CA` and `station = Shafter  component=    270`.
fn heading(lines: &[&str]) -> Heading {
    let event_line = lines.get(3).copied().unwrap_or_default();
    let event = event_line.trim_start_matches(|c: char| c.is_ascii_digit() || c == ' ');
    let text = lines.get(5).copied().unwrap_or_default();
    let line = text.trim().strip_prefix("station").unwrap_or_default();
    let (station, component) = line.split_once("component=").unwrap_or((line, ""));
    let station = spaced(station.trim_start_matches([' ', '=']));
    // The field is short and may end with the first letter of a word.
    let whole = station.rsplit_once(", ").filter(|(_, last)| last.len() < 2);
    Heading {
        event: spaced(event.split(',').next().unwrap_or_default()),
        station: whole.map_or(&*station, |(whole, _)| whole).to_owned(),
        component: heading::component(component),
    }
}
