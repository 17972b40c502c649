//! The fields of a line of a table.

use super::super::fault::{RecordCause, Shown};
use super::super::fortran_number::{fields, number};

/// The character that separates the fields of a line: a semicolon before a comma; none if blanks do.
pub(super) fn separator(line: &str) -> Option<char> {
    [';', ','].into_iter().find(|by| line.contains(*by))
}

/// The fields between separators, or between blanks. A separator within a field that is in quotes does not count.
pub(in crate::system) fn split(line: &str, by: Option<char>) -> Vec<&str> {
    let (mut in_quotes, mut begins) = (false, true);
    let pieces = line.split(|c: char| {
        if in_quotes {
            in_quotes = c != '"';
            return false;
        }
        in_quotes = begins && c == '"';
        let ends = by.map_or(c.is_whitespace(), |by| c == by);
        begins = ends || begins && c.is_whitespace();
        ends
    });
    let fields = pieces.map(str::trim);
    fields
        .filter(|field| by.is_some() || !field.is_empty())
        .collect()
}

/// The fields of a row without their quotes; a separator may also end it.
pub(super) fn cells(line: &str) -> Vec<&str> {
    let line = line.trim();
    let by = separator(line);
    let line = by.and_then(|by| line.strip_suffix(by)).unwrap_or(line);
    let cells = split(line, by).into_iter().map(bare);
    match by {
        Some(_) => cells.collect(),
        None => cells.flat_map(apart).collect(),
    }
}

/// The numbers of a cell that Fortran has filled, such as `0.005-0.123`: if it has several and each has a point, as no date has.
fn apart(cell: &str) -> Vec<&str> {
    let numbers: Vec<&str> = fields(cell).collect();
    let is_number = |text: &&str| text.contains('.') && number(text).is_ok();
    match numbers.len() > 1 && numbers.iter().all(is_number) {
        true => numbers,
        false => vec![cell],
    }
}

/// A field without the quotes around it.
pub(in crate::system) fn bare(field: &str) -> &str {
    let inner = field
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'));
    inner.map_or(field, str::trim)
}

/// The fault of a row whose commas are those of numbers: between blanks (`0,01 1,5`), or with digits behind them that no whole number
/// has (`0,002`).
pub(super) fn decimal_comma(line: &str) -> Option<RecordCause> {
    let line = line.trim();
    if line.contains([';', '.', '"']) || !line.contains(',') {
        return None;
    }
    let words: Vec<&str> = line.split_whitespace().collect();
    let is_number = |word: &&str| number(word).is_ok() || has_comma(word);
    let between_blanks = words.len() > 1 && words.iter().all(is_number);
    let shown = words
        .iter()
        .find(|word| has_comma(word))
        .filter(|_| between_blanks);
    if let Some(word) = shown {
        return Some(RecordCause::DecimalComma(Shown::new(word)));
    }
    let fields: Vec<&str> = line.split(',').collect();
    let is_fraction = |text: &str| {
        let digits = text.bytes().take_while(u8::is_ascii_digit).count();
        digits > 1 && text.starts_with('0')
    };
    let pair = fields.windows(2).find(|pair| is_fraction(pair[1]))?;
    let text = format!("{},{}", pair[0].trim(), pair[1].trim());
    number(&text.replace(',', ".")).ok()?;
    Some(RecordCause::DecimalComma(Shown::new(&text)))
}

/// Whether a text is a number with one comma and digits behind it.
fn has_comma(text: &str) -> bool {
    let digit = |rest: &str| rest.starts_with(|c: char| c.is_ascii_digit());
    text.split_once(',').is_some_and(|(_, rest)| digit(rest))
        && number(&text.replacen(',', ".", 1)).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_without_a_blank_are_apart_and_dates_are_not() {
        for (line, expected) in [
            (
                "0.005-0.123-4.5E-02+1.",
                &["0.005", "-0.123", "-4.5E-02", "+1."][..],
            ),
            (
                "  9.990-10.123100.000  1.5",
                &["9.990", "-10.123", "100.000", "1.5"],
            ),
            ("1.0E-02-2.0", &["1.0E-02", "-2.0"]),
            ("-.25-.5D+01", &["-.25", "-.5D+01"]),
            (
                "2000-01-01 12.05.2010 1.2-b",
                &["2000-01-01", "12.05.2010", "1.2-b"],
            ),
            ("0.5-0.25,1", &["0.5-0.25", "1"]),
        ] {
            assert_eq!(cells(line), expected);
        }
    }

    #[test]
    fn a_separator_in_quotes_is_part_of_its_field() {
        let of = |line| split(line, separator(line));
        assert_eq!(of("t, u ,,S"), ["t", "u", "", "S"]);
        assert_eq!(of("  t\t u  S"), ["t", "u", "S"]);
        assert_eq!(of("1,5; 2"), ["1,5", "2"]);
        assert_eq!(of("t, \"u, left\" ,S"), ["t", "\"u, left\"", "S"]);
        assert_eq!(of("t \"u left\" S"), ["t", "\"u left\"", "S"]);
        // A quote within a field is an inch.
        assert_eq!(of("u (\"),S (\")"), ["u (\")", "S (\")"]);
        assert_eq!(split("a\tb c\t", Some('\t')), ["a", "b c", ""]);
    }
}
