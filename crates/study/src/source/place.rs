//! Line and column of byte offsets, and the line of a text with a mark under the column.

use slipgap_problem::problem::expression::is_plain;

/// A position in a text with its line and column. Offsets in rising order need one pass over the text.
pub struct Place<'a> {
    text: &'a str,
    offset: usize,
    line: usize,
    column: usize,
}

impl<'a> Place<'a> {
    /// The first character.
    pub fn start(text: &'a str) -> Place<'a> {
        Place {
            text,
            offset: 0,
            line: 1,
            column: 1,
        }
    }

    /// Line and column of the character at byte `offset`, both from 1, in characters; an offset past the end is the end.
    pub fn at(&mut self, offset: usize) -> (usize, usize) {
        if offset < self.offset {
            *self = Place::start(self.text);
        }
        for c in self.text[self.offset..].chars() {
            if self.offset >= offset {
                break;
            }
            self.offset += c.len_utf8();
            if c == '\n' {
                self.line += 1;
                self.column = 1;
            } else {
                self.column += 1;
            }
        }
        (self.line, self.column)
    }
}

/// The texts that the offsets of faults refer to: a file and the settings of the command line. Each begins one byte after the
/// end of the text before.
pub struct Texts<'a>(Vec<Part<'a>>);

/// One of them.
struct Part<'a> {
    name: String,
    text: &'a str,
    start: usize,
    place: Place<'a>,
}

impl<'a> Texts<'a> {
    /// A file without settings.
    pub fn new(name: &str, text: &'a str) -> Texts<'a> {
        let mut texts = Texts(Vec::new());
        texts.push(name.to_owned(), text);
        texts
    }

    /// Adds a text and gives the offset of its first byte.
    pub fn push(&mut self, name: String, text: &'a str) -> usize {
        let end = |last: &Part| last.start + last.text.len() + 1;
        let start = self.0.last().map_or(0, end);
        let first = Place::start(text);
        self.0.push(Part {
            name,
            text,
            start,
            place: first,
        });
        start
    }

    /// The name and text that hold byte `offset`, with its line and column.
    pub fn at(&mut self, offset: usize) -> (&str, &'a str, usize, usize) {
        let last = self.0.iter().rposition(|part| part.start <= offset);
        let part = &mut self.0[last.unwrap_or(0)];
        let (line, column) = part.place.at(offset - part.start);
        (&part.name, part.text, line, column)
    }
}

/// Most characters of a line that are shown.
const WIDEST: usize = 100;

/// Number of them before the place.
const BEFORE: usize = 60;

/// Line `line` of a text and a caret below character `column`. Of a long line, only the part around the column.
pub fn shown(text: &str, line: usize, column: usize) -> String {
    let full = text.lines().nth(line - 1).unwrap_or_default();
    let count = full.chars().count();
    let start = match count > WIDEST {
        true => (column - 1).saturating_sub(BEFORE),
        false => 0,
    };
    // A character that would move the cursor becomes a space.
    let plain = |c: char| if is_plain(c) { c } else { ' ' };
    let part: String = full.chars().skip(start).take(WIDEST).map(plain).collect();
    let (before, after) = (
        if start > 0 { "…" } else { "" },
        if start + WIDEST < count { "…" } else { "" },
    );
    let blank = " ".repeat(column - 1 - start + before.chars().count());
    format!("  | {before}{}{after}\n  | {blank}^", part.trim_end())
}

/// Offset of byte `column` of line `line`, both from 1.
pub fn offset_of(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text
        .split_inclusive('\n')
        .take(line.saturating_sub(1))
        .map(str::len)
        .sum();
    (before + column.saturating_sub(1)).min(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_characters_not_bytes_and_knows_windows_line_ends() {
        let text = "αβ\r\nγ x\n";
        let mut start = Place::start(text);
        assert_eq!(start.at(0), (1, 1));
        assert_eq!(start.at(2), (1, 2));
        assert_eq!(start.at(6), (2, 1));
        assert_eq!(start.at(9), (2, 3));
        assert_eq!(start.at(999), (3, 1));
        assert_eq!(start.at(2), (1, 2));
    }

    #[test]
    fn the_place_is_shown_under_its_line() {
        assert_eq!(shown("ab\n\tcd = 1\n", 2, 4), "  |  cd = 1\n  |    ^");
        assert_eq!(shown("", 1, 1), "  | \n  | ^");
        // Beyond the end, as in a file that is cut off.
        assert_eq!(shown("{", 1, 2), "  | {\n  |  ^");
        let long = format!("{}x{}", "α".repeat(200), "β".repeat(300));
        let shown = shown(&long, 1, 201);
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(lines[0].chars().count(), 4 + WIDEST + 2);
        let caret = lines[1].chars().position(|c| c == '^').unwrap();
        assert_eq!(lines[0].chars().nth(caret), Some('x'));
    }

    #[test]
    fn offset_of_is_the_inverse_of_line_and_column() {
        assert_eq!(offset_of("ab\ncd", 2, 2), 4);
        assert_eq!(offset_of("ab\n", 2, 0), 3);
        assert_eq!(offset_of("", 1, 0), 0);
    }
}
