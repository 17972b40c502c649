//! Many cases in lanes: their order, and which of them have the same reference.

use super::metric_table::MetricTable;
use super::{Loops, Motion, ToSystem, Track, Unsolvable, Warnings, advance};
use crate::lane::Lane;
use crate::methods::ModeCount;
use crate::system::System;
use std::ops::Range;

/// A case in the form for lanes: L of them are solved together.
pub trait LaneCase<const L: usize>: ToSystem {
    /// The exact solution at the steps of a case.
    type Reference;
    /// How many modes the cases have.
    type Modes: ModeCount;
    /// What is recorded of the steps.
    type Track: Track<L>;
    /// The laws that have a loop over steps of their own.
    type Loops: Loops<L>;
    /// The default metrics of all lanes, one after the other.
    type Metrics: AsRef<[Lane<L>]>;
    /// Those of one lane.
    type OneMetrics: AsRef<[Lane<1>]>;

    /// The numbers that the exact solution at the case's steps depends on.
    fn reference_key(&self) -> ReferenceKey;
    /// The exact solution at the case's steps.
    fn reference(&self) -> Self::Reference;
    /// Changes the motion of the modes to that of the contacts, where they differ.
    fn condense(_cases: &[Self; L], _motion: &mut Motion<L, Self::Track>) {}
    /// The metrics of all lanes, for cases that have this exact solution.
    fn metrics(
        cases: &[Self; L],
        motion: &Motion<L, Self::Track>,
        reference: &Self::Reference,
    ) -> Self::Metrics;
    /// The metrics of one lane.
    fn metrics_of_one(
        &self,
        motion: &Motion<L, Self::Track>,
        lane: usize,
        reference: &Self::Reference,
    ) -> Self::OneMetrics;
    /// The warnings of a case with these metrics.
    #[inline(always)]
    fn warnings(&self, _metrics: impl Fn(usize) -> f64) -> Warnings {
        Warnings::NONE
    }
}

/// The numbers that an exact solution at the steps of a run depends on.
pub type ReferenceKey = [f64; 5];

/// Smallest number of cases with one exact solution for which the metrics of all lanes are computed together; those of fewer cases
/// are computed one by one.
const SHARED: usize = 4;

/// Most steps of a case that is solved together with others: longer runs would not fit in the caches of the processor.
pub const LONGEST: u64 = 1 << 15;

/// Puts the default metrics of cases in the table, each in its row. They have the same bits as those of a single case.
pub fn sweep<const L: usize, C: LaneCase<L>>(cases: &[(usize, C)], table: &mut MetricTable) {
    let mut scratch = Scratch::default();
    // Mostly all cases are of one kind and have one exact solution.
    let first = cases.first().map(|(_, case)| (case, kind(&case.system())));
    let similar = |(_, case): &(usize, C)| {
        first.is_some_and(|(first, first_kind)| {
            alike(first, case) && kind(&case.system()) == first_kind
        })
    };
    if cases.iter().all(similar) {
        for group in cases.chunks(L) {
            scratch.group::<C>(group, table);
        }
        return;
    }
    let mut order: Vec<u128> = (0..)
        .zip(cases)
        .map(|(i, (_, case))| rank(case, i))
        .collect();
    order.sort_unstable();
    let mut members = Vec::with_capacity(L);
    for kind in order.chunk_by(|a, b| a >> KIND == b >> KIND) {
        for group in kind.chunks(L) {
            members.clear();
            members.extend(group.iter().map(|rank| cases[*rank as u32 as usize]));
            scratch.group::<C>(&members, table);
        }
    }
}

/// Bits of a rank below those of a case's kind.
const KIND: u32 = 80;

