//! The metrics of many cases.

use super::{Unsolvable, Warnings};
use std::collections::BTreeMap;

/// The metrics of many cases, row by row, why some have none, and the warnings of others.
///
/// ```
/// use slipgap_solver::solve::{MetricTable, Unsolvable};
///
/// let mut table = MetricTable::new(3, 2);
/// table.set(0, [0.5, f64::NAN].into_iter());
/// table.fail(2, Unsolvable::OutOfRange);
/// assert_eq!(table.row(0).collect::<Vec<_>>(), [Some(0.5), None]);
/// assert_eq!(table.column(0).collect::<Vec<_>>(), [Some(0.5), None, None]);
/// // Cases 0 and 1 have no second metric; case 2 was not solved.
/// assert_eq!(table.solved_without(1), 2);
/// assert_eq!(table.failure(2), Some(&Unsolvable::OutOfRange));
/// ```
#[derive(Debug, Clone, Default)]
pub struct MetricTable {
    len: usize,
    width: usize,
    /// NaN for an undefined metric: half of the memory of an option.
    metrics: Vec<f64>,
    failures: BTreeMap<usize, Unsolvable>,
    /// Empty if no case has a warning.
    warnings: Vec<Warnings>,
}

impl MetricTable {
    /// `len` cases without metrics, with room for the first `width` metrics of the problem's table.
    pub fn new(len: usize, width: usize) -> MetricTable {
        MetricTable {
            len,
            width,
            metrics: vec![f64::NAN; len * width],
            failures: BTreeMap::new(),
            warnings: Vec::new(),
        }
    }

    /// Number of cases.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The metrics of a case, the first ones of the problem's table.
    pub fn row(&self, case: usize) -> impl Iterator<Item = Option<f64>> + '_ {
        let row = &self.metrics[case * self.width..(case + 1) * self.width];
        row.iter().map(|x| defined(*x))
    }

    /// A metric of every case; `None` if one is undefined.
    pub fn column(&self, metric: usize) -> impl Iterator<Item = Option<f64>> + '_ {
        let (inside, width) = (metric < self.width, self.width);
        let cell = move |case: usize| match inside {
            true => defined(self.metrics[case * width + metric]),
            false => None,
        };
        (0..self.len).map(cell)
    }

    /// Why a case could not be solved, if so.
    pub fn failure(&self, case: usize) -> Option<&Unsolvable> {
        self.failures.get(&case)
    }

    /// The cases that could not be solved, in increasing order, and why.
    pub fn failures(&self) -> impl Iterator<Item = (usize, &Unsolvable)> {
        self.failures.iter().map(|(case, why)| (*case, why))
    }

    /// The warnings of a case.
    pub fn warnings(&self, case: usize) -> Warnings {
        self.warnings.get(case).copied().unwrap_or_default()
    }

    /// The cases with warnings, in increasing order.
    pub fn warned(&self) -> impl Iterator<Item = (usize, Warnings)> + '_ {
        let all = self.warnings.iter().copied().enumerate();
        all.filter(|(_, warnings)| !warnings.is_empty())
    }

    /// Number of cases that were solved and do not have a metric.
    pub fn solved_without(&self, metric: usize) -> u64 {
        let without = |(case, cell): &(usize, Option<f64>)| {
            cell.is_none() && !self.failures.contains_key(case)
        };
        self.column(metric).enumerate().filter(without).count() as u64
    }

    /// Sets the metrics of a case, at most as many as there are in a row; those that are not finite are undefined.
    #[inline]
    pub fn set(&mut self, case: usize, metrics: impl Iterator<Item = f64>) {
        let row = &mut self.metrics[case * self.width..(case + 1) * self.width];
        let mut cells = row.iter_mut();
        // In a sweep the number of metrics is known to the compiler, that of cells is not: a zip would not be unrolled.
        for metric in metrics {
            let Some(x) = cells.next() else { return };
            *x = finite_or_nan(metric);
        }
    }

    /// Records why a case could not be solved.
    pub fn fail(&mut self, case: usize, why: Unsolvable) {
        self.failures.insert(case, why);
    }

    /// Sets the warnings of a case.
    #[inline]
    pub fn warn(&mut self, case: usize, warnings: Warnings) {
        if warnings.is_empty() && self.warnings.is_empty() {
            return;
        }
        self.warnings.resize(self.len, Warnings::NONE);
        self.warnings[case] = warnings;
    }

    /// Sets the result of a case: its metrics, or why it could not be solved.
    pub fn put(&mut self, case: usize, metrics: Result<Vec<Option<f64>>, Unsolvable>) {
        match metrics {
            Ok(row) => self.set(case, row.iter().map(|x| x.unwrap_or(f64::NAN))),
            Err(why) => self.fail(case, why),
        }
    }

    /// Copies a case of another table, which has at most as many columns.
    pub fn copy(&mut self, case: usize, other: &MetricTable, from: usize) {
        let (to, row) = (
            case * self.width,
            from * other.width..(from + 1) * other.width,
        );
        self.metrics[to..to + other.width].copy_from_slice(&other.metrics[row]);
        if let Some(why) = other.failure(from) {
            self.failures.insert(case, why.clone());
        }
        self.warn(case, other.warnings(from));
    }

    /// This table and another of the same width below it.
    pub fn followed_by(mut self, below: MetricTable) -> MetricTable {
        let moved = below.failures.into_iter();
        self.failures
            .extend(moved.map(|(case, why)| (self.len + case, why)));
        self.metrics.extend(below.metrics);
        if !self.warnings.is_empty() || !below.warnings.is_empty() {
            self.warnings.resize(self.len, Warnings::NONE);
            self.warnings.extend(below.warnings);
            self.warnings.resize(self.len + below.len, Warnings::NONE);
        }
        self.len += below.len;
        self
    }
}

/// The number itself if it is finite, else NaN: 0 times an infinity is NaN. It needs fewer instructions than a choice.
fn finite_or_nan(x: f64) -> f64 {
    x + 0.0 * x
}

fn defined(x: f64) -> Option<f64> {
    (!x.is_nan()).then_some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_follow_their_cases() {
        use crate::solve::Warning;
        let gain = Warnings::NONE.with(Warning::ContactGain, true);
        let (without, mut with) = (MetricTable::new(2, 1), MetricTable::new(3, 1));
        with.warn(0, Warnings::NONE);
        assert_eq!(with.warned().count(), 0);
        with.warn(1, gain);
        for (joined, place) in [
            (without.clone().followed_by(with.clone()), 3),
            (with.clone().followed_by(without), 1),
        ] {
            assert_eq!(joined.warned().collect::<Vec<_>>(), [(place, gain)]);
        }
        let mut copy = MetricTable::new(1, 1);
        copy.copy(0, &with, 1);
        assert_eq!(copy.warnings(0), gain);
        copy.copy(0, &with, 0);
        assert!(copy.warnings(0).is_empty());
    }

    #[test]
    fn finite_numbers_keep_their_bits_and_others_are_undefined() {
        let numbers = [
            0.0,
            1.0,
            0.1,
            5e-324,
            f64::MIN_POSITIVE,
            f64::MAX,
            1.0 / 3.0,
        ];
        for x in numbers.into_iter().flat_map(|x| [x, -x]) {
            assert_eq!(finite_or_nan(x).to_bits(), x.to_bits(), "{x:e}");
        }
        for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert!(finite_or_nan(x).is_nan(), "{x}");
        }
    }
}
