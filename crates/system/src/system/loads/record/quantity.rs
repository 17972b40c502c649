//! Headers that name a velocity or a displacement.

use super::fault::{LineFault, RecordCause, fault};
use crate::system::loads::Unit;

/// Words of a line that is about the soil, or about single numbers of the motion.
const OTHERS: [&str; 8] = [
    "wave", "shear", "vs30", "initial", "peak", "max", "pgv", "rupture",
];

/// The fault of a header that names a velocity or a displacement and nowhere an acceleration.
pub(super) fn check(header: &[&str]) -> Result<(), LineFault> {
    if header.iter().any(|line| is_acceleration(line)) {
        return Ok(());
    }
    let of = |line: &&str| {
        let lower = line.to_lowercase();
        match OTHERS.iter().any(|word| lower.contains(word)) {
            true => None,
            false => of_words(&lower),
        }
    };
    match header
        .iter()
        .enumerate()
        .find_map(|(index, line)| Some((index, of(line)?)))
    {
        Some((index, other)) => Err(fault(index, RecordCause::Quantity(other))),
        None => Ok(()),
    }
}

/// The quantity of the name of a column, if it is a velocity or a displacement.
pub(super) fn of_column(name: &str) -> Option<&'static str> {
    match is_acceleration(name) {
        true => None,
        false => of_words(&name.to_lowercase())
            .or_else(|| in_brackets(name, of_unit))
            .or_else(|| of_unit(name).filter(|_| name.contains('/'))),
    }
}

/// The first text in brackets of which something is known.
pub(super) fn in_brackets<T>(text: &str, known: fn(&str) -> Option<T>) -> Option<T> {
    let mut inner = text.split(['(', '[']).skip(1);
    inner.find_map(|text| known(text.split([')', ']']).next()?))
}

/// The quantity of a unit of velocity or displacement.
pub(super) fn of_unit(text: &str) -> Option<&'static str> {
    let plain = text.trim().trim_end_matches(['.', ',', ';']).to_lowercase();
    match plain.replace("sec", "s").as_str() {
        "m/s" | "cm/s" | "mm/s" | "km/s" | "in/s" | "ft/s" | "kine" => Some("velocity"),
        "m" | "cm" | "mm" | "in" | "ft" => Some("displacement"),
        _ => None,
    }
}

fn of_words(lower: &str) -> Option<&'static str> {
    let has = |words: [&str; 2]| words.iter().any(|word| lower.contains(word));
    match (
        has(["velocity", "velocidad"]),
        has(["displacement", "desplazamiento"]),
    ) {
        (true, _) => Some("velocity"),
        (false, true) => Some("displacement"),
        (false, false) => None,
    }
}

/// Whether a line names an acceleration, or its unit in brackets.
fn is_acceleration(line: &str) -> bool {
    let lower = line.to_lowercase();
    let words = lower.split(|c: char| !c.is_alphanumeric());
    lower.contains("acceler")
        || lower.contains("acelerac")
        || words.into_iter().any(|word| matches!(word, "acc" | "gal"))
        || in_brackets(line, Unit::spelled).is_some()
}
