//! The parameters of the method of integration, which all problems have.

use super::{Case, Violation};
use crate::methods::{Description, METHODS, Method, MethodParameter, six_digits_below};
use crate::problem::numbers::parameter::{Default, Kind, Parameter, Value, shortest};
use crate::solve;
use crate::system::{Mode, System};
use std::slice;
use std::sync::LazyLock;

/// The names of the methods, each with its meaning.
const NAMES: [(&str, &str); METHODS.len()] = {
    let mut names = [("", ""); METHODS.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = (METHODS[i].name, METHODS[i].meaning);
        i += 1;
    }
    names
};

/// Most parameters of a method.
const MOST: usize = {
    let mut most = 0;
    let mut i = 0;
    while i < METHODS.len() {
        let count = METHODS[i].parameters.len();
        most = if count > most { count } else { most };
        i += 1;
    }
    most
};

/// The method of a study that names none.
const DEFAULT: &str = METHODS[0].name;

/// The parameters for the table of each problem: the method, and then those of each method.
pub static PARAMETERS: LazyLock<Vec<Parameter>> = LazyLock::new(|| {
    let method = Parameter::new(
        ["method", "method", "1"],
        Kind::Choice(&NAMES),
        Default::Is(Value::Name(DEFAULT)),
        "method of integration",
    );
    let of_method = |method: &'static Description| {
        let row = |parameter: &MethodParameter| {
            Parameter::only_for(
                [parameter.name, parameter.symbol, "1"],
                Kind::Number(parameter.range),
                Default::Is(Value::Number(parameter.default)),
                ("method", slice::from_ref(&method.name)),
                parameter.meaning,
            )
        };
        method.parameters.iter().map(row)
    };
    let rows = [method]
        .into_iter()
        .chain(METHODS.iter().flat_map(of_method));
    rows.map(Parameter::with_column_if_given).collect()
});

/// Why a method other than moreau-jean cannot have this restitution of a rigid contact.
pub(super) fn ignores_restitution(method: &str, restitution: f64) -> String {
    format!(
        "{method} ignores the restitution {} of a rigid contact: the bodies part at 0 to 3 times the closing speed, by chance; allowed: \
         method moreau-jean, or a law with stiffness for the other methods, in a block of its own in \"blocks\"",
        shortest(restitution)
    )
}

/// The method of a completed case, whose parameters are in the table from row `first` on; `None` for a parameter that is not given.
pub fn of_case(case: &Case, first: usize) -> Option<Method> {
    let name = case.name_at(first);
    let mut row = first + 1;
    for method in METHODS {
        let count = method.parameters.len();
        if method.name == name {
            let mut numbers = [0.0; MOST];
            for (number, row) in numbers.iter_mut().zip(row..row + count) {
                *number = case.at(row)?;
            }
            return (method.method)(numbers.get(..count)?);
        }
        row += count;
    }
    None
}

/// Whether the method of a case may have rules for the step; the parameters of the method are in the table from row `first` on.
pub fn has_rules(case: &Case, first: usize) -> bool {
    case.name_at(first) != DEFAULT
}

/// The rules for the step of a system: below the critical step of a method that has one, with the contact closed up to this `overlap`,
/// and one root of the contact's law in every step. `name` is the parameter of the step.
pub fn step_rules(name: &'static str, system: &System, overlap: f64) -> Vec<Violation> {
    let violation = |message: String| {
        vec![Violation {
            parameter: name.into(),
            message,
            at: None,
        }]
    };
    if system.method.has_critical_step() {
        // A mode of a bar needs sines, and the search for the highest frequency takes the modes many times.
        let modes: Vec<Mode> = (0..system.linear.len())
            .map(|j| system.linear.mode(j).mode)
            .collect();
        let of_law = system.law.properties().largest_stiffness(overlap);
        // An element without mass is in series with the contact.
        let stiffness = 1.0 / (1.0 / of_law + system.linear.contact_compliance());
        if stiffness == f64::INFINITY {
            return vec![Violation {
                parameter: "method".into(),
                message: "has no stable step with rigid contact; allowed: a law with compliance, or moreau-jean".into(),
                at: None,
            }];
        }
        let critical = system
            .method
            .critical_step(modes.iter().copied(), stiffness);
        if system.step > critical {
            return violation(format!(
                "must be at most {}, the critical step of this method with the contact closed, got {}",
                shortest(six_digits_below(critical)),
                shortest(system.step)
            ));
        }
    }
    if !system.law.properties().falls() || one_root(system, system.step) {
        return Vec::new();
    }
    let (mut low, mut high) = (0.0, system.step);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match one_root(system, middle) {
            true => low = middle,
            false => high = middle,
        }
    }
    violation(format!(
        "must be at most {}, got {}: the friction falls with velocity, and a longer step may have several solutions",
        shortest(six_digits_below(low)),
        shortest(system.step)
    ))
}

/// Whether all steps of this length have one root.
fn one_root(system: &System, step: f64) -> bool {
    let flexibilities = solve::flexibilities(&System { step, ..*system });
    let law = system.law.properties();
    flexibilities.is_some_and(|both| both.iter().all(|on| law.has_one_root(on)))
}
