//! Tables after any header: columns with blanks, tabs, commas or semicolons, the first of them the times, or none if a time step is
//! given.

mod facts;
pub(in crate::system) mod fields;
mod layout;

use super::fault::{LineFault, RecordCause, fault};
use super::fortran_number::{before_end, decimal, number};
use super::{Reading, Record, end, quantity};
use crate::system::loads::Unit;
use facts::Facts;
use fields::{cells, decimal_comma};

/// Its name in messages.
pub(super) const NAME: &str = "a table";

/// Names of a column of times.
const TIMES: [&str; 4] = ["t", "time", "times", "tiempo"];

/// The rows of a table.
struct Rows<'a> {
    /// The lines, without empty ones.
    lines: Vec<&'a str>,
    /// The names of the columns, in the line before the first row.
    names: Option<Vec<&'a str>>,
}

/// The record of a table. Without a column it has two, or one if a time step is given.
pub(super) fn parse(lines: &[&str], reading: &Reading) -> Result<Record, LineFault> {
    let least = match reading.dt {
        Some(_) => 1,
        None => 2,
    };
    if reading.column.is_some_and(|column| column < least) {
        return Err(fault(0, RecordCause::ColumnOfTimes));
    }
    let lines = before_end(lines)?;
    let Some(from) = row_of(lines, least) else {
        let facts = Facts::of(lines)?;
        return Err(match facts.step.filter(|_| least == 2) {
            Some(step) => fault(step.line, RecordCause::NoTimes(step.value, step.place())),
            None => fault(end(lines), RecordCause::NoRow(least)),
        });
    };
    let count = cells(lines[from]).len();
    let (header, body) = lines.split_at(from);
    let rows = Rows {
        lines: body
            .iter()
            .copied()
            .filter(|line| !line.trim().is_empty())
            .collect(),
        names: names(header, count),
    };
    let facts = Facts::of(header)?;
    let mut commas = body.iter().enumerate();
    if let Some((index, cause)) = commas.find_map(|(i, line)| Some((i, decimal_comma(line)?))) {
        return Err(fault(from + index, cause));
    }
    check_columns(header, &rows, reading)?;
    let mut record = Record {
        times: Vec::new(),
        values: Vec::new(),
        unit: unit((header, &rows), &facts, reading),
        removed_mean: None,
        doubts: Vec::new(),
    };
    for (index, line) in body.iter().enumerate() {
        if line.trim().is_empty() {
            continue;
        }
        let at = |cause| fault(from + index, cause);
        let (t, a) = row(line, reading).map_err(|cause| {
            let RecordCause::Row(count, even) = cause else {
                return at(cause);
            };
            at(layout::fault(&rows, count, even))
        })?;
        if let (Some(_), Some(_), width) = (reading.dt, reading.column, cells(line).len())
            && width != count
        {
            return Err(at(RecordCause::Ragged(width, count, from + 1)));
        }
        let t = match (t, reading.dt) {
            (Some(t), _) => t,
            (None, dt) => record.times.len() as f64 * dt.unwrap_or_default(),
        };
        if let Some(&last) = record.times.last().filter(|last| t <= **last) {
            return Err(at(match reading.column {
                Some(_) if reading.dt.is_none() => RecordCause::ColumnOfNoTimes(t, last),
                _ => RecordCause::Time { t, last },
            }));
        }
        record.times.push(t);
        record.values.push(a);
    }
    if record.times.len() < 2 {
        return Err(fault(from, RecordCause::OneRow));
    }
    if !record.times.last().is_some_and(|last| last.is_finite()) {
        return Err(fault(from, RecordCause::TooLarge));
    }
    if reading.dt.is_some() && reading.column.is_some() && layout::is_series(&rows) {
        return Err(fault(from, RecordCause::Wrapped(count)));
    }
    check_facts(&facts, (&rows, &record), reading)?;
    Ok(record)
}

/// The index of the first row of a table with times.
pub(super) fn first_row(lines: &[&str]) -> Option<usize> {
    row_of(lines, 2)
}

/// The index of the first line with `least` numbers or more and nothing else.
fn row_of(lines: &[&str], least: usize) -> Option<usize> {
    let is_row = |line: &&str| {
        let fields = cells(line);
        let count = fields.len().max(line.split_whitespace().count());
        // A line of asterisks is none; in a row they are a number that its field could not hold.
        count >= least
            && fields.iter().any(|field| !field.starts_with('*'))
            && fields.into_iter().all(is_numeric)
    };
    lines.iter().position(is_row)
}

/// The names of `count` columns in the last line of a header that has letters.
fn names<'a>(header: &[&'a str], count: usize) -> Option<Vec<&'a str>> {
    let has_letters = |line: &&&str| line.contains(char::is_alphabetic);
    let line = header.iter().rev().find(has_letters)?;
    let fields = cells(line.trim_start_matches(['#', ' ']));
    (fields.len() == count && count > 1).then_some(fields)
}

