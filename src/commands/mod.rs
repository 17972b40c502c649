//! One file for each verb, and what they share.

pub mod advice;
pub mod asked;
pub mod check;
pub mod claims;
pub mod compare;
pub mod drawn;
pub mod explain;
pub mod files;
pub mod init;
pub mod list;
pub mod progress;
pub mod recommend;
pub mod report;
pub mod run;
pub mod sources;
pub mod tables;
pub mod unsolved;

use slipgap::batch::whole::no_more_writing;
use slipgap::error::Error;
use slipgap::study::printable;
use std::io::{BufWriter, ErrorKind, Write, stderr, stdout};
use std::iter::repeat_n;

/// Exit code where a case could not be solved.
pub const UNSOLVED: u8 = 3;
/// Exit code where a check is not met.
pub const NOT_MET: u8 = 5;
/// Exit code after Ctrl-C.
const INTERRUPTED: i32 = 130;

/// Writes what was asked for to stdout, characters that command a terminal written out; a reader that has gone away is no failure.
pub fn say(text: &str) -> Result<u8, Error> {
    say_all([text])
}

/// The same piece by piece.
pub fn say_all(pieces: impl IntoIterator<Item = impl AsRef<str>>) -> Result<u8, Error> {
    let mut out = BufWriter::new(stdout().lock());
    let mut pieces = pieces.into_iter();
    let written = pieces.try_for_each(|piece| out.write_all(printable(piece.as_ref()).as_bytes()));
    match written.and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(Error::io("cannot write", "stdout")(e)),
        _ => Ok(0),
    }
}

/// Writes a line about the run to stderr; that nobody reads it stops nothing.
pub fn note(line: &str) {
    let _ = writeln!(stderr(), "{}", printable(line));
}

/// Says on stderr what went wrong; each fault of a study with its line and a caret.
pub fn tell(error: &Error) {
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

/// The threads to compute with: `jobs`, or one for each core.
pub fn pool(jobs: Option<u16>) -> Result<rayon::ThreadPool, Error> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(jobs.map_or(0, usize::from))
        .build()
        .map_err(|e| Error::Internal(format!("cannot start threads: {e}")))
}

/// Ends at once on Ctrl-C, with no file half-written.
pub fn end_on_interrupt() -> Result<(), Error> {
    ctrlc::set_handler(|| {
        let _guard = no_more_writing();
        note("slipgap: interrupted; all files are complete and finished parts are kept; run the same command again to continue");
        std::process::exit(INTERRUPTED);
    })
    .map_err(|e| Error::Internal(format!("cannot listen for Ctrl-C: {e}")))
}

/// Rows of text in columns, the first row being the header; control characters become spaces.
pub fn columns(rows: &[Vec<String>]) -> String {
    lines(|| rows.iter().cloned()).collect()
}

/// The same line by line, of rows that are made as they are asked for, twice: first for the widths.
pub fn lines<I: Iterator<Item = Vec<String>>>(
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
            // Not by a format's width, which ends at 65 535.
            line.push_str(&cell);
            line.extend(repeat_n(' ', width - cell.chars().count() + 2));
        }
        line.truncate(line.trim_end().len());
        line.push('\n');
        line
    })
}
