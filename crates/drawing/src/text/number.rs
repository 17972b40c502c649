//! Numbers as figures write them: a minus sign, powers of ten, multiples of pi.

use slipgap_notation::shortest;
use std::collections::HashSet;
use std::f64::consts::PI;

/// Most significant digits of a number in a study; numbers with more were computed.
const WRITTEN: usize = 5;

/// Fewest significant digits of a rounded number.
const FEWEST: usize = 3;

/// The one form of several numbers, as those of a legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Form {
    /// Significant digits of those that were computed.
    digits: usize,
    /// Whether all have a power of ten.
    powers: bool,
}

impl Form {
    /// The form of a number alone, with these significant digits if it was computed.
    pub fn alone(digits: usize, x: f64) -> Form {
        let powers = !has_decimal_form(rounded_to(digits, x));
        Form { digits, powers }
    }

    /// The form that distinguishes all these numbers.
    pub fn of(numbers: impl Iterator<Item = f64>) -> Form {
        let mut sorted: Vec<f64> = numbers.collect();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        let form = |digits: usize| {
            let mut shown = sorted.iter().filter(|x| of_pi(**x).is_none());
            let powers = shown.any(|x| !has_decimal_form(rounded_to(digits, *x)));
            Form { digits, powers }
        };
        let apart = |form: &Form| {
            let labels: HashSet<String> = sorted.iter().map(|x| form.write(*x)).collect();
            labels.len() == sorted.len()
        };
        let fewer = (FEWEST..MOST).map(form).find(apart);
        fewer.unwrap_or_else(|| form(MOST))
    }

    /// A number in markup; multiples of pi as such.
    pub fn write(self, x: f64) -> String {
        of_pi(x).unwrap_or_else(|| match self.powers {
            true => with_power(rounded_to(self.digits, x)),
            false => decimal(rounded_to(self.digits, x)),
        })
    }
}

/// Significant digits that distinguish any two doubles.
const MOST: usize = 17;

/// The number with these significant digits if it has more than `WRITTEN`.
fn rounded_to(digits: usize, x: f64) -> f64 {
    let written = shortest(x);
    let mantissa = written.split('e').next().unwrap_or_default();
    let figures: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    match figures.trim_matches('0').len() <= WRITTEN {
        true => x,
        false => format!("{x:.0$e}", digits - 1).parse().unwrap_or(x),
    }
}

/// Whether a number is short without a power of ten.
fn has_decimal_form(x: f64) -> bool {
    x == 0.0 || (1e-4..1e5).contains(&x.abs())
}

fn decimal(x: f64) -> String {
    x.to_string().replace('-', "−")
}

/// A number as `3 × 10^−5^`; from 1 to 10 without the power.
fn with_power(x: f64) -> String {
    let text = format!("{x:e}").replace('-', "−");
    match text.split_once('e') {
        None | Some((_, "0")) => decimal(x),
        Some(("1", power)) => format!("10^{power}^"),
        Some(("−1", power)) => format!("−10^{power}^"),
        Some((mantissa, power)) => format!("{mantissa} × 10^{power}^"),
    }
}

/// A number alone in markup, rounded to `digits` if it has more than `WRITTEN`; multiples of pi as such.
pub fn rounded(x: f64, digits: usize) -> String {
    Form::alone(digits, x).write(x)
}

/// A number in markup; multiples of pi as `2π`, `π/10`, `2π/3`.
pub fn number(x: f64) -> String {
    of_pi(x).unwrap_or_else(|| plain(x))
}

/// A number in markup, in decimal form or as `3 × 10^−5^`.
pub fn plain(x: f64) -> String {
    match x.is_finite() && !has_decimal_form(x) {
        true => with_power(x),
        false => decimal(x),
    }
}

/// A number in markup, as `3/4` if it is a fraction with a denominator up to 12.
pub fn fraction(x: f64, form: Form) -> String {
    let parts = (2..=12_u32).find_map(|q| {
        let p = x * f64::from(q);
        let whole = p.round();
        (x.fract() != 0.0 && whole.abs() < 100.0 && (p - whole).abs() <= 1e-12 * p.abs())
            .then(|| format!("{whole}/{q}").replace('-', "−"))
    });
    parts.unwrap_or_else(|| form.write(x))
}

