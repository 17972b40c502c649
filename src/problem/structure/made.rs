//! Signals that cases share, so that samples are computed once for all cases with the same numbers.

use crate::system::structure::Signal;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Most numbers of all kept signals: 64 MiB, or 1397 synthetic records.
const MOST_NUMBERS: usize = 8 << 20;

/// Numbers that a kept signal needs besides its points: key and pointers.
const OVERHEAD: usize = 32;

/// The signals made so far, by the bits of their numbers.
#[derive(Debug, Default)]
pub struct Made {
    signals: BTreeMap<Vec<u64>, Arc<Signal>>,
    numbers: usize,
}

impl Made {
    /// The signal with this key.
    pub fn get(&self, key: &[u64]) -> Option<Arc<Signal>> {
        self.signals.get(key).cloned()
    }

    /// Keeps a signal. If there are too many, every second one is dropped first: a sweep that returns to the same records still
    /// finds half of them.
    pub fn keep(&mut self, key: Vec<u64>, signal: Arc<Signal>) {
        let own = numbers(&signal);
        while self.numbers + own > MOST_NUMBERS && !self.signals.is_empty() {
            let mut kept = false;
            self.signals.retain(|_, _| {
                kept = !kept;
                !kept
            });
            self.numbers = self.signals.values().map(|signal| numbers(signal)).sum();
        }
        self.numbers += own;
        if let Some(replaced) = self.signals.insert(key, signal) {
            self.numbers -= numbers(&replaced);
        }
    }
}

/// Size of a kept signal in numbers.
fn numbers(signal: &Signal) -> usize {
    OVERHEAD
        + match signal {
            Signal::Table(table) => 2 * table.times().len(),
            Signal::Sine { .. } => 0,
        }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::structure::Table;

    #[test]
    fn the_memory_of_kept_signals_is_bounded_and_the_last_ones_are_found() {
        let mut made = Made::default();
        let points = MOST_NUMBERS / 16;
        let times: Vec<f64> = (0..points).map(|i| i as f64).collect();
        let table = Table::new(times, vec![0.0; points]).unwrap();
        let signal = Arc::new(Signal::Table(table));
        for key in 0..100 {
            made.keep(vec![key], signal.clone());
            assert!(made.get(&[key]).is_some());
            // 8 of 1/8 and its overhead do not fit.
            assert!((1..=7).contains(&made.signals.len().max(1)));
            assert!(made.numbers <= MOST_NUMBERS);
            assert_eq!(made.numbers, made.signals.len() * numbers(&signal));
        }
        // A signal that is larger than all that may be kept is kept alone.
        let times: Vec<f64> = (0..MOST_NUMBERS).map(|i| i as f64).collect();
        let table = Table::new(times, vec![0.0; MOST_NUMBERS]).unwrap();
        made.keep(vec![1000], Arc::new(Signal::Table(table)));
        assert_eq!(made.signals.len(), 1);
        made.keep(vec![0], signal);
        assert_eq!(made.signals.len(), 1);
    }
}
