//! The results in a page, decoded from the description of the format without code of the program.

use super::packed::scripts;
use serde_json::Value as Json;

/// The first table of a page.
pub struct Data {
    pub head: Json,
    /// Name and cells of each column; `None` if a value is undefined.
    pub columns: Vec<(String, Vec<Option<Cell>>)>,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    Number(f64),
    Name(String),
}

pub fn data(page: &str) -> Data {
    let results = page
        .split_once("class=\"results\"")
        .expect("a table of results")
        .1;
    let scripts = scripts(results);
    let head: Json = serde_json::from_slice(&scripts[0]).unwrap();
    let mut bytes = &scripts[1][..];
    let rows = head["rows"].as_u64().unwrap() as usize;
    let mut columns = Vec::new();
    for column in head["columns"].as_array().unwrap() {
        let width = column["width"].as_u64().unwrap() as usize;
        let listed = column["listed"].as_u64().unwrap() as usize;
        let count = if width == 8 { rows } else { listed };
        let stored = match column["rounded"].as_bool().unwrap() {
            true => decimals(take(&mut bytes, 5 * count)),
            false => doubles(take(&mut bytes, 8 * count)),
        };
        let numbers = match width {
            0 => vec![stored[0]; rows],
            8 => stored,
            _ => {
                let index_of = |code: &[u8]| {
                    code.iter()
                        .rev()
                        .fold(0, |sum, byte| 256 * sum + usize::from(*byte))
                };
                take(&mut bytes, width * rows)
                    .chunks(width)
                    .map(|code| stored[index_of(code)])
                    .collect()
            }
        };
        assert_eq!(numbers.len(), rows);
        let names = column["names"].as_array().unwrap();
        let cell = |x: &f64| match names.is_empty() {
            true => Cell::Number(*x),
            false => Cell::Name(names[*x as usize].as_str().unwrap().to_owned()),
        };
        let cells = numbers.iter().map(|x| (!x.is_nan()).then(|| cell(x)));
        columns.push((column["name"].as_str().unwrap().to_owned(), cells.collect()));
    }
    assert!(bytes.is_empty());
    Data { head, columns }
}

/// The first bytes, which are removed.
fn take<'a>(bytes: &mut &'a [u8], count: usize) -> &'a [u8] {
    let (first, rest) = bytes.split_at(count);
    *bytes = rest;
    first
}

/// Numbers of three bytes of digits, with the sign in the highest bit, and two of the power of ten; equal bytes of all are together.
fn decimals(bytes: &[u8]) -> Vec<f64> {
    let count = bytes.len() / 5;
    let number = |i: usize| {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| bytes[k * count + i]);
        let digits = u32::from_le_bytes([a, b, c & 127, 0]);
        let size = match i16::from_le_bytes([d, e]) {
            i16::MAX if digits > 0 => f64::NAN,
            i16::MAX => f64::INFINITY,
            power => format!("{digits}e{power}").parse().unwrap(),
        };
        if c > 127 { -size } else { size }
    };
    (0..count).map(number).collect()
}

fn doubles(bytes: &[u8]) -> Vec<f64> {
    assert_eq!(bytes.len() % 8, 0);
    bytes
        .chunks(8)
        .map(|eight| f64::from_le_bytes(eight.try_into().unwrap()))
        .collect()
}

/// The bytes of a base64 text: six bits per letter, without incomplete bytes.
pub fn bytes(base64: &str) -> Vec<u8> {
    assert_eq!(base64.len() % 4, 0);
    let (mut bytes, mut bits, mut count) = (Vec::new(), 0_u32, 0);
    for letter in base64.trim_end_matches('=').bytes() {
        let six = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => panic!("{letter}"),
        };
        (bits, count) = (bits << 6 | u32::from(six), count + 6);
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count & 255) as u8);
        }
    }
    bytes
}
