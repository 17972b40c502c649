//! Cases of one law through the stepper, side by side.

use super::release;
use crate::lane::Lane;
use crate::law::{DisplacementControl, Law, VelocityControl};
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
        let x0 = case.number("x0")?;
        let (model, force) = match case.number("alpha") {
            Some(alpha) => {
                let (_, force) = release(case.choice("initial_slip"), x0, alpha);
                (Model::Displacement { alpha }, force)
            }
            None => {
                let beta = case.number("beta")?;
                (Model::Velocity { beta }, 0.0)
            }
        };
        Some(Given {
            model,
            force,
            x0,
            step: case.number("dT")?,
            duration: case.number("duration")?,
            last,
        })
    }

    fn compliance(&self) -> f64 {
        match self.model {
            Model::Displacement { alpha } => alpha,
            Model::Velocity { beta } => beta,
        }
    }

    pub fn exact(&self) -> Sampled {
        Sampled::new(self.x0, self.step, self.last, self.duration)
    }
}

/// The last step's contact of each lane.
pub type Ends<const L: usize> = [Contact<1>; L];

/// Steps 0..=last of each case, shown to `show`, from rest at x0; all cases have the law of the first.
#[inline(always)]
pub fn run<const L: usize>(cases: &[Given; L], show: impl FnMut(&Contact<L>)) -> Ends<L> {
    let of = |number: fn(&Given) -> f64| Lane(cases.each_ref().map(number));
    let start = Start {
        mode: [UNIT; L],
        displacement: of(|case| case.x0),
        velocity: Lane::splat(0.0),
    };
    let stepper = Stepper::single(of(|c| c.step), &start, Lane::splat(0.0), of(|c| c.force));
    let (compliance, limit) = (of(Given::compliance), Lane::splat(1.0));
    let on = stepper.flexibility();
    let last = cases.each_ref().map(|case| case.last);
    match cases[0].model {
        Model::Displacement { .. } => walk(
            stepper,
            DisplacementControl::new(compliance, limit, on),
            &last,
            show,
        ),
        Model::Velocity { .. } => walk(
            stepper,
            VelocityControl::new(compliance, limit, on),
            &last,
            show,
        ),
    }
}

#[inline(always)]
fn walk<const L: usize>(
    mut stepper: Stepper<L, [Moving<L>; 1]>,
    law: impl Law<L>,
    last: &[u64; L],
    show: impl FnMut(&Contact<L>),
) -> Ends<L> {
    let mut ends = [stepper.contact().lane(0); L];
    stepper.run(&law, last, show, |l, stepper| {
        ends[l] = stepper.contact().lane(l);
    });
    ends
}

/// Work of the friction force over |x0|: what the oscillator has lost of its energy. The method keeps the sum of both,
/// (S_i + S_{i+1}) (X_{i+1} - X_i)/2 to (X^2 + V^2)/2, to round-off.
pub fn work(case: &Given, end: &Contact<1>) -> f64 {
    let Contact {
        displacement: Lane([x]),
        velocity: Lane([v]),
        ..
    } = *end;
    let scale = case.x0.abs();
    0.5 * ((case.x0 - x) / scale * (case.x0 + x) - v / scale * v)
}
