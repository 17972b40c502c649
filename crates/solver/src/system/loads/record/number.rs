//! Numbers of record files, as Fortran and others write them.

use super::{LineFault, fault, shown};

/// A finite number, also with `D` before its exponent; else why not.
pub(super) fn number(text: &str) -> Result<f64, String> {
    match text.replace(['d', 'D'], "e").parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(format!("not a finite number: {}", shown(text))),
        Err(_) => Err(format!("not a number: {}", shown(text))),
    }
}

/// All numbers of the lines from `from` on, `count` of them; `source` says where the count is from.
///
/// Fortran fills a field of a fixed width, so that a minus may follow the number before it without a blank.
pub(super) fn all(
    lines: &[&str],
    from: usize,
    count: f64,
    source: &str,
) -> Result<Vec<f64>, LineFault> {
    let mut numbers = Vec::new();
    for (index, line) in lines.iter().enumerate().skip(from) {
        let fields = line.split(|c: char| c.is_whitespace() || c == ',');
        for text in fields.flat_map(signed).filter(|text| !text.is_empty()) {
            if numbers.len() as f64 >= count {
                let message = format!("more numbers than {source}, {count}");
                return Err(fault(index, message));
            }
            numbers.push(number(text).map_err(|message| fault(index, message))?);
        }
    }
    if (numbers.len() as f64) < count {
        let message = format!(
            "the file ends after {} numbers; {source} is {count}",
            numbers.len()
        );
        return Err(fault(super::end(lines), message));
    }
    Ok(numbers)
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
