//! Numbers of record files, as Fortran and others write them.

use super::fault::{LineFault, RecordCause, Shown, fault};
use super::file_text::is_end;

/// A number of a header.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stated {
    /// The number; of a sampling rate the time step.
    pub value: f64,
    /// Its label.
    pub by: String,
    /// Index of its line.
    pub line: usize,
}

impl Stated {
    /// Where it is.
    pub(super) fn place(&self) -> String {
        format!("{} of line {}", self.by, self.line + 1)
    }

    /// A number with its label and the index of its line.
    pub(super) fn new(value: f64, by: &str, line: usize) -> Stated {
        let by = by.to_owned();
        Stated { value, by, line }
    }
}

/// A finite number, also with `D` before its exponent; else why not.
pub(in crate::system) fn number(text: &str) -> Result<f64, RecordCause> {
    match text.replace(['d', 'D'], "e").parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(RecordCause::NotFinite(Shown::new(text))),
        Err(_) => Err(RecordCause::NoNumber(Shown::new(text))),
    }
}

/// A number of a table; else why not, also that it has a decimal comma.
pub(in crate::system) fn decimal(text: &str) -> Result<f64, RecordCause> {
    number(text).map_err(|cause| match number(&text.replacen(',', ".", 1)) {
        Ok(_) => RecordCause::DecimalComma(Shown::new(text)),
        Err(_) => cause,
    })
}

/// All numbers of the lines from `from` on, `count` of them; `source` says where the count is from.
pub(super) fn all(
    lines: &[&str],
    from: usize,
    count: f64,
    source: &str,
) -> Result<Vec<f64>, LineFault> {
    let lines = before_end(lines)?;
    let mut numbers = Vec::new();
    for (index, line) in lines.iter().enumerate().skip(from) {
        for text in fields(line) {
            if numbers.len() as f64 >= count {
                let more = RecordCause::MoreNumbers(source.to_owned(), count);
                return Err(fault(index, more));
            }
            numbers.push(number(text).map_err(|cause| fault(index, cause))?);
        }
    }
    enough(numbers, lines, count, source)
}

/// The first `count` numbers of the lines from `from` on; what is behind their last line is not read.
pub(super) fn first(
    lines: &[&str],
    from: usize,
    count: f64,
    source: &str,
) -> Result<Vec<f64>, LineFault> {
    let mut numbers = Vec::new();
    let mut end = lines.len();
    for (index, line) in lines.iter().enumerate().skip(from) {
        if numbers.len() as f64 >= count {
            end = index;
            break;
        }
        for text in fields(line) {
            numbers.push(number(text).map_err(|cause| fault(index, cause))?);
        }
    }
    if numbers.len() as f64 > count {
        let more = RecordCause::MoreNumbers(source.to_owned(), count);
        return Err(fault(end - 1, more));
    }
    enough(numbers, lines, count, source)
}

/// All numbers of `count` lines.
pub(super) fn table(lines: &[&str], from: usize, count: usize) -> Result<Vec<f64>, LineFault> {
    let mut numbers = Vec::new();
    for index in from..from + count {
        let Some(line) = lines.get(index) else {
            return Err(fault(super::end(lines), RecordCause::HeaderEnds(index + 1)));
        };
        for text in fields(line) {
            numbers.push(number(text).map_err(|cause| fault(index, cause))?);
        }
    }
    Ok(numbers)
}

/// The numbers if they are enough.
fn enough(
    numbers: Vec<f64>,
    lines: &[&str],
    count: f64,
    source: &str,
) -> Result<Vec<f64>, LineFault> {
    if numbers.len() as f64 >= count {
        return Ok(numbers);
    }
    let fewer = RecordCause::FewerNumbers(numbers.len(), source.to_owned(), count);
    Err(fault(super::end(lines), fewer))
}

/// The lines before the one that says that the numbers end, if there is one; no numbers follow it.
pub(super) fn before_end<'a, 'b>(lines: &'a [&'b str]) -> Result<&'a [&'b str], LineFault> {
    let Some(end) = lines.iter().position(|line| is_end(line)) else {
        return Ok(lines);
    };
    let is_row = |line: &&str| {
        let mut fields = fields(line).peekable();
        fields.peek().is_some() && fields.all(|text| number(text).is_ok())
    };
    match lines[end..].iter().position(is_row) {
        Some(more) => Err(fault(end + more, RecordCause::AfterEnd(end + 1))),
        None => Ok(&lines[..end]),
    }
}

/// `count` numbers from the line `from` on; a line of words ends them, and no number is behind the last one.
pub(super) fn block(
    lines: &[&str],
    from: usize,
    count: f64,
    source: &str,
) -> Result<Vec<f64>, LineFault> {
    let rest = lines.get(from..).unwrap_or_default();
    let length = rest.iter().position(|line| is_words(line));
    let numbers = all(&rest[..length.unwrap_or(rest.len())], 0, count, source);
    numbers.map_err(|LineFault { line, cause }| {
        let cause = if let RecordCause::FewerNumbers(numbers, source, count) = cause {
            RecordCause::BlockEnds(numbers, source, count)
        } else {
            cause
        };
        fault(from + line - 1, cause)
    })
}

/// Whether a line has a word, or begins as the end of a block, `/&`.
fn is_words(line: &str) -> bool {
    let begins = |word: &str| {
        word.starts_with(|c: char| c.is_alphabetic() || c == '/') && word.parse::<f64>().is_err()
    };
    line.split_whitespace().any(begins)
}

/// The fields of a line.
///
/// Fortran fills a field of a fixed width, so that a minus may follow the number before it without a blank.
pub(super) fn fields(line: &str) -> impl Iterator<Item = &str> {
    let fields = line.split(|c: char| c.is_whitespace() || c == ',');
    fields
        .flat_map(signed)
        .flat_map(pointed)
        .filter(|text| !text.is_empty())
}

/// The numbers of a text with several points, as Fortran writes them in full fields: each with as many decimals as the last one, two or
/// more.
fn pointed(text: &str) -> impl Iterator<Item = &str> {
    let decimals = text.rsplit_once('.').map_or(0, |parts| parts.1.len());
    let mut rest = text;
    std::iter::from_fn(move || {
        let point = rest.find('.').filter(|_| decimals > 1);
        let cut = point.map(|point| point + 1 + decimals);
        let is_whole = |cut: &usize| {
            let of_decimals = rest.as_bytes().get(cut - decimals..*cut);
            let digits = of_decimals.is_some_and(|bytes| bytes.iter().all(u8::is_ascii_digit));
            digits && rest[*cut..].contains('.')
        };
        let cut = cut.filter(is_whole).unwrap_or(rest.len());
        let (number, behind) = rest.split_at(cut);
        rest = behind;
        (!number.is_empty()).then_some(number)
    })
}

/// The parts of a field, each but the first one from a sign that follows a digit or a point.
fn signed(field: &str) -> impl Iterator<Item = &str> {
    let bytes = field.as_bytes();
    let starts = (1..bytes.len()).filter(|i| {
        matches!(bytes[*i], b'+' | b'-') && matches!(bytes[*i - 1], b'0'..=b'9' | b'.')
    });
    let mut from = 0;
    let ends = starts.chain([field.len()]);
    ends.map(move |end| &field[std::mem::replace(&mut from, end)..end])
}
