//! The LuGre model in a plane.
//!
//! ```text
//! dz/dt = rdot - sigma0 |rdot| z/g(|rdot|),   S = sigma0 z + sigma1 dz/dt + sigma2 rdot
//! ```
//!
//! The step is that of the scalar model: z follows its flow for the mean velocity of the step, in which it relaxes to the direction of
//! the motion, and dz/dt at the end is the slope of the parabola through the last three z.

use super::{PlaneMemory, PlaneStep, PlaneTrial};
use crate::contact::Lugre;
use crate::contact::pair::{Pair, cut, length, map, root};
use crate::contact::saturation::rise;

/// S' of a step, and the bristles after it.
pub(super) fn answer(
    law: &Lugre,
    on: &PlaneStep,
    trial: &PlaneTrial,
    memory: &PlaneMemory,
) -> (Pair, PlaneMemory) {
    let dt = on.dt;
    let weight = match memory.begun {
        true => dt / (dt + memory.dt),
        false => 0.0,
    };
    let before = match (memory.begun, trial.velocity) {
        (true, _) => memory.friction,
        (false, [0.0, 0.0]) => trial.force,
        (false, _) => [0.0; 2],
    };
    let before = cut(before, law.static_limit);
    if law.limit <= 0.0 {
        let memory = PlaneMemory {
            begun: true,
            dt,
            ..PlaneMemory::default()
        };
        return ([0.0; 2], memory);
    }
    let quotient = 1.0 / (law.sigma0 * dt);
    let grip = 1.0 + law.sigma1 * (1.0 + weight) * quotient;
    let shrink = 1.0 / (1.0 + law.sigma2 * on.h_rate);
    let known: Pair = std::array::from_fn(|i| {
        before[i] - law.sigma1 * weight * memory.rate[i] + law.sigma2 * trial.rate[i]
    });
    let bristles = |dr: Pair| over(law, before, dr, dt);
    let force = |change: Pair| {
        map(known, change, |known, change| {
            (known + grip * change) * shrink
        })
    };
    let dr = match on.h == 0.0 {
        true => trial.change,
        false => {
            let rest = |dr: Pair| {
                let force = force(bristles(dr));
                std::array::from_fn(|i| dr[i] + on.h * force[i] - trial.change[i])
            };
            let held = 1.0 / (1.0 + on.h * shrink * grip * law.sigma0);
            let start = map(trial.change, known, |c, known| {
                (c - on.h * shrink * known) * held
            });
            root(rest, start, 1e-6 * law.limit / law.sigma0)
        }
    };
    let change = bristles(dr);
    let after = PlaneMemory {
        friction: map(before, change, |before, change| before + change),
        rate: change.map(|change| change * quotient),
        dt,
        begun: true,
        ..*memory
    };
    (force(change), after)
}

/// Change of the force of the bristles over a straight motion in a time.
fn over(law: &Lugre, before: Pair, dr: Pair, dt: f64) -> Pair {
    let x = length(dr);
    if x == 0.0 {
        return [0.0; 2];
    }
    let g = law.strength_at(x / dt);
    let m = rise(law.sigma0 * x / g);
    map(dr, before, |dr, before| (g * dr / x - before) * m)
}
