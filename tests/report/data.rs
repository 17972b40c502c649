//! The results in a page, decoded from the description of the format without code of the program.

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
    let (head, rest) = cut(page, "<script type=\"application/json\">");
    let head: Json = serde_json::from_str(head).unwrap();
    let rows = head["rows"].as_u64().unwrap() as usize;
    let mut rest = rest;
    let mut columns = Vec::new();
    for column in head["columns"].as_array().unwrap() {
        let text;
        (text, rest) = cut(rest, "<script type=\"text/plain\">");
        let width = column["width"].as_u64().unwrap() as usize;
        let list = doubles(&bytes(column["list"].as_str().unwrap()));
        let numbers = match width {
            0 => {
                assert_eq!((text, list.len()), ("", 1));
                vec![list[0]; rows]
            }
            8 => doubles(&bytes(text)),
            _ => {
                let place = |code: &[u8]| {
                    code.iter()
                        .rev()
                        .fold(0, |sum, byte| 256 * sum + usize::from(*byte))
                };
                bytes(text)
                    .chunks(width)
                    .map(|code| list[place(code)])
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
    Data { head, columns }
}

/// The content of the first element with this start tag, and the text after it.
fn cut<'a>(page: &'a str, begin: &str) -> (&'a str, &'a str) {
    let after = page.split_once(begin).expect("a script of the data").1;
    after.split_once("</script>").unwrap()
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
