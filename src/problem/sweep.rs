//! Many cases side by side: in which order they fill lanes, and which share their exact solution.

use super::Case;
use std::ops::Range;

/// The metrics of a case, or why there are none.
pub type Metrics = Result<Vec<Option<f64>>, String>;

/// A case that can stand beside others.
pub trait Beside: Copy {
    /// What cases that move side by side have in common: law and number of modes.
    fn kind(&self) -> u64;
    /// Number of steps.
    fn last(&self) -> u64;
    /// What decides the exact solution at the case's steps.
    fn exact(&self) -> [u64; EXACT];
}

/// Numbers that decide an exact solution at a run's steps.
pub const EXACT: usize = 5;

/// Least cases that share their exact solution for which all lanes are judged at once; fewer are judged one by one.
const SHARED: usize = 4;

/// Most steps of a case that moves beside others: longer runs would leave the processor's caches.
const LONGEST: u64 = 1 << 15;

/// Metrics of all cases: `together` those that can move side by side, each of the rest `alone`.
pub fn split<G: Beside>(
    cases: &[&Case],
    given: impl Fn(&Case) -> Option<G>,
    together: impl Fn(&[G]) -> Vec<Metrics>,
    alone: impl Fn(&Case) -> Metrics,
) -> Vec<Metrics> {
    let given: Vec<Option<G>> = cases
        .iter()
        .map(|case| given(case).filter(|case| case.last() <= LONGEST))
        .collect();
    let lanes: Vec<G> = given.iter().flatten().copied().collect();
    let mut lanes = together(&lanes).into_iter();
    let metrics = |(case, given): (&&Case, &Option<G>)| match given {
        Some(_) => lanes.next().unwrap_or_else(|| alone(case)),
        None => alone(case),
    };
    cases.iter().zip(&given).map(metrics).collect()
}

/// The cases in lanes of `L`: `solve` is given as many cases as there are lanes and the numbers of those that are meant
/// (the last lanes may repeat a case), in runs that share their exact solution.
pub fn sweep<const L: usize, G: Beside>(cases: &[G], mut solve: impl FnMut(&[G; L], &[u32])) {
    let mut order: Vec<(u64, [u64; EXACT], u32)> = (0..)
        .zip(cases)
        .map(|(i, case)| (case.kind() << 32 | case.last(), case.exact(), i))
        .collect();
    // Alike cases side by side, those with as many steps next to them: what a lane waits for the others is little.
    order.sort_unstable();
    for kind in order.chunk_by(|a, b| a.0 >> 32 == b.0 >> 32) {
        for group in kind.chunks(L) {
            let last = group.len() - 1;
            let lanes = std::array::from_fn(|l| cases[group[l.min(last)].2 as usize]);
            let numbers: Vec<u32> = group.iter().map(|(_, _, i)| *i).collect();
            solve(&lanes, &numbers);
        }
    }
}

/// The default metrics, and none of the others of a table of `len`.
pub fn row(own: &[Option<f64>], len: usize) -> Vec<Option<f64>> {
    let mut row = vec![None; len];
    row[..own.len()].copy_from_slice(own);
    row
}

/// The runs of equal cases among the first `count` lanes, and whether all lanes are judged at once for them.
pub fn runs<G: Beside>(lanes: &[G], count: usize) -> impl Iterator<Item = (Range<usize>, bool)> {
    let mut from = 0;
    lanes[..count]
        .chunk_by(|a, b| a.last() == b.last() && a.exact() == b.exact())
        .map(move |run| {
            let range = from..from + run.len();
            from = range.end;
            (range, run.len() >= SHARED)
        })
}
