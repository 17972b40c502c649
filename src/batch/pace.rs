//! How fast a run computes, for the time that is left: what it finds in the store is no speed.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Work of a run, in steps times modes: what is done of it, and how.
#[derive(Debug)]
pub struct Pace {
    all: f64,
    done: Mutex<Work>,
}

/// Work that is done.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Work {
    /// Of cases that the store had.
    pub found: f64,
    /// Of cases that this run computed.
    pub computed: f64,
    /// When this run began to compute.
    began: Option<Instant>,
}

impl Pace {
    /// Nothing done yet of so much work.
    pub fn new(all: f64) -> Pace {
        Pace {
            all,
            done: Mutex::default(),
        }
    }

    /// Notes that computing begins, if it has not begun.
    pub fn begin(&self) {
        self.lock().began.get_or_insert_with(Instant::now);
    }

    /// Adds work of cases that the store had.
    pub fn found(&self, work: f64) {
        self.lock().found += work;
    }

    /// Adds work of cases that this run computed.
    pub fn computed(&self, work: f64) {
        self.lock().computed += work;
    }

    /// What is done.
    pub fn done(&self) -> Work {
        *self.lock()
    }

    /// The time left, at the rate of this run; none before it has computed anything.
    pub fn left(&self) -> Option<Duration> {
        let since = self.done().began?.elapsed();
        self.left_after(since)
    }

    /// The same where it has computed for so long.
    fn left_after(&self, computing: Duration) -> Option<Duration> {
        let done = self.done();
        let left = (self.all - done.found - done.computed).max(0.0);
        let seconds = left / done.computed * computing.as_secs_f64();
        Duration::try_from_secs_f64(seconds).ok()
    }

    fn lock(&self) -> MutexGuard<'_, Work> {
        self.done.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::store::Store;
    use crate::batch::{Wishes, run};
    use crate::study::parse;
    use indicatif::ProgressBar;

    #[test]
    fn a_run_tells_what_it_found_and_what_it_computed() {
        let folder = tempfile::tempdir().unwrap();
        // Steps of 0.1 up to 3; so many cases in chunks of 16 384.
        let work = |betas: u64| {
            let text = format!(
                r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "dT": 0.1, "duration": 3,
                "beta": {{"range": [1, {betas}, 1]}}}}}}"#
            );
            let study = parse("s.json", &text).unwrap();
            let (store, pace) = (Store::open(folder.path()).unwrap(), Pace::new(0.0));
            let wishes = Wishes {
                store: Some(&store),
                pace: Some(&pace),
                ..Wishes::METRICS
            };
            run(&study, &ProgressBar::hidden(), &wishes, |_| Ok(())).unwrap();
            store.close().unwrap();
            let done = pace.done();
            [done.found, done.computed]
        };
        let steps = |cases: u64| 30.0 * cases as f64;
        assert_eq!(work(16_384), [0.0, steps(16_384)]);
        assert_eq!(work(20_000), [steps(16_384), steps(3616)]);
        assert_eq!(work(20_000), [steps(20_000), 0.0]);
    }

    #[test]
    fn cases_from_the_store_do_not_change_the_rate() {
        let pace = Pace::new(100.0);
        let computing = Duration::from_secs(4);
        assert_eq!(pace.left_after(computing), None);
        pace.found(60.0);
        assert_eq!(pace.left_after(computing), None);
        pace.computed(10.0);
        // 30 are left, and 10 took 4 s; with the store's 60 as speed it would be 30/70 of 4 s.
        assert_eq!(pace.left_after(computing), Some(Duration::from_secs(12)));
        // More from the store: 10 are left, at the same rate.
        pace.found(20.0);
        assert_eq!(pace.left_after(computing), Some(Duration::from_secs(4)));
        // The total of very many cases is an estimate: less than is done of it leaves no time.
        pace.computed(50.0);
        assert_eq!(pace.left_after(computing), Some(Duration::ZERO));
    }
}
