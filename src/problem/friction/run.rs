//! Cases of one law through the stepper, side by side.

use super::release;
use super::tables::rows;
use crate::lane::Lane;
use crate::law::{DisplacementControl, Law, Trial, VelocityControl};
use crate::metrics::friction::Sampled;
use crate::problem::Case;
use crate::stepper::{Contact, Moving, Start, Stepper};
use crate::structure::Mode;

/// The oscillator itself: X'' + X + S = 0.
const UNIT: Mode = Mode {
    omega2: 1.0,
    phi2: 1.0,
};

/// The law of a case, with 1/k^C or 1/c^C.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Model {
    Displacement { alpha: f64 },
    Velocity { beta: f64 },
}

/// What a case is solved by.
#[derive(Debug, Clone, Copy)]
pub struct Given {
    pub model: Model,
    /// S(0).
    pub force: f64,
    pub x0: f64,
    pub step: f64,
    pub duration: f64,
    pub last: u64,
}

impl Given {
    /// The case's own parameters; `None` where one is not given.
    pub fn of(case: &Case, last: u64) -> Option<Given> {
        let x0 = case.at(rows::X0)?;
        let (model, force) = match case.at(rows::ALPHA) {
            Some(alpha) => {
                let (_, force) = release(case.name_at(rows::INITIAL_SLIP), x0, alpha);
                (Model::Displacement { alpha }, force)
            }
            None => {
                let beta = case.at(rows::BETA)?;
                (Model::Velocity { beta }, 0.0)
            }
        };
        Some(Given {
            model,
            force,
            x0,
            step: case.at(rows::DT)?,
            duration: case.at(rows::DURATION)?,
            last,
        })
    }

    fn compliance(&self) -> f64 {
        match self.model {
            Model::Displacement { alpha } => alpha,
            Model::Velocity { beta } => beta,
        }
    }

    /// The exact solution at the case's steps.
    pub fn exact_at_steps(&self) -> Sampled {
        Sampled::new(self.x0, self.step, self.last, self.duration)
    }
}

/// Oscillators side by side.
pub type Oscillators<const L: usize> = Stepper<L, [Moving<L>; 1]>;

/// The law of a group of cases.
#[derive(Debug, Clone, Copy)]
pub enum Laws<const L: usize> {
    Displacement(DisplacementControl<L>),
    Velocity(VelocityControl<L>),
}

/// The cases at rest at x0, all with the law of the first.
pub fn start<const L: usize>(cases: &[Given; L]) -> (Oscillators<L>, Laws<L>) {
    let of = |number: fn(&Given) -> f64| {
        let mut lane = Lane::splat(0.0);
        for (x, case) in lane.0.iter_mut().zip(cases) {
            *x = number(case);
        }
        lane
    };
    let start = Start {
        mode: [UNIT; L],
        displacement: of(|case| case.x0),
        velocity: Lane::splat(0.0),
    };
    let stepper = Stepper::single(of(|c| c.step), &start, Lane::splat(0.0), of(|c| c.force));
    let (compliance, limit) = (of(Given::compliance), Lane::splat(1.0));
    let on = stepper.flexibility();
    let laws = match cases[0].model {
        Model::Displacement { .. } => {
            Laws::Displacement(DisplacementControl::new(compliance, limit, on))
        }
        Model::Velocity { .. } => Laws::Velocity(VelocityControl::new(compliance, limit, on)),
    };
    (stepper, laws)
}

impl<const L: usize> Law<L> for Laws<L> {
    #[inline(always)]
    fn respond(&self, trial: &Trial<L>) -> Lane<L> {
        match self {
            Laws::Displacement(law) => law.respond(trial),
            Laws::Velocity(law) => law.respond(trial),
        }
    }
}

/// Work of the friction force over |x0|: what the oscillator has lost of its energy. The method keeps the sum of both,
/// (S_i + S_{i+1}) (X_{i+1} - X_i)/2 to (X^2 + V^2)/2, to round-off.
pub fn work<const L: usize>(cases: &[Given; L], end: &Contact<L>) -> Lane<L> {
    let mut work = end.displacement;
    for (l, case) in cases.iter().enumerate() {
        let (x, v, scale) = (end.displacement.0[l], end.velocity.0[l], case.x0.abs());
        work.0[l] = 0.5 * ((case.x0 - x) / scale * (case.x0 + x) - v / scale * v);
    }
    work
}
