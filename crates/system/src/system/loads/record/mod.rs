//! Recorded accelerations: the formats of record files, and the choice among them.
//!
//! The content decides on the format. A file that is in none of the others is a table.

mod agencies;
mod at2;
mod cosmos;
mod fault;
pub(in crate::system) mod file_text;
pub(in crate::system) mod fortran_number;
mod geonet;
mod heading;
mod knet;
mod mean;
mod quantity;
mod smc;
pub(in crate::system) mod table;

pub use fault::{Doubt, RecordCause, RecordFault, Shown};
pub use heading::Heading;
pub use mean::Mean;

use super::Unit;
use fault::{LineFault, fault};
use fortran_number::Stated;

/// A recorded acceleration. It is straight between its points.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Times in seconds; at least two, and they rise.
    pub times: Vec<f64>,
    /// Accelerations in the record's unit, one for each time.
    pub values: Vec<f64>,
    /// The unit that the file has: that of the format, or the one of the header; none without one there.
    pub unit: Option<Unit>,
    /// The mean that was subtracted from the values, in the same unit; `None` if they are those of the file.
    pub removed_mean: Option<f64>,
    /// What its header states otherwise.
    pub doubts: Vec<Doubt>,
}

/// What a study says about a file besides its name.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Reading {
    /// What happens to the mean. Without it, the mean of K-NET is removed, because its counts have the offset of the digitiser, and
    /// that of the other formats is kept.
    pub mean: Option<Mean>,
    /// The column of a table that has the accelerations, from 1; of another format the only one.
    pub column: Option<usize>,
    /// The time step of a table without times; of another format, that of its header.
    pub dt: Option<f64>,
    /// The component of a file with several, from 1.
    pub component: Option<usize>,
}

/// The record of a file, and the time step that its header states; none of times that are not even.
type Series = Result<(Record, Option<Stated>), LineFault>;

/// A format besides tables.
struct Format {
    name: &'static str,
    /// Whether a file is in this format; else why not.
    find: fn(&[&str]) -> Result<(), &'static str>,
    read: fn(&[&str], &Reading) -> Series,
    /// What the header names.
    heading: fn(&[&str], &Reading) -> Heading,
    parts: Parts,
}

/// What of a file may be wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Parts {
    /// The only series.
    One,
    /// One of several components.
    Components,
    /// One of several columns.
    Columns,
}

/// The formats besides tables, in the order in which they are tried.
const FORMATS: [Format; 9] = [
    knet::FORMAT,
    at2::FORMAT,
    smc::FORMAT,
    cosmos::FORMAT,
    geonet::FORMAT,
    agencies::ACCELEROGRAM,
    agencies::ESM,
    agencies::UNAM,
    agencies::NSMP,
];

/// Share by which two time steps that are the same may differ: one may be from a rate.
const SAME: f64 = 1e-6;

impl Record {
    /// Values that are `dt` apart, from t = 0 on.
    fn even(values: Vec<f64>, dt: f64, unit: Option<Unit>) -> Record {
        Record {
            times: (0..values.len()).map(|i| i as f64 * dt).collect(),
            values,
            unit,
            removed_mean: None,
            doubts: Vec::new(),
        }
    }

    /// The same without the mean of its values, if that is not yet removed.
    fn without_mean(mut self) -> Record {
        if self.removed_mean.is_none() {
            let mean = mean::of(&self.values);
            self.values.iter_mut().for_each(|value| *value -= mean);
            self.removed_mean = Some(mean);
        }
        self
    }
}

/// The content of a record file; `name` is for messages only.
///
/// # Errors
/// The first line at fault. Of a file in an unknown format, the formats that were tried and why it is in none of them.
pub fn parse(name: &str, bytes: &[u8], reading: Reading) -> Result<Record, RecordFault> {
    let text = file_text::decode(bytes);
    let lines: Vec<&str> = text.lines().collect();
    let record = record(&lines, &reading).map(|record| match reading.mean {
        Some(Mean::Removed) => record.without_mean(),
        Some(Mean::Kept) | None => record,
    });
    record.map_err(|LineFault { line, cause }| RecordFault {
        name: name.to_owned(),
        line,
        cause,
    })
}

/// The record of a file by its format.
fn record(lines: &[&str], reading: &Reading) -> Result<Record, LineFault> {
    let mut others = Vec::new();
    for format in &FORMATS {
        match (format.find)(lines) {
            Ok(()) => return of_format(format, lines, reading),
            Err(why) => others.push((format.name, why)),
        }
    }
    if reading.component.is_some() {
        let given = reading.column.is_some() || reading.dt.is_some();
        return Err(fault(
            0,
            match given {
                true => RecordCause::TwoChoices(table::NAME),
                false => RecordCause::OneComponent(table::NAME),
            },
        ));
    }
    let given = reading.column.is_some() || reading.dt.is_some();
    table::parse(lines, reading).map_err(|LineFault { line, cause }| {
        // Rows before this one would be those of a table.
        let is_first = table::first_row(lines).is_none_or(|first| line <= first + 1);
        let cause = match is_first && !given && cause.is_of_rows() {
            true => RecordCause::Unknown(Box::new(cause), others),
            false => cause,
        };
        LineFault { line, cause }
    })
}

/// The record of a file in a format with the time step of its header.
fn of_format(format: &Format, lines: &[&str], reading: &Reading) -> Result<Record, LineFault> {
    if reading.component.is_some() && format.parts != Parts::Components {
        let cause = match format.parts {
            Parts::Columns => RecordCause::TwoChoices(format.name),
            Parts::One | Parts::Components => RecordCause::OneComponent(format.name),
        };
        return Err(fault(0, cause));
    }
    let other = reading.column.filter(|column| *column > 1);
    if let Some(column) = other.filter(|_| format.parts != Parts::Columns) {
        return Err(fault(0, RecordCause::OneColumn(format.name, column)));
    }
    let (record, step) = (format.read)(lines, reading)?;
    match (&step, reading.dt) {
        (Some(step), dt) => agree(step, dt)?,
        (None, Some(_)) => return Err(fault(0, RecordCause::OwnTimes)),
        (None, None) => {}
    }
    Ok(record)
}

/// The time step of the study is the one that a header states.
fn agree(stated: &Stated, dt: Option<f64>) -> Result<(), LineFault> {
    match dt.filter(|dt| (dt - stated.value).abs() > SAME * stated.value) {
        Some(dt) => {
            let cause = RecordCause::Contradicts(dt, stated.value, stated.place());
            Err(fault(stated.line, cause))
        }
        None => Ok(()),
    }
}

/// The place of the wanted one of these components, from 0.
fn component(names: &[String], wanted: Option<usize>) -> Result<usize, LineFault> {
    choice("component", names, wanted)
}

/// The place of the wanted one of the parts that a key chooses, from 0.
///
/// # Errors
/// There are several and none is wanted, or there is no such part.
fn choice(key: &'static str, names: &[String], wanted: Option<usize>) -> Result<usize, LineFault> {
    match (names.len(), wanted) {
        (_, Some(number)) if (1..=names.len()).contains(&number) => Ok(number - 1),
        (1, None) => Ok(0),
        (_, wanted) => {
            let names = names.iter().map(|name| Shown::new(name)).collect();
            Err(fault(0, RecordCause::Parts(key, names, wanted)))
        }
    }
}

/// The last line of a file, as an index.
fn end(lines: &[&str]) -> usize {
    lines.len().saturating_sub(1)
}

#[cfg(test)]
mod tests;
