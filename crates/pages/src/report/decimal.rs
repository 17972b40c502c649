//! Numbers of six significant digits, as a page about several studies has them.

/// Digits after the first.
const MORE_DIGITS: usize = 5;

/// The sign in the highest of the three bytes of the digits.
const NEGATIVE: u32 = 1 << 23;

/// The exponent of what is no finite number: of infinity with digits 0, of NaN with digits 1.
const NOT_FINITE: i16 = i16::MAX;

/// The number nearest to `x` that has six significant digits.
pub fn rounded(x: f64) -> f64 {
    match x.is_finite() {
        true => format!("{x:.MORE_DIGITS$e}").parse().unwrap_or(x),
        false => x,
    }
}

/// Adds numbers of six digits: `digits` times ten to the `exponent`, three bytes and two. Equal bytes of all numbers are together,
/// little end first, because they compress better so.
pub fn encode(numbers: &[f64], out: &mut Vec<u8>) {
    let parts: Vec<[u8; 5]> = numbers.iter().map(|x| bytes(*x)).collect();
    for k in 0..5 {
        out.extend(parts.iter().map(|part| part[k]));
    }
}

fn bytes(x: f64) -> [u8; 5] {
    let written = format!("{:.MORE_DIGITS$e}", x.abs());
    let parts = written.split_once('e').and_then(|(digits, exponent)| {
        let digits: u32 = digits.replace('.', "").parse().ok()?;
        let exponent: i16 = exponent.parse().ok()?;
        Some((digits, exponent - MORE_DIGITS as i16))
    });
    let (digits, exponent) = parts.unwrap_or((u32::from(x.is_nan()), NOT_FINITE));
    let sign = if x.is_sign_negative() { NEGATIVE } else { 0 };
    let [a, b, c, _] = (digits | sign).to_le_bytes();
    let [d, e] = exponent.to_le_bytes();
    [a, b, c, d, e]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_and_exponent_make_the_rounded_number() {
        let numbers = [
            (0.0, 0, -5),
            (1.0, 100_000, -5),
            (-2.5, 250_000 | NEGATIVE, -5),
            (123_456.7, 123_457, 0),
            (0.999_999_6, 100_000, -5),
            (4.940_656e-324, 494_066, -329),
            (1.797_693e308, 179_769, 303),
            (f64::INFINITY, 0, i16::MAX),
            (f64::NAN, 1, i16::MAX),
        ];
        for (x, digits, exponent) in numbers {
            let [a, b, c, d, e] = bytes(x);
            assert_eq!(u32::from_le_bytes([a, b, c, 0]), digits, "{x}");
            assert_eq!(i16::from_le_bytes([d, e]), exponent, "{x}");
        }
        let mut out = Vec::new();
        encode(&[1.0, 123_456.0], &mut out);
        // 100000 = 0x0186a0 and 123456 = 0x01e240.
        assert_eq!(out, [0xa0, 0x40, 0x86, 0xe2, 1, 1, 0xfb, 0, 0xff, 0]);
    }

    #[test]
    fn rounding_moves_by_at_most_half_a_digit() {
        for x in [1.0 / 3.0, -2.0e-9 / 7.0, 123_456.5, 9.999_995e200] {
            let y = rounded(x);
            assert!((y - x).abs() <= 5.0e-6 * x.abs(), "{x}: {y}");
            assert_eq!(rounded(y), y);
        }
        assert_eq!(rounded(f64::NEG_INFINITY), f64::NEG_INFINITY);
        assert!(rounded(f64::NAN).is_nan());
    }
}
