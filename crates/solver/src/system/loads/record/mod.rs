//! Recorded accelerations: PEER AT2, K-NET ASCII, and two columns.
//!
//! The content decides on the format: a file with a line `Scale Factor` in its header is K-NET, one with a line that names NPTS and
//! DT is AT2, and any other file has two columns.

mod at2;
mod columns;
mod fault;
mod knet;
mod mean;
mod number;

pub use fault::{RecordCause, RecordFault, Shown};
pub use mean::Mean;

use super::Unit;
use fault::LineFault;

/// A recorded acceleration. It is straight between its points.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Times in seconds; at least two, and they rise.
    pub times: Vec<f64>,
    /// Accelerations in the record's unit, one for each time.
    pub values: Vec<f64>,
    /// The unit that the file has: cm/s2 (gal) for K-NET, the one of the header for AT2 and for two columns, none without one there.
    pub unit: Option<Unit>,
    /// The mean that was subtracted from the values, in the same unit; `None` if they are those of the file.
    pub removed_mean: Option<f64>,
}

impl Record {
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

/// The content of a record file; `name` is for messages only. Without `mean`, the mean of K-NET is removed, because its counts have
/// the offset of the digitiser, and that of the other formats is kept.
pub fn parse(name: &str, bytes: &[u8], mean: Option<Mean>) -> Result<Record, RecordFault> {
    let text = String::from_utf8_lossy(bytes); // Names of stations in a header may have any encoding.
    let lines: Vec<&str> = text.trim_start_matches('\u{feff}').lines().collect();
    let record = if knet::is_format(&lines) {
        knet::parse(&lines, mean.unwrap_or(Mean::Removed))
    } else if let Some(header) = at2::header(&lines) {
        // The header of two columns may name NPTS and DT, too.
        at2::parse(&lines, header).or_else(|fault| columns::parse(&lines).map_err(|_| fault))
    } else {
        columns::parse(&lines)
    };
    let record = record.map(|record| match mean {
        Some(Mean::Removed) => record.without_mean(),
        Some(Mean::Kept) | None => record,
    });
    record.map_err(|LineFault { line, cause }| RecordFault {
        name: name.to_owned(),
        line,
        cause,
    })
}

/// The last line of a file, as an index.
fn end(lines: &[&str]) -> usize {
    lines.len().saturating_sub(1)
}

#[cfg(test)]
mod tests;
