//! The reductions of channels in arithmetic, such as `max(a3 - a2)` in `max(a3 - a2)/h`.

use super::metric::OF_ALL;
use super::reduction::REDUCTIONS;
use crate::problem::expression::FUNCTIONS;
use crate::problem::structure::metrics::ground_metric::{PREFIX, without_direction};
use crate::problem::structure::metrics::window::begins_with_limit;
use std::ops::Range;

/// A part of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece {
    /// A reduction with its brackets, at these bytes.
    Metric(Range<usize>),
    /// Another name, at these bytes.
    Name(Range<usize>),
}

/// The reductions and names of a text, in its order. `max(a, b)` and `min(a, b)` of two numbers are functions.
pub fn pieces(text: &str) -> Vec<Piece> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        if !(c.is_alphabetic() || c == '_') {
            // Digits and what follows them directly, as in 1e-3, begin no name.
            let number = text[at..].find(|c: char| !(c.is_alphanumeric() || c == '.'));
            at += match c.is_ascii_digit() {
                true => number.unwrap_or(text.len() - at),
                false => c.len_utf8(),
            };
            continue;
        }
        let rest = &text[at..];
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.'));
        let name = &rest[..end.unwrap_or(rest.len())];
        let known = &*without_direction(name).0;
        let length = match REDUCTIONS.iter().any(|reduction| reduction.0 == known) {
            true => length_of_metric(known, rest, name.len()),
            false => None,
        };
        match length {
            Some(length) => found.push(Piece::Metric(at..at + length)),
            None => found.push(Piece::Name(at..at + name.len())),
        }
        at += length.unwrap_or(name.len());
    }
    found
}

/// Number of bytes of the reduction at the beginning of `rest`, of which the first `length` are its name; `None` if it is none.
fn length_of_metric(name: &str, rest: &str, length: usize) -> Option<usize> {
    let after = rest[length..].trim_start();
    let opens = rest.len() - after.len();
    let alone = OF_ALL.contains(&name) || name.starts_with(PREFIX);
    if !after.starts_with('(') {
        return alone.then_some(length);
    }
    let (mut depth, mut has_comma) = (0, false);
    for (place, c) in after.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' => has_comma |= depth == 1 && !begins_with_limit(&after[place + 1..]),
            _ => {}
        }
        if depth == 0 {
            let is_function = has_comma && FUNCTIONS.iter().any(|function| function.0 == name);
            return (!is_function).then_some(opens + place + 1);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reductions_are_found_in_arithmetic() {
        let metrics = |text: &str| -> Vec<String> {
            let metric = |piece: Piece| match piece {
                Piece::Metric(range) => Some(text[range].to_owned()),
                Piece::Name(_) => None,
            };
            pieces(text).into_iter().filter_map(metric).collect()
        };
        for (text, expected) in [
            ("max(a3 - a2)/3.2", &["max(a3 - a2)"][..]),
            ("peak(gap.S)/F1", &["peak(gap.S)"]),
            ("peak(gap.S)/peak(gap2.S)", &["peak(gap.S)", "peak(gap2.S)"]),
            ("max(peak(a), min (b))*2", &["peak(a)", "min (b)"]),
            (
                "max(max(a, from=1, to=T), min(b , to = 2))",
                &["max(a, from=1, to=T)", "min(b , to = 2)"],
            ),
            ("max(1, 2) + min(1e-3, b)", &[]),
            ("divergence(p1, 0.01)/T", &["divergence(p1, 0.01)"]),
            (
                "ground.y.Sa((T1), 0.02)/ground.pga - energy_error",
                &["ground.y.Sa((T1), 0.02)", "ground.pga", "energy_error"],
            ),
            ("peak(a", &[]),
            ("xpeak(a) + peak_1(a)", &[]),
            ("2*peak(g1.right-p2)", &["peak(g1.right-p2)"]),
        ] {
            assert_eq!(metrics(text), expected, "{text}");
        }
        let of_text = pieces("peak(a)/(h*F_1) + 2e3*sqrt(x.y)");
        let names = of_text.into_iter().filter_map(|piece| match piece {
            Piece::Name(range) => Some(range),
            Piece::Metric(_) => None,
        });
        let text = "peak(a)/(h*F_1) + 2e3*sqrt(x.y)";
        let names: Vec<&str> = names.map(|range| &text[range]).collect();
        assert_eq!(names, ["h", "F_1", "sqrt", "x.y"]);
    }
}
