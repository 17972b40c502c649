//! Output on the terminal: results to stdout, notes and errors to stderr.

mod duration;
mod metrics;
mod observer;
pub mod progress;
mod studies;

pub use duration::duration;
pub use observer::Terminal;

use crate::error::Error;
use crate::study::printable;
use std::io::{BufWriter, ErrorKind, Write, stderr, stdout};
use std::iter::repeat_n;

/// Writes results to stdout and returns the exit code. Control characters are replaced by visible text. A closed pipe is
/// no error.
pub fn print(text: &str) -> Result<u8, Error> {
    print_all([text])
}

/// Writes results piece by piece, as [`print`] does.
pub fn print_all(pieces: impl IntoIterator<Item = impl AsRef<str>>) -> Result<u8, Error> {
    let mut out = BufWriter::new(stdout().lock());
    let mut pieces = pieces.into_iter();
    let written = pieces.try_for_each(|piece| out.write_all(printable(piece.as_ref()).as_bytes()));
    match written.and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(Error::io("cannot write", "stdout")(e)),
        Err(_) | Ok(()) => Ok(0),
    }
}

/// Writes a line about the run to stderr, at once: several processes may have the same stderr. A closed stderr is no error.
pub fn note(line: &str) {
    let line = format!("{}\n", printable(line));
    let _ = stderr().write_all(line.as_bytes());
}

/// Writes an error to stderr; each fault of a study with its line and a caret.
pub fn report_error(error: &Error) {
    let Error::Faults(faults) = error else {
        return note(&format!("slipgap: {error}"));
    };
    for fault in faults {
        note(&fault.to_string());
        if !fault.shown.is_empty() {
            note(&fault.shown);
        }
    }
}

/// Blanks between two columns of a table.
pub const GAP: usize = 2;

/// Rows of text in aligned columns. The first row is the header. Control characters become spaces.
pub fn table(rows: &[Vec<String>]) -> String {
    table_lines(|| rows.iter().cloned()).collect()
}

/// The lines of a table. `rows` is called twice: first for the widths.
pub fn table_lines<I: Iterator<Item = Vec<String>>>(
    rows: impl Fn() -> I,
) -> impl Iterator<Item = String> {
    let mut widths: Vec<usize> = Vec::new();
    for row in rows() {
        widths.resize(widths.len().max(row.len()), 0);
        for (width, cell) in widths.iter_mut().zip(&row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    rows().map(move |row| {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            let cell = cell.replace(char::is_control, " ");
            // The width of a format specification is limited to 65 535.
            line.push_str(&cell);
            line.extend(repeat_n(' ', width - cell.chars().count() + GAP));
        }
        line.truncate(line.trim_end().len());
        line.push('\n');
        line
    })
}
