//! Tables after any header: columns with blanks, tabs, commas or semicolons, the first of them the times, or none if a time step is
//! given.

use super::fault::{LineFault, RecordCause, fault};
use super::fields::{separator, split};
use super::number::number;
use super::{Reading, Record, end};
use crate::system::loads::Unit;

/// Its name in messages.
pub(super) const NAME: &str = "a table";

/// The record of a table. Without a column it has two, or one if a time step is given.
pub(super) fn parse(lines: &[&str], reading: &Reading) -> Result<Record, LineFault> {
    let least = match reading.dt {
        Some(_) => 1,
        None => 2,
    };
    if reading.column.is_some_and(|column| column < least) {
        return Err(fault(0, RecordCause::ColumnOfTimes));
    }
    let Some(from) = row_of(lines, least) else {
        let cause = RecordCause::NoRow(least);
        return Err(fault(end(lines), cause));
    };
    let count = fields(lines[from]).len();
    let mut record = Record {
        times: Vec::new(),
        values: Vec::new(),
        unit: unit(&lines[..from], reading.column, count),
        removed_mean: None,
    };
    for (index, line) in lines.iter().enumerate().skip(from) {
        if line.trim().is_empty() {
            continue;
        }
        let (t, a) = row(line, reading).map_err(|cause| fault(index, cause))?;
        let t = match (t, reading.dt) {
            (Some(t), _) => t,
            (None, dt) => record.times.len() as f64 * dt.unwrap_or_default(),
        };
        if let Some(&last) = record.times.last().filter(|last| t <= **last) {
            return Err(fault(index, RecordCause::Time { t, last }));
        }
        record.times.push(t);
        record.values.push(a);
    }
    if record.times.len() < 2 {
        return Err(fault(from, RecordCause::OneRow));
    }
    match record.times.last().is_some_and(|last| last.is_finite()) {
        true => Ok(record),
        false => Err(fault(from, RecordCause::TooLarge)),
    }
}

/// The index of the first row of a table with times.
pub(super) fn first_row(lines: &[&str]) -> Option<usize> {
    row_of(lines, 2)
}

/// The index of the first line with `least` numbers or more and nothing else.
fn row_of(lines: &[&str], least: usize) -> Option<usize> {
    let is_row = |line: &&str| {
        let fields = fields(line);
        fields.len() >= least && fields.into_iter().all(is_numeric)
    };
    lines.iter().position(is_row)
}

/// The unit of acceleration in brackets in a line of the header, as in `Acc. (m/s2)`. In a line with a name for each of `count`
/// columns it is that of the column.
fn unit(header: &[&str], column: Option<usize>, count: usize) -> Option<Unit> {
    let in_brackets = |text: &str| {
        let inner = text.split(['(', '[']).skip(1);
        let mut inner = inner.filter_map(|text| text.split([')', ']']).next());
        inner.find_map(Unit::spelled)
    };
    let of_line = |line: &&str| match (column, &fields(line)[..]) {
        (Some(column), names) if names.len() == count => in_brackets(names.get(column - 1)?),
        _ => in_brackets(line),
    };
    header.iter().find_map(of_line)
}

/// t and a of a row; no t without times.
fn row(line: &str, reading: &Reading) -> Result<(Option<f64>, f64), RecordCause> {
    let fields = fields(line);
    let wrong = || RecordCause::Fields(fields.len(), reading.column, reading.dt.is_some());
    let text = match (reading.column, reading.dt, &fields[..]) {
        (Some(column), _, fields) => fields.get(column - 1).copied().ok_or_else(wrong)?,
        (None, None, [_, a]) | (None, Some(_), [a]) => a,
        _ => return Err(wrong()),
    };
    let t = match (reading.dt, fields.first()) {
        (None, Some(t)) => Some(number(t)?),
        _ => None,
    };
    Ok((t, number(text)?))
}

/// The fields of a row; a separator may also end it.
fn fields(line: &str) -> Vec<&str> {
    let line = line.trim();
    let by = separator(line);
    let line = by.and_then(|by| line.strip_suffix(by)).unwrap_or(line);
    split(line, by)
}

/// Whether a field is or begins as a number, so that a slip in the first row does not make a header of it. Dates and hours do not.
fn is_numeric(field: &str) -> bool {
    let begins = field
        .trim_start_matches(['+', '-', '.'])
        .starts_with(|c: char| c.is_ascii_digit() || c == '*');
    begins && !field.contains(['/', ':']) || field.parse::<f64>().is_ok()
}
