//! Default metrics of many cases, side by side.

use super::OUT_OF_RANGE;
use super::run::{Given, Laws, Model, Oscillators, start, work};
use super::tables::METRICS;
use crate::lane::Lane;
use crate::law::{DisplacementControl, Law, VelocityControl};
use crate::metrics::friction::{COUNT, Sampled, evaluate};
use crate::problem::sweep::{Beside, EXACT, Metrics, row, runs, sweep};
use crate::stepper::Contact;
use multiversion::multiversion;

/// Cases side by side: as many as keep the adders busy while each waits for its own last result.
pub const LANES: usize = 32;

impl Beside for Given {
    fn kind(&self) -> u64 {
        match self.model {
            Model::Displacement { .. } => 0,
            Model::Velocity { .. } => 1,
        }
    }

    fn last(&self) -> u64 {
        self.last
    }

    fn exact(&self) -> [u64; EXACT] {
        let decides = [self.x0, self.step, self.duration, 0.0, 0.0];
        decides.map(f64::to_bits)
    }
}

/// What is used from group to group.
#[derive(Debug, Default)]
struct Desk {
    x: Vec<Lane<LANES>>,
    exact: Option<([u64; EXACT], Sampled)>,
}

/// The metrics of each case, in their order, to the bit as each alone has them.
pub fn metrics(cases: &[Given]) -> Vec<Metrics> {
    let mut found = vec![Ok(Vec::new()); cases.len()];
    let mut desk = Desk::default();
    sweep::<LANES, _>(cases, |lanes, numbers| {
        group(&mut desk, lanes, numbers, &mut found);
    });
    found
}

/// The metrics of a group.
fn group(desk: &mut Desk, lanes: &[Given; LANES], numbers: &[u32], found: &mut [Metrics]) {
    let longest = lanes.iter().map(|case| case.last).max().unwrap_or(0) as usize;
    desk.x.resize(longest + 1, Lane::splat(0.0));
    let x = &mut desk.x[..=longest];
    let ends = moved(lanes, x);
    let works = work(lanes, &ends);
    for (range, together) in runs(lanes, numbers.len()) {
        let first = &lanes[range.start];
        let key = first.exact();
        let exact = match &mut desk.exact {
            Some((kept, exact)) if *kept == key => exact,
            other => &mut other.insert((key, first.exact_at_steps())).1,
        };
        let steps = &x[..=first.last as usize];
        let all = if together {
            judged(steps, works, exact)
        } else {
            [[None; COUNT]; LANES]
        };
        for l in range {
            let own = if together {
                all[l]
            } else {
                let steps: Vec<_> = steps.iter().map(|x| Lane([x.0[l]])).collect();
                evaluate(&steps, Lane([works.0[l]]), exact)[0]
            };
            found[numbers[l] as usize] = match ends.lane(l).is_finite() {
                true => Ok(row(&own, METRICS.len())),
                false => Err(OUT_OF_RANGE.into()),
            };
        }
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
    stepper.run(&lanes.each_ref().map(|case| case.last), walk, |_, _| ())
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
fn judged(x: &[Lane<LANES>], works: Lane<LANES>, exact: &Sampled) -> [[Option<f64>; COUNT]; LANES] {
    evaluate(x, works, exact)
}
