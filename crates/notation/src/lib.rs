//! How numbers and symbols are written, in tables and along axes. Problems and drawings both use it, and neither the other.
//!
//! A part of slipgap, whose names may change.

mod digits;

pub use digits::{push_real, push_shortest, push_whole, real, shortest};

/// Hash of the code of this crate and of the crates of others that it computes with.
pub const CODE_KEY: &str = env!("SLIPGAP_CODE");

/// How numbers are laid along an axis, of a figure or of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm; only positive numbers.
    Log,
}

/// Plain text in the markup of titles and symbols that shows it unchanged.
pub fn escape(plain: &str) -> String {
    let mut markup = String::new();
    for c in plain.chars() {
        if ['\\', '*', '_', '^'].contains(&c) {
            markup.push('\\');
        }
        markup.push(c);
    }
    markup
}

/// A unit in markup, as in `m/s^2^` for `m/s2` and `kN·m` for `kN m`; another text unchanged.
pub fn unit(text: &str) -> String {
    let parts = text.split([' ', '·']).filter(|factor| !factor.is_empty());
    let factors: Option<Vec<String>> = parts.map(quotient).collect();
    factors.map_or_else(|| escape(text), |factors| factors.join("·"))
}

/// Units with powers, with `/` between; `None` for another text.
fn quotient(text: &str) -> Option<String> {
    let powers = text.split('/').map(|part| {
        let name = part.trim_end_matches(|c: char| c.is_ascii_digit());
        let power = &part[name.len()..];
        let name = name.trim_end_matches('^');
        let is_name = !["of", "per"].contains(&name) && name.chars().all(char::is_alphabetic);
        match (name, power) {
            ("", "1") => Some(power.to_owned()),
            (_, power) if is_name && (1..=4).contains(&name.chars().count()) => Some(match power {
                "" => name.to_owned(),
                power => format!("{name}^{power}^"),
            }),
            _ => None,
        }
    });
    let parts: Option<Vec<String>> = powers.collect();
    parts.map(|parts| parts.join("/"))
}

/// The title of an axis with its unit, both in markup.
pub fn in_unit(title: &str, unit: &str) -> String {
    match unit {
        "" => title.to_owned(),
        unit => format!("{title}, {unit}"),
    }
}

/// A title in words with a capital; a symbol keeps its case.
pub fn capital(title: &str) -> String {
    let first = title.split([' ', ',', '-']).next().unwrap_or_default();
    let is_word = first.len() > 1 && first.chars().all(|c| c.is_ascii_lowercase());
    let mut letters = title.chars();
    match letters.next() {
        Some(letter) if is_word => letter.to_uppercase().chain(letters).collect(),
        _ => title.to_owned(),
    }
}

/// A title in words as it is within a sentence.
pub fn small(title: &str) -> String {
    let mut letters = title.chars();
    match letters.next() {
        Some(first) if letters.clone().next().is_some_and(char::is_lowercase) => {
            first.to_lowercase().chain(letters).collect()
        }
        _ => title.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_set() {
        for (text, markup) in [
            ("m/s2", "m/s^2^"),
            ("m/s^2", "m/s^2^"),
            ("kN m", "kN·m"),
            ("kN s/m", "kN·s/m"),
            ("m2", "m^2^"),
            ("1/s", "1/s"),
            ("m/s²", "m/s²"),
            ("°", "°"),
            ("% of g", "% of g"),
            ("of_g", "of\\_g"),
            ("", ""),
        ] {
            assert_eq!(unit(text), markup, "{text}");
        }
    }

    #[test]
    fn a_title_in_words_has_a_capital() {
        assert_eq!(capital("force of p1"), "Force of p1");
        assert_eq!(capital("rms-error"), "Rms-error");
        assert_eq!(capital("*F*/*F*_0_"), "*F*/*F*_0_");
        assert_eq!(capital("x over t"), "x over t");
        assert_eq!(in_unit("Force", "kN"), "Force, kN");
        assert_eq!(small("Force of P1"), "force of P1");
        assert_eq!(small("EW drift"), "EW drift");
    }
}
