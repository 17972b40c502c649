//! Hints for an unknown name: the nearest name, a synonym, or a quantity that is not modelled.

mod foreign_words;

use crate::units::{NEEDS_UNITS, scaled};
use foreign_words::{OF_STRUCTURES, OUTSIDE, SCALED, SYNONYMS, UNITS};
use slipgap_contact::contact::LAWS;
use slipgap_problem::problem::expression::length_of_number;

/// Most bytes of a name that is compared with others. Every valid name is shorter.
const LONGEST: usize = 100;

/// The hint for a quantity that this program does not model, or that its equations are scaled by.
pub(crate) fn outside(name: &str, allowed: &[&str]) -> Option<String> {
    let in_units = |name: &str| scaled(name).is_some_and(|metric| allowed.contains(&metric));
    if in_units(name) && !allowed.iter().any(|known| in_units(known)) {
        // The quantities of a history have names without units.
        let quantity = scaled(name).filter(|_| allowed.contains(&"r"));
        return Some(match quantity {
            Some(quantity) => format!(
                "write \"{quantity}\", and \"in_units\": true in the figure of a study with \"units\""
            ),
            None => NEEDS_UNITS.into(),
        });
    }
    let name = plain(name);
    if synonym(&name, allowed).is_some() {
        return None;
    }
    let find = |table: &[(&[&str], &'static str)]| {
        let mut rows = table.iter();
        let row = rows.find(|(words, _)| words.contains(&name.as_str()));
        row.map(|row| row.1)
    };
    let has_table = allowed.contains(&"alpha") || allowed.contains(&"k_I");
    if let Some(what) = find(OF_STRUCTURES).filter(|_| has_table) {
        return Some(format!(
            "only studies with \"problem\": \"structure\" have {what}; see docs/structures.md"
        ));
    }
    if let Some(what) = find(OUTSIDE) {
        return Some(format!(
            "slipgap does not model {what}; docs/scope.md says what it does"
        ));
    }
    let scaled = allowed.contains(&"alpha") && SCALED.contains(&name.as_str());
    scaled.then(|| {
        "the equations are scaled: lengths are over Delta = nu N/k, times over 1/omega_n; see docs/scope.md".into()
    })
}

/// The name that was probably intended: a synonym, a near misspelling, or a name that begins with the other.
pub(crate) fn nearest<'a>(name: &str, allowed: &[&'a str]) -> Option<&'a str> {
    if name.len() > LONGEST {
        return None;
    }
    if let Some(intended) = synonym(&plain(name), allowed) {
        return Some(intended);
    }
    if outside(name, allowed).is_some() {
        return None;
    }
    misspelt(&plain(name), allowed).or_else(|| begun(&plain(name), allowed))
}

fn synonym<'a>(name: &str, allowed: &[&'a str]) -> Option<&'a str> {
    let synonym = SYNONYMS.iter().find(|(words, _)| words.contains(&name));
    let law = LAWS.iter().find(|law| law.offer.also.contains(&name));
    let of_synonym = synonym.map_or(&[][..], |synonym| synonym.1).iter().copied();
    let mut names = of_synonym.chain(law.map(|law| law.offer.name));
    names.find_map(|right| allowed.iter().find(|known| **known == right).copied())
}

/// The name with the fewest letters wrong, missing, added or exchanged: at most one for three to six letters, two for more,
/// none for fewer. The first letter must be right, or exchanged with the second.
fn misspelt<'a>(name: &str, allowed: &[&'a str]) -> Option<&'a str> {
    let mut first = name.chars();
    let (first, second) = (first.next()?, first.next());
    let most = match name.chars().count() {
        ..=2 => 0,
        3..=6 => 1,
        _ => 2,
    };
    let distance = |right: &&'a str| {
        let plain = plain(right);
        let begins = plain.starts_with(first) || plain.chars().next() == second;
        let distance = strsim::osa_distance(name, &plain);
        (begins && distance <= most).then_some((distance, *right))
    };
    let near = allowed.iter().filter_map(distance);
    near.min_by_key(|(distance, _)| *distance)
        .map(|(_, right)| right)
}

/// The shortest of the names that begin with this one, if all others begin with it; otherwise the longest name with which
/// this one begins.
fn begun<'a>(name: &str, allowed: &[&'a str]) -> Option<&'a str> {
    if name.chars().count() < LEAST_BEGUN {
        return None;
    }
    let longer: Vec<&str> = allowed
        .iter()
        .filter(|right| plain(right).starts_with(name))
        .copied()
        .collect();
    if let Some(shortest) = longer.iter().min_by_key(|right| right.len()) {
        let is_start = longer.iter().all(|right| right.starts_with(shortest));
        return is_start.then_some(shortest);
    }
    let part = |right: &&&str| {
        let right = plain(right);
        right.chars().count() >= LEAST_BEGUN && name.starts_with(&right)
    };
    let shorter = allowed.iter().filter(part);
    shorter.max_by_key(|right| right.len()).copied()
}

/// Fewest letters of such a beginning.
const LEAST_BEGUN: usize = 3;

/// A name in small letters without `_`, `-`, `.` and blanks, which are often written differently.
fn plain(name: &str) -> String {
    let compared = |c: &char| !matches!(c, '_' | '-' | '.' | ' ');
    name.to_lowercase().chars().filter(compared).collect()
}

