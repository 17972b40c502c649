//! The values of a rule that are decimals of at most 15 digits, as 0.3 is of 0, 0.1, 0.2: what the rule gives of the decimals in the
//! study, without the round-off of sums and powers. Other values, such as thirds, have no such form.

/// The first decimal with more digits than every double of it reads back with.
const TOO_LARGE: u128 = 1_000_000_000_000_000;

/// Largest power of ten that is a double, and so is the nearest double of digits times or over it.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// The two primes modulo which powers are compared: 2^61 - 1 and 2^62 - 57.
const PRIMES: [u128; 2] = [(1 << 61) - 1, (1 << 62) - 57];

/// Largest root that can be a fraction: the ratio of two doubles of 17 digits is below 2^2150.
const MOST_ROOT: u64 = 2150;

/// Digits times 10^exponent: the shortest decimal of a double.
#[derive(Debug, Clone, Copy)]
struct Decimal {
    digits: i128,
    exponent: i32,
}

impl Decimal {
    fn of(x: f64) -> Option<Decimal> {
        let text = format!("{x:e}");
        let (number, exponent) = text.split_once('e')?;
        let fraction = number.split_once('.').map_or(0, |(_, digits)| digits.len());
        let exponent: i32 = exponent.parse().ok()?;
        Some(Decimal {
            digits: number.replace('.', "").parse().ok()?,
            exponent: exponent - i32::try_from(fraction).ok()?,
        })
    }

    /// Its digits with a smaller exponent.
    fn digits_at(self, exponent: i32) -> Option<i128> {
        let power = 10_i128.checked_pow(u32::try_from(self.exponent - exponent).ok()?)?;
        self.digits.checked_mul(power)
    }

    /// The nearest double, if it has at most 15 digits.
    fn double(mut self) -> Option<f64> {
        if self.digits == 0 {
            return Some(0.0);
        }
        while self.digits % 10 == 0 {
            (self.digits, self.exponent) = (self.digits / 10, self.exponent + 1);
        }
        if self.digits.unsigned_abs() >= TOO_LARGE {
            return None;
        }
        let (digits, power) = (
            self.digits as f64,
            POWERS.get(self.exponent.unsigned_abs() as usize),
        );
        match (power, self.exponent >= 0) {
            (Some(power), true) => Some(digits * power),
            (Some(power), false) => Some(digits / power),
            (None, _) => format!("{}e{}", self.digits, self.exponent).parse().ok(),
        }
    }
}

/// Two decimals, as digits times the same power of ten.
fn together(a: f64, b: f64) -> Option<([i128; 2], i32)> {
    let (a, b) = (Decimal::of(a)?, Decimal::of(b)?);
    // Zero has the exponent of the other one.
    let exponent = match (a.digits, b.digits) {
        (0, _) => b.exponent,
        (_, 0) => a.exponent,
        _ => a.exponent.min(b.exponent),
    };
    let digits = |decimal: Decimal| match decimal.digits {
        0 => Some(0),
        _ => decimal.digits_at(exponent),
    };
    Some(([digits(a)?, digits(b)?], exponent))
}

/// Evenly spaced numbers from `a`: by steps, or `steps` up to an end.
#[derive(Debug, Clone, Copy)]
pub struct Even {
    start: i128,
    step: i128,
    exponent: i32,
    /// What the step is over: 10^`digits` over `odd`, and no factor of ten in `odd`.
    odd: i128,
    factor: i128,
}

impl Even {
    /// a, a + step, ...
    pub fn by(a: f64, step: f64) -> Option<Even> {
        let ([start, step], exponent) = together(a, step)?;
        Some(Even {
            start,
            step,
            exponent,
            odd: 1,
            factor: 1,
        })
    }

    /// As many steps from a to b.
    pub fn to(a: f64, b: f64, steps: u64) -> Option<Even> {
        let ([a, b], exponent) = together(a, b)?;
        let steps = i128::from(steps);
        let (mut odd, mut tens, mut power) = (steps, 0, 1_i128);
        // Over 10^tens it is a whole number over what is left.
        while power % twos_and_fives(steps) != 0 {
            (power, tens) = (power.checked_mul(10)?, tens + 1);
        }
        odd /= twos_and_fives(steps);
        Some(Even {
            start: a.checked_mul(steps)?,
            step: b.checked_sub(a)?,
            exponent: exponent - tens,
            odd,
            factor: power / twos_and_fives(steps),
        })
    }

    /// The number after `i` steps.
    pub fn at(&self, i: u64) -> Option<f64> {
        let moved = self.step.checked_mul(i128::from(i))?;
        let sum = self.start.checked_add(moved)?;
        if sum % self.odd != 0 {
            return None;
        }
        let digits = (sum / self.odd).checked_mul(self.factor)?;
        let exponent = self.exponent;
        Decimal { digits, exponent }.double()
    }
}

/// The factor of a number > 0 that has only twos and fives.
fn twos_and_fives(n: i128) -> i128 {
    let (mut rest, mut found) = (n, 1);
    for prime in [2, 5] {
        while rest % prime == 0 {
            (rest, found) = (rest / prime, found * prime);
        }
    }
    found
}

