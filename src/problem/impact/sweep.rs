//! Default metrics of many cases, side by side.

use super::run::run_on;
use super::tables::METRICS;
use super::{Given, OUT_OF_RANGE};
use crate::lane::Lane;
use crate::metrics::impact::{COUNT, Sampled, Track, evaluate};
use crate::problem::sweep::{Beside, EXACT, Metrics, row, runs, sweep};
use multiversion::multiversion;

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

#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn group(desk: &mut Desk, lanes: &[Given; LANES], numbers: &[u32], found: &mut [Metrics]) {
    let dt = Lane(lanes.each_ref().map(|case| case.dt));
    let last = lanes.each_ref().map(|case| case.last);
    let scaled = lanes.each_ref().map(|case| case.scaled);
    let track = &mut desk.track;
    let ends = run_on(&scaled, dt, &last, track);
    for (range, together) in runs(lanes, numbers.len()) {
        let first = &lanes[range.start];
        let key = first.exact();
        let at_steps = match &mut desk.exact {
            Some((kept, exact)) if *kept == key => exact,
            other => &mut other.insert((key, first.exact_at_steps().1)).1,
        };
        let all = if together {
            evaluate(track, at_steps)
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