/// The unit that follows a number, as in `0.05 s` or `7850 kg/m^3`.
pub(crate) fn unit(text: &str) -> Option<&str> {
    let text = text.trim_start().trim_start_matches(['+', '-']);
    let end = length_of_number(text.as_bytes());
    let unit = text.get(end..)?.trim();
    let part = |part: &str| {
        let digits = |c: char| c.is_ascii_digit() || matches!(c, '-' | '^' | '²' | '³');
        UNITS.contains(&part.trim().trim_end_matches(digits))
    };
    (end > 0 && unit.split(['/', '*', '·']).all(part)).then_some(unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axes::axis_rule::RULES;
    use slipgap_problem::problem::PROBLEMS;

    /// The names of parameters of a problem.
    fn names(problem: usize) -> Vec<&'static str> {
        let table = PROBLEMS[problem].parameters().iter();
        table.map(|parameter| &*parameter.name).collect()
    }

    #[test]
    fn a_misspelt_name_has_the_intended_one_as_hint_or_none() {
        let (friction, bars) = (&names(0)[..], &names(1)[..]);
        let rules = &RULES.map(|rule| rule.0)[..];
        let laws = &["displacement-control", "velocity-control"][..];
        let keys = &crate::decode::KEYS.map(|key| key.0)[..];
        let metrics = &["peak_force", "peak_error", "rms_error", "rms_error_law"][..];
        for (misspelt, allowed, intended) in [
            // Wrong, missing, added, exchanged.
            ("alpa", friction, Some("alpha")),
            ("alpha1", friction, Some("alpha")),
            ("aplha", friction, Some("alpha")),
            ("laph", friction, None),
            ("lapha", friction, Some("alpha")),
            ("duratoin", friction, Some("duration")),
            ("durration", friction, Some("duration")),
            ("displacment-control", laws, Some("displacement-control")),
            ("gama", bars, Some("gamma")),
            // Capitals, underscores and hyphens.
            ("dt", friction, Some("dT")),
            ("X_0", friction, Some("x0")),
            ("k_i", bars, Some("k_I")),
            ("Velocity_Control", laws, Some("velocity-control")),
            // Beginnings.
            ("displacement", laws, Some("displacement-control")),
            ("initial", friction, Some("initial_slip")),
            ("rms", metrics, Some("rms_error")),
            ("peak", metrics, None),
            ("durations", friction, Some("duration")),
            ("du", friction, None),
            // Other words.
            ("logspace", rules, Some("geomspace")),
            ("arange", rules, Some("range")),
            ("timestep", friction, Some("dT")),
            ("time_step", bars, Some("dt")),
            ("t_end", bars, Some("duration")),
            ("Young's modulus", bars, None),
            ("youngs_modulus", bars, Some("E")),
            ("penalty", bars, Some("k_I")),
            ("penalty", friction, None),
            // Names of something else.
            ("zeta", friction, None),
            ("eta", friction, None),
            ("theta", friction, Some("theta")),
            ("mu", friction, None),
            ("integrator", keys, None),
            ("method", keys, None),
            ("solver", keys, None),
            ("damping", keys, None),
            ("coulomb", laws, None),
            ("n2", bars, None),
            ("", laws, None),
            ("_", laws, None),
        ] {
            assert_eq!(nearest(misspelt, allowed), intended, "{misspelt}");
        }
        assert_eq!(nearest(&"alpha".repeat(1000), friction), None);
    }

    #[test]
    fn a_quantity_that_is_not_modelled_has_a_hint() {
        let (friction, bars) = (&names(0)[..], &names(1)[..]);
        for (name, allowed, hint) in [
            ("zeta", friction, Some("have damping;")),
            ("damping_ratio", bars, Some("have damping;")),
            ("forcing", friction, Some("have applied forces;")),
            ("ground_motion", friction, Some("have ground motion;")),
            ("record", bars, Some("have ground motion;")),
            ("mu", friction, Some("the equations are scaled: ")),
            ("omega_n", friction, Some("the equations are scaled: ")),
            ("mu", bars, None),
            ("integrator", friction, None),
            ("beta1", friction, None),
        ] {
            let found = outside(name, allowed);
            match hint {
                Some(hint) => assert!(
                    found.as_ref().is_some_and(|f| f.contains(hint)),
                    "{name}: {found:?}"
                ),
                None => assert_eq!(found, None, "{name}"),
            }
        }
    }

    #[test]
    fn words_of_the_tables_are_written_as_names_are_compared() {
        let of_laws = LAWS.iter().flat_map(|law| law.offer.also);
        let words = SYNONYMS.iter().flat_map(|row| row.0).chain(of_laws);
        let outside = OUTSIDE.iter().chain(OF_STRUCTURES).flat_map(|row| row.0);
        for word in words.chain(outside).chain(SCALED) {
            assert_eq!(plain(word), **word);
            assert!(
                names(0).iter().chain(&names(1)).all(|name| *name != *word) || *word == "mass",
                "{word}"
            );
        }
    }

    #[test]
    fn units_are_distinguished_from_other_text() {
        for (text, expected) in [
            ("0.05 s", Some("s")),
            ("0.05s", Some("s")),
            ("210 GPa", Some("GPa")),
            ("7850 kg/m^3", Some("kg/m^3")),
            ("9.81 m/s²", Some("m/s²")),
            ("120 mm/s2", Some("mm/s2")),
            ("1e-3 m", Some("m")),
            ("-5 %", Some("%")),
            ("2 pi", None),
            ("2 x", None),
            ("2 3", None),
            ("s", None),
            ("3", None),
            ("-", None),
            ("2 / s", None),
        ] {
            assert_eq!(unit(text), expected, "{text}");
        }
    }
}
