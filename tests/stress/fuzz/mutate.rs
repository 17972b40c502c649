//! Studies changed at random: as text, byte by byte, and as tokens.

use crate::random_choice::RandomChoice;
use crate::words::{CHARACTERS, KEYS, NUMBERS, STRINGS};

/// The text with one to four changes.
pub fn mutated(text: &str, random: &mut RandomChoice) -> String {
    let mut text = text.to_owned();
    for _ in 0..=random.below(4) {
        text = match random.below(3) {
            0 => bytes(&text, random),
            _ => tokens(&text, random),
        };
    }
    text
}

/// Changes a byte, removes or repeats some bytes, inserts a character, or removes the end.
fn bytes(text: &str, random: &mut RandomChoice) -> String {
    let mut bytes = text.as_bytes().to_vec();
    if bytes.is_empty() {
        return text.to_owned();
    }
    let at = random.below(bytes.len());
    let end = (at + 1 + random.below(40)).min(bytes.len());
    match random.below(10) {
        0..4 => bytes[at] ^= 1 << random.below(8),
        4..6 => drop(bytes.drain(at..end)),
        6 => {
            let piece = bytes[at..end].to_vec();
            bytes.splice(at..at, piece);
        }
        7 => bytes.truncate(at),
        _ => {
            let character = random.of(&CHARACTERS);
            bytes.splice(at..at, character.bytes());
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Exchanges, removes or repeats tokens, or replaces them by others of the same kind.
fn tokens(text: &str, random: &mut RandomChoice) -> String {
    let mut tokens = split(text);
    let solid = |token: &&str| !token.trim().is_empty();
    let places: Vec<usize> = (0..tokens.len()).filter(|i| solid(&tokens[*i])).collect();
    if places.is_empty() {
        return text.to_owned();
    }
    let (a, b) = (
        places[random.below(places.len())],
        places[random.below(places.len())],
    );
    let mut quoted = String::new();
    match random.below(8) {
        0 => tokens.swap(a, b),
        1 => drop(tokens.remove(a)),
        2 => tokens.insert(a, tokens[b]),
        _ => {
            let numbers: Vec<usize> = kind(&tokens, |c| c.is_ascii_digit() || c == '-');
            let strings: Vec<usize> = kind(&tokens, |c| c == '"');
            if random.once_in(2) && !numbers.is_empty() {
                tokens[numbers[random.below(numbers.len())]] = random.of(&NUMBERS);
            } else if !strings.is_empty() {
                let words = if random.once_in(3) {
                    &KEYS[..]
                } else {
                    &STRINGS[..]
                };
                quoted = format!("\"{}\"", random.of(words));
                tokens[strings[random.below(strings.len())]] = &quoted;
            }
        }
    }
    let joined = tokens.concat();
    drop(quoted);
    joined
}

/// Indices of the tokens with such a first character.
fn kind(tokens: &[&str], begins: impl Fn(char) -> bool) -> Vec<usize> {
    let matches = |token: &str| token.chars().next().is_some_and(&begins);
    (0..tokens.len()).filter(|i| matches(tokens[*i])).collect()
}

/// Splits into strings, words, white space and other characters.
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

/// Length in bytes of the string at the beginning of a text.
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
