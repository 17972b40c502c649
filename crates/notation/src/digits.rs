//! Numbers as text: the shortest decimal form that reads back as the same double, plain or with an exponent.

/// Most significant digits of a double in its shortest form.
const MOST: usize = 17;

/// Appends a number as text: plain, or with an exponent if that is shorter.
pub fn push_shortest(text: &mut Vec<u8>, x: f64) {
    match Decimal::of(x) {
        Some(decimal) => decimal.push(text),
        None => text.extend(x.to_string().into_bytes()),
    }
}

/// The shortest decimal form that reads back as the same double, plain or with an exponent.
pub fn shortest(x: f64) -> String {
    let mut text = Vec::new();
    push_shortest(&mut text, x);
    // The text is ASCII.
    String::from_utf8_lossy(&text).into_owned()
}

/// Appends a number as a cell of a column of real numbers: as [`push_shortest`], but with a point or an exponent, from which other
/// programs take the type of a column. Whole numbers below 1e16 are plain with `.0`.
pub fn push_real(text: &mut Vec<u8>, x: f64) {
    let start = text.len();
    push_shortest(text, x);
    let written = &text[start..];
    if !x.is_finite() || written.contains(&b'.') {
        return;
    }
    let zeros = match written.iter().position(|byte| *byte == b'e') {
        None => 0,
        // Behind one digit.
        Some(exponent_at) => match written[exponent_at + 1..] {
            [digit @ b'0'..=b'9'] => {
                text.truncate(start + exponent_at);
                usize::from(digit - b'0')
            }
            [b'1', digit @ b'0'..=b'5'] => {
                text.truncate(start + exponent_at);
                usize::from(digit - b'0') + 10
            }
            _ => return,
        },
    };
    text.resize(text.len() + zeros, b'0');
    text.extend_from_slice(b".0");
}

/// A number as a cell of a column of real numbers; see [`push_real`].
pub fn real(x: f64) -> String {
    let mut text = Vec::new();
    push_real(&mut text, x);
    // The text is ASCII.
    String::from_utf8_lossy(&text).into_owned()
}

/// The shortest decimal form of a finite number that is not zero: its digits times 10^exponent.
struct Decimal {
    negative: bool,
    digits: [u8; MOST],
    /// Number of digits, of which the first and the last are not 0.
    len: usize,
    exponent: i32,
}

impl Decimal {
    /// `None` for zero and numbers that are not finite.
    fn of(x: f64) -> Option<Decimal> {
        if x == 0.0 || !x.is_finite() {
            return None;
        }
        let mut buffer = zmij::Buffer::new();
        let found = Decimal::read(buffer.format_finite(x))?;
        // Of two shortest forms at the same distance, tables have the one further from zero, as the standard library.
        match found.may_be_halfway(x) {
            true => Decimal::read(&format!("{x:e}")),
            false => Some(found),
        }
    }

    /// Reads plain numbers and numbers with an exponent; `None` for other text.
    fn read(text: &str) -> Option<Decimal> {
        let negative = text.starts_with('-');
        let mut decimal = Decimal {
            negative,
            digits: [b'0'; MOST],
            len: 0,
            exponent: 0,
        };
        let (mut after_point, mut zeros) = (false, 0);
        let bytes = text.as_bytes();
        for (index, byte) in bytes.iter().enumerate().skip(usize::from(negative)) {
            match byte {
                b'.' => after_point = true,
                b'e' => {
                    let exponent: i32 = text.get(index + 1..)?.parse().ok()?;
                    decimal.exponent += exponent;
                    break;
                }
                digit => {
                    decimal.exponent -= i32::from(after_point);
                    // Zeros count only if another digit follows.
                    if *digit == b'0' {
                        zeros += i32::from(decimal.len > 0);
                        continue;
                    }
                    decimal.len += zeros as usize;
                    *decimal.digits.get_mut(decimal.len)? = *digit;
                    (decimal.len, zeros) = (decimal.len + 1, 0);
                }
            }
        }
        decimal.exponent += zeros;
        Some(decimal)
    }

    /// Whether the number may lie halfway between this form and another one with as many digits. Twice the number over
    /// 10^exponent is then odd, so that its factor of two is that of 10^exponent/2.
    fn may_be_halfway(&self, x: f64) -> bool {
        let bits = x.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let biased = (bits >> 52 & 0x7ff) as i32;
        let (whole, exponent) = match biased {
            0 => (fraction, -1074),
            _ => (fraction | 1 << 52, biased - 1075),
        };
        self.exponent < 0 && whole.trailing_zeros() as i32 + exponent == self.exponent - 1
    }

    /// Appends the shorter one of the two forms, the plain one if they are as long.
    fn push(&self, text: &mut Vec<u8>) {
        let digits = &self.digits[..self.len];
        if self.negative {
            text.push(b'-');
        }
        // Digits before the point.
        let before = self.len as i32 + self.exponent;
        let power = before - 1;
        let sign_and_digits = match power.unsigned_abs() {
            0..10 => 1,
            10..100 => 2,
            _ => 3,
        } + usize::from(power < 0);
        let scientific = self.len + usize::from(self.len > 1) + 1 + sign_and_digits;
        let plain = match (self.exponent >= 0, before > 0) {
            (true, _) => before as usize,
            (false, true) => self.len + 1,
            (false, false) => 2 + before.unsigned_abs() as usize + self.len,
        };
        let zeros = |text: &mut Vec<u8>, count: i32| text.resize(text.len() + count as usize, b'0');
        if scientific < plain {
            text.push(digits[0]);
            if self.len > 1 {
                text.push(b'.');
                text.extend_from_slice(&digits[1..]);
            }
            text.push(b'e');
            if power < 0 {
                text.push(b'-');
            }
            push_whole(text, u64::from(power.unsigned_abs()));
        } else if self.exponent >= 0 {
            text.extend_from_slice(digits);
            zeros(text, self.exponent);
        } else if before > 0 {
            let (whole, fraction) = digits.split_at(before as usize);
            text.extend_from_slice(whole);
            text.push(b'.');
            text.extend_from_slice(fraction);
        } else {
            text.extend_from_slice(b"0.");
            zeros(text, -before);
            text.extend_from_slice(digits);
        }
    }
}

