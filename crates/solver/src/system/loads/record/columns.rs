//! Two columns, t and a, after any header: with blanks, tabs, commas or semicolons.

use super::fault::{LineFault, RecordCause, fault};
use super::number::number;
use super::{Record, end};
use crate::system::loads::Unit;

/// The record of a file with two columns.
pub(super) fn parse(lines: &[&str]) -> Result<Record, LineFault> {
    let is_row = |line: &&str| {
        let fields = fields(line);
        fields.len() >= 2 && fields.into_iter().all(is_numeric)
    };
    let Some(from) = lines.iter().position(is_row) else {
        return Err(fault(end(lines), RecordCause::NoRow));
    };
    let mut record = Record {
        times: Vec::new(),
        values: Vec::new(),
        unit: lines[..from].iter().find_map(|line| unit(line)),
        removed_mean: None,
    };
    for (index, line) in lines.iter().enumerate().skip(from) {
        if line.trim().is_empty() {
            continue;
        }
        let (t, a) = row(line).map_err(|cause| fault(index, cause))?;
        if let Some(&last) = record.times.last().filter(|last| t <= **last) {
            return Err(fault(index, RecordCause::Time { t, last }));
        }
        record.times.push(t);
        record.values.push(a);
    }
    if record.times.len() < 2 {
        return Err(fault(from, RecordCause::OneRow));
    }
    Ok(record)
}

/// The unit of acceleration in brackets in a line of the header, as in `Acc. (m/s2)`.
fn unit(line: &str) -> Option<Unit> {
    let inner = line.split(['(', '[']).skip(1);
    let mut inner = inner.filter_map(|text| text.split([')', ']']).next());
    inner.find_map(Unit::spelled)
}

/// t and a of a row.
fn row(line: &str) -> Result<(f64, f64), RecordCause> {
    match fields(line)[..] {
        [t, a] => Ok((number(t)?, number(a)?)),
        ref fields => Err(RecordCause::Fields(fields.len())),
    }
}

/// The fields of a row. A semicolon separates before a comma, a comma before blanks; one may also end the row.
fn fields(line: &str) -> Vec<&str> {
    let line = line.trim();
    match [';', ','].into_iter().find(|by| line.contains(*by)) {
        Some(by) => {
            let line = line.strip_suffix(by).unwrap_or(line);
            line.split(by).map(str::trim).collect()
        }
        None => line.split_whitespace().collect(),
    }
}

/// Whether a field is or begins as a number, so that a slip in the first row does not make a header of it. Dates and hours do not.
fn is_numeric(field: &str) -> bool {
    let begins = field
        .trim_start_matches(['+', '-', '.'])
        .starts_with(|c: char| c.is_ascii_digit() || c == '*');
    begins && !field.contains(['/', ':']) || field.parse::<f64>().is_ok()
}
