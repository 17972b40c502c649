//! Numbers of record files, as Fortran and others write them.

use super::fault::{LineFault, RecordCause, Shown, fault};

/// A finite number, also with `D` before its exponent; else why not.
pub(in crate::system) fn number(text: &str) -> Result<f64, RecordCause> {
    match text.replace(['d', 'D'], "e").parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(RecordCause::NotFinite(Shown::new(text))),
        Err(_) => Err(RecordCause::NoNumber(Shown::new(text))),
    }
}

/// All numbers of the lines from `from` on, `count` of them; `source` says where the count is from.
pub(super) fn all(
    lines: &[&str],
    from: usize,
    count: f64,
    source: &str,
) -> Result<Vec<f64>, LineFault> {
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

/// The fields of a line.
///
/// Fortran fills a field of a fixed width, so that a minus may follow the number before it without a blank.
fn fields(line: &str) -> impl Iterator<Item = &str> {
    let fields = line.split(|c: char| c.is_whitespace() || c == ',');
    fields.flat_map(signed).filter(|text| !text.is_empty())
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
