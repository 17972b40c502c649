//! The LuGre model in a plane.
//!
//! ```text
//! dz/dt = rdot - sigma0 |rdot| z/g(|rdot|),   S = sigma0 z + sigma1 dz/dt + sigma2 rdot
//! ```
//!
//! The step is that of the scalar model: z follows its flow for the mean velocity of the step, in which it relaxes to the direction of
//! the motion, and dz/dt at the end is the slope of the parabola through the last three z.

use super::{Over, PlaneLaw, PlaneStep, PlaneTrial, Root};
use crate::contact::Lugre;
use crate::contact::pair::{Pair, cut, length, map, root};
use crate::contact::saturation::rise;

/// What the model remembers from step to step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Memory {
    /// The force of the bristles, and its change in the last step over the length of the step.
    bristles: Pair,
    rate: Pair,
    /// Length of the last step.
    dt: f64,
    /// Whether there was a step or an equilibrium.
    begun: bool,
}

impl PlaneLaw for Lugre {
    type Step = ();
    type Memory = Memory;

    fn step(&self, _: &PlaneStep) {}

    fn answer(&self, over: &Over<Self>, trial: &PlaneTrial) -> (Pair, Memory) {
        let Over { on, memory, .. } = over;
        let dt = on.dt;
        let weight = match memory.begun {
            true => dt / (dt + memory.dt),
            false => 0.0,
        };
        let uncut = match (memory.begun, trial.velocity) {
            (true, _) => memory.bristles,
            (false, [0.0, 0.0]) => trial.force,
            (false, _) => [0.0; 2],
        };
        let before = cut(uncut, self.static_limit);
        if self.limit <= 0.0 {
            let memory = Memory {
                begun: true,
                dt,
                ..Memory::default()
            };
            return ([0.0; 2], memory);
        }
        let quotient = 1.0 / (self.sigma0 * dt);
        let grip = 1.0 + self.sigma1 * (1.0 + weight) * quotient;
        let shrink = 1.0 / (1.0 + self.sigma2 * on.h_rate);
        let known: Pair = std::array::from_fn(|i| {
            before[i] - self.sigma1 * weight * memory.rate[i] + self.sigma2 * trial.rate[i]
        });
        let bristles = |dr: Pair| change_over(self, before, dr, dt);
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
                let held = 1.0 / (1.0 + on.h * shrink * grip * self.sigma0);
                let start = map(trial.change, known, |c, known| {
                    (c - on.h * shrink * known) * held
                });
                root(rest, start, 1e-6 * self.limit / self.sigma0)
            }
        };
        let change = bristles(dr);
        let after = Memory {
            bristles: map(before, change, |before, change| before + change),
            rate: change.map(|change| change * quotient),
            dt,
            begun: true,
        };
        (force(change), after)
    }

    fn slopes(&self, over: &Over<Self>, root: &Root) -> (Pair, Pair) {
        over.slopes_by_differences(self, root, 1e-6 * (self.static_limit / self.sigma0))
    }

    fn bound(&self) -> f64 {
        self.static_limit
    }

    fn rate(&self, z: Pair, rdot: Pair) -> Pair {
        let speed = length(rdot);
        let g = self.strength_at(speed);
        match g > 0.0 {
            true => map(rdot, z, |v, z| self.sigma0 * (v - speed * z / g)),
            false => [0.0; 2],
        }
    }

    fn force(&self, z: Pair, _: Pair, rdot: Pair) -> Pair {
        if self.limit <= 0.0 {
            return [0.0; 2];
        }
        let rate = self.rate(z, rdot);
        std::array::from_fn(|i| z[i] + self.sigma1 / self.sigma0 * rate[i] + self.sigma2 * rdot[i])
    }

    fn memory(&self, bristles: Pair, begun: bool) -> Memory {
        Memory {
            bristles,
            begun,
            ..Memory::default()
        }
    }
}

/// Change of the force of the bristles over a straight motion in a time.
fn change_over(law: &Lugre, before: Pair, dr: Pair, dt: f64) -> Pair {
    let x = length(dr);
    if x == 0.0 {
        return [0.0; 2];
    }
    let g = law.strength_at(x / dt);
    let m = rise(law.sigma0 * x / g);
    map(dr, before, |dr, before| (g * dr / x - before) * m)
}
