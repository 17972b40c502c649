//! Studies changed at random: as text, byte by byte, and as tokens.

use crate::chance::Chance;
use crate::words::{CHARACTERS, KEYS, NUMBERS, STRINGS};

/// The text with one to four changes.
pub fn mutated(text: &str, chance: &mut Chance) -> String {
    let mut text = text.to_owned();
    for _ in 0..=chance.below(4) {
        text = match chance.below(3) {
            0 => bytes(&text, chance),
            _ => tokens(&text, chance),
        };
    }
    text
}

/// A byte changed, a piece left out or repeated, a character put in, the end cut off.
fn bytes(text: &str, chance: &mut Chance) -> String {
    let mut bytes = text.as_bytes().to_vec();
    if bytes.is_empty() {
        return text.to_owned();
    }
    let at = chance.below(bytes.len());
    let end = (at + 1 + chance.below(40)).min(bytes.len());
    match chance.below(10) {
        0..4 => bytes[at] ^= 1 << chance.below(8),
        4..6 => drop(bytes.drain(at..end)),
        6 => {
            let piece = bytes[at..end].to_vec();
            bytes.splice(at..at, piece);
        }
        7 => bytes.truncate(at),
        _ => {
            let character = chance.of(&CHARACTERS);
            bytes.splice(at..at, character.bytes());
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Tokens exchanged, left out, repeated, or replaced by others of their kind.
fn tokens(text: &str, chance: &mut Chance) -> String {
    let mut tokens = split(text);
    let solid = |token: &&str| !token.trim().is_empty();
    let places: Vec<usize> = (0..tokens.len()).filter(|i| solid(&tokens[*i])).collect();
    if places.is_empty() {
        return text.to_owned();
    }
    let (a, b) = (
        places[chance.below(places.len())],
        places[chance.below(places.len())],
    );
    let mut quoted = String::new();
    match chance.below(8) {
        0 => tokens.swap(a, b),
        1 => drop(tokens.remove(a)),
        2 => tokens.insert(a, tokens[b]),
        _ => {
            let numbers: Vec<usize> = kind(&tokens, |c| c.is_ascii_digit() || c == '-');
            let strings: Vec<usize> = kind(&tokens, |c| c == '"');
            if chance.once_in(2) && !numbers.is_empty() {
                tokens[numbers[chance.below(numbers.len())]] = chance.of(&NUMBERS);
            } else if !strings.is_empty() {
                let words = if chance.once_in(3) {
                    &KEYS[..]
                } else {
                    &STRINGS[..]
                };
                quoted = format!("\"{}\"", chance.of(words));
                tokens[strings[chance.below(strings.len())]] = &quoted;
            }
        }
    }
    let joined = tokens.concat();
    drop(quoted);
    joined
}

/// Places of the tokens that begin in a way.
fn kind(tokens: &[&str], begins: impl Fn(char) -> bool) -> Vec<usize> {
    let fits = |token: &str| token.chars().next().is_some_and(&begins);
    (0..tokens.len()).filter(|i| fits(tokens[*i])).collect()
}

/// Strings, runs of letters and digits, blanks, and single other characters.
fn split(text: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let word = |c: char| c.is_ascii_alphanumeric() || "+-.".contains(c);
        let run = |of: &dyn Fn(char) -> bool| rest.find(|c| !of(c)).unwrap_or(rest.len());
        let length = match first {
            '"' => string_length(rest),
            c if word(c) => run(&word),
            c if c.is_whitespace() => run(&char::is_whitespace),
            c => c.len_utf8(),
        };
        let (token, after) = rest.split_at(length);
        tokens.push(token);
        rest = after;
    }
    tokens
}

/// Number of bytes of the string that a text begins with.
fn string_length(text: &str) -> usize {
    let mut escaped = false;
    for (i, c) in text.char_indices().skip(1) {
        match c {
            '"' if !escaped => return i + 1,
            '\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    text.len()
}
