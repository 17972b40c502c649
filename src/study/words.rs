//! The words of expressions: functions and numbers.

/// A function by its number of arguments.
#[derive(Clone, Copy)]
pub(super) enum Function {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
}

/// The functions by name.
pub(super) const FUNCTIONS: [(&str, Function); 10] = [
    ("sqrt", Function::One(f64::sqrt)),
    ("sin", Function::One(libm::sin)),
    ("cos", Function::One(libm::cos)),
    ("tan", Function::One(libm::tan)),
    ("exp", Function::One(libm::exp)),
    ("ln", Function::One(libm::log)),
    ("log10", Function::One(libm::log10)),
    ("abs", Function::One(f64::abs)),
    ("min", Function::Two(f64::min)),
    ("max", Function::Two(f64::max)),
];

/// Number of bytes that the number at the beginning of `rest` takes, as in 12, .5 or 1.5e-3.
pub(super) fn length_of_number(rest: &[u8]) -> usize {
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
