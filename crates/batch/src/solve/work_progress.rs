//! The finished work of a run, and the time left. Cases from the store do not count as speed. A run can be stopped by it.

use crate::files::heartbeat::Computed;
use slipgap_study::error::Error;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The work of a run, in steps times modes, and how much of it is finished.
#[derive(Debug)]
pub struct WorkProgress {
    total: f64,
    finished: Mutex<Finished>,
    stopped: AtomicBool,
}

/// Finished work.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Finished {
    /// Of cases from the store.
    pub stored: f64,
    /// Of cases that this run computed.
    pub computed: f64,
    /// Number of cases that this run computed.
    pub cases: u64,
    /// When this run started to compute.
    started: Option<Instant>,
}

impl WorkProgress {
    /// Nothing finished yet of this work.
    pub fn new(total: f64) -> WorkProgress {
        WorkProgress {
            total,
            finished: Mutex::default(),
            stopped: AtomicBool::new(false),
        }
    }

    /// Ends the run before its next sweep, from any thread.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// [`Error::Interrupted`] if the run is stopped.
    pub fn go_on(&self) -> Result<(), Error> {
        match self.stopped.load(Ordering::Relaxed) {
            true => Err(Error::Interrupted),
            false => Ok(()),
        }
    }

    /// Starts the clock, unless it runs.
    pub fn start_computing(&self) {
        self.lock().started.get_or_insert_with(Instant::now);
    }

    /// Adds work of cases from the store.
    pub fn add_stored(&self, work: f64) {
        self.lock().stored += work;
    }

    /// Adds cases that this run computed, with their work.
    pub fn add_computed(&self, cases: u64, work: f64) {
        let mut finished = self.lock();
        finished.computed += work;
        finished.cases += cases;
    }

    /// What this run has computed so far, and the time since it started to.
    pub fn computed(&self) -> Computed {
        let finished = self.finished();
        let elapsed = finished.started.map(|started| started.elapsed());
        Computed {
            seconds: elapsed.unwrap_or_default().as_secs_f64(),
            cases: finished.cases,
            work: finished.computed,
        }
    }

    /// The work finished so far.
    pub fn finished(&self) -> Finished {
        *self.lock()
    }

    /// The time left, at the rate of this run; `None` before it has computed anything.
    pub fn time_left(&self) -> Option<Duration> {
        let elapsed = self.finished().started?.elapsed();
        self.time_left_after(elapsed)
    }

    /// The time left after computing for the time `elapsed`.
    fn time_left_after(&self, elapsed: Duration) -> Option<Duration> {
        let finished = self.finished();
        let left = (self.total - finished.stored - finished.computed).max(0.0);
        let seconds = left / finished.computed * elapsed.as_secs_f64();
        Duration::try_from_secs_f64(seconds).ok()
    }

    fn lock(&self) -> MutexGuard<'_, Finished> {
        self.finished.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::Store;
    use crate::{RunOptions, run};
    use indicatif::ProgressBar;
    use slipgap_study::parse;

    #[test]
    fn stored_and_computed_work_are_counted_apart() {
        let folder = tempfile::tempdir().unwrap();
        // Steps of 0.1 up to 3. A chunk has 16 384 cases.
        let work = |betas: u64| {
            let text = format!(
                r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "dT": 0.1, "duration": 3,
                "beta": {{"range": [1, {betas}, 1]}}}}}}"#
            );
            let study = parse("s.json", &text).unwrap();
            let (store, progress) = (Store::open(folder.path()).unwrap(), WorkProgress::new(0.0));
            let options = RunOptions {
                store: Some(&store),
                progress: Some(&progress),
                ..RunOptions::METRICS
            };
            run(&study, &ProgressBar::hidden(), &options, |_| Ok(())).unwrap();
            store.close().unwrap();
            let finished = progress.finished();
            // 30 steps a case.
            assert_eq!(finished.computed, 30.0 * finished.cases as f64);
            [finished.stored, finished.computed]
        };
        let steps = |cases: u64| 30.0 * cases as f64;
        assert_eq!(work(16_384), [0.0, steps(16_384)]);
        assert_eq!(work(20_000), [steps(16_384), steps(3616)]);
        assert_eq!(work(20_000), [steps(20_000), 0.0]);
    }

    #[test]
    fn cases_from_the_store_do_not_change_the_rate() {
        let progress = WorkProgress::new(100.0);
        let elapsed = Duration::from_secs(4);
        assert_eq!(progress.time_left_after(elapsed), None);
        progress.add_stored(60.0);
        assert_eq!(progress.time_left_after(elapsed), None);
        progress.add_computed(1, 10.0);
        // 30 are left, and 10 took 4 s. With the stored 60 as speed it would be 30/70 of 4 s.
        assert_eq!(
            progress.time_left_after(elapsed),
            Some(Duration::from_secs(12))
        );
        // More from the store: 10 are left, at the same rate.
        progress.add_stored(20.0);
        assert_eq!(
            progress.time_left_after(elapsed),
            Some(Duration::from_secs(4))
        );
        // The total of very many cases is an estimate. No time is left if more than the total is finished.
        progress.add_computed(1, 50.0);
        assert_eq!(progress.time_left_after(elapsed), Some(Duration::ZERO));
    }
    #[test]
    fn a_stopped_run_ends_before_its_next_sweep() {
        // 20 parts of one chunk each, and an order to stop after the first one.
        let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "dT": 0.1, "duration": 3,
            "beta": {"range": [1, 327680, 1]}}}"#;
        let study = parse("s.json", text).unwrap();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .build()
            .unwrap();
        let progress = WorkProgress::new(0.0);
        let options = RunOptions {
            progress: Some(&progress),
            ..RunOptions::METRICS
        };
        let mut taken = 0;
        let ended = pool.install(|| {
            run(&study, &ProgressBar::hidden(), &options, |_| {
                taken += 1;
                progress.stop();
                Ok(())
            })
        });
        assert!(matches!(ended, Err(Error::Interrupted)), "{ended:?}");
        // Parts that were finished before the order are still taken: those of the first two windows, 1 and 2.
        assert!((1..=3).contains(&taken), "{taken}");
    }
}
