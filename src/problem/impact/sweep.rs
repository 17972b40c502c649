//! Default metrics of many cases, side by side.

use super::Given;
use super::run::{note, start, walk};
use crate::lane::Lane;
use crate::law::ImpactSpring;
use crate::metrics::impact::{COUNT, Sampled, Track, evaluate};
use crate::problem::sweep::{Beside, DECIDE};
use crate::stepper::{Contact, Stepper};
use multiversion::multiversion;
use std::ops::Range;

/// Cases side by side: more of them, with all their modes, do not stay near the processor.
pub const LANES: usize = 16;

impl Beside<LANES> for Given {
    type Exact = Sampled;
    type Track = Track<LANES>;
    type Judged = [Lane<LANES>; COUNT];
    type Alone = [Lane<1>; COUNT];

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

    fn decides(&self) -> [f64; DECIDE] {
        let bars = self.scaled.bars;
        let (z, theta) = (bars.impedance_ratio, bars.time_ratio);
        [self.dt, self.duration, bars.gap, z, theta]
    }

    fn exact(&self) -> Sampled {
        self.exact_at_steps().1
    }

    fn moved(lanes: &[Given; LANES], track: &mut Track<LANES>) -> [bool; LANES] {
        moved(lanes, track).finite()
    }

    fn judged(track: &Track<LANES>, exact: &Sampled) -> Self::Judged {
        judged(track, exact)
    }

    fn judged_alone(track: &Track<LANES>, lane: usize, exact: &Sampled) -> Self::Alone {
        evaluate(&track.lane(lane, exact.count()), exact)
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
fn judged(track: &Track<LANES>, exact: &Sampled) -> [Lane<LANES>; COUNT] {
    evaluate(track, exact)
}
