//! Two columns, t and a, after any header: with blanks, tabs, commas or semicolons.

use super::number::number;
use super::{LineFault, Record, end, fault};
use crate::system::loads::Unit;

/// The record of a file with two columns.
pub(super) fn parse(lines: &[&str]) -> Result<Record, LineFault> {
    let is_row = |line: &&str| {
        let fields = fields(line);
        fields.len() >= 2 && fields.into_iter().all(is_numeric)
    };
    let Some(from) = lines.iter().position(is_row) else {
        return Err(fault(end(lines), NO_ROW));
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
        let (t, a) = row(line).map_err(|message| fault(index, message))?;
        if let Some(last) = record.times.last().filter(|last| t <= **last) {
            let message = format!("the times must rise, got {t} after {last}");
            return Err(fault(index, message));
        }
        record.times.push(t);
        record.values.push(a);
    }
    if record.times.len() < 2 {
        let message = "the file has one row of numbers; a record needs two or more";
        return Err(fault(from, message));
    }
    Ok(record)
}

/// The unit of acceleration in brackets in a line of the header, as in `Acc. (m/s2)`.
fn unit(line: &str) -> Option<Unit> {
    let inner = line.split(['(', '[']).skip(1);
    let mut inner = inner.filter_map(|text| text.split([')', ']']).next());
    inner.find_map(Unit::spelled)
}

const NO_ROW: &str = "the file has no row of two numbers; allowed: two columns t and a with decimal points, PEER AT2, K-NET ASCII";

/// t and a of a row.
fn row(line: &str) -> Result<(f64, f64), String> {
    match fields(line)[..] {
        [t, a] => Ok((number(t)?, number(a)?)),
        ref fields => {
            let count = fields.len();
            Err(format!(
                "a row must have two numbers, t and a, with decimal points, got {count}"
            ))
        }
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
