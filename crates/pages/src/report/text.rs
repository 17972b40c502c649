//! Texts of the page: escaped text of a user, and verdicts.

/// A page needs nothing beside itself, and loads nothing.
pub const POLICY: &str = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; \
     style-src 'unsafe-inline'; img-src data:\">";

/// The text as HTML, in elements and in quoted attributes.
pub fn escape(text: &str) -> String {
    printable(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Escaped text with what is between backticks as code.
pub fn code(escaped: &str) -> String {
    let parts = escaped.split('`').enumerate();
    let shown = parts.map(|(i, part)| match i % 2 {
        0 => part.to_owned(),
        _ => format!("<code>{part}</code>"),
    });
    shown.collect()
}

/// The text with a visible sign for every character that HTML forbids: control characters other than tabs and line ends,
/// and noncharacters.
pub fn printable(text: &str) -> String {
    let shown = |c: char| match c {
        '\t' | '\n' => c,
        // Unicode has pictures of control characters in the same order.
        '\0'..='\x1f' => {
            char::from_u32(0x2400 + u32::from(c)).unwrap_or(char::REPLACEMENT_CHARACTER)
        }
        '\x7f' => '\u{2421}',
        '\u{80}'..='\u{9f}' | '\u{fdd0}'..='\u{fdef}' => char::REPLACEMENT_CHARACTER,
        _ if u32::from(c) & 0xfffe == 0xfffe => char::REPLACEMENT_CHARACTER,
        _ => c,
    };
    text.replace("\r\n", "\n").chars().map(shown).collect()
}

/// Class and word of a verdict. The word is needed because colour alone is not enough.
pub fn verdict(holds: bool, yes: &'static str, no: &'static str) -> (&'static str, &'static str) {
    if holds { ("holds", yes) } else { ("fails", no) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_character_that_html_forbids_remains() {
        let characters: String = ('\0'..=char::MAX).collect();
        let left = printable(&characters);
        assert_eq!(left.chars().count(), characters.chars().count());
        // "Control" and "noncharacter" of the Infra standard, which HTML forbids in its input, apart from white space.
        let forbidden = |c: char| {
            let code = u32::from(c);
            (c.is_control() && c != '\n' && c != '\t')
                || (0xfdd0..=0xfdef).contains(&code)
                || [0xfffe, 0xffff].contains(&(code % 0x10000))
        };
        assert_eq!(left.chars().find(|c| forbidden(*c)), None);
        let changed = characters.chars().zip(left.chars()).filter(|(a, b)| a != b);
        // 30 of C0, delete, 32 of C1, and the 66 noncharacters.
        assert_eq!(changed.count(), 30 + 1 + 32 + 66);
    }

    #[test]
    fn words_between_backticks_are_code() {
        assert_eq!(code("a `b` c, `d`"), "a <code>b</code> c, <code>d</code>");
        assert_eq!(code("plain"), "plain");
    }

    #[test]
    fn signs_show_the_replaced_characters() {
        assert_eq!(printable("a\0b\x1b[2J\r\nc\x7f"), "a␀b␛[2J\nc␡");
        assert_eq!(escape("\u{fffe}<\"&\x08>"), "\u{fffd}&lt;&quot;&amp;␈&gt;");
    }
}
