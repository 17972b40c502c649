//! The text of a file, whatever program wrote it.

/// The text of these bytes: UTF-8, or UTF-16 as Excel and PowerShell write it. Lines may end as on old Macs. Where all behind a
/// Ctrl-Z is empty, it ends the file, as in DOS.
pub(in crate::system) fn decode(bytes: &[u8]) -> String {
    let units = |of: fn([u8; 2]) -> u16, bytes: &[u8]| {
        let pairs = bytes.chunks_exact(2);
        let units = pairs.map(|pair| of([pair[0], pair[1]]));
        let chars = char::decode_utf16(units);
        chars
            .map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect::<String>()
    };
    let decoded = match bytes {
        [0xff, 0xfe, rest @ ..] => units(u16::from_le_bytes, rest),
        [0xfe, 0xff, rest @ ..] => units(u16::from_be_bytes, rest),
        [a, 0, b, 0, ..] if *a != 0 && *b != 0 => units(u16::from_le_bytes, bytes),
        [0, a, 0, b, ..] if *a != 0 && *b != 0 => units(u16::from_be_bytes, bytes),
        // Names of stations may have any encoding.
        _ => String::from_utf8_lossy(bytes).into_owned(),
    };
    let text = decoded.trim_start_matches('\u{feff}');
    let is_padding = |c: char| c.is_whitespace() || matches!(c, '\u{1a}' | '\0');
    let text = match text.split_once('\u{1a}') {
        Some((before, after)) if after.chars().all(is_padding) => before,
        _ => text,
    };
    match text.contains('\n') {
        true => text.to_owned(),
        false => text.replace('\r', "\n"),
    }
}

/// Whether a line says that the numbers end, such as `END OF DATA`, `*** End Data ***`, `End-of-data` or `EOF`.
pub(in crate::system) fn is_end(line: &str) -> bool {
    let mut words = line
        .split(|c: char| !c.is_ascii_alphabetic())
        .filter(|word| !word.is_empty())
        .map(str::to_ascii_lowercase);
    let has_digit = line.contains(|c: char| c.is_ascii_digit());
    let first = words.next();
    match first.as_deref() {
        Some("eof") => !has_digit && words.next().is_none(),
        Some("end") => {
            let known = ["of", "the", "data", "file", "record", "listing"];
            !has_digit && words.all(|word| known.contains(&word.as_str()))
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_gives_the_same_text() {
        let text = "t;a\n0;1\u{b2}\n";
        let wide = |to: fn(u16) -> [u8; 2], mark: bool| -> Vec<u8> {
            let mark = mark.then_some(0xfeff);
            let units = mark.into_iter().chain(text.encode_utf16());
            units.flat_map(to).collect()
        };
        for bytes in [
            text.as_bytes().to_vec(),
            ["\u{feff}", text].concat().into_bytes(),
            wide(u16::to_le_bytes, true),
            wide(u16::to_be_bytes, true),
            wide(u16::to_le_bytes, false),
            wide(u16::to_be_bytes, false),
            [text, "\u{1a}"].concat().into_bytes(),
            [text, "\u{1a}\0\0\r\n"].concat().into_bytes(),
        ] {
            assert_eq!(decode(&bytes), text);
        }
        assert_eq!(decode(b"0 1\r1 2\r"), "0 1\n1 2\n");
        // Nothing is left out where numbers follow.
        assert_eq!(decode(b"0 1\n\x1a1 2\n"), "0 1\n\u{1a}1 2\n");
    }

    #[test]
    fn an_end_has_no_number_and_no_other_word() {
        for line in [
            "END OF DATA",
            "*** End Data ***",
            "End-of-data",
            "end",
            "EOF",
            "# end of file",
        ] {
            assert!(is_end(line), "{line}");
        }
        for line in [
            "",
            "End-of-data for Chan 1",
            "end 1",
            "ending",
            "end of the event",
            "eof data",
            "1 2",
        ] {
            assert!(!is_end(line), "{line}");
        }
    }
}
