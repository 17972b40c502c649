//! Parameters that follow from others, and the rules across parameters.

use super::case::ImpactCase;
use super::law_of_case::{self, is_rigid};
use super::scaled::Scaled;
use super::scales::Scales;
use super::tables::{LAW, METHOD, Opposite, law_parameters, rows};
use crate::contact::StoredEnergy;
use crate::contact::numbers::bars;
use crate::exact::wave::Bars;
use crate::problem::method::{self, step_rules};
use crate::problem::numbers::parameter::{Default, Value, shortest};
use crate::problem::numbers::unit::Dimension;
use crate::problem::{Case, Violation, time_rules};
use crate::solve::ToSystem;

/// Most fronts of the exact solution that fit in memory: travel times there and back within the run.
const MOST_FRONTS: f64 = 1e5;

/// Fills in parameters that follow from others, and reports every rule that the case breaks.
pub(super) fn complete(case: &mut Case) -> Vec<Violation> {
    let mut violations = Vec::new();
    follow_left(case);
    violations.extend(ignored_restitution(case));
    law_of_case::fill_restitution(case);
    stiffness(case, &mut violations);
    if let (Some(step), Some(duration)) = (case.at(rows::DT), case.at(rows::DURATION)) {
        violations.extend(time_rules("dt", step, duration));
    }
    closing(case, &mut violations);
    violations.extend(no_restitution(case));
    if violations.is_empty()
        && let Some(scaled) = Scaled::new(case)
    {
        scales(case, &scaled, &mut violations);
        violations.extend(no_condensation(&scaled));
        violations.extend(no_impulse(&scaled));
    }
    if violations.is_empty()
        && method::has_rules(case, METHOD)
        && let Some(impact) = ImpactCase::new(case)
    {
        // Twice the overlap of the linear spring under the force F0 of the exact impact.
        let overlap = 2.0 / impact.scaled.spring;
        violations = step_rules("dt", &impact.system(), overlap);
    }
    violations
}

/// A contact node without mass follows the law, which must then give r for a force.
fn no_condensation(scaled: &Scaled) -> Option<Violation> {
    let needs = scaled.pair.contact_compliance() > 0.0;
    let gives = scaled.law.deflection(-1.0).is_some();
    (needs && !gives).then(|| Violation {
        parameter: "mass".into(),
        message:
            "massless-contact needs a law without damping; allowed: impact-spring, hertz, rigid"
                .into(),
        at: None,
    })
}

/// A damped law needs a restitution above zero.
fn no_restitution(case: &Case) -> Option<Violation> {
    let zero = case.at(LAW + law_parameters::rows::RESTITUTION) == Some(0.0);
    (zero && !is_rigid(case)).then(|| Violation {
        parameter: "restitution".into(),
        message: "must be > 0 for a law with damping, got 0".into(),
        at: None,
    })
}

/// A restitution that is given for rigid contact needs a method that knows it; its default does no harm.
fn ignored_restitution(case: &Case) -> Option<Violation> {
    let given = case.at(LAW + law_parameters::rows::RESTITUTION)?;
    let method = method::of_case(case, METHOD)?;
    let ignores = is_rigid(case) && !method.has_impulses();
    ignores.then(|| Violation {
        parameter: "restitution".into(),
        message: method::ignores_restitution(case.name_at(METHOD), given),
        at: None,
    })
}

/// Impulses and corrections act on nodes with mass.
fn no_impulse(scaled: &Scaled) -> Option<Violation> {
    let massless = scaled.pair.contact_compliance() > 0.0;
    let acts = match (scaled.method.has_impulses(), scaled.method.corrects()) {
        (true, _) => "moreau-jean acts by impulses",
        (false, true) => "contact-stabilized-newmark acts by corrections",
        (false, false) => return None,
    };
    massless.then(|| Violation {
        parameter: "method".into(),
        message: format!(
            "{acts} on contact nodes with mass; allowed: another mass matrix, or another method"
        ),
        at: None,
    })
}

/// Parameters of the right bar that are not given are equal to those of the left one; the velocity has the opposite sign. A wall
/// has none of them.
fn follow_left(case: &mut Case) {
    let opposite = Opposite::of(case);
    for [right, left] in rows::FOLLOWS {
        let default = match case.values[left] {
            Some(Value::Number(v)) if right == rows::RIGHT_V0 => Some(Value::Number(0.0 - v)),
            value => value,
        };
        case.values[right] = match opposite {
            Some(Opposite::Wall) => None,
            None => case.values[right].or(default),
        };
    }
}

