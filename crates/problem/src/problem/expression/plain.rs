//! Characters that a terminal, a picture or a page cannot show.

/// Longest piece of a study that a message repeats, in characters.
const LONGEST_QUOTE: usize = 60;

/// Whether titles, notes, labels and names of files may contain a character. Control characters move the cursor of a terminal
/// or send it commands, U+2028 and U+2029 break lines, codes of direction change the order in which a line is read, and
/// noncharacters such as U+FFFE make XML ill-formed.
pub fn is_plain(c: char) -> bool {
    let direction = matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let line = matches!(c, '\u{2028}' | '\u{2029}');
    let code = u32::from(c);
    let noncharacter = matches!(code, 0xfdd0..=0xfdef) || code & 0xfffe == 0xfffe;
    !(c.is_control() || direction || line || noncharacter)
}

/// The code of the first character that a text may not contain.
pub fn unprintable(text: &str) -> Option<String> {
    let c = text.chars().find(|c| !is_plain(*c))?;
    Some(format!("U+{:04X}", u32::from(c)))
}

/// The text with every such character as an escape, as in `\u{1b}`, except line ends and tabs.
pub fn printable(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' | '\t' => plain.push(c),
            c if is_plain(c) => plain.push(c),
            c => plain.extend(c.escape_unicode()),
        }
    }
    plain
}

/// A string in quotes, on one line and not too long.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// The beginning of a text, on one line.
pub fn shortened(text: &str) -> String {
    let mut short: String = text.chars().take(LONGEST_QUOTE).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    let written = short.escape_debug().to_string().replace("\\'", "'");
    // Some characters remain after escape_debug.
    printable(&written)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exactly_the_characters_of_the_standard_are_not_plain() {
        // Unicode 16, 23.7: 66 noncharacters; 65 control characters (C0, DEL, C1); 2 separators; 9 codes of directions.
        let chars = (0..=0x0010_ffff).filter_map(char::from_u32);
        assert_eq!(chars.filter(|c| !is_plain(*c)).count(), 66 + 65 + 2 + 9);
        for c in "aé 漢\u{200d}\u{200f}😀\u{e000}\u{fffd}\u{feff}".chars() {
            assert!(is_plain(c), "{c:?}");
        }
    }

    #[test]
    fn control_characters_are_escaped() {
        assert_eq!(printable("a\tb\n"), "a\tb\n");
        assert_eq!(
            printable("\u{1b}[31m\u{9b}\r\u{202e}"),
            "\\u{1b}[31m\\u{9b}\\u{d}\\u{202e}"
        );
    }
}
