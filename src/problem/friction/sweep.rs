//! Default metrics of many cases, side by side.

use super::run::{Given, Laws, Model, Oscillators, start, work};
use crate::lane::Lane;
use crate::law::{DisplacementControl, Law, VelocityControl};
use crate::metrics::friction::{COUNT, Sampled, evaluate};
use crate::problem::sweep::{Beside, DECIDE};
use crate::stepper::Contact;
use multiversion::multiversion;

/// Cases side by side: as many as keep the adders busy while each waits for its own last result.
pub const LANES: usize = 32;

/// Displacements of a group, step by step, and the work of friction at the end.
#[derive(Debug, Default)]
pub struct Motion {
    x: Vec<Lane<LANES>>,
    work: Lane<LANES>,
}

impl Beside<LANES> for Given {
    type Exact = Sampled;
    type Track = Motion;
    type Judged = [Lane<LANES>; COUNT];
    type Alone = [Lane<1>; COUNT];

    fn kind(&self) -> u64 {
        match self.model {
            Model::Displacement { .. } => 0,
            Model::Velocity { .. } => 1,
        }
    }

    fn last(&self) -> u64 {
        self.last
    }

    fn decides(&self) -> [f64; DECIDE] {
        [self.x0, self.step, self.duration, 0.0, 0.0]
    }

    fn exact(&self) -> Sampled {
        self.exact_at_steps()
    }

    fn moved(lanes: &[Given; LANES], track: &mut Motion) -> [bool; LANES] {
        let longest = lanes.iter().map(|case| case.last).max().unwrap_or(0) as usize;
        track.x.resize(longest + 1, Lane::splat(0.0));
        let ends = moved(lanes, &mut track.x);
        track.work = work(lanes, &ends);
        ends.finite()
    }

    fn judged(track: &Motion, exact: &Sampled) -> Self::Judged {
        judged(&track.x[..exact.count()], track.work, exact)
    }

    fn judged_alone(track: &Motion, lane: usize, exact: &Sampled) -> Self::Alone {
        let steps = track.x[..exact.count()].iter();
        let steps: Vec<_> = steps.map(|x| Lane([x.0[lane]])).collect();
        evaluate(&steps, Lane([track.work.0[lane]]), exact)
    }
}

/// All steps of a group.
fn moved(lanes: &[Given; LANES], x: &mut [Lane<LANES>]) -> Contact<LANES> {
    let (mut stepper, law) = start(lanes);
    let Some((first, mut rows)) = x.split_first_mut() else {
        return stepper.contact();
    };
    *first = stepper.contact().displacement;
    let walk = |stepper: &mut Oscillators<LANES>, steps: usize| {
        let (now, later) = std::mem::take(&mut rows).split_at_mut(steps);
        rows = later;
        match &law {
            Laws::Displacement(law) => by_displacement(stepper, law, now),
            Laws::Velocity(law) => by_velocity(stepper, law, now),
        }
    };
    let mut last = [0; LANES];
    for (last, case) in last.iter_mut().zip(lanes) {
        *last = case.last;
    }
    stepper.run(&last, walk, |_, _| ())
}

/// Steps, one for each row of displacements.
// Small functions of their own: among other code these loops would be compiled less well.
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn by_displacement(
    stepper: &mut Oscillators<LANES>,
    law: &DisplacementControl<LANES>,
    rows: &mut [Lane<LANES>],
) {
    walk(stepper, *law, rows);
}

/// The same for the other law.
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn by_velocity(
    stepper: &mut Oscillators<LANES>,
    law: &VelocityControl<LANES>,
    rows: &mut [Lane<LANES>],
) {
    walk(stepper, *law, rows);
}

#[inline(always)]
fn walk(stepper: &mut Oscillators<LANES>, law: impl Law<LANES>, rows: &mut [Lane<LANES>]) {
    let mut moving = stepper.clone();
    for row in rows {
        moving.step(&law);
        *row = moving.contact().displacement;
    }
    *stepper = moving;
}

/// All metrics of a group.
#[allow(unused_braces, reason = "the macro puts them")]
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn judged(x: &[Lane<LANES>], works: Lane<LANES>, exact: &Sampled) -> [Lane<LANES>; COUNT] {
    evaluate(x, works, exact)
}
