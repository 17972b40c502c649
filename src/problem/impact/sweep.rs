//! Default metrics of many cases, side by side.

use super::run::{note, start, walk};
use super::tables::METRICS;
use super::{Given, OUT_OF_RANGE};
use crate::lane::Lane;
use crate::law::ImpactSpring;
use crate::metrics::impact::{COUNT, Sampled, Track, evaluate};
use crate::problem::sweep::{Beside, EXACT, Metrics, row, runs, sweep};
use crate::stepper::{Contact, Stepper};
use multiversion::multiversion;
use std::ops::Range;

/// Cases side by side: more of them, with all their modes, do not stay near the processor.
pub const LANES: usize = 16;

impl Beside for Given {
    fn kind(&self) -> u64 {
        let modes = |bar: u32| u64::from(bar) + 1;
        let right = match self.scaled.right {
            Some(bar) if bar != self.scaled.left => u64::from(bar.elements),
            _ => 0,
        };
        modes(self.scaled.left.elements) + right
    }

    fn last(&self) -> u64 {
        self.last
    }

    fn exact(&self) -> [u64; EXACT] {
        let bars = self.scaled.bars;
        let decides = [
            self.dt,
            self.duration,
            bars.gap,
            bars.impedance_ratio,
            bars.time_ratio,
        ];
        decides.map(f64::to_bits)
    }
}

/// What is used from group to group.
#[derive(Debug, Default)]
struct Desk {
    track: Track<LANES>,
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
    let track = &mut desk.track;
    let ends = moved(lanes, track);
    for (range, together) in runs(lanes, numbers.len()) {
        let first = &lanes[range.start];
        let key = first.exact();
        let at_steps = match &mut desk.exact {
            Some((kept, exact)) if *kept == key => exact,
            other => &mut other.insert((key, first.exact_at_steps().1)).1,
        };
        let all = if together {
            judged(track, at_steps)
        } else {
            [[None; COUNT]; LANES]
        };
        for l in range {
            let own = if together {
                all[l]
            } else {
                evaluate(&track.lane(l, first.last), at_steps)[0]
            };
            found[numbers[l] as usize] = match ends.lane(l).is_finite() {
                true => Ok(row(&own, METRICS.len())),
                false => Err(OUT_OF_RANGE.into()),
            };
        }
    }
}

/// All steps of a group.
fn moved(lanes: &[Given; LANES], track: &mut Track<LANES>) -> Contact<LANES> {
    let dt = Lane(lanes.each_ref().map(|case| case.dt));
    let scaled = lanes.each_ref().map(|case| case.scaled);
    let (mut stepper, law) = start(&scaled, dt);
    let last = lanes.each_ref().map(|case| case.last);
    let longest = last.iter().copied().max().unwrap_or(0) as usize;
    track.resize(longest + 1);
    note(track.rows(0, 1).next(), &stepper.contact());
    let (mut centres, mut at) = (Lane::splat(0.0), 1);
    let ends = stepper.run(
        &last,
        |stepper, steps| {
            walked(stepper, &law, track, at..at + steps);
            at += steps;
        },
        |rigid, ending| centres = ending.pick(rigid, centres),
    );
    track.restitution = centres * 0.5;
    ends
}

/// Steps, each noted.
// A small function of its own: among other code its loops would be compiled less well.
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn walked(
    stepper: &mut Stepper<LANES>,
    law: &ImpactSpring<LANES>,
    track: &mut Track<LANES>,
    steps: Range<usize>,
) {
    walk(stepper, law, track.rows(steps.start, steps.len()));
}

/// All metrics of a group.
#[allow(unused_braces, reason = "the macro puts them")]
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn judged(track: &Track<LANES>, exact: &Sampled) -> [[Option<f64>; COUNT]; LANES] {
    evaluate(track, exact)
}
