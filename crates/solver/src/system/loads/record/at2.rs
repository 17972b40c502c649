//! PEER AT2: a header of four lines, the last with NPTS and DT, then the accelerations in rows.

use super::Record;
use super::fault::{LineFault, RecordCause, fault};
use super::number::{all, number};
use crate::system::loads::Unit;

/// Lines that are searched for NPTS and DT. PEER has them in line 4; an editor or a mail may have added some.
const HEADER: usize = 20;

/// The two numbers of a header.
#[derive(Clone, Copy, PartialEq)]
enum Key {
    Npts,
    Dt,
}

/// The index of the line that names NPTS and DT.
pub(super) fn header(lines: &[&str]) -> Option<usize> {
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
pub(super) fn parse(lines: &[&str], header: usize) -> Result<Record, LineFault> {
    let titles = &lines[..header];
    for (index, title) in titles.iter().enumerate() {
        let title = title.to_ascii_lowercase();
        for other in ["velocity", "displacement"] {
            if title.contains(&format!("{other} time")) {
                return Err(fault(index, RecordCause::Quantity(other)));
            }
        }
    }
    let (npts, dt) = counts(lines[header]).map_err(|cause| fault(header, cause))?;
    let source = format!("NPTS of line {}", header + 1);
    let values = all(lines, header + 1, npts, &source)?;
    Ok(Record {
        times: (0..values.len()).map(|i| i as f64 * dt).collect(),
        values,
        unit: titles.iter().find_map(|title| unit(title)),
        removed_mean: None,
    })
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
    let after = after.trim_start_matches([':', '=', ' ']);
    let after = after.strip_prefix("OF ").unwrap_or(after);
    Unit::spelled(after.split_whitespace().next()?)
}
