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
use super::{Over, PlaneLaw, PlaneStep, PlaneTrial, Root};
use crate::contact::laws::friction::pendulum::{coefficient, expected};
use crate::contact::pair::{self, Pair, dot, length};
use crate::contact::{AnyRunningLaw, DisplacementControl};

/// Friction that is elastic up to its limit, with a spring beside it.
#[derive(Debug, Clone, Copy)]
pub struct ElasticInPlane {
    /// The elastic part and its limit.
    pub law: DisplacementControl,
    /// Stiffness of the spring beside it.
    pub spring: f64,
    /// Whether it has the force of its first loading from r = 0 on, as hardening has.
    pub from_zero: bool,
    /// nu_min/nu_max and a of a coefficient that rises with the speed; 1 and 0 of a constant one.
    pub rising: [f64; 2],
}

/// What the law remembers from step to step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Memory {
    /// Friction without the spring beside it.
    friction: Pair,
    /// What is added to the trial force in the next step, because friction turns; and whether the contact slid.
    turn: Pair,
    slides: bool,
    /// |rdot| at the start of the last step, and its length.
    speed: f64,
    dt: f64,
    /// Whether there was a step or an equilibrium.
    begun: bool,
}

impl From<DisplacementControl> for ElasticInPlane {
    fn from(law: DisplacementControl) -> ElasticInPlane {
        ElasticInPlane {
            law,
            spring: 0.0,
            from_zero: false,
            rising: [1.0, 0.0],
        }
    }
}

impl PlaneLaw for ElasticInPlane {
    type Step = AnyRunningLaw<1>;
    type Memory = Memory;

    fn step(&self, on: &PlaneStep) -> Self::Step {
        running(&self.law.into(), on.h / (1.0 + self.spring * on.h), on)
    }

    fn answer(&self, over: &Over<Self>, trial: &PlaneTrial) -> (Pair, Memory) {
        let Over { on, step, memory } = over;
        let start = self.start(trial, memory, on);
        let share = 1.0 / (1.0 + self.spring * on.h);
        let [r, change] = [trial.displacement, trial.change];
        let change = pair::map(change, r, |c, r| (c - self.spring * on.h * r) * share);
        let free = PlaneTrial {
            force: start,
            change,
            ..*trial
        };
        let direction = pair::map(start, change, |s, c| s + c / self.law.compliance);
        let now = self.coefficient(trial, memory);
        let step = match now == 1.0 {
            true => **step,
            false => running(&self.law.into(), now * on.h * share, on),
        };
        let friction = along(step, on, direction, &free);
        // S' = spring r' + friction with r' = r + change - h S'.
        let force = std::array::from_fn(|i| {
            let r = trial.displacement[i] + trial.change[i];
            (self.spring * r + now * friction[i]) * share
        });
        let end: Pair = std::array::from_fn(|i| {
            start[i] + (trial.change[i] - on.h * force[i]) / self.law.compliance
        });
        let beyond = length(end) - self.law.limit;
        let slides = self.law.limit > 0.0 && beyond > 0.0;
        let turn = match slides && memory.slides {
            true => turn(self.friction(trial, memory), friction, beyond),
            false => [0.0; 2],
        };
        let after = Memory {
            friction,
            turn,
            slides,
            speed: length(trial.velocity),
            dt: on.dt,
            begun: true,
        };
        (force, after)
    }

    fn slopes(&self, over: &Over<Self>, Root { moved, .. }: &Root) -> (Pair, Pair) {
        let Over { on, memory, .. } = over;
        let part = self.coefficient(moved, memory);
        let start = self.start(moved, memory, on);
        let trial = pair::map(start, moved.change, |s, c| s + c / self.law.compliance);
        let k = 1.0 / self.law.compliance;
        let size = length(trial);
        let friction = match size <= self.law.limit {
            true => [k, k],
            false => [0.0, self.law.limit * k / size],
        };
        let slopes = friction.map(|k| part * k + self.spring);
        (pair::unit(trial), slopes)
    }

    fn is_cut(&self) -> bool {
        true
    }

    fn bound(&self) -> f64 {
        self.law.limit
    }

    fn rate(&self, _: Pair, rdot: Pair) -> Pair {
        rdot.map(|v| v / self.law.compliance)
    }

    fn force(&self, z: Pair, r: Pair, rdot: Pair) -> Pair {
        let z = pair::cut(z, self.law.limit);
        let part = coefficient(self.rising, length(rdot));
        pair::map(r, z, |r, z| self.spring * r + part * z)
    }

    fn state(&self, at_rest: Option<Pair>, r: Pair) -> Pair {
        match at_rest {
            Some(force) => pair::map(force, r, |s, r| (s - self.spring * r) / self.rising[0]),
            None => self.unbent(r),
        }
    }

    fn memory(&self, friction: Pair, at_rest: bool) -> Memory {
        Memory {
            friction,
            begun: at_rest || self.spring != 0.0,
            ..Memory::default()
        }
    }
}

impl ElasticInPlane {
    /// nu/nu_max at the end of the step.
    fn coefficient(&self, trial: &PlaneTrial, memory: &Memory) -> f64 {
        let speed = length(trial.velocity);
        // Without a step before, the length of it is 0.
        let before = if memory.dt > 0.0 { memory.speed } else { speed };
        coefficient(self.rising, expected(speed, before))
    }

    /// Friction from which the motion of a step leads to the trial force.
    fn start(&self, trial: &PlaneTrial, memory: &Memory, on: &PlaneStep) -> Pair {
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
    fn friction(&self, trial: &PlaneTrial, memory: &Memory) -> Pair {
        match (self.spring == 0.0, memory.begun) {
            (true, _) => trial.force,
            (false, true) => memory.friction,
            (false, false) => self.unbent(trial.displacement),
        }
    }

    /// Friction of a contact at r that nothing has moved yet.
    fn unbent(&self, r: Pair) -> Pair {
        match self.from_zero {
            true => pair::cut(r.map(|r| r / self.law.compliance), self.law.limit),
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
