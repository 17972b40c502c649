//! PEER AT2: a header of four lines, the last with NPTS and DT, then the accelerations in rows.

use super::fault::{RecordCause, fault};
use super::fortran_number::{Stated, all, before_end, fields, number};
use super::heading::{self, Heading, spaced};
use super::{Format, Parts, Reading, Record, Series, quantity};
use crate::system::loads::Unit;

/// The format.
pub(super) const FORMAT: Format = Format {
    name: "PEER AT2",
    find: |lines| match header(lines) {
        Some(header) if is_table(lines, header) => {
            Err("its rows are not NPTS numbers but those of a table")
        }
        Some(_) => Ok(()),
        None => Err("no line of the first 20 names NPTS and DT"),
    },
    read: |lines, _| parse(lines, header(lines).unwrap_or_default()),
    heading,
    parts: Parts::One,
};

/// Lines that are searched for NPTS and DT. PEER has them in line 4; an editor or a mail may have added some.
const HEADER: usize = 20;

/// The two numbers of a header.
#[derive(Clone, Copy, PartialEq)]
enum Key {
    Npts,
    Dt,
}

/// The index of the line that names NPTS and DT.
fn header(lines: &[&str]) -> Option<usize> {
    let both = |line: &&str| {
        [Key::Npts, Key::Dt]
            .iter()
            .all(|key| keys(line).any(|k| k == *key))
    };
    lines.iter().take(HEADER).position(both)
}

/// The names in a line, in their order.
fn keys(line: &str) -> impl Iterator<Item = Key> + '_ {
    let words = line.split(|c: char| !c.is_ascii_alphabetic());
    words.filter_map(|word| match word.to_ascii_uppercase().as_str() {
        "NPTS" => Some(Key::Npts),
        "DT" => Some(Key::Dt),
        _ => None,
    })
}

/// The record of a file whose line `header` names NPTS and DT.
fn parse(lines: &[&str], header: usize) -> Series {
    let titles = &lines[..header];
    for (index, title) in titles.iter().enumerate() {
        let title = title.to_ascii_lowercase();
        for other in ["velocity", "displacement"] {
            if title.contains(&format!("{other} time")) {
                return Err(fault(index, RecordCause::Quantity(other)));
            }
        }
    }
    quantity::check(titles)?;
    let (npts, dt) = counts(lines[header]).map_err(|cause| fault(header, cause))?;
    let source = format!("NPTS of line {}", header + 1);
    let values = all(lines, header + 1, npts, &source)?;
    let unit = titles.iter().find_map(|title| unit(title));
    let step = Stated::new(dt, "DT", header);
    Ok((Record::even(values, dt, unit), Some(step)))
}

/// NPTS and DT of the lines before the first row of a table, with the index of their line.
pub(super) fn stated(lines: &[&str]) -> Option<(usize, f64, f64)> {
    let header = header(lines)?;
    let (npts, dt) = counts(lines[header]).ok()?;
    Some((header, npts, dt))
}

/// Whether the rows behind the header are those of a table: of one length, two numbers or more, and not NPTS numbers in all. Either
/// there are NPTS rows, or the first numbers are times.
fn is_table(lines: &[&str], header: usize) -> bool {
    let lines = before_end(lines).unwrap_or(lines);
    let row = |line: &&str| -> Option<Vec<f64>> {
        let line = line.replace(';', " ");
        fields(&line).map(|text| number(text).ok()).collect()
    };
    let below_header = lines.iter().skip(header + 1);
    let body = below_header.filter(|line| !line.trim().is_empty());
    let rows: Vec<Vec<f64>> = body
        .skip_while(|line| row(line).is_none())
        .map_while(row)
        .collect();
    let Some(width) = rows.first().map(Vec::len).filter(|width| *width > 1) else {
        return false;
    };
    let npts = counts(lines[header]).map_or(f64::NAN, |counts| counts.0);
    let rises = rows.len() > 2
        && rows
            .windows(2)
            .all(|pair| pair[0].first() < pair[1].first());
    rows.iter().all(|row| row.len() == width)
        && (rows.len() * width) as f64 != npts
        && (rows.len() as f64 == npts || rises)
}

/// NPTS and DT: the first two numbers of the line, in the order of the names, which are before, between or after them.
fn counts(line: &str) -> Result<(f64, f64), RecordCause> {
    let fields = line.split(|c: char| c.is_whitespace() || ",;:=".contains(c));
    let numbers: Vec<f64> = fields
        .filter_map(|field| number(without_second(field)).ok())
        .collect();
    let [first, second, ..] = numbers[..] else {
        return Err(RecordCause::NoCounts);
    };
    let (npts, dt) = match keys(line).next() {
        Some(Key::Dt) => (second, first),
        _ => (first, second),
    };
    if npts < 2.0 || npts.fract() != 0.0 {
        return Err(RecordCause::Npts(npts));
    }
    if dt <= 0.0 || !(npts * dt).is_finite() {
        return Err(RecordCause::Dt(dt));
    }
    Ok((npts, dt))
}

/// A number without `SEC` or `S` right behind it.
fn without_second(field: &str) -> &str {
    let field = field.trim_end_matches(['.', 's', 'S', 'e', 'E', 'c', 'C']);
    if field.is_empty() { "-" } else { field }
}

/// The unit of a title such as `ACCELERATION TIME SERIES IN UNITS OF G`.
fn unit(title: &str) -> Option<Unit> {
    let title = title.to_ascii_uppercase();
    let (_, after) = title.split_once("UNITS")?;
    let trimmed = after.trim_start_matches([':', '=', ' ']);
    let after = trimmed.strip_prefix("OF ").unwrap_or(trimmed);
    Unit::spelled(after.split_whitespace().next()?)
}

/// What a title such as `Nowhere-01, 1/1/2000, Hand Written, 90` names.
fn heading(lines: &[&str], _: &Reading) -> Heading {
    let titles = &lines[..header(lines).unwrap_or_default()];
    let title = titles.iter().find(|title| title.matches(',').count() > 1);
    let parts = title.into_iter().flat_map(|title| title.split(','));
    let texts = parts.map(|field| {
        let field = field.split('(').next().unwrap_or_default();
        let words = field.split_whitespace().filter(|word| !is_time(word));
        spaced(&words.collect::<Vec<_>>().join(" "))
    });
    let fields: Vec<String> = texts.filter(|field| !field.is_empty()).collect();
    let (event, station, component) = match &fields[..] {
        [] => return Heading::default(),
        [event] => (event, String::new(), ""),
        [event, station] => (event, station.clone(), ""),
        [event, station @ .., component] => (event, station.join(", "), &**component),
    };
    Heading {
        event: event.clone(),
        station,
        component: heading::component(component),
    }
}

/// Whether a word is a date or an hour, such as `1/17/94` or `12:31`.
fn is_time(word: &str) -> bool {
    word.contains(['/', ':'])
        && word
            .chars()
            .all(|c| c.is_ascii_digit() || "/:.".contains(c))
}
