//! The parameters of the method of integration, which all problems have.

use super::choice::choice;
use super::parameter::{Default, Kind, Parameter, Range, Value, row_of, shortest};
use super::{Case, Violation};
use crate::methods::{Coefficients, MethodChoice, six_digits_below};
use crate::solve;
use crate::system::{Mode, System};

choice! {
    /// Method of integration.
    pub enum MethodName {
        AverageAcceleration = "average-acceleration":
            "constant average acceleration, Newmark's method with beta = 1/4, gamma = 1/2 [F section 4, I section 3]",
        LinearAcceleration = "linear-acceleration":
            "linear acceleration, Newmark's method with beta = 1/6, gamma = 1/2",
        Newmark = "newmark": "Newmark's method with newmark_beta and newmark_gamma (Newmark 1959)",
        Hht = "hht":
            "alpha method of Hilber, Hughes and Taylor (1977): equilibrium within the step, numerical damping by hht_alpha",
        GeneralizedAlpha = "generalized-alpha":
            "generalized-alpha method of Chung and Hulbert (1993), numerical damping by rho_inf",
        Bathe = "bathe":
            "two sub-steps: trapezoidal rule, then three-point backward difference (Bathe and Baig 2005)",
        CentralDifference = "central-difference":
            "central differences, explicit; stable up to the critical step 2/omega_max",
        MoreauJean = "moreau-jean":
            "velocities and impulses with the theta rule; rigid impacts with restitution (Moreau 1988, Jean 1999)",
    }
}

/// Name of constant average acceleration.
const DEFAULT: &str = "average-acceleration";

/// Their parameters, for the table of each problem.
pub static PARAMETERS: [Parameter; 6] = [
    Parameter::new(
        ["method", "method", "1"],
        MethodName::KIND,
        Default::Is(Value::Name(DEFAULT)),
        "method of integration",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["newmark_beta", "*β*_N_", "1"],
        Kind::Number(Range::NotNegative),
        Default::Is(Value::Number(0.3025)),
        ("method", &["newmark"]),
        "Newmark's beta; the method is stable at every step if 2 beta >= gamma >= 1/2",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["newmark_gamma", "*γ*_N_", "1"],
        Kind::Number(Range::NotNegative),
        Default::Is(Value::Number(0.6)),
        ("method", &["newmark"]),
        "Newmark's gamma; numerical damping above 1/2",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["hht_alpha", "*α*_H_", "1"],
        Kind::Number(Range::HilberHughesTaylor),
        Default::Is(Value::Number(-0.1)),
        ("method", &["hht"]),
        "alpha of Hilber, Hughes and Taylor; beta = (1 - alpha)^2/4, gamma = 1/2 - alpha; no numerical damping at 0",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["rho_inf", "*ρ*_∞_", "1"],
        Kind::Number(Range::UpToOne),
        Default::Is(Value::Number(0.8)),
        ("method", &["generalized-alpha"]),
        "spectral radius of a mode of infinite frequency; no numerical damping at 1",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["theta", "*θ*", "1"],
        Kind::Number(Range::FromHalfToOne),
        Default::Is(Value::Number(0.5)),
        ("method", &["moreau-jean"]),
        "theta of the Moreau-Jean method; no numerical damping at 1/2",
    )
    .with_column_if_given(),
];

/// Why a method other than moreau-jean cannot have this restitution of a rigid contact.
pub(super) fn ignores_restitution(method: &str, restitution: f64) -> String {
    format!(
        "{method} ignores the restitution {} of a rigid contact: the bodies part at 0 to 3 times the closing speed, by chance; allowed: \
         method moreau-jean, or a law with stiffness for the other methods, in a block of its own in \"blocks\"",
        shortest(restitution)
    )
}

/// The method of a completed case, whose parameters are in the table from row `first` on; `None` for a parameter that is not given.
pub fn of_case(case: &Case, first: usize) -> Option<MethodChoice> {
    let number = |name: usize| case.at(first + name);
    Some(match MethodName::parse(case.name_at(first))? {
        MethodName::AverageAcceleration => MethodChoice::AverageAcceleration,
        MethodName::LinearAcceleration => MethodChoice::Family(Coefficients::linear_acceleration()),
        MethodName::Newmark => {
            MethodChoice::Family(Coefficients::newmark(number(BETA)?, number(GAMMA)?))
        }
        MethodName::Hht => MethodChoice::Family(Coefficients::hht(number(HHT_ALPHA)?)),
        MethodName::GeneralizedAlpha => {
            MethodChoice::Family(Coefficients::generalized_alpha(number(RHO_INF)?))
        }
        MethodName::Bathe => MethodChoice::Bathe,
        MethodName::CentralDifference => MethodChoice::Family(Coefficients::central_difference()),
        MethodName::MoreauJean => MethodChoice::MoreauJean {
            theta: number(THETA)?,
        },
    })
}

const BETA: usize = row_of(&PARAMETERS, "newmark_beta");
const GAMMA: usize = row_of(&PARAMETERS, "newmark_gamma");
const HHT_ALPHA: usize = row_of(&PARAMETERS, "hht_alpha");
const RHO_INF: usize = row_of(&PARAMETERS, "rho_inf");
const THETA: usize = row_of(&PARAMETERS, "theta");

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
    if let MethodChoice::Family(own) = system.method
        && own.stability_limit() < f64::INFINITY
    {
        // A mode of a bar needs sines, and the search for the highest frequency takes the modes many times.
        let modes = (0..system.linear.len()).map(|j| system.linear.mode(j).mode);
        let modes: Vec<Mode> = modes.collect();
        let stiffness = system.law.properties().largest_stiffness(overlap);
        // An element without mass is in series with the contact.
        let stiffness = 1.0 / (1.0 / stiffness + system.linear.contact_compliance());
        if stiffness == f64::INFINITY {
            return vec![Violation {
                parameter: "method".into(),
                message: "has no stable step with rigid contact; allowed: a law with compliance, or moreau-jean".into(),
                at: None,
            }];
        }
        let critical = own.critical_step(modes.iter().copied(), stiffness);
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
