//! What follows from a case's parameters, and the rules across them.

use super::scaled::Scaled;
use super::tables::rows;
use crate::exact::wave::Bars;
use crate::problem::parameter::{Default, Value, shortest};
use crate::problem::{Case, Violation, time_rules};

/// Most fronts of the exact solution that fit in memory: trips there and back within the run.
const MOST_TRIPS: f64 = 1e5;

/// Fills in what follows, and names every rule that the case breaks.
pub(super) fn complete(case: &mut Case) -> Vec<Violation> {
    let mut violations = Vec::new();
    follow_left(case);
    stiffness(case, &mut violations);
    if let (Some(step), Some(duration)) = (case.at(rows::DT), case.at(rows::DURATION)) {
        violations.extend(time_rules("dt", step, duration));
    }
    closing(case, &mut violations);
    if violations.is_empty() {
        scales(case, &mut violations);
    }
    violations
}

/// What is left out of the right bar is as in the left one; its velocity has the sign turned.
fn follow_left(case: &mut Case) {
    let wall = case.name_at(rows::RIGHT) == "wall";
    for [right, left] in rows::FOLLOWS {
        case.values[right] = match (case.values[right], case.values[left]) {
            _ if wall => None,
            (Some(own), _) => Some(own),
            (None, Some(Value::Number(v))) if right == rows::RIGHT_V0 => {
                Some(Value::Number(0.0 - v))
            }
            (None, value) => value,
        };
    }
}

/// gamma and k_I, each from the other.
fn stiffness(case: &mut Case, violations: &mut Vec<Violation>) {
    let (gamma, k_i) = (case.at(rows::GAMMA), case.at(rows::K_I));
    let violation = |parameter, message: &str| Violation {
        parameter,
        message: message.into(),
    };
    match (gamma, k_i) {
        (Some(_), Some(_)) => {
            let message = "cannot be given together with gamma; give exactly one of gamma, k_I";
            return violations.push(violation("k_I".into(), message));
        }
        (None, None) => {
            let message = "missing: give exactly one of gamma, k_I";
            return violations.push(violation("gamma".into(), message));
        }
        _ => {}
    }
    let parts = (
        case.at(rows::N),
        case.at(rows::E),
        case.at(rows::A),
        case.at(rows::L),
    );
    let (Some(n), Some(e), Some(a), Some(l)) = parts else {
        return;
    };
    let element = n * e * a / l;
    let (parameter, name, row, value) = match (gamma, k_i) {
        (Some(gamma), _) => ("gamma", "k_I", rows::K_I, gamma * element),
        (None, Some(k_i)) => ("k_I", "gamma", rows::GAMMA, k_i / element),
        (None, None) => return,
    };
    if !(value.is_finite() && value > 0.0) {
        let message = format!("gives {name} = {value}, outside the range of double precision");
        return violations.push(violation(parameter.into(), &message));
    }
    case.values[row] = Some(Value::Number(value));
}

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
    // A left bar at its default is not to blame.
    let parameter = match case.schema.parameters[rows::V0].default {
        Default::Is(usual) if usual.matches(Value::Number(left)) => "right.V0",
        _ => "V0",
    };
    violations.push(Violation {
        parameter: parameter.into(),
        message,
    });
}

/// The scaled data must be doubles, and waves must not be too many for the exact solution, which follows every front:
/// in a bar much shorter than the other, or in a very long run.
fn scales(case: &Case, violations: &mut Vec<Violation>) {
    let (Some(scaled), Some(duration)) = (Scaled::new(case), case.at(rows::DURATION)) else {
        return;
    };
    let Bars {
        time_ratio,
        impedance_ratio,
        ..
    } = scaled.bars;
    let mut violation = |parameter, message| violations.push(Violation { parameter, message });
    let wall = case.name_at(rows::RIGHT) == "wall";
    if !(time_ratio.is_normal() && (wall || impedance_ratio.is_normal())) {
        let message = "the bars differ too much: the ratio of their impedances A sqrt(E rho) or of their travel times \
                       L sqrt(rho/E) is outside the range of double precision";
        return violation("right".into(), message.into());
    }
    if !scaled.spring.is_finite() {
        let message = "the spring is too stiff: the ratio of its stiffness to that of the bars is outside the range of double precision";
        return violation("gamma".into(), message.into());
    }
    let count = duration / time_ratio.min(1.0);
    if count > MOST_TRIPS {
        let message = format!(
            "waves would travel {count:.3e} times through the shorter bar; allowed: at most {MOST_TRIPS:e}; \
             give bars with more similar travel times, or a shorter duration"
        );
        violation("duration".into(), message);
    }
}
