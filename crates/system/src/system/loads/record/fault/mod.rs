//! Faults of record files.

mod messages;

use std::fmt;

/// Why a file is no record: displayed as `FILE:LINE: MESSAGE`.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordFault {
    /// The file.
    pub name: String,
    /// Line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub cause: RecordCause,
}

impl fmt::Display for RecordFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.name, self.line, self.cause)
    }
}

impl std::error::Error for RecordFault {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.cause)
    }
}

/// What is wrong with a line of a record: displayed with what is allowed.
#[derive(Debug, Clone, PartialEq)]
pub enum RecordCause {
    /// A text instead of a number.
    NoNumber(Shown),
    /// A number that is not finite.
    NotFinite(Shown),
    /// A measured number whose square could overflow.
    Bounds(Shown),
    /// More numbers than the header has, which is from this source.
    MoreNumbers(String, f64),
    /// So many numbers, less than the header has, which is from this source.
    FewerNumbers(usize, String, f64),
    /// Less than two numbers.
    OneNumber,
    /// A time series of another quantity than acceleration.
    Quantity(&'static str),
    /// No numbers for NPTS and DT.
    NoCounts,
    /// An NPTS that is no whole number >= 2.
    Npts(f64),
    /// A DT that is not > 0, or too large.
    Dt(f64),
    /// No row of so many numbers.
    NoRow(usize),
    /// One row of two numbers.
    OneRow,
    /// A row with so many numbers, without the wanted column; or without a wanted one, but with more than one acceleration. The last
    /// one says whether the rows have no times.
    Fields(usize, Option<usize>, bool),
    /// A row with so many numbers, which are no columns; or one without times.
    Row(usize, bool),
    /// Rows with so many numbers that look like one series; or without times.
    Series(usize, bool),
    /// Rows with so many numbers, the first ones of which are no times.
    EvenColumns(usize),
    /// A time that is not after the one before it, in a table of which a column is wanted.
    ColumnOfNoTimes(f64, f64),
    /// Rows with so many numbers of one series where a column is wanted.
    Wrapped(usize),
    /// A row with so many numbers, the first one with so many in this line.
    Ragged(usize, usize, usize),
    /// So many rows, but the header states, there, so many.
    Rows(usize, String, f64),
    /// Times that are so far apart, but the header states another step, there.
    Steps(f64, String, f64),
    /// No times; the header states a time step, there.
    NoTimes(f64, String),
    /// A time step of the study, that of the file, and where it is stated.
    Contradicts(f64, f64, String),
    /// A column other than the first of a file in this format, whose rows are one series.
    OneColumn(&'static str, usize),
    /// Numbers behind the line that says that they end.
    AfterEnd(usize),
    /// The wanted column has the times.
    ColumnOfTimes,
    /// A component of a file in this format, which has columns.
    TwoChoices(&'static str),
    /// A component of a file in this format, which has one.
    OneComponent(&'static str),
    /// None of these parts is wanted by the key, or one that is not there.
    Parts(&'static str, Vec<Shown>, Option<usize>),
    /// A time step for a file with times of its own.
    OwnTimes,
    /// A row with so many numbers, but the header has, there, so many channels.
    Channels(usize, String, usize),
    /// So many numbers before other lines, less than the header has, which is from this source.
    BlockEnds(usize, String, f64),
    /// The largest acceleration, but the header states another, there.
    Peak(f64, String, f64),
    /// The last time, but the header states another duration, there.
    Ends(f64, String, f64),
    /// The header ends before this line.
    HeaderEnds(usize),
    /// A number of something that is no whole number >= 2.
    Count(&'static str, f64),
    /// The file is no table, for this reason, and in no other format, for those.
    Unknown(Box<RecordCause>, Vec<(&'static str, &'static str)>),
    /// A time that is not after the one before it.
    Time {
        /// The time.
        t: f64,
        /// The one before it.
        last: f64,
    },
    /// A header of another length than that of K-NET.
    Header,
    /// No line of the header that begins with this label.
    NoLine(&'static str),
    /// A number of the line with this label that is not > 0.
    NotPositive(&'static str, f64),
    /// A scale factor of another form.
    Scale(Shown),
    /// Times or accelerations beyond the range of numbers.
    TooLarge,
    /// No line with the names of the columns.
    NoNames,
    /// No column of this name; the names that there are.
    NoColumn(Shown, Vec<Shown>),
    /// Two columns of this name.
    TwoColumns(Shown),
    /// A row with so many fields, instead of one for each of so many names.
    Cells(usize, usize),
    /// What is wrong with the number of this column.
    InColumn(Shown, Box<RecordCause>),
    /// No number.
    Missing,
    /// A number with a decimal comma.
    DecimalComma(Shown),
}

impl std::error::Error for RecordCause {}

impl RecordCause {
    /// The key of the study that the file contradicts.
    pub fn key(&self) -> Option<&'static str> {
        if matches!(self, RecordCause::Contradicts(..) | RecordCause::OwnTimes) {
            return Some("dt");
        }
        let of_component = matches!(
            self,
            RecordCause::TwoChoices(_)
                | RecordCause::OneComponent(_)
                | RecordCause::Parts("component", _, Some(_))
        );
        let of_column = matches!(
            self,
            RecordCause::OneColumn(..)
                | RecordCause::Parts("column", _, Some(_))
                | RecordCause::Fields(_, Some(_), _)
                | RecordCause::Wrapped(_)
        );
        [("component", of_component), ("column", of_column)]
            .into_iter()
            .find_map(|(key, is_own)| is_own.then_some(key))
    }

    /// Whether it is about rows that are not those of a table.
    pub(super) fn is_of_rows(&self) -> bool {
        matches!(
            self,
            RecordCause::NoRow(_)
                | RecordCause::Fields(..)
                | RecordCause::Row(..)
                | RecordCause::Series(..)
                | RecordCause::EvenColumns(_)
        )
    }
}

/// What the header of a file says otherwise than its numbers: displayed as `line LINE: MESSAGE`.
#[derive(Debug, Clone, PartialEq)]
pub struct Doubt {
    /// Line, from 1.
    pub line: usize,
    /// What differs.
    pub cause: RecordCause,
}

impl Doubt {
    /// In the line with this index, from 0.
    pub(super) fn new(index: usize, cause: RecordCause) -> Doubt {
        let line = index + 1;
        Doubt { line, cause }
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.cause)
    }
}

/// The start of a text of a file: displayed in quotes on one line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shown(String);

impl Shown {
    /// Of a text, of any length.
    pub(in crate::system) fn new(text: &str) -> Shown {
        Shown(text.chars().take(30).collect())
    }
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.0.escape_debug())
    }
}

/// A fault with its line, from 1, in a file without a name.
#[derive(Debug)]
pub(super) struct LineFault {
    pub line: usize,
    pub cause: RecordCause,
}

/// A fault in the line with this index, from 0.
pub(super) fn fault(index: usize, cause: RecordCause) -> LineFault {
    LineFault {
        line: index + 1,
        cause,
    }
}
