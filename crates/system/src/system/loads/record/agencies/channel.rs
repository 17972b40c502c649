//! The channels of a file in the layout of CSMIP: lines of text, rows of 80 whole numbers or more, rows of numbers, then the data.

use super::super::fortran_number::{fields, number};

/// The parts of a channel, as indices of lines.
pub(super) struct Channel {
    /// First line of the text.
    pub text: usize,
    /// First row of whole numbers.
    pub whole: usize,
    /// First row of the numbers of the header.
    pub numbers: usize,
    /// First line behind them.
    pub data: usize,
}

/// Fewest whole numbers of the first row.
const FEWEST: usize = 10;

/// By so much the last row of the header's numbers is shorter than the first one: they are 50 or 100 in rows of 8.
const SHORTER: usize = 10;

/// The channels of a file.
pub(super) fn channels(lines: &[&str]) -> Vec<Channel> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(whole) = (from..lines.len()).find(|i| is_first_whole(lines[*i])) {
        let is_text = |i: &usize| !is_row(lines[*i]) && !lines[*i].starts_with("/&");
        let text = (from..whole).rev().take_while(is_text).last();
        let end = |from: usize, has: fn(&str) -> bool| {
            let mut rest = from..lines.len();
            rest.find(|i| !has(lines[*i])).unwrap_or(lines.len())
        };
        let numbers = end(whole, is_whole);
        let width = |i: usize| lines[i].trim_end().len();
        let rows = numbers..end(numbers, is_row);
        let last = rows.clone().find(|i| width(*i) + SHORTER <= width(numbers));
        let data = last.map_or(rows.end, |last| last + 1);
        found.push(Channel {
            text: text.unwrap_or(whole),
            whole,
            numbers,
            data,
        });
        from = data.max(whole + 1);
    }
    found
}

/// Whether a line has whole numbers only.
fn is_whole(line: &str) -> bool {
    let is_part = |c: u8| c.is_ascii_digit() || matches!(c, b' ' | b'-' | b'\t');
    line.bytes().all(is_part) && !line.trim().is_empty()
}

fn is_first_whole(line: &str) -> bool {
    is_whole(line) && line.split_whitespace().count() >= FEWEST
}

/// Whether a line has numbers only.
fn is_row(line: &str) -> bool {
    let mut fields = fields(line).peekable();
    fields.peek().is_some() && fields.all(|text| number(text).is_ok())
}
