//! Default metrics of many cases, side by side.

use super::OUT_OF_RANGE;
use super::run::{Given, Model, run, work};
use super::tables::METRICS;
use crate::lane::Lane;
use crate::metrics::friction::{COUNT, Sampled, evaluate};
use crate::problem::sweep::{Beside, EXACT, Metrics, row, runs, sweep};
use multiversion::multiversion;

/// Cases side by side: as many as keep the adders busy while each waits for its own last result.
pub const LANES: usize = 16;

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

#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn group(desk: &mut Desk, lanes: &[Given; LANES], numbers: &[u32], found: &mut [Metrics]) {
    let x = &mut desk.x;
    let longest = lanes.iter().map(|case| case.last).max().unwrap_or(0) as usize;
    x.resize(longest + 1, Lane::splat(0.0));
    let mut rows = x.iter_mut();
    let ends = run(lanes, |contact| {
        if let Some(row) = rows.next() {
            for (to, from) in row.0.iter_mut().zip(&contact.displacement.0) {
                *to = *from;
            }
        }
    });
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
            evaluate(steps, works, exact)
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
