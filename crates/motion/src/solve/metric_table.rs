//! The metrics of many cases.

use super::{Unsolvable, Warnings};
use crate::lane::Lane;
use std::collections::BTreeMap;
use std::ops::Range;

/// The metrics of many cases, column by column, why some have none, and the warnings of others.
///
/// ```
/// use slipgap_motion::solve::{MetricTable, Unsolvable};
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
    /// The columns one after the other; NaN for an undefined metric: half of the memory of an option.
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
        (0..self.width).map(move |metric| self.value(case, metric))
    }

    /// A metric of a case; `None` if it is undefined.
    pub fn value(&self, case: usize, metric: usize) -> Option<f64> {
        let inside = metric < self.width;
        inside.then(|| defined(self.metrics[metric * self.len + case]))?
    }

    /// A metric of every case, NaN where it is undefined; `None` if the table does not have the metric.
    pub fn numbers(&self, metric: usize) -> Option<&[f64]> {
        let inside = metric < self.width;
        inside.then(|| &self.metrics[metric * self.len..(metric + 1) * self.len])
    }

    /// A metric of every case; `None` if one is undefined.
    pub fn column(&self, metric: usize) -> impl Iterator<Item = Option<f64>> + '_ {
        (0..self.len).map(move |case| self.value(case, metric))
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
        let by_row = self.warnings.iter().copied().enumerate();
        by_row.filter(|(_, warnings)| !warnings.is_empty())
    }

    /// Number of cases that were solved and do not have a metric.
    pub fn solved_without(&self, metric: usize) -> u64 {
        let without = |(case, cell): &(usize, Option<f64>)| {
            cell.is_none() && !self.failures.contains_key(case)
        };
        self.column(metric).enumerate().filter(without).count() as u64
    }

    /// Sets the metrics of a case, at most as many as there are columns; those that are not finite are undefined.
    #[inline]
    pub fn set(&mut self, case: usize, metrics: impl Iterator<Item = f64>) {
        let len = self.len;
        for (metric, x) in metrics.take(self.width).enumerate() {
            self.metrics[metric * len + case] = finite_or_nan(x);
        }
    }

    /// Sets the metrics of the cases in some lanes, each in its row, at most as many as there are columns; those of cases that are not
    /// solved are undefined.
    #[inline]
    pub fn set_lanes<const L: usize>(
        &mut self,
        rows: &[usize; L],
        lanes: Range<usize>,
        metrics: &[Lane<L>],
        solved: &[bool; L],
    ) {
        let len = self.len;
        let zero = solved.map(|solved| if solved { 0.0 } else { f64::NAN });
        // Most sweeps have consecutive rows: one bound to check, and several numbers at a time.
        let consecutive = lanes == (0..L) && (1..L).all(|lane| rows[lane] == rows[0] + lane);
        for (metric, x) in metrics.iter().take(self.width).enumerate() {
            let column = &mut self.metrics[metric * len..(metric + 1) * len];
            if consecutive {
                let cells = &mut column[rows[0]..rows[0] + L];
                for (lane, to) in cells.iter_mut().enumerate() {
                    *to = x.0[lane] + zero[lane] * x.0[lane];
                }
                continue;
            }
            for lane in lanes.clone() {
                let x = x.0[lane];
                column[rows[lane]] = x + zero[lane] * x;
            }
        }
    }

    /// Sets a metric of every case; those that are not finite are undefined.
    pub fn set_column(&mut self, metric: usize, values: impl Iterator<Item = f64>) {
        let column = &mut self.metrics[metric * self.len..(metric + 1) * self.len];
        for (to, x) in column.iter_mut().zip(values) {
            *to = finite_or_nan(x);
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
        for metric in 0..other.width {
            self.metrics[metric * self.len + case] = other.metrics[metric * other.len + from];
        }
        if let Some(why) = other.failure(from) {
            self.failures.insert(case, why.clone());
        }
        self.warn(case, other.warnings(from));
    }

    /// Tables of the same width, one below the other.
    pub fn joined(mut tables: Vec<MetricTable>) -> MetricTable {
        if tables.len() == 1 {
            return tables.remove(0);
        }
        let (len, width) = (
            tables.iter().map(|table| table.len).sum(),
            tables.first().map_or(0, |table| table.width),
        );
        let mut joined = MetricTable {
            len,
            width,
            ..MetricTable::default()
        };
        joined.metrics.reserve_exact(len * width);
        for metric in 0..width {
            let columns = tables.iter().filter_map(|table| table.numbers(metric));
            columns.for_each(|column| joined.metrics.extend_from_slice(column));
        }
        let mut start = 0;
        for table in tables {
            let moved = table.failures.into_iter();
            joined
                .failures
                .extend(moved.map(|(case, why)| (start + case, why)));
            for (case, warnings) in table.warnings.iter().enumerate() {
                joined.warn(start + case, *warnings);
            }
            start += table.len;
        }
        joined
    }

    /// The table with `width` columns, which are at least as many; the new ones have no values.
    pub fn widened(mut self, width: usize) -> MetricTable {
        self.metrics.resize(self.len * width, f64::NAN);
        self.width = width;
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
        for (tables, row) in [
            (vec![without.clone(), with.clone()], 3),
            (vec![with.clone(), without], 1),
        ] {
            let joined = MetricTable::joined(tables);
            assert_eq!(joined.warned().collect::<Vec<_>>(), [(row, gain)]);
        }
        let mut copy = MetricTable::new(1, 1);
        copy.copy(0, &with, 1);
        assert_eq!(copy.warnings(0), gain);
        copy.copy(0, &with, 0);
        assert!(copy.warnings(0).is_empty());
    }

    #[test]
    fn rows_columns_and_lanes_are_the_same_numbers() {
        let mut table = MetricTable::new(3, 2);
        table.set(1, [10.0, 11.0, 12.0].into_iter());
        let lanes = [Lane([20.0, 0.0, f64::INFINITY]), Lane([21.0, 1.0, 9.0])];
        table.set_lanes(&[2, 0, 1], 0..2, &lanes, &[true; 3]);
        assert_eq!(table.numbers(0), Some(&[0.0, 10.0, 20.0][..]));
        assert_eq!(table.numbers(1), Some(&[1.0, 11.0, 21.0][..]));
        assert_eq!(table.numbers(2), None);
        let mut more = table.clone().widened(3);
        more.set_column(2, [5.0, f64::INFINITY, 7.0].into_iter());
        for (case, third) in [(0, Some(5.0)), (1, None), (2, Some(7.0))] {
            let row: Vec<_> = table.row(case).chain([third]).collect();
            assert_eq!(more.row(case).collect::<Vec<_>>(), row);
        }
        let joined = MetricTable::joined(vec![table.clone(), MetricTable::new(1, 2), table]);
        let column: Vec<_> = joined.column(1).collect();
        let [a, b, c] = [1.0, 11.0, 21.0].map(Some);
        assert_eq!(column, [a, b, c, None, a, b, c]);
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