/// `x` as a multiple of pi with a denominator up to 1000, if it is one within rounding.
pub fn of_pi(x: f64) -> Option<String> {
    let (q, p) = (1..=1000_u32).find_map(|q| {
        let p = x / PI * f64::from(q);
        let whole = p.round();
        let near = whole != 0.0 && whole.abs() <= 1e4 && (p - whole).abs() <= 1e-12 * p.abs();
        near.then_some((q, whole as i64))
    })?;
    let sign = if p < 0 { "−" } else { "" };
    let times = match p.abs() {
        1 => String::new(),
        n => n.to_string(),
    };
    let over = match q {
        1 => String::new(),
        q => format!("/{q}"),
    };
    Some(format!("{sign}{times}π{over}"))
}

/// A round number on a scale: without the last digits, which have the rounding of a product, and without
/// a power of ten if it is short without one.
pub fn short(x: f64) -> String {
    let freed: f64 = format!("{x:.6e}").parse().unwrap_or(x);
    plain(freed)
}

/// A number in plain text: six digits, multiples of pi as such.
pub fn plain_text(x: f64) -> String {
    let short = |x: f64| shortest(format!("{x:.5e}").parse().unwrap_or(x));
    of_pi(x).unwrap_or_else(|| short(x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_to_what_tells_them_apart() {
        let labels = |numbers: &[f64]| -> Vec<String> {
            let form = Form::of(numbers.iter().copied());
            numbers.iter().map(|x| form.write(*x)).collect()
        };
        assert_eq!(
            labels(&[1.0 / 68.0, 1.0 / 34.0, 2.5]),
            ["0.0147", "0.0294", "2.5"]
        );
        // 0.147059 and 0.147082 are both 0.1471 to four figures.
        assert_eq!(labels(&[10.0 / 68.0, 0.147_082_1]), ["0.14706", "0.14708"]);
        // One written with fewer digits is not one rounded to the same.
        assert_eq!(labels(&[0.0147, 1.0 / 68.0]), ["0.0147", "0.01471"]);
        let next = f64::from_bits((0.1_f64 + 0.2).to_bits() + 1);
        let close = labels(&[0.1 + 0.2, next]);
        assert_ne!(close[0], close[1]);
        // What somebody wrote, and multiples of pi, keep their form.
        assert_eq!(
            labels(&[1.2345, 12000.0, PI / 80.0, -2.0 * PI / 3.0, 0.0]),
            ["1.2345", "12000", "π/80", "−2π/3", "0"]
        );
        assert_eq!(labels(&[1e5 / 3.0, 0.004]), ["33300", "0.004"]);
    }

    #[test]
    fn numbers_of_a_legend_have_one_form() {
        let form = |numbers: &[f64]| {
            let form = Form::of(numbers.iter().copied());
            numbers.iter().map(|x| form.write(*x)).collect::<Vec<_>>()
        };
        // Half decades, as geomspace makes them.
        let steps: Vec<f64> = (0..7)
            .map(|k| 1e4 * 10.0_f64.powf(f64::from(k) / 2.0))
            .collect();
        assert_eq!(
            form(&steps),
            [
                "10^4^",
                "3.16 × 10^4^",
                "10^5^",
                "3.16 × 10^5^",
                "10^6^",
                "3.16 × 10^6^",
                "10^7^"
            ]
        );
        assert_eq!(form(&[5e4, 9.9e4]), ["50000", "99000"]);
        assert_eq!(form(&[0.0, 2.0, 3e-7]), ["0", "2", "3 × 10^−7^"]);
        assert_eq!(form(&[-1e-6, 1e-6]), ["−10^−6^", "10^−6^"]);
        assert_eq!(rounded(0.004, 3), "0.004");
    }

    #[test]
    fn fractions() {
        for (x, text) in [
            (0.0, "0"),
            (0.25, "1/4"),
            (0.5, "1/2"),
            (-1.5, "−3/2"),
            (0.31, "0.31"),
        ] {
            assert_eq!(fraction(x, Form::alone(3, x)), text);
        }
    }

    #[test]
    fn multiples_of_pi_and_others() {
        for (x, text) in [
            (PI, "π"),
            (8.0 * PI, "8π"),
            (PI / 10.0, "π/10"),
            (2.0 * PI / 3.0, "2π/3"),
            (-PI / 80.0, "−π/80"),
            (0.1, "0.1"),
            (-12.5, "−12.5"),
            (0.0, "0"),
            (0.303, "0.303"),
            (1e-5, "10^−5^"),
            (2.5e-7, "2.5 × 10^−7^"),
            (2.5, "2.5"),
        ] {
            assert_eq!(number(x), text);
        }
    }
}
