//! Faults of record files.

use super::foreign::Looks;
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
    /// The same where a column is wanted.
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
    /// A known format that is not read.
    Foreign(Box<Looks>),
    /// The wanted column has the times.
    ColumnOfTimes,
    /// Columns and components together.
    TwoChoices,
    /// A component of a file in this format, which has one.
    OneComponent(&'static str),
    /// None of these components is wanted, or one that is not there.
    Components(Vec<Shown>, Option<usize>),
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

impl fmt::Display for RecordCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RecordCause::NoNumber(text) => write!(f, "not a number: {text}"),
            RecordCause::NotFinite(text) => write!(f, "not a finite number: {text}"),
            RecordCause::Bounds(text) => write!(f, "must be from -1e100 to 1e100, got {text}"),
            RecordCause::MoreNumbers(source, count) => {
                write!(f, "more numbers than {source}, {count}")
            }
            RecordCause::FewerNumbers(numbers, source, count) => {
                write!(
                    f,
                    "the file ends after {numbers} numbers; {source} is {count}"
                )
            }
            RecordCause::OneNumber => f.write_str("a record needs two or more numbers"),
            RecordCause::Quantity(other) => {
                write!(f, "the file has a {other}; it must have an acceleration")
            }
            RecordCause::NoCounts => f.write_str(
                "needs NPTS and DT with a number each, as in \"NPTS= 4000, DT= .005 SEC\"",
            ),
            RecordCause::Npts(npts) => write!(f, "NPTS must be a whole number >= 2, got {npts}"),
            RecordCause::Dt(dt) => write!(f, "DT must be > 0 and finite, got {dt}"),
            RecordCause::NoRow(1) => f.write_str("the file has no row of numbers"),
            RecordCause::NoRow(_) => f.write_str(
                "the file has no row of two numbers, t and a; if it has no times, give \"dt\"",
            ),
            RecordCause::OneRow => {
                f.write_str("the file has one row of numbers; a record needs two or more")
            }
            RecordCause::Fields(count, Some(column), _) => {
                write!(f, "a row needs {column} numbers or more, got {count}")
            }
            RecordCause::Fields(count, None, even) => write!(
                f,
                "{}, got {count}; of several columns give \"column\"",
                wanted(*even)
            ),
            RecordCause::Row(count, even) => write!(f, "{}, got {count}", wanted(*even)),
            RecordCause::Series(count, even) => write!(
                f,
                "{}, got {count}; the rows look like one series of numbers, not like columns: write one number a line{}",
                wanted(*even),
                if *even { "" } else { ", and give \"dt\"" }
            ),
            RecordCause::Wrapped(count) => write!(
                f,
                "the rows look like one series in rows of {count} numbers, not like columns: write one number a line; columns need a line with their names before them"
            ),
            RecordCause::Ragged(count, first, line) => write!(
                f,
                "a row must have as many numbers as that of line {line}, {first}, got {count}; if the rows are one series, write one number a line"
            ),
            RecordCause::Rows(rows, by, count) => {
                write!(f, "the table has {rows} rows, but {by} is {count}")
            }
            RecordCause::Steps(step, by, stated) => {
                write!(f, "the times are {step} apart, but {by} is {stated}")
            }
            RecordCause::NoTimes(step, by) => write!(
                f,
                "the file has no row of two numbers, t and a; {by} states a time step: give \"dt\": {step}"
            ),
            RecordCause::Contradicts(dt, stated, by) => {
                write!(f, "dt is {dt}, but {stated} by {by}; give {stated}")
            }
            RecordCause::OneColumn(format, column) => write!(
                f,
                "the file is {format}, whose rows are one series, which is column 1; give 1 or no column, got {column}"
            ),
            RecordCause::AfterEnd(line) => write!(
                f,
                "numbers after line {line}, which says that they end; a file must have one record"
            ),
            RecordCause::Foreign(looks) => {
                let marks = looks.marks.iter().map(|mark| format!("\"{mark}\""));
                let marks: Vec<String> = marks.collect();
                write!(
                    f,
                    "the file looks like {}, by {}; this format is not read, {}: write the accelerations as a table, t and a in two columns, or a alone with \"dt\", and give \"unit\"",
                    looks.name,
                    marks.join(", "),
                    looks.rows
                )
            }
            RecordCause::ColumnOfTimes => f.write_str(
                "column 1 has the times; give another column, or \"dt\" if the table has no times",
            ),
            RecordCause::TwoChoices => f.write_str(
                "the file is a table, which has columns and no components; give no component",
            ),
            RecordCause::OneComponent(format) => {
                write!(
                    f,
                    "the file is {format}, which has one component; give none"
                )
            }
            RecordCause::Components(names, wanted) => {
                let names = names.iter().enumerate();
                let names: Vec<String> =
                    names.map(|(i, name)| format!("{} {name}", i + 1)).collect();
                let wanted = wanted.map_or(String::new(), |number| format!(", got {number}"));
                let names = names.join(", ");
                write!(
                    f,
                    "\"component\" must be the number of one of the file's components, {names}{wanted}"
                )
            }
            RecordCause::HeaderEnds(line) => write!(f, "the header needs line {line}"),
            RecordCause::Count(what, count) => {
                write!(f, "{what} must be a whole number >= 2, got {count}")
            }
            RecordCause::Unknown(table, others) => {
                let others = others.iter().map(|(name, why)| format!("{name} ({why})"));
                let others: Vec<String> = others.collect();
                write!(
                    f,
                    "{table}; the file is in no other format, either: {}",
                    others.join(", ")
                )
            }
            RecordCause::Time { t, last } => {
                write!(f, "the times must rise, got {t} after {last}")
            }
            RecordCause::Header => {
                f.write_str("a K-NET header must have 17 lines, the last one \"Memo.\"")
            }
            RecordCause::NoLine(label) => write!(f, "the header needs the line \"{label}\""),
            RecordCause::NotPositive(label, number) => {
                write!(f, "{label} must be > 0, got {number}")
            }
            RecordCause::Scale(text) => write!(
                f,
                "the scale factor must have the form \"a(gal)/b\", got {text}"
            ),
            RecordCause::TooLarge => {
                f.write_str("the numbers are too large with this frequency and scale factor")
            }
            RecordCause::NoNames => f.write_str(
                "the file must begin with a line of names, one for each column; only lines with # may be before it",
            ),
            RecordCause::NoColumn(name, names) => {
                let names: Vec<String> = names.iter().map(Shown::to_string).collect();
                write!(f, "no column {name}; the columns are {}", names.join(", "))
            }
            RecordCause::TwoColumns(name) => {
                write!(f, "two columns have the name {name}; each needs one of its own")
            }
            RecordCause::Cells(count, names) => {
                write!(f, "a row must have a number for each of the {names} columns, got {count}")
            }
            RecordCause::InColumn(name, cause) => write!(f, "column {name}: {cause}"),
            RecordCause::Missing => f.write_str("a number is missing"),
            RecordCause::DecimalComma(text) => {
                write!(f, "numbers must have decimal points, got {text}")
            }
        }
    }
}

impl std::error::Error for RecordCause {}

impl RecordCause {
    /// The key of the study that the file contradicts.
    pub fn key(&self) -> Option<&'static str> {
        if matches!(self, RecordCause::Contradicts(..)) {
            return Some("dt");
        }
        let of_component = matches!(self, RecordCause::TwoChoices | RecordCause::OneComponent(_));
        let of_column = matches!(
            self,
            RecordCause::OneColumn(..)
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
        )
    }
}

/// What a row must have; without times one number.
fn wanted(even: bool) -> &'static str {
    match even {
        false => "a row must have two numbers, t and a, with decimal points",
        true => "a row must have one number, a, with a decimal point, since \"dt\" is given",
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
