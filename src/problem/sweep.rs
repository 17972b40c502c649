//! Many cases side by side: in which order they fill lanes, and which share their exact solution.

use super::cases::Cases;
use super::found::Found;
use super::{Case, OUT_OF_RANGE, Problem};
use std::ops::Range;

/// A case that can stand beside others, in lanes of `L`.
pub trait Beside<const L: usize>: Copy {
    /// The exact solution at the steps of a case.
    type Exact;
    /// What is noted of the steps of all lanes.
    type Track: Default;
    /// The default metrics of a case.
    type Row: AsRef<[Option<f64>]>;

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
    fn judged(track: &Self::Track, exact: &Self::Exact) -> [Self::Row; L];
    /// The metrics of one lane.
    fn judged_alone(track: &Self::Track, lane: usize, exact: &Self::Exact) -> Self::Row;
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
            None => match problem.solve(case, &[]) {
                Ok(solution) => found.set(place, Ok(&solution.metrics[..])),
                Err(why) => found.set(place, Err(why)),
            },
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
            // The last group of a kind fills its lanes with its last case.
            let of_lane = |l: usize| beside[group[l.min(group.len() - 1)] as u32 as usize];
            desk.group(&std::array::from_fn(of_lane), group.len(), &mut found);
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
    exact: Option<([u64; DECIDE], E)>,
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
    /// Puts in the metrics of a group, of which the first `count` lanes are meant.
    fn group<const L: usize, G>(&mut self, lanes: &[(usize, G); L], count: usize, found: &mut Found)
    where
        G: Beside<L, Exact = E, Track = T>,
    {
        let finite = G::moved(&lanes.map(|(_, case)| case), &mut self.track);
        for range in runs(&lanes[..count]) {
            let first = &lanes[range.start].1;
            let key = key(first);
            let exact = match &mut self.exact {
                Some((kept, exact)) if *kept == key => exact,
                other => &mut other.insert((key, first.exact())).1,
            };
            let all = (range.len() >= SHARED).then(|| G::judged(&self.track, exact));
            for l in range {
                let alone = all
                    .is_none()
                    .then(|| G::judged_alone(&self.track, l, exact));
                let row = all.as_ref().map(|all| &all[l]).or(alone.as_ref());
                let metrics = match row {
                    Some(row) if finite[l] => Ok(row.as_ref()),
                    _ => Err(OUT_OF_RANGE.into()),
                };
                found.set(lanes[l].0, metrics);
            }
        }
    }
}

fn key<const L: usize, G: Beside<L>>(case: &G) -> [u64; DECIDE] {
    case.decides().map(f64::to_bits)
}

/// The runs of cases with the same steps and exact solution.
fn runs<const L: usize, G: Beside<L>>(lanes: &[(usize, G)]) -> impl Iterator<Item = Range<usize>> {
    let mut from = 0;
    lanes
        .chunk_by(|a, b| a.1.last() == b.1.last() && key(&a.1) == key(&b.1))
        .map(move |run| {
            let range = from..from + run.len();
            from = range.end;
            range
        })
}