/// gamma, k_I and k_h, each from the one that is given. Rigid contact has none.
fn stiffness(case: &mut Case, violations: &mut Vec<Violation>) {
    let (rigid, curved) = (is_rigid(case), law_of_case::has(case, &bars::K_H));
    let keys: &[(&'static str, usize)] = match curved {
        true => &[("gamma", rows::GAMMA), ("k_I", rows::K_I), ("k_h", K_H)],
        false => &[("gamma", rows::GAMMA), ("k_I", rows::K_I)],
    };
    let mut violation = |parameter: &'static str, message: String| {
        violations.push(Violation {
            parameter: parameter.into(),
            message,
            at: None,
        });
    };
    let names = || keys.iter().map(|row| row.0).collect::<Vec<_>>().join(", ");
    let mut given = keys.iter().filter(|row| case.at(row.1).is_some());
    let (name, row) = match (given.next(), given.next()) {
        (Some(one), None) if !rigid => *one,
        (None, _) if rigid => return,
        (None, _) => {
            let names = names();
            return violation("gamma", format!("missing: give exactly one of {names}"));
        }
        (Some((name, _)), _) if rigid => {
            return violation(
                name,
                "does not apply to law rigid, which has no stiffness".into(),
            );
        }
        (Some((first, _)), Some((second, _))) => {
            let names = names();
            let message =
                format!("cannot be given together with {first}; give exactly one of {names}");
            return violation(second, message);
        }
        (Some(_), None) => return,
    };
    let (Some(value), Some(element)) = (case.at(row), element_stiffness(case)) else {
        return;
    };
    // k_I is the secant stiffness of k_h delta^1.5 at the force F0.
    let k_i = match name {
        "gamma" => value * element,
        "k_I" => value,
        _ => {
            let Some(scales) = Scales::new(case) else {
                return;
            };
            libm::cbrt(value) * libm::cbrt(value) * libm::cbrt(scales.size(Dimension::Force))
        }
    };
    let k_h = || {
        let force = Scales::new(case)?.size(Dimension::Force);
        Some(k_i / force.sqrt() * k_i.sqrt())
    };
    let gamma = match name {
        "gamma" => value,
        _ => k_i / element,
    };
    let k_h = k_h().filter(|_| curved);
    let filled = [("gamma", rows::GAMMA, gamma), ("k_I", rows::K_I, k_i)]
        .into_iter()
        .chain(k_h.map(|k_h| ("k_h", K_H, k_h)));
    for (other, row, value) in filled.filter(|other| other.0 != name) {
        if !(value.is_finite() && value > 0.0) {
            let message = format!("gives {other} = {value}, outside the range of double precision");
            return violation(name, message);
        }
        case.values[row] = Some(Value::Number(value));
    }
}

/// E A n/L of the left bar.
fn element_stiffness(case: &Case) -> Option<f64> {
    let (n, e) = (case.at(rows::N)?, case.at(rows::E)?);
    let (a, l) = (case.at(rows::A)?, case.at(rows::L)?);
    Some(n * e * a / l)
}

/// Row of k_h.
const K_H: usize = LAW + law_parameters::rows::K_H;

/// The bars must close: c = V_left - V_right > 0.
fn closing(case: &Case, violations: &mut Vec<Violation>) {
    let (Some(left), right) = (case.at(rows::V0), case.at(rows::RIGHT_V0).unwrap_or(0.0)) else {
        return;
    };
    let c = left - right;
    let message = if c.is_infinite() {
        "the closing speed is outside the range of double precision".into()
    } else if c > 0.0 {
        return;
    } else {
        format!(
            "the bars must close: V0 of the left bar ({}) must be greater than that of the right ({})",
            shortest(left),
            shortest(right)
        )
    };
    // If V0 of the left bar has its default, the fault is in the right bar.
    let at_default = match case.schema.parameters[rows::V0].default {
        Default::Is(usual) => usual.matches(Value::Number(left)),
        Default::Required | Default::Follows(_) => false,
    };
    let parameter = if at_default { "right.V0" } else { "V0" };
    violations.push(Violation {
        parameter: parameter.into(),
        message,
        at: None,
    });
}

/// The scaled data must be in the range of double precision. The exact solution follows every front, so there must not be too many:
/// they come from a bar much shorter than the other, or from a very long run.
fn scales(case: &Case, scaled: &Scaled, violations: &mut Vec<Violation>) {
    let Some(duration) = case.at(rows::DURATION) else {
        return;
    };
    let Bars {
        time_ratio,
        impedance_ratio,
        ..
    } = scaled.bars;
    let mut violation = |parameter, message| {
        violations.push(Violation {
            parameter,
            message,
            at: None,
        })
    };
    let impedance_is_normal = match Opposite::of(case) {
        Some(Opposite::Wall) => true,
        None => impedance_ratio.is_normal(),
    };
    if !(time_ratio.is_normal() && impedance_is_normal) {
        let message = "the bars differ too much: the ratio of their impedances A sqrt(E rho) or of their travel times \
                       L sqrt(rho/E) is outside the range of double precision";
        return violation("right".into(), message.into());
    }
    if !scaled.spring.is_finite() && !is_rigid(case) {
        let message = "the spring is too stiff: the ratio of its stiffness to that of the bars is outside the range of double precision";
        return violation("gamma".into(), message.into());
    }
    let count = duration / time_ratio.min(1.0);
    if count > MOST_FRONTS {
        let message = format!(
            "waves would travel {count:.3e} times through the shorter bar; allowed: at most {MOST_FRONTS:e}; \
             give bars with more similar travel times, or a shorter duration"
        );
        violation("duration".into(), message);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{ContactLaw, ImpactSpring, VelocityControl};
    use crate::problem::impact::BarImpact;

    #[test]
    fn a_node_without_mass_needs_a_law_without_damping() {
        let refused = |mass: &'static str, law: ContactLaw| {
            let given = [
                ("gamma", Value::Number(1.0)),
                ("n", Value::Whole(4)),
                ("dt", Value::Number(0.1)),
                ("duration", Value::Number(1.0)),
                ("mass", Value::Name(mass)),
            ];
            let (case, broken) = Case::given(&BarImpact, &given);
            assert_eq!(broken, []);
            let mut scaled = Scaled::new(&case).unwrap();
            scaled.law = law;
            no_condensation(&scaled).is_some()
        };
        let spring = ContactLaw::ImpactSpring(ImpactSpring { stiffness: 1.0 });
        let damper = ContactLaw::VelocityControl(VelocityControl {
            compliance: 1.0,
            limit: 1.0,
        });
        assert!(!refused("massless-contact", spring) && refused("massless-contact", damper));
        assert!(!refused("lumped", damper) && !refused("consistent", damper));
    }
}
