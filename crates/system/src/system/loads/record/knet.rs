//! K-NET and KiK-net ASCII: a header of 17 lines, the last one `Memo.`, then counts of the digitiser in rows.

use super::fault::{LineFault, RecordCause, Shown, fault};
use super::fortran_number::{Stated, all, number};
use super::heading::Heading;
use super::{Format, Mean, Parts, Reading, Record, Series, end, mean as means};
use crate::system::loads::Unit;

/// The format.
pub(super) const FORMAT: Format = Format {
    name: "K-NET ASCII",
    find: |lines| match LABELS
        .iter()
        .filter(|label| header(lines, label).is_some())
        .count()
    {
        FEWEST.. => Ok(()),
        _ => Err(
            "its first 17 lines are not those of K-NET, such as \"Sampling Freq(Hz)\" and \"Scale Factor\"",
        ),
    },
    read: |lines, reading: &Reading| parse(lines, reading.mean.unwrap_or(Mean::Removed)),
    heading: |lines, _| {
        let behind = |label| header(lines, label).map_or("", |(_, rest)| rest);
        let date = behind("Origin Time").split(' ').next();
        Heading {
            event: date.unwrap_or_default().replace('/', "-"),
            station: behind("Station Code").to_owned(),
            component: behind("Dir.").to_owned(),
        }
    },
    parts: Parts::One,
};

/// Lines of the header.
const HEADER: usize = 17;

/// Labels of the header, and how many of them a file has at least: tables may have one, too.
const LABELS: [&str; 7] = [
    "Origin Time",
    "Station Code",
    "Sampling Freq(Hz)",
    "Duration Time(s)",
    "Dir.",
    "Scale Factor",
    "Memo",
];
const FEWEST: usize = 3;

/// The index and the rest of the line of the header that begins with `label`.
fn header<'a>(lines: &[&'a str], label: &str) -> Option<(usize, &'a str)> {
    let rest = lines
        .iter()
        .take(HEADER)
        .map(|line| line.trim().strip_prefix(label));
    rest.enumerate()
        .find_map(|(index, rest)| Some((index, rest?.trim())))
}

/// The record in gal (cm/s2): (count - mean of all counts) a/b with the scale factor a(gal)/b, or count a/b if the mean is kept.
fn parse(lines: &[&str], mean: Mean) -> Series {
    let memo = lines.get(HEADER - 1).map(|line| line.trim());
    if !memo.is_some_and(|memo| memo.starts_with("Memo")) {
        return Err(fault(end(lines).min(HEADER - 1), RecordCause::Header));
    }
    let frequency = positive(lines, "Sampling Freq(Hz)", |text| {
        number(text.strip_suffix("Hz").unwrap_or(text).trim())
    })?;
    let duration = positive(lines, "Duration Time(s)", number)?;
    let scale = positive(lines, "Scale Factor", scale)?;
    let count = (duration * frequency).round();
    let source = "Duration Time(s) times Sampling Freq(Hz)";
    let counts = all(lines, HEADER, count, source)?;
    if counts.len() < 2 {
        return Err(fault(end(lines), RecordCause::OneNumber));
    }
    let dt = 1.0 / frequency;
    let offset = match mean {
        Mean::Removed => means::of(&counts),
        Mean::Kept => 0.0,
    };
    let record = Record {
        times: (0..counts.len()).map(|i| i as f64 * dt).collect(),
        values: counts
            .iter()
            .map(|count| (count - offset) * scale)
            .collect(),
        unit: Some(Unit::CentimetrePerSecond2),
        removed_mean: (mean == Mean::Removed).then_some(offset * scale),
        doubts: Vec::new(),
    };
    let finite = record
        .times
        .iter()
        .chain(&record.values)
        .all(|x| x.is_finite());
    let line = header(lines, "Sampling Freq(Hz)").map_or(0, |pair| pair.0);
    finite
        .then_some((record, Some(Stated::new(dt, "Sampling Freq(Hz)", line))))
        .ok_or_else(|| fault(HEADER, RecordCause::TooLarge))
}

/// The number > 0 of the line of the header that begins with `label`.
fn positive(
    lines: &[&str],
    label: &'static str,
    read: impl Fn(&str) -> Result<f64, RecordCause>,
) -> Result<f64, LineFault> {
    let Some((index, text)) = header(lines, label) else {
        return Err(fault(HEADER - 1, RecordCause::NoLine(label)));
    };
    let number = read(text).map_err(|cause| fault(index, cause))?;
    if number <= 0.0 {
        return Err(fault(index, RecordCause::NotPositive(label, number)));
    }
    Ok(number)
}

/// a/b of a scale factor `a(gal)/b`.
fn scale(text: &str) -> Result<f64, RecordCause> {
    let form = || RecordCause::Scale(Shown::new(text));
    let (gal, count) = text.split_once("(gal)/").ok_or_else(form)?;
    let scale = number(gal.trim())? / number(count.trim())?;
    if scale.is_finite() {
        Ok(scale)
    } else {
        Err(form())
    }
}
