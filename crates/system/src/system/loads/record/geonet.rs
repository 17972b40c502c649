//! GeoNet V1A and V2A: components one after the other, each with 16 lines of text, 4 lines of whole numbers and 6 of numbers, then
//! the accelerations in fields of eight characters. V2A has velocities and displacements behind them.

use super::fault::{RecordCause, fault};
use super::fortran_number::{Stated, first, table};
use super::heading::{self, Heading, spaced};
use super::{Format, Parts, Reading, Record, Series, component};
use crate::system::loads::Unit;

/// The format.
pub(super) const FORMAT: Format = Format {
    name: "GeoNet V1A or V2A",
    find: |lines| match lines.first().is_some_and(is_start) {
        true if marks(lines) >= FEWEST => Ok(()),
        true => {
            Err("its first 16 lines are not those of GeoNet, such as \"Site\" and \"Component\"")
        }
        false => Err(
            "line 1 does not begin with \"Corrected accelerogram\" or \"Uncorrected accelerogram\"",
        ),
    },
    read,
    heading,
    parts: Parts::Components,
};

/// Lines of text, of whole numbers and of numbers in the header.
const HEADER: [usize; 3] = [16, 4, 6];

/// Line and field of the number of accelerations among the whole numbers, and of the time step among the numbers.
const PLACES: [[usize; 2]; 2] = [[3, 3], [2, 5]];

/// Words with which lines of the text begin, and how many of them a file has at least: others have the same first line.
const MARKS: [&str; 8] = [
    "site ",
    "component ",
    "instrument ",
    "resolution",
    "number of points",
    "acceleration",
    "velocity",
    "displacement",
];
const FEWEST: usize = 2;

/// Number of the marks of the format that the text has.
fn marks(lines: &[&str]) -> usize {
    let begins = |mark: &&&str| {
        let mut text = lines.iter().take(HEADER[0]);
        text.any(|line| line.trim_start().to_ascii_lowercase().starts_with(**mark))
    };
    MARKS.iter().filter(begins).count()
}

/// Whether a component begins with this line.
fn is_start(line: &&str) -> bool {
    let line = line.trim_start().to_ascii_lowercase();
    line.starts_with("corrected accelerogram") || line.starts_with("uncorrected accelerogram")
}

/// The record of a component in mm/s2.
fn read(lines: &[&str], reading: &Reading) -> Series {
    let starts = starts(lines);
    let name = |start: &usize| behind(lines, *start, "Component").trim().to_owned();
    let names: Vec<String> = starts.iter().map(name).collect();
    let start = starts[component(&names, reading.component)?];
    let [text, whole, numbers] = HEADER;
    let number = |from: usize, [line, field]: [usize; 2]| {
        let row = table(lines, start + from + line, 1)?;
        Ok(row.get(field).copied().unwrap_or_default())
    };
    let count = number(text, PLACES[0])?;
    if count < 2.0 || count.fract() != 0.0 {
        let cause = RecordCause::Count("field 4, the number of accelerations,", count);
        return Err(fault(start + text + PLACES[0][0], cause));
    }
    let dt = number(text + whole, PLACES[1])?;
    if dt <= 0.0 || !(count * dt).is_finite() {
        let cause = RecordCause::NotPositive("field 6, the time step,", dt);
        return Err(fault(start + text + whole + PLACES[1][0], cause));
    }
    let source = format!("field 4 of line {}", start + text + PLACES[0][0] + 1);
    let values = first(lines, start + text + whole + numbers, count, &source)?;
    let line = start + text + whole + PLACES[1][0];
    let step = Stated::new(dt, "field 6 of the header", line);
    let record = Record::even(values, dt, Some(Unit::MillimetrePerSecond2));
    Ok((record, Some(step)))
}

/// The lines with which components begin.
fn starts(lines: &[&str]) -> Vec<usize> {
    let starts = lines.iter().enumerate().filter(|(_, line)| is_start(line));
    starts.map(|(index, _)| index).collect()
}

/// What is behind a label in the header of a component.
fn behind<'a>(lines: &[&'a str], start: usize, label: &str) -> &'a str {
    let mut header = lines.iter().skip(start).take(HEADER[0]);
    let named = header.find_map(|line| line.trim().strip_prefix(label));
    named.unwrap_or_default()
}

/// The date of the event, the code of the station and the component.
fn heading(lines: &[&str], reading: &Reading) -> Heading {
    let starts = starts(lines);
    let index = reading.component.unwrap_or(1).saturating_sub(1);
    let start = starts.get(index).copied().unwrap_or_default();
    let first = |label| behind(lines, start, label).split_whitespace().next();
    let mut header = lines.iter().skip(start).take(HEADER[0]);
    Heading {
        event: header.find_map(|line| date(line)).unwrap_or_default(),
        station: spaced(first("Site").unwrap_or_default()),
        component: heading::component(first("Component").unwrap_or_default()),
    }
}

/// The date of a line such as `2016 November 13         11:02:56 UT`.
fn date(line: &str) -> Option<String> {
    const MONTHS: [&str; 12] = [
        "January",
        "February",
        "March",
        "April",
        "May",
        "June",
        "July",
        "August",
        "September",
        "October",
        "November",
        "December",
    ];
    let mut words = line.split_whitespace();
    let year: u16 = words.next()?.parse().ok()?;
    let word = words.next()?;
    let month = MONTHS.iter().position(|name| *name == word)? + 1;
    let day: u8 = words.next()?.parse().ok()?;
    Some(format!("{year}-{month:02}-{day:02}"))
}
