//! The friction laws of a search, and their widths.

use crate::{Setting, setting};
use slipgap_contact::contact::WhichLaw;
use slipgap_contact::contact::numbers::oscillator::{EXPONENT, SIGMA0, SIGMA1};
use slipgap_contact::contact::offer::{Offered, Place};
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::numbers::parameter::Value;

/// Damping ratio of a mass of 1 on the bristles of lugre: sigma1 = sqrt(sigma0), as in Canudas de Wit et al. (1995).
const ZETA: f64 = 0.5;

/// Names of the laws that are searched. `stribeck` is not: its static friction is other physics than the reference.
pub fn names() -> Vec<&'static str> {
    let mut names = setting::choices(&FrictionOscillator, "law");
    names.retain(|name| which(name) != Some(WhichLaw::Stribeck));
    names
}

/// A law with a short list of its exponents.
pub fn law(name: &'static str) -> Vec<Setting> {
    match which(name) {
        Some(WhichLaw::BoucWen) => Setting::each(name, EXPONENT.key, &[1.0, 2.0, 10.0]),
        Some(WhichLaw::Dahl) => Setting::each(name, EXPONENT.key, &[1.0, 2.0]),
        _ => vec![Setting::new(name)],
    }
}

/// The parameter that is the width of a law, the first of its numbers; `None` for a law without compliance.
pub fn width(law: &str) -> Option<&'static str> {
    let numbers = Offered::named(Place::Oscillator, law)?
        .at(Place::Oscillator)?
        .numbers;
    numbers.first().map(|number| number.key)
}

/// Whether the width of a law is that of bristles.
pub fn has_bristles(name: &str) -> bool {
    which(name) == Some(WhichLaw::Lugre)
}

/// The law of a name.
fn which(name: &str) -> Option<WhichLaw> {
    Some(Offered::named(Place::Oscillator, name)?.law)
}

/// The parameters of a law with this width. The width of lugre is 1/sigma0.
pub fn of_width(law: &str, value: f64) -> Vec<(&'static str, Value)> {
    match (which(law), width(law)) {
        (_, None) => Vec::new(),
        (Some(WhichLaw::Lugre), _) => {
            let sigma0 = three_digits(1.0 / value);
            let sigma1 = three_digits(2.0 * ZETA * sigma0.sqrt());
            vec![
                (SIGMA0.key, Value::Number(sigma0)),
                (SIGMA1.key, Value::Number(sigma1)),
            ]
        }
        (_, Some(name)) => vec![(name, Value::Number(value))],
    }
}

/// The parameters that a search gives the laws: those from a list, and those of a width. Each has a place in the order of its law.
pub fn parameters() -> [Vec<&'static str>; 2] {
    let mut all = [Vec::new(), Vec::new()];
    let mut add = |kind: usize, name: &'static str| {
        if !all[kind].contains(&name) {
            all[kind].push(name);
        }
    };
    for name in names() {
        let listed = law(name).into_iter().flat_map(|law| law.parameters);
        listed.for_each(|(parameter, _)| add(0, parameter));
        let of_width = of_width(name, 1.0).into_iter();
        of_width.for_each(|(parameter, _)| add(1, parameter));
    }
    all
}

fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use crate::SearchSpace;
    use crate::friction::Friction;

    #[test]
    fn tables_and_studies_have_the_parameters_of_all_laws() {
        let methods = [
            "newmark_beta",
            "newmark_gamma",
            "hht_alpha",
            "rho_inf",
            "theta",
        ];
        let space = Friction::new(crate::Fixed::default(), 12.0);
        let table = [
            "law", "exponent", "alpha", "beta", "sigma0", "sigma1", "dT", "method",
        ];
        assert_eq!(
            space.table_parameters(),
            [&table[..], &methods[..]].concat()
        );
        let study = [
            "law", "alpha", "beta", "exponent", "sigma0", "sigma1", "dT", "duration", "x0",
            "method",
        ];
        assert_eq!(
            space.study_parameters(),
            [&study[..], &methods[..]].concat()
        );
    }
}