/// Appends a whole number.
pub fn push_whole(text: &mut Vec<u8>, n: u64) {
    let mut digits = [0; 20];
    let (mut rest, mut from) = (n, digits.len());
    loop {
        from -= 1;
        digits[from] = b'0' + (rest % 10) as u8;
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    text.extend_from_slice(&digits[from..]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    /// The same by the standard library.
    fn by_standard_library(x: f64) -> String {
        let (plain, scientific) = (format!("{x}"), format!("{x:e}"));
        match scientific.len() < plain.len() {
            true => scientific,
            false => plain,
        }
    }

    #[test]
    fn numbers_of_all_sizes_have_the_digits_of_the_standard_library() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..300_000 {
            let x = f64::from_bits(random.next_u64());
            assert_eq!(shortest(x), by_standard_library(x));
            // Sizes that tables have.
            let decades = (random.next_u64() % 40) as i32 - 25;
            let x = (random.next_u64() as f64 / 2e19) * libm::pow(10.0, f64::from(decades));
            assert_eq!(shortest(x), by_standard_library(x));
            // Few digits.
            let x = (random.next_u64() % 100_000) as f64 * libm::pow(10.0, f64::from(decades));
            assert_eq!(shortest(x), by_standard_library(x));
        }
    }

    #[test]
    fn whole_numbers_and_special_ones_have_the_digits_of_the_standard_library() {
        let special = [
            0.0, 1.0, 0.1, 1e15, 1e16, 1e21, 1e22, 1e23, 5e-324, 1e-5, 0.0001, 123e-7,
        ];
        let more = [f64::MAX, f64::MIN_POSITIVE, f64::EPSILON, f64::INFINITY];
        for x in special.into_iter().chain(more).flat_map(|x| [x, -x]) {
            assert_eq!(shortest(x), by_standard_library(x));
        }
        assert_eq!(shortest(f64::NAN), "NaN");
        for n in (0..70_000_i64).chain((1 << 53) - 1000..(1 << 53) + 1000) {
            assert_eq!(shortest(n as f64), by_standard_library(n as f64));
        }
        for power in -1074..1024 {
            let bits = libm::ldexp(1.0, power).to_bits();
            for x in [bits - 1, bits, bits + 1].map(f64::from_bits) {
                assert_eq!(shortest(x), by_standard_library(x));
            }
        }
    }

    #[test]
    fn of_two_forms_at_the_same_distance_the_one_of_the_standard_library_is_taken() {
        // 1.2449226090092102|5: the shortest digits of other algorithms end with the even digit.
        let x = 1.2449226090092103e15;
        assert_eq!(shortest(x), "1244922609009210.3");
        // Few binary digits: many of these numbers are halfway.
        let (mut random, mut halfway) = (ChaCha8Rng::seed_from_u64(2), 0);
        for power in 0..200 {
            for _ in 0..1000 {
                let bits = 40 + random.next_u64() % 14;
                let whole = random.next_u64() >> (64 - bits) | 1;
                let x = libm::ldexp(whole as f64, -power);
                assert_eq!(shortest(x), by_standard_library(x));
                let other = Decimal::read(zmij::Buffer::new().format_finite(x)).unwrap();
                halfway += usize::from(other.digits != Decimal::of(x).unwrap().digits);
            }
        }
        assert!(halfway > 10, "{halfway}");
    }

    #[test]
    fn real_numbers_have_a_point_or_an_exponent() {
        for (x, text) in [
            (0.0, "0.0"),
            (-0.0, "-0.0"),
            (2.0, "2.0"),
            (-25.0, "-25.0"),
            (1e3, "1000.0"),
            (-7e9, "-7000000000.0"),
            (2e10, "20000000000.0"),
            (1e15, "1000000000000000.0"),
            (1e16, "1e16"),
            (9007199254740993.0, "9007199254740992.0"),
            (1e300, "1e300"),
            (1.5e20, "1.5e20"),
            (1e-5, "1e-5"),
            (0.1, "0.1"),
            (12345.0, "12345.0"),
        ] {
            assert_eq!(real(x), text);
        }
        let mut random = ChaCha8Rng::seed_from_u64(3);
        for power in -330..310 {
            let whole = (random.next_u64() % 1000) as f64;
            for x in [whole, f64::from_bits(random.next_u64())] {
                let x = x * libm::pow(10.0, f64::from(power));
                if x.is_finite() {
                    let text = real(x);
                    assert!(text.contains(['.', 'e']), "{text}");
                    assert_eq!(text.parse::<f64>().unwrap().to_bits(), x.to_bits());
                }
            }
        }
    }

    #[test]
    fn whole_numbers_have_all_digits() {
        for n in [0, 7, 10, 99, 100, 1_000_000, u64::MAX] {
            let mut text = Vec::new();
            push_whole(&mut text, n);
            assert_eq!(text, n.to_string().into_bytes());
        }
    }
}
