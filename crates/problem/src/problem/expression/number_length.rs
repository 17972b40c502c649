//! The length of a number in a text.

/// Number of bytes of the number at the beginning of `rest`, as in 12, .5 or 1.5e-3.
pub fn length_of_number(rest: &[u8]) -> usize {
    let digits = |from: usize| {
        let digits = rest[from..].iter().take_while(|b| b.is_ascii_digit());
        from + digits.count()
    };
    let mut end = digits(0);
    if rest.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(rest.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(rest.get(end + 1), Some(b'+' | b'-')));
        let first = end + 1 + sign;
        // Without a digit this is the constant e after a number, which the parser refuses.
        if rest.get(first).is_some_and(u8::is_ascii_digit) {
            end = digits(first);
        }
    }
    end
}
