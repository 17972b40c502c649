//! Many cases side by side: in which order they fill lanes, and which share their exact solution.

use super::cases::Cases;
use super::found::Found;
use super::{Case, OUT_OF_RANGE, Problem};
use crate::lane::Lane;
use std::ops::Range;

/// A case that can stand beside others, in lanes of `L`.
pub trait Beside<const L: usize>: Copy {
    /// The exact solution at the steps of a case.
    type Exact;
    /// What is noted of the steps of all lanes.
    type Track: Default;
    /// The default metrics of all lanes, one after the other.
    type Judged: AsRef<[Lane<L>]>;
    /// Those of one lane.
    type Alone: AsRef<[Lane<1>]>;

    /// What cases that move side by side have in common: law and number of modes.
    fn kind(&self) -> u64;
    /// Number of steps.
    fn last(&self) -> u64;
    /// What decides the exact solution at the case's steps.
    fn decides(&self) -> [f64; DECIDE];
    /// The exact solution at the case's steps.
    fn exact(&self) -> Self::Exact;
    /// All steps of a group, noted; for each lane whether its motion stays finite.
    fn moved(lanes: &[Self; L], track: &mut Self::Track) -> [bool; L];
    /// The metrics of all lanes, for cases that have this exact solution.
    fn judged(track: &Self::Track, exact: &Self::Exact) -> Self::Judged;
    /// The metrics of one lane.
    fn judged_alone(track: &Self::Track, lane: usize, exact: &Self::Exact) -> Self::Alone;
}

/// Numbers that decide an exact solution at a run's steps.
pub const DECIDE: usize = 5;

/// Least cases that share their exact solution for which all lanes are judged at once; fewer are judged one by one.
const SHARED: usize = 4;

/// Most steps of a case that moves beside others: longer runs would leave the processor's caches.
const LONGEST: u64 = 1 << 15;

/// The default metrics of the cases in these rows, in their order: side by side where they can, to the bit as each alone.
pub fn sweep<const L: usize, G: Beside<L>>(
    problem: &impl Problem,
    cases: &Cases,
    rows: &[u32],
    given: impl Fn(&Case) -> Option<G>,
) -> Found {
    let mut found = Found::new(rows.len(), defaults(problem));
    let mut beside: Vec<(usize, G)> = Vec::with_capacity(rows.len());
    let mut shown = cases.shown();
    for (place, row) in rows.iter().enumerate() {
        let case = shown.at(*row as usize);
        match given(case).filter(|case| case.last() <= LONGEST) {
            Some(case) => beside.push((place, case)),
            None => found.put(
                place,
                problem.solve(case, &[]).map(|solution| solution.metrics),
            ),
        }
    }
    let mut order: Vec<u128> = (0..)
        .zip(&beside)
        .map(|(i, (_, case))| rank(case, i))
        .collect();
    order.sort_unstable();
    let mut desk = Desk::default();
    for kind in order.chunk_by(|a, b| a >> KIND == b >> KIND) {
        for group in kind.chunks(L) {
            let members = group.iter().map(|rank| beside[*rank as u32 as usize]);
            desk.group::<L, G>(members, &mut found);
        }
    }
    found
}

/// How many metrics of a problem every study has: the first of its table.
pub fn defaults(problem: &(impl Problem + ?Sized)) -> usize {
    problem.metrics().iter().take_while(|m| m.default).count()
}

/// Bits of a rank below those of a case's kind.
const KIND: u32 = 80;

/// Alike cases side by side, those with as many steps next to them, so that a lane waits little for the others; then
/// those with one exact solution, by a sum that seldom puts others between them.
fn rank<const L: usize, G: Beside<L>>(case: &G, index: u32) -> u128 {
    let stirred = |sum: u64, x: f64| {
        let sum = (sum ^ x.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        sum ^ (sum >> 32)
    };
    let sum = case.decides().into_iter().fold(0, stirred) >> 32;
    let order = u128::from(case.kind()) << KIND | u128::from(case.last()) << 64;
    order | u128::from(sum) << 32 | u128::from(index)
}

/// What is used from group to group.
struct Desk<E, T> {
    track: T,
    /// The last exact solution, with what decides it.
    exact: Option<([f64; DECIDE], E)>,
}

impl<E, T: Default> Default for Desk<E, T> {
    fn default() -> Desk<E, T> {
        Desk {
            track: T::default(),
            exact: None,
        }
    }
}

impl<E, T> Desk<E, T> {
    /// Puts in the metrics of a group, at most L cases with the places that they have in `found`.
    // Arrays are filled by loops: past 16 lanes, maps of arrays stay a call for each lane.
    fn group<const L: usize, G>(
        &mut self,
        members: impl ExactSizeIterator<Item = (usize, G)> + Clone,
        found: &mut Found,
    ) where
        G: Beside<L, Exact = E, Track = T>,
    {
        let count = members.len();
        let Some((place, last)) = members.clone().last() else {
            return;
        };
        // The last group of a kind fills its lanes with its last case.
        let (mut places, mut lanes) = ([place; L], [last; L]);
        for (l, (place, case)) in members.enumerate() {
            (places[l], lanes[l]) = (place, case);
        }
        let finite = G::moved(&lanes, &mut self.track);
        for range in runs(&lanes[..count]) {
            let first = &lanes[range.start];
            let exact = match &mut self.exact {
                Some((kept, exact)) if same(*kept, first.decides()) => exact,
                other => &mut other.insert((first.decides(), first.exact())).1,
            };
            let all = (range.len() >= SHARED).then(|| G::judged(&self.track, exact));
            for l in range {
                let place = places[l];
                if !finite[l] {
                    found.fail(place, OUT_OF_RANGE.into());
                } else if let Some(all) = &all {
                    found.set(place, all.as_ref().iter().map(|metric| metric.0[l]));
                } else {
                    let alone = G::judged_alone(&self.track, l, exact);
                    found.set(place, alone.as_ref().iter().map(|metric| metric.0[0]));
                }
            }
        }
    }
}

/// Whether numbers are the same in all bits.
fn same(a: [f64; DECIDE], b: [f64; DECIDE]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

/// The runs of cases with the same steps and exact solution.
fn runs<const L: usize, G: Beside<L>>(lanes: &[G]) -> impl Iterator<Item = Range<usize>> {
    let mut from = 0;
    lanes
        .chunk_by(|a, b| a.last() == b.last() && same(a.decides(), b.decides()))
        .map(move |run| {
            let range = from..from + run.len();
            from = range.end;
            range
        })
}