/// The header and the names of the columns say nothing else than a time and an acceleration.
fn check_columns(header: &[&str], rows: &Rows, reading: &Reading) -> Result<(), LineFault> {
    let Some(names) = &rows.names else {
        return quantity::check(header);
    };
    let line = header
        .iter()
        .rposition(|line| line.contains(char::is_alphabetic))
        .unwrap_or_default();
    let wanted = reading
        .column
        .unwrap_or(2 - usize::from(reading.dt.is_some()));
    let Some(name) = names.get(wanted - 1) else {
        return quantity::check(&header[..line]);
    };
    // A name such as `a` or `acc_x` says more than a title.
    if !name.to_lowercase().starts_with('a') {
        quantity::check(&header[..line])?;
    }
    if wanted == 1 && is_time(name) {
        return Err(fault(line, RecordCause::ColumnOfTimes));
    }
    match quantity::of_column(name) {
        Some(other) => Err(fault(line, RecordCause::Quantity(other))),
        None => Ok(()),
    }
}

/// Whether a name such as `Time (s)` is that of times.
fn is_time(name: &str) -> bool {
    let mut words = name.split(|c: char| !c.is_alphabetic());
    let first = words.next().unwrap_or_default().to_lowercase();
    TIMES.contains(&first.as_str())
}

/// What the header states is what the rows and the study have.
fn check_facts(
    facts: &Facts,
    (rows, record): (&Rows, &Record),
    reading: &Reading,
) -> Result<(), LineFault> {
    let count = record.times.len();
    if let Some(stated) = facts
        .count
        .as_ref()
        .filter(|stated| stated.value != count as f64)
    {
        return Err(fault(
            stated.line,
            RecordCause::Rows(count, stated.place(), stated.value),
        ));
    }
    let of_times = layout::step(rows);
    match (reading.dt, &facts.step, of_times) {
        (Some(dt), Some(stated), _) => super::agree(stated, Some(dt)),
        (Some(dt), None, Some(step)) if (dt - step).abs() > 1e-3 * step => {
            let cause = RecordCause::Contradicts(dt, step, "the times of column 1".to_owned());
            Err(fault(0, cause))
        }
        // Times have few digits.
        (None, Some(stated), Some(step)) if (stated.value - step).abs() > 0.01 * step => {
            Err(fault(
                stated.line,
                RecordCause::Steps(step, stated.place(), stated.value),
            ))
        }
        _ => Ok(()),
    }
}

/// The unit of acceleration: in brackets in the name of the wanted column, as in `Acc. (m/s2)`, behind a label, or in brackets in
/// another line that names no columns.
fn unit((header, rows): (&[&str], &Rows), facts: &Facts, reading: &Reading) -> Option<Unit> {
    let in_brackets = |text: &str| quantity::in_brackets(text, Unit::spelled);
    let count = rows.lines.first().map_or(0, |line| cells(line).len());
    let of_names = header
        .iter()
        .find_map(|line| match (reading.column, &cells(line)[..]) {
            (Some(column), names) if names.len() == count => in_brackets(names.get(column - 1)?),
            _ => None,
        });
    let others = || {
        let mut others = header
            .iter()
            .filter(|line| reading.column.is_none() || cells(line).len() != count);
        others.find_map(|line| in_brackets(line))
    };
    of_names.or(facts.unit).or_else(others)
}

/// t and a of a row; no t without times.
fn row(line: &str, reading: &Reading) -> Result<(Option<f64>, f64), RecordCause> {
    let fields = cells(line);
    let text = match (reading.column, reading.dt, &fields[..]) {
        (Some(column), _, fields) => {
            let wrong = || RecordCause::Fields(fields.len(), reading.column, reading.dt.is_some());
            fields.get(column - 1).copied().ok_or_else(wrong)?
        }
        (None, None, [_, a]) | (None, Some(_), [a]) => a,
        _ => return Err(RecordCause::Row(fields.len(), reading.dt.is_some())),
    };
    let t = match (reading.dt, fields.first()) {
        (None, Some(t)) => Some(decimal(t)?),
        _ => None,
    };
    Ok((t, decimal(text)?))
}

/// Whether a field is or begins as a number, so that a slip in the first row does not make a header of it. Dates and hours do not.
fn is_numeric(field: &str) -> bool {
    let begins = field
        .trim_start_matches(['+', '-', '.'])
        .starts_with(|c: char| c.is_ascii_digit() || c == '*');
    begins && !field.contains(['/', ':']) || number(field).is_ok() || field.parse::<f64>().is_ok()
}
