//! Lines of markup set in the embedded font.

pub mod font;
pub mod markup;
pub mod number;
pub mod outline;

use crate::style::{SCRIPT, SUBSCRIPT_DROP, SUPERSCRIPT_RISE};
use markup::Set;

/// A piece of text in one face and size, placed relative to the beginning of its line.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The characters.
    pub text: String,
    /// Italic or upright.
    pub italic: bool,
    /// Type size.
    pub size: f64,
    /// Beginning along the line.
    pub x: f64,
    /// Height of the base line above that of the line, negative for subscripts.
    pub rise: f64,
}

/// The runs of a line of markup at a type size, and its length.
pub fn set(markup: &str, size: f64) -> (Vec<Run>, f64) {
    let mut runs = Vec::new();
    let mut x = 0.0;
    for piece in markup::parse(markup) {
        let (scale, rise) = match piece.set {
            Set::Roman | Set::Italic => (1.0, 0.0),
            Set::Subscript => (SCRIPT, -SUBSCRIPT_DROP),
            Set::Superscript => (SCRIPT, SUPERSCRIPT_RISE),
        };
        let italic = piece.set == Set::Italic;
        let (_, length) = font::set(&piece.text, italic);
        runs.push(Run {
            text: piece.text,
            italic,
            size: scale * size,
            x,
            rise: rise * size,
        });
        x += length * scale * size;
    }
    (runs, x)
}

/// The length of a line of markup at a type size.
pub fn width(markup: &str, size: f64) -> f64 {
    set(markup, size).1
}

/// A line of markup as lines of at most this length, each complete markup; a word alone may be longer.
pub fn wrap(markup: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words(markup) {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= room => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// The words of a line of markup; words inside a pair of marks stay together.
fn words(markup: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    // Other spaces than those of ASCII do not separate words.
    let mut rest: Vec<&str> = markup.split_ascii_whitespace().collect();
    let whole = |parts: &[&str]| markup::plain(&parts.join(" "));
    while !rest.is_empty() {
        let closed = |count: &usize| {
            let (word, behind) = rest.split_at(*count);
            format!("{} {}", whole(word), whole(behind)) == whole(&rest)
        };
        let count = (1..rest.len()).find(closed).unwrap_or(rest.len());
        words.push(rest[..count].join(" "));
        rest.drain(..count);
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_follow_one_another() {
        let (runs, length) = set("*X*_0_ = 12", 10.0);
        assert_eq!(runs.len(), 3);
        assert!(runs[0].italic && !runs[1].italic);
        assert_eq!(runs[1].size, 7.0);
        assert!(runs[1].rise < 0.0 && runs[2].rise == 0.0);
        assert!(runs[0].x < runs[1].x && runs[1].x < runs[2].x && runs[2].x < length);
        assert_eq!(width("", 10.0), 0.0);
    }
}