/// Numbers with the same ratio from one to the next.
#[derive(Debug, Clone, Copy)]
pub struct Ratios {
    ends: [Decimal; 2],
    steps: u64,
}

impl Ratios {
    /// As many steps from a to b, both not 0.
    pub fn new(a: f64, b: f64, steps: u64) -> Option<Ratios> {
        let ends = [Decimal::of(a)?, Decimal::of(b)?];
        Some(Ratios { ends, steps })
    }

    /// The number after `i` steps, which is about `x`.
    pub fn at(&self, i: u64, x: f64) -> Option<f64> {
        let common = divisor(i, self.steps);
        let (p, q) = (i / common, self.steps / common);
        if q > MOST_ROOT {
            return None;
        }
        // The exponent i/steps is rounded, so that the last digits of `x` are not known.
        let mut rounded = (11..15)
            .rev()
            .map(|digits| format!("{x:.digits$e}").parse().ok());
        rounded.find_map(|power: Option<f64>| power.filter(|power| self.is_exact(*power, [p, q])))
    }

    /// Whether own^q = a^(q - p) b^p. Numbers that agree to 11 digits and modulo both primes are equal.
    fn is_exact(&self, number: f64, [p, q]: [u64; 2]) -> bool {
        let Some(decimal) = Decimal::of(number) else {
            return false;
        };
        let [a, b] = self.ends;
        let exponent = |decimal: Decimal, power: u64| i64::from(decimal.exponent) * power as i64;
        let tens = exponent(decimal, q) - exponent(a, q - p) - exponent(b, p);
        let same = |prime: &u128| {
            let power = |digits: u128, power: u64| power_modulo(digits, power, *prime);
            let of =
                |decimal: Decimal, exponent: u64| power(decimal.digits.unsigned_abs(), exponent);
            let ends = of(a, q - p) * of(b, p) % prime;
            let shift = power(10, tens.unsigned_abs());
            match tens >= 0 {
                true => of(decimal, q) * shift % prime == ends,
                false => of(decimal, q) == ends * shift % prime,
            }
        };
        PRIMES.iter().all(same)
    }
}

/// The greatest common divisor.
fn divisor(a: u64, b: u64) -> u64 {
    match b {
        0 => a,
        _ => divisor(b, a % b),
    }
}

fn power_modulo(base: u128, power: u64, prime: u128) -> u128 {
    let (mut result, mut square, mut rest) = (1, base % prime, power);
    while rest > 0 {
        if rest % 2 == 1 {
            result = result * square % prime;
        }
        (square, rest) = (square * square % prime, rest / 2);
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn evenly_spaced_decimals_are_those_of_their_text() {
        let tenths = Even::to(0.0, 3.0, 30).unwrap();
        let steps = Even::by(0.0, 0.1).unwrap();
        let down = Even::by(-1.0, -0.1).unwrap();
        for i in 0..=30 {
            let text: f64 = format!("{}.{}", i / 10, i % 10).parse().unwrap();
            assert_eq!(tenths.at(i), Some(text));
            assert_eq!(steps.at(i), Some(text));
            assert_eq!(
                down.at(i),
                Some(-format!("{}e-1", i + 10).parse::<f64>().unwrap())
            );
        }
        // Sixths: every third is a half.
        let sixths = Even::to(0.0, 1.0, 6).unwrap();
        let known = [0, 1, 2, 3, 6].map(|i| sixths.at(i));
        assert_eq!(known, [Some(0.0), None, None, Some(0.5), Some(1.0)]);
        // 25 over 2 500 of 1e-300, and more digits than 15.
        assert_eq!(Even::to(0.0, 2.5e-299, 2500).unwrap().at(7), Some(7e-302));
        assert_eq!(Even::by(0.1, 1e-16).unwrap().at(1), None);
        assert_eq!(Even::by(1e-300, 1e300).map(|even| even.at(1)), None);
    }

    #[test]
    fn ratios_are_exact_where_their_root_is() {
        let close = |a: f64, b: f64, steps: u64, i: u64| {
            let x = a * libm::pow(b / a, i as f64 / steps as f64);
            Ratios::new(a, b, steps).unwrap().at(i, x)
        };
        for i in 0..=12 {
            let power: f64 = format!("1e{}", i as i32 - 6).parse().unwrap();
            assert_eq!(close(1e-6, 1e6, 12, i), Some(power));
            assert_eq!(close(3.0, 12288.0, 12, i), Some(3.0 * f64::from(1 << i)));
            assert_eq!(
                close(-0.7, -0.7e12, 12, i),
                Some(format!("-7e{}", i as i32 - 1).parse().unwrap())
            );
        }
        // Sixths are no doubles, and 1e6 to the power of their error is 5 units in the last place.
        assert_eq!(close(1e-3, 1e3, 6, 4), Some(10.0));
        // Odd powers of sqrt(10) are not.
        assert_eq!(close(1.0, 100.0, 4, 1), None);
        assert_eq!(close(1.0, 100.0, 4, 2), Some(10.0));
        assert_eq!(close(1.0, 10.0, 1_000_000, 7), None);
        // 0.2 to 0.45 by a factor of 3/2, which is no power of ten.
        assert_eq!(close(0.2, 0.45, 2, 1), Some(0.3));
    }
}
