//! The limit of friction.

use super::violation;
use crate::problem::structure::parts::contact::{Contact, Normal};
use crate::problem::{Case, Violation};
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::structure::{Limit, PressedBy, Pressure};

/// The friction limit, and its value at rest. `pressed_by` is what N names.
pub(super) fn limit(
    contact: &Contact,
    case: &Case,
    metre: f64,
    (pressed_by, with_samples): (PressedBy, bool),
) -> Result<(Limit, f64), Violation> {
    let (limit, at_rest) = without_pressure(contact, case, metre, (pressed_by, with_samples))?;
    let given = contact.value("pressure_exponent", case)?;
    let Some(exponent) = given.filter(|p| *p > 0.0) else {
        return Ok((limit, at_rest));
    };
    if contact.number("nu").is_none() {
        return Err(violation(contact, "pressure_exponent needs nu and N"));
    }
    if at_rest <= 0.0 {
        let message = format!("pressure_exponent needs N > 0 at rest, got {at_rest}");
        return Err(violation(contact, message));
    }
    let pressure = Some(Pressure { at_rest, exponent });
    Ok((Limit { pressure, ..limit }, at_rest))
}

fn without_pressure(
    contact: &Contact,
    case: &Case,
    metre: f64,
    (pressed_by, with_samples): (PressedBy, bool),
) -> Result<(Limit, f64), Violation> {
    if let Some(limit) = contact.value("limit", case)? {
        return Ok((Limit::constant(limit), limit));
    }
    let (Some(nu), Some(normal)) = (contact.number("nu"), &contact.normal) else {
        let needs = "friction needs limit, or nu and N";
        return Err(violation(contact, needs));
    };
    let nu = nu.value(case)?;
    let of = |constant, varying| Limit {
        constant,
        varying,
        pressure: None,
        pressed_by: None,
        static_ratio: 1.0,
    };
    match normal {
        Normal::Constant(force) => {
            let limit = nu * force.value(case)?;
            Ok((Limit::constant(limit), limit))
        }
        Normal::Parts(_) => {
            let mut limit = Limit::constant(0.0);
            limit.pressed_by = Some(PressedBy { nu, ..pressed_by });
            Ok((limit, 0.0))
        }
        Normal::Table(source) => {
            let signal = source.signal(case, metre)?;
            let at_rest = nu * signal.at(0.0);
            let varying = Some((nu, signal));
            let constant = 0.0;
            Ok((of(constant, varying), at_rest))
        }
        Normal::Weight { weight, vertical } => {
            let weight = nu * weight.value(case)?;
            if !with_samples && vertical.source.is_sampled() {
                vertical.check(case, metre)?;
                return Ok((Limit::constant(weight), weight));
            }
            let (signal, scale) = vertical.in_case(case, metre)?;
            let gravity = STANDARD_GRAVITY / metre;
            let varying = Some((weight * scale / gravity, signal));
            let constant = weight;
            Ok((of(constant, varying), weight))
        }
    }
}
