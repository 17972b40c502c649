//! Base64 (RFC 4648, section 4): bytes as text that every browser decodes.

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The bytes as text.
pub fn text(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |i: usize| u32::from(three.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for letter in 0..4 {
            let letter_index = (bits >> (18 - 6 * letter) & 63) as usize;
            text.push(if letter > three.len() {
                '='
            } else {
                char::from(LETTERS[letter_index])
            });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::text;

    /// The vectors of RFC 4648, section 10.
    #[test]
    fn the_standard_s_own_vectors() {
        let vectors = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (bytes, wanted) in vectors {
            assert_eq!(text(bytes.as_bytes()), wanted);
        }
        assert_eq!(text(&[0xfb, 0xff, 0xbf]), "+/+/");
    }
}
