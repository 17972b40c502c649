//! Scalar laws along a direction.

use super::{PlaneStep, PlaneTrial};
use crate::contact::pair::{self, Pair, dot};
use crate::contact::{
    AnyRunningLaw, ContactLaw, ContactResponse, Flexibility, StepFlexibility, Trial,
};
use crate::lane::Lane;

/// A flexibility that changes nothing but keeps the law without compliance finite.
const LEAST: f64 = f64::MIN_POSITIVE;

/// The scalar law over a step.
pub(super) fn running(law: &ContactLaw, h: f64, on: &PlaneStep) -> AnyRunningLaw<1> {
    let flexibility = |h: f64, h_rate: f64| Flexibility {
        h: Lane([h]),
        h_rate: Lane([h_rate]),
    };
    // Without compliance, the force of a given velocity is the limit.
    let steps = [[h, on.h_rate.max(LEAST)], [0.0, LEAST]].map(|[h, h_rate]| StepFlexibility {
        // The motion contains S.
        start: flexibility(0.0, 0.0),
        end: flexibility(h, h_rate),
        dt: Lane([on.dt]),
        by_impulse: false,
    });
    ContactLaw::running(&[*law], &steps)
}

/// The force of a scalar law over a step along a direction.
pub(super) fn along(
    mut step: AnyRunningLaw<1>,
    on: &PlaneStep,
    direction: Pair,
    trial: &PlaneTrial,
) -> Pair {
    if direction == [0.0; 2] {
        return [0.0; 2];
    }
    let unit = pair::unit(direction);
    let part_of = |of: Pair| Lane([dot(unit, of)]);
    let trial = Trial {
        displacement: part_of(trial.displacement),
        velocity: part_of(trial.velocity),
        force: part_of(trial.force),
        change: part_of(trial.change),
        rate: part_of(trial.rate),
    };
    // The second part is of a motion that is given.
    let Lane([force]) = step.force(usize::from(on.is_given()), &trial);
    unit.map(|x| x * force)
}

/// dS/drdot of a scalar law along rdot, of a motion that is given.
pub(super) fn scalar_slope(
    step: AnyRunningLaw<1>,
    given: &PlaneStep,
    moved: &PlaneTrial,
    speed: f64,
) -> f64 {
    let width = 1e-7 * speed;
    let direction = pair::unit(moved.rate);
    let at = |speed: f64| {
        let moved = PlaneTrial {
            rate: direction.map(|x| x * speed),
            ..*moved
        };
        dot(direction, along(step, given, moved.rate, &moved))
    };
    match speed > 0.0 {
        true => (at(speed + width) - at(speed - width)) / (2.0 * width),
        false => {
            let width = f64::MIN_POSITIVE.sqrt();
            at(width) / width
        }
    }
}