/// The order of cases: first by their kind; then by number of steps, so that lanes end at similar times; then by a checksum of the
/// exact solution, so that cases with one exact solution are together.
fn rank<const L: usize, C: LaneCase<L>>(case: &C, index: u32) -> u128 {
    let mixed = |sum: u64, x: f64| {
        let sum = (sum ^ x.to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        sum ^ (sum >> 32)
    };
    let sum = case.reference_key().into_iter().fold(0, mixed) >> 32;
    let system = case.system();
    let kind = u128::from(kind(&system));
    kind << KIND | u128::from(system.last) << 64 | u128::from(sum) << 32 | u128::from(index)
}

/// The kind of a system: its method, its law and its number of modes, which all lanes of a group share.
#[inline(always)]
fn kind(system: &System) -> u64 {
    let kinds = u64::from(system.method.scheme()) << 5 | system.law.which() as u64;
    kinds << 40 | system.linear.len() as u64
}

/// Memory that all groups use.
struct Scratch<const L: usize, E, T> {
    motion: Motion<L, T>,
    /// The last exact solution, with its key.
    reference: Option<(ReferenceKey, E)>,
}

impl<const L: usize, E, T: Default> Default for Scratch<L, E, T> {
    fn default() -> Self {
        Scratch {
            motion: Motion::default(),
            reference: None,
        }
    }
}

impl<const L: usize, E, T: Track<L>> Scratch<L, E, T> {
    /// Puts in the table the metrics of a group, at most L cases with their rows.
    // Arrays are filled by loops: with more than 16 lanes, maps of arrays are not inlined.
    fn group<C>(&mut self, members: &[(usize, C)], table: &mut MetricTable)
    where
        C: LaneCase<L, Reference = E, Track = T>,
    {
        let count = members.len();
        let Some(&(row, last)) = members.last() else {
            return;
        };
        // The last group of a kind fills its lanes with its last case.
        let (mut rows, mut lanes) = ([row; L], [last; L]);
        for (l, (row, case)) in members.iter().enumerate() {
            (rows[l], lanes[l]) = (*row, *case);
        }
        let finite = advance::<L, C::Modes, T, C::Loops, C>(&lanes, &mut self.motion);
        C::condense(&lanes, &mut self.motion);
        for range in runs(&lanes[..count]) {
            let first = &lanes[range.start];
            let reference = match &mut self.reference {
                Some((key, reference)) if same(*key, first.reference_key()) => reference,
                other => &mut other.insert((first.reference_key(), first.reference())).1,
            };
            for l in range.clone().filter(|l| !finite[*l]) {
                table.fail(rows[l], Unsolvable::OutOfRange);
            }
            let solved = range.clone().filter(|l| finite[*l]);
            if range.len() >= SHARED {
                let values = C::metrics(&lanes, &self.motion, reference);
                table.set_lanes(&rows, range, values.as_ref(), &finite);
                for l in solved {
                    table.warn(rows[l], lanes[l].warnings(|i| values.as_ref()[i].0[l]));
                }
            } else {
                for l in solved {
                    let one = lanes[l].metrics_of_one(&self.motion, l, reference);
                    table.set(rows[l], one.as_ref().iter().map(|metric| metric.0[0]));
                    table.warn(rows[l], lanes[l].warnings(|i| one.as_ref()[i].0[0]));
                }
            }
        }
    }
}

/// Whether numbers are the same in all bits.
// Without branches: else the compiler calls `memcmp`.
#[inline(always)]
fn same(a: ReferenceKey, b: ReferenceKey) -> bool {
    let differ = |i: usize| a[i].to_bits() ^ b[i].to_bits();
    (0..a.len()).fold(0, |bits, i| bits | differ(i)) == 0
}

/// Whether two cases have the same number of steps and the same exact solution.
#[inline(always)]
fn alike<const L: usize, C: LaneCase<L>>(a: &C, b: &C) -> bool {
    a.system().last == b.system().last && same(a.reference_key(), b.reference_key())
}

/// The runs of cases that are alike.
fn runs<const L: usize, C: LaneCase<L>>(lanes: &[C]) -> impl Iterator<Item = Range<usize>> {
    let mut from = 0;
    lanes.chunk_by(alike).map(move |run| {
        let range = from..from + run.len();
        from = range.end;
        range
    })
}
