//! Faults of record files in words.

use super::{RecordCause, Shown};
use std::fmt;

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
            RecordCause::EvenColumns(count) => write!(
                f,
                "{}, got {count}; of several columns without times give \"dt\" and \"column\"",
                wanted(false)
            ),
            RecordCause::ColumnOfNoTimes(t, last) => write!(
                f,
                "the times must rise, got {t} after {last}; column 1 has the times, a table without times needs \"dt\""
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
            RecordCause::ColumnOfTimes => f.write_str(
                "column 1 has the times; give another column, or \"dt\" if the table has no times",
            ),
            RecordCause::TwoChoices(format) => write!(
                f,
                "the file is {format}, which has columns and no components; give no component"
            ),
            RecordCause::OwnTimes => {
                f.write_str("the file has times of its own, which are not even; give no dt")
            }
            RecordCause::Channels(count, by, channels) => write!(
                f,
                "a row must have a number for each of the {channels} channels of {by}, got {count}"
            ),
            RecordCause::BlockEnds(numbers, source, count) => {
                write!(f, "the numbers end after {numbers}; {source} is {count}")
            }
            RecordCause::Peak(peak, by, stated) => {
                write!(f, "the largest acceleration is {peak}, but {by} is {stated}")
            }
            RecordCause::Ends(end, by, stated) => {
                write!(f, "the times end at {end}, but {by} is {stated}")
            }
            RecordCause::OneComponent(format) => {
                write!(
                    f,
                    "the file is {format}, which has one component; give none"
                )
            }
            RecordCause::Parts(key, names, wanted) => {
                let numbered = names.iter().enumerate();
                let names: Vec<String> =
                    numbered.map(|(i, name)| format!("{} {name}", i + 1)).collect();
                let wanted = wanted.map_or(String::new(), |number| format!(", got {number}"));
                let names = names.join(", ");
                write!(
                    f,
                    "\"{key}\" must be the number of one of the file's {key}s, {names}{wanted}"
                )
            }
            RecordCause::HeaderEnds(line) => write!(f, "the header needs line {line}"),
            RecordCause::Count(what, count) => {
                write!(f, "{what} must be a whole number >= 2, got {count}")
            }
            RecordCause::Unknown(table, others) => {
                let reasons = others.iter().map(|(name, why)| format!("{name} ({why})"));
                let others: Vec<String> = reasons.collect();
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

/// What a row must have; without times one number.
fn wanted(even: bool) -> &'static str {
    match even {
        false => "a row must have two numbers, t and a, with decimal points",
        true => "a row must have one number, a, with a decimal point, since \"dt\" is given",
    }
}
