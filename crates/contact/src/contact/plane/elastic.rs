//! Friction that is elastic up to its limit, with a spring beside it.
//!
//! ```text
//! c dF/dt = rdot - lambda F/|F|,  |F| <= limit,   S = k r + F
//! ```
//!
//! A step returns to the disc along the radius: F' + Lambda n' = F + dr/c with n' = F'/|F'|. Alone this is of first order where the
//! path turns, since n' is the direction at the end of the step. The mean direction is n' - (n' - n)/2. Its change is taken from the
//! last step, so that it is known: F' + Lambda n' = F + dr/c + q with q = Lambda (n - n_before)/2. This is of second order, and F'
//! remains the projection of a known point plus dr/c: the gradient of a convex function. On a straight path, q = 0.

use super::scalar::{along, running};
use super::{PlaneMemory, PlaneStep, PlaneTrial};
use crate::contact::laws::friction::pendulum::{coefficient, expected};
use crate::contact::pair::{self, Pair, dot, length};
use crate::contact::{AnyRunningLaw, ElasticInPlane};

/// The law of friction with the step of its scalar form.
#[derive(Debug, Clone, Copy)]
pub(super) struct Elastic {
    pub(super) own: ElasticInPlane,
    pub(super) step: AnyRunningLaw<1>,
}

impl Elastic {
    /// S' of a step, and what the law remembers.
    pub(super) fn answer(
        &self,
        trial: &PlaneTrial,
        memory: &PlaneMemory,
        on: &PlaneStep,
        part: usize,
    ) -> (Pair, PlaneMemory) {
        let start = self.start(trial, memory, on);
        let share = 1.0 / (1.0 + self.own.spring * on.h);
        let [r, change] = [trial.displacement, trial.change];
        let change = pair::map(change, r, |c, r| (c - self.own.spring * on.h * r) * share);
        let free = PlaneTrial {
            force: start,
            change,
            ..*trial
        };
        let direction = pair::map(start, change, |s, c| s + c / self.own.law.compliance);
        let now = self.coefficient(trial, memory);
        let step = match now == 1.0 {
            true => self.step,
            false => {
                let law = self.own.law.into();
                running(&law, now * on.h * share, on)
            }
        };
        let friction = along(step, part, direction, &free);
        // S' = spring r' + friction with r' = r + change - h S'.
        let force = std::array::from_fn(|i| {
            let r = trial.displacement[i] + trial.change[i];
            (self.own.spring * r + now * friction[i]) * share
        });
        let end: Pair = std::array::from_fn(|i| {
            start[i] + (trial.change[i] - on.h * force[i]) / self.own.law.compliance
        });
        let beyond = length(end) - self.own.law.limit;
        let slides = self.own.law.limit > 0.0 && beyond > 0.0;
        let turn = match slides && memory.slides {
            true => turn(self.friction(trial, memory), friction, beyond),
            false => [0.0; 2],
        };
        let after = PlaneMemory {
            friction,
            turn,
            slides,
            speed: length(trial.velocity),
            dt: on.dt,
            begun: true,
            ..*memory
        };
        (force, after)
    }

    /// nu/nu_max at the end of the step.
    pub(super) fn coefficient(&self, trial: &PlaneTrial, memory: &PlaneMemory) -> f64 {
        let speed = length(trial.velocity);
        // Without a step before, the length of it is 0.
        let before = if memory.dt > 0.0 { memory.speed } else { speed };
        coefficient(self.own.rising, expected(speed, before))
    }

    /// Friction from which the motion of a step leads to the trial force.
    pub(super) fn start(&self, trial: &PlaneTrial, memory: &PlaneMemory, on: &PlaneStep) -> Pair {
        let before = self.friction(trial, memory);
        match memory.turn {
            [0.0, 0.0] => before,
            turn => {
                let scale = on.dt / memory.dt;
                pair::map(before, turn, |s, q| s + scale * scale * q)
            }
        }
    }

    /// Friction at the start of a step.
    fn friction(&self, trial: &PlaneTrial, memory: &PlaneMemory) -> Pair {
        match (self.own.spring == 0.0, memory.begun) {
            (true, _) => trial.force,
            (false, true) => memory.friction,
            (false, false) => self.unbent(trial.displacement),
        }
    }

    /// Friction of a contact at r that nothing has moved yet.
    pub(super) fn unbent(&self, r: Pair) -> Pair {
        match self.own.from_zero {
            true => pair::cut(r.map(|r| r / self.own.law.compliance), self.own.law.limit),
            false => [0.0; 2],
        }
    }
}

/// q of the next step: half of what the direction of friction has turned by, times Lambda; none after more than a right angle.
fn turn(before: Pair, after: Pair, beyond: f64) -> Pair {
    let [a, b] = [before, after].map(pair::unit);
    if dot(a, b) <= 0.0 {
        return [0.0; 2];
    }
    let sine = a[0] * b[1] - a[1] * b[0];
    let half = 0.5 * beyond * sine;
    [-half * b[1], half * b[0]]
}
