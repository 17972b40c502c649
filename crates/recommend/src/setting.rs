//! Laws and methods with their parameters: the short lists that a search tries.

use slipgap_contact::contact::{Described, DisplacementControl, ImpactSpring, VelocityControl};
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::parameter::{Kind, Value, shortest};
use slipgap_system::methods::{AverageAcceleration, Description, METHODS, Method};

/// A law or a method, with the parameters that a search takes from a list.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Its name in studies.
    pub name: &'static str,
    /// Names and values of parameters.
    pub parameters: Vec<(&'static str, f64)>,
}

impl Setting {
    /// A law or a method without such parameters.
    pub fn new(name: &'static str) -> Setting {
        Setting {
            name,
            parameters: Vec::new(),
        }
    }

    /// One for each value of a parameter.
    pub fn each(name: &'static str, parameter: &'static str, values: &[f64]) -> Vec<Setting> {
        let one = |value: &f64| Setting {
            name,
            parameters: vec![(parameter, *value)],
        };
        values.iter().map(one).collect()
    }

    /// Name and parameters, as in `hht (hht_alpha -0.1)`.
    pub fn label(&self) -> String {
        if self.parameters.is_empty() {
            return self.name.into();
        }
        let parameters = self.parameters.iter();
        let parameters: Vec<String> = parameters
            .map(|(name, value)| format!("{name} {}", shortest(*value)))
            .collect();
        format!("{} ({})", self.name, parameters.join(", "))
    }

    /// The parameters of a case with this law or method; `row` is the parameter of its name.
    pub fn given(&self, row: &'static str) -> impl Iterator<Item = (&'static str, Value)> + '_ {
        let parameters = self.parameters.iter();
        let parameters = parameters.map(|(name, value)| (*name, Value::Number(*value)));
        [(row, Value::Name(self.name))]
            .into_iter()
            .chain(parameters)
    }
}

/// A law with a method and, for bars, a mass matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Variant {
    /// The law.
    pub law: Setting,
    /// The method.
    pub method: Setting,
    /// The mass matrix; `None` for a problem without one.
    pub mass: Option<&'static str>,
}

/// The laws of the papers.
const LAWS: [&str; 3] = [
    DisplacementControl::NAME,
    VelocityControl::NAME,
    ImpactSpring::NAME,
];

impl Variant {
    /// Whether law, method and mass matrix are those of the papers.
    pub fn of_the_papers(&self) -> bool {
        let mass = self.mass.unwrap_or("lumped");
        LAWS.contains(&self.law.name)
            && self.method.name == AverageAcceleration::NAME
            && ["lumped", "consistent"].contains(&mass)
    }
}

/// The names that a parameter may have.
pub fn choices(problem: &dyn Problem, parameter: &str) -> Vec<&'static str> {
    let mut rows = problem.parameters().iter();
    match rows.find(|p| p.name == parameter).map(|p| &p.kind) {
        Some(Kind::Choice(choices)) => choices.iter().map(|choice| choice.0).collect(),
        _ => Vec::new(),
    }
}

/// Names of the parameters of all methods.
pub fn method_parameters() -> Vec<&'static str> {
    let parameters = METHODS.iter().flat_map(|method| method.parameters);
    parameters.map(|parameter| parameter.name).collect()
}

/// The method of this name, with the defaults of its parameters.
pub fn method_named(name: &str) -> Option<Method> {
    Description::named(name)?.with_defaults()
}

/// Whether one of the variants has a method with several sub-steps.
pub fn has_sub_steps(variants: &[Variant]) -> bool {
    let mut methods = variants.iter().filter_map(|v| method_named(v.method.name));
    methods.any(|method| method.count_of_sub_steps() > 1)
}

/// The methods of a problem, each with a short list of its parameters; only the one of this name if there is one.
pub fn methods(problem: &dyn Problem, only: Option<&str>) -> Vec<Setting> {
    let names = choices(problem, "method").into_iter();
    let names = names.filter(|name| only.is_none_or(|only| only == *name));
    names.flat_map(method).collect()
}

/// A method with the values that its parameters' descriptions have for a search.
fn method(name: &'static str) -> Vec<Setting> {
    let parameters = Description::named(name).map_or(&[][..], |method| method.parameters);
    let Some(first) = parameters.first() else {
        return vec![Setting::new(name)];
    };
    let setting = |place: usize| Setting {
        name,
        parameters: parameters
            .iter()
            .filter_map(|parameter| Some((parameter.name, *parameter.tried.get(place)?)))
            .collect(),
    };
    (0..first.tried.len()).map(setting).collect()
}

/// The settings in a sentence: every name once, with the values of its parameters.
pub fn sentence<'a>(settings: impl Iterator<Item = &'a Setting>) -> String {
    let mut seen: Vec<String> = Vec::new();
    for setting in settings {
        let label = setting.label();
        if !seen.contains(&label) {
            seen.push(label);
        }
    }
    seen.join(", ")
}
