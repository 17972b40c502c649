//! Signals that cases share, so that samples are computed once for all cases with the same numbers.

use crate::problem::Violation;
use crate::system::structure::Signal;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// Most numbers of all kept signals: 64 MiB, or 1386 synthetic records.
pub const MOST_NUMBERS: usize = 8 << 20;

/// Numbers that a kept signal needs besides its points: key and pointers.
const OVERHEAD: usize = 32;

/// A signal that one of the cases which need it makes, while the others wait for it.
pub type Cell = Arc<OnceLock<Result<Arc<Signal>, Violation>>>;

/// The signals made so far, by the bits of their numbers.
#[derive(Debug, Default)]
pub struct SignalCache {
    signals: BTreeMap<Vec<u64>, Kept>,
    numbers: usize,
    clock: u64,
    /// Number of sampled signals that were made, those that are no longer kept included.
    pub count: u64,
}

/// A kept signal.
#[derive(Debug)]
struct Kept {
    cell: Cell,
    numbers: usize,
    /// When it was used last.
    used: u64,
}

impl SignalCache {
    /// The signal with this key, which has so many points. If there are too many numbers, the signals that were not used for the
    /// longest time are dropped first, half of the numbers at a time.
    pub fn cell(&mut self, key: &[u64], points: usize) -> Cell {
        self.clock += 1;
        if let Some(kept) = self.signals.get_mut(key) {
            kept.used = self.clock;
            return kept.cell.clone();
        }
        let numbers = numbers(points);
        if self.numbers + numbers > MOST_NUMBERS {
            self.drop_oldest();
        }
        self.numbers += numbers;
        let kept = Kept {
            cell: Cell::default(),
            numbers,
            used: self.clock,
        };
        let cell = kept.cell.clone();
        self.signals.insert(key.to_vec(), kept);
        cell
    }

    fn drop_oldest(&mut self) {
        let mut ages: Vec<(u64, usize)> =
            self.signals.values().map(|k| (k.used, k.numbers)).collect();
        ages.sort_unstable();
        let (mut left, mut before) = (self.numbers, 0);
        for (used, numbers) in ages {
            if left <= MOST_NUMBERS / 2 {
                break;
            }
            (left, before) = (left - numbers, used);
        }
        self.signals.retain(|_, kept| kept.used > before);
        self.numbers = left;
    }
}

/// Size of a kept signal with so many points, in numbers.
pub fn numbers(points: usize) -> usize {
    OVERHEAD + 2 * points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_memory_of_kept_signals_is_bounded_and_those_used_last_are_found() {
        let mut made = SignalCache::default();
        let points = MOST_NUMBERS / 16;
        let first = made.cell(&[0], points);
        for key in 1..100 {
            let cell = made.cell(&[key], points);
            assert!(Arc::ptr_eq(&cell, &made.cell(&[key], points)));
            // Used again and again, it stays.
            assert!(Arc::ptr_eq(&first, &made.cell(&[0], points)));
            // 8 of 1/8 and its overhead do not fit.
            assert!((2..=7).contains(&made.signals.len()));
            assert_eq!(made.numbers, made.signals.len() * numbers(points));
        }
        // A signal that is larger than all that may be kept is kept alone.
        made.cell(&[1000], MOST_NUMBERS);
        made.cell(&[1001], MOST_NUMBERS);
        assert_eq!(made.signals.len(), 1);
        made.cell(&[0], points);
        assert_eq!(made.signals.len(), 1);
    }
}
