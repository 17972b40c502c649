//! The friction laws of a search, and their widths.

use crate::{Setting, setting};
use slipgap_solver::problem::friction::FrictionOscillator;
use slipgap_solver::problem::parameter::Value;

/// Damping ratio of a mass of 1 on the bristles of lugre: sigma1 = sqrt(sigma0), as in Canudas de Wit et al. (1995).
const ZETA: f64 = 0.5;

/// Names of the laws that are searched. `stribeck` is not: its static friction is other physics than the reference.
pub fn names() -> Vec<&'static str> {
    let mut names = setting::choices(&FrictionOscillator, "law");
    names.retain(|name| *name != "stribeck");
    names
}

/// A law with a short list of its exponents.
pub fn law(name: &'static str) -> Vec<Setting> {
    match name {
        "bouc-wen" => Setting::each(name, "exponent", &[1.0, 2.0, 10.0]),
        "dahl" => Setting::each(name, "exponent", &[1.0, 2.0]),
        _ => vec![Setting::new(name)],
    }
}

/// The parameter that is the width of a law; `None` for a law without compliance.
pub fn width(law: &str) -> Option<&'static str> {
    match law {
        "coulomb" => None,
        "velocity-control" | "tanh" => Some("beta"),
        "lugre" => Some("sigma0"),
        _ => Some("alpha"),
    }
}

/// The parameters of a law with this width. The width of lugre is 1/sigma0.
pub fn of_width(law: &str, value: f64) -> Vec<(&'static str, Value)> {
    match width(law) {
        None => Vec::new(),
        Some("sigma0") => {
            let sigma0 = three_digits(1.0 / value);
            let sigma1 = three_digits(2.0 * ZETA * sigma0.sqrt());
            vec![
                ("sigma0", Value::Number(sigma0)),
                ("sigma1", Value::Number(sigma1)),
            ]
        }
        Some(name) => vec![(name, Value::Number(value))],
    }
}

fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
