//! Curves of laws for figures.

use super::{Cycle, Flexibility, Law, StepFlexibility, StepLaw, Trial};
use crate::lane::Lane;

/// Points on a branch.
const POINTS: i32 = 100;

/// (rdot, S) from -1.1 `reach` to 1.1 `reach`, with most points near rdot = 0; `force` is |S| at a velocity >= 0.
pub(super) fn over_velocity(reach: f64, force: impl Fn(f64) -> f64) -> Cycle {
    let point = |k: i32| {
        let t = f64::from(k) / f64::from(POINTS);
        let velocity = 1.1 * reach * t * t * t;
        [velocity, force(velocity.abs()).copysign(velocity)]
    };
    ((-POINTS..=POINTS).map(point).collect(), Vec::new())
}

/// (r, S) from rest to `reach`, to -`reach` and back.
pub(super) fn over_displacement(law: impl Law, reach: f64) -> Cycle {
    let zero = Lane([0.0]);
    let step = law_of_motion(law, 1.0);
    let mut memory = Default::default();
    let [mut r, mut s] = [0.0, 0.0];
    let mut points = vec![[r, s]];
    for [from, to] in [[0.0, reach], [reach, -reach], [-reach, reach]] {
        for k in 1..=POINTS {
            let next = from + (to - from) * f64::from(k) / f64::from(POINTS);
            let trial = Trial {
                displacement: Lane([r]),
                velocity: zero,
                force: Lane([s]),
                change: Lane([next - r]),
                rate: zero,
            };
            [s] = step.force(&trial, &mut memory).0;
            r = next;
            points.push([r, s]);
        }
    }
    (points, Vec::new())
}

/// The law in a step whose motion is given: S(i+1) as a function of r(i+1) and rdot(i+1).
pub(super) fn law_of_motion<W: Law>(law: W, dt: f64) -> W::Step<1> {
    let none = Flexibility {
        h: Lane([0.0]),
        h_rate: Lane([0.0]),
    };
    let on = StepFlexibility {
        start: none,
        end: none,
        dt: Lane([dt]),
        by_impulse: false,
    };
    W::step(&[law], &on)
}
