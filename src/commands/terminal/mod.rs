//! Output on the terminal: results to stdout, notes and errors to stderr.

mod duration;
mod message;
mod metrics;
mod observer;
pub mod progress;
mod studies;
mod summary;

pub use duration::duration;
pub use message::{input_note, line, note, warn};
pub use observer::Terminal;
pub use summary::Summary;

use crate::error::Error;
use crate::study::printable;
use message::labelled;
use std::io::{BufWriter, ErrorKind, Write, stdout};
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

/// Writes an error to stderr; each fault of a study with its line and a caret.
pub fn report_error(error: &Error) {
    let Error::Faults(faults) = error else {
        let text = error.to_string();
        return labelled("error", &text, || line(&format!("slipgap: {text}")));
    };
    for fault in faults {
        let text = fault.to_string();
        labelled("error", &text, || line(&text));
        if !fault.shown.is_empty() {
            line(&fault.shown);
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
