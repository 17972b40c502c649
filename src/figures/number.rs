//! Numbers as figures write them: a true minus, powers of ten, multiples of pi.

use crate::problem::parameter::{Value, shortest};
use std::f64::consts::PI;

/// A number in markup; multiples of pi as `2π`, `π/10`, `2π/3`.
pub fn number(x: f64) -> String {
    of_pi(x).unwrap_or_else(|| plain(x))
}

/// A parameter's value in markup.
pub fn value(value: Value) -> String {
    match value {
        Value::Number(x) => number(x),
        Value::Whole(n) => n.to_string(),
        Value::Name(name) => super::markup::escape(name),
    }
}

/// A number in markup, in decimal form or as `3 × 10^−5^`.
pub fn plain(x: f64) -> String {
    let text = shortest(x).replace('-', "−");
    match text.split_once('e') {
        None => text,
        Some(("1", power)) => format!("10^{power}^"),
        Some(("−1", power)) => format!("−10^{power}^"),
        Some((mantissa, power)) => format!("{mantissa} × 10^{power}^"),
    }
}

/// A number in markup, as `3/4` where that says it with a denominator up to 12.
pub fn fraction(x: f64) -> String {
    let parts = (2..=12_u32).find_map(|q| {
        let p = x * f64::from(q);
        let whole = p.round();
        (x.fract() != 0.0 && whole.abs() < 100.0 && (p - whole).abs() <= 1e-12 * p.abs())
            .then(|| format!("{whole}/{q}").replace('-', "−"))
    });
    parts.unwrap_or_else(|| plain(x))
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

/// A round number on a scale: without the last digits, where a product of digit and power has its rounding, and without
/// a power of ten where it can be read without.
pub fn short(x: f64) -> String {
    let freed: f64 = format!("{x:.6e}").parse().unwrap_or(x);
    match freed.abs() {
        1e-4..1e5 => freed.to_string().replace('-', "−"),
        _ => plain(freed),
    }
}

/// A number in plain words, as a reader is told it: six digits, multiples of pi as such.
pub fn told(x: f64) -> String {
    let short = |x: f64| shortest(format!("{x:.5e}").parse().unwrap_or(x));
    of_pi(x).unwrap_or_else(|| short(x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions() {
        for (x, text) in [
            (0.0, "0"),
            (0.25, "1/4"),
            (0.5, "1/2"),
            (-1.5, "−3/2"),
            (0.31, "0.31"),
        ] {
            assert_eq!(fraction(x), text);
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
