//! Lines on stderr. On a terminal they wrap between words, and errors, warnings and notes begin with their word in colour; elsewhere a line is
//! one line, as other programs read it.

use crate::batch::WarnedCases;
use crate::study::printable;
use console::{Style, Term, measure_text_width};
use std::io::{IsTerminal, Write, stderr};

/// Columns below which nothing is wrapped.
const NARROWEST: usize = 40;

/// Blanks before the second line of a message without a word.
const INDENT: usize = 2;

/// The columns of the terminal; `None` if stderr is none, or a narrow one.
pub(super) fn width() -> Option<usize> {
    let (_, width) = Term::stderr().size_checked()?;
    let width = usize::from(width);
    (stderr().is_terminal() && width >= NARROWEST).then_some(width)
}

/// Writes a line to stderr as it is, at once: several processes may have the same stderr. A closed stderr is no error.
pub fn line(text: &str) {
    let text = format!("{}\n", printable(text));
    let _ = stderr().write_all(text.as_bytes());
}

/// Writes a line about the run to stderr.
pub fn note(text: &str) {
    match width() {
        Some(width) => line(&wrapped(text, width, 0, INDENT)),
        None => line(text),
    }
}

/// Writes a note on the input of a study.
pub fn input_note(text: &str) {
    labelled("note", text, || line(text));
}

/// Writes a warning about cases of a study; `begin` makes it begin with the file of the study.
pub fn warn(begin: impl Fn(&str) -> String, warned: &WarnedCases) {
    let rest = format!("{}; {}", warned.kind.name(), warned.example());
    let text = format!("{}\n{rest}", begin(&warned.sentence()));
    labelled(warned.word(), &text, || line(&begin(&warned.to_string())));
}

/// On a terminal, writes the paragraphs of a text after the word, in colour; elsewhere does what `plain` does.
pub fn labelled(word: &str, text: &str, plain: impl FnOnce()) {
    let Some(width) = width() else {
        return plain();
    };
    let style = Style::new().for_stderr().bold();
    let coloured = match word {
        "error" => style.red(),
        "warning" => style.yellow(),
        _ => style.cyan(),
    };
    let indent = word.len() + 2;
    let text = printable(text);
    let paragraphs: Vec<String> = text
        .lines()
        .map(|paragraph| wrapped(paragraph, width, indent, indent))
        .collect();
    let (label, next) = (coloured.apply_to(format!("{word}:")), " ".repeat(indent));
    let lines = paragraphs.join(&format!("\n{next}"));
    let _ = stderr().write_all(format!("{label} {lines}\n").as_bytes());
}

/// The text with line breaks between words, so that no line is wider than `width`, unless a word is. `used` columns of the first
/// line are taken; the others begin with so many blanks.
fn wrapped(text: &str, width: usize, used: usize, indent: usize) -> String {
    let (mut lines, mut column) = (String::new(), used);
    for (i, word) in text.split(' ').enumerate() {
        let wide = measure_text_width(word);
        if i > 0 && column + 1 + wide > width {
            lines.push('\n');
            lines.push_str(&" ".repeat(indent));
            column = indent;
        } else if i > 0 {
            lines.push(' ');
            column += 1;
        }
        lines.push_str(word);
        column += wide;
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_between_words_and_lose_none() {
        let text = "s.json: 3 of 40 cases have an impact that touches for fewer than 6 steps";
        for width in [20, 30, 79] {
            let lines = wrapped(text, width, 9, 4);
            let widths = lines.lines().enumerate();
            for (i, line) in widths {
                let used = if i == 0 { 9 } else { 0 };
                assert!(line.chars().count() + used <= width, "{width}: {lines}");
                assert!(i == 0 || line.starts_with("    "), "{lines}");
            }
            let words: Vec<&str> = lines.split_whitespace().collect();
            assert_eq!(words.join(" "), text);
        }
        // A path is not cut.
        assert_eq!(wrapped("a bbbbbb c", 5, 0, 2), "a\n  bbbbbb\n  c");
    }
}
