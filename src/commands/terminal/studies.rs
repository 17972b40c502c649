//! How far a command with several studies is, and what remains.

use super::duration::duration;
use crate::batch::solve::cost;
use crate::batch::solve::work_progress::WorkProgress;
use crate::run::Source;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Shortest time between two estimates in a log, so that the lines of short runs are the same every time.
const BETWEEN_ESTIMATES: Duration = Duration::from_secs(60);

/// The studies of a command.
pub struct Studies {
    count: usize,
    /// Work of the cases of each study.
    works: Vec<f64>,
    /// Number of the current study, from 1; 0 before the first.
    current: usize,
    /// Outputs of the current study.
    outputs: usize,
    /// When the cases or the outputs of the current study began.
    since: Instant,
    /// When the log last had an estimate.
    estimated: Instant,
    left: Arc<Mutex<Left>>,
}

/// What remains after the current study, and how fast it was so far. An output is a figure; the tables of a study are one.
#[derive(Debug, Default)]
struct Left {
    work: f64,
    outputs: usize,
    computed: Rate,
    /// Of studies whose cases were all stored; taken while nothing is computed.
    stored: Rate,
    written: Rate,
}

/// A finished amount, and the seconds that it took.
#[derive(Debug, Default)]
struct Rate {
    amount: f64,
    seconds: f64,
}

impl Rate {
    fn add(&mut self, amount: f64, time: Duration) {
        self.amount += amount;
        self.seconds += time.as_secs_f64();
    }

    /// The seconds for an amount; `None` if nothing is finished yet.
    fn seconds_for(&self, amount: f64) -> Option<f64> {
        let seconds = match amount > 0.0 {
            true => amount * self.seconds / self.amount,
            false => 0.0,
        };
        seconds.is_finite().then_some(seconds)
    }
}

impl Left {
    /// The time left, if the current study needs `own` seconds for its cases and has these outputs left.
    fn seconds(&self, own_seconds: f64, outputs: usize) -> Option<f64> {
        let computed = self.computed.seconds_for(self.work);
        let cases = computed.or_else(|| self.stored.seconds_for(self.work))?;
        let outputs = (self.outputs + outputs) as f64;
        Some(own_seconds + cases + self.written.seconds_for(outputs)?)
    }
}

/// Estimates the time left of all studies, from any thread.
#[derive(Clone)]
pub struct Estimate(Arc<Mutex<Left>>);

impl Estimate {
    /// The time left as text, if the current study needs `own` for its cases and has these outputs left.
    pub fn text(&self, left: Option<Duration>, outputs: usize) -> String {
        let seconds = left.and_then(|left| lock(&self.0).seconds(left.as_secs_f64(), outputs));
        seconds.map_or("?".into(), duration)
    }
}

impl Studies {
    /// The studies of a command, before the first.
    pub fn new(sources: &[Source]) -> Studies {
        let now = Instant::now();
        let count = sources.len();
        let works: Vec<f64> = sources.iter().map(|source| work(source, count)).collect();
        let left = Left {
            work: works.iter().sum(),
            outputs: sources.iter().map(outputs).sum(),
            ..Left::default()
        };
        Studies {
            count,
            works,
            current: 0,
            outputs: 0,
            since: now,
            estimated: now,
            left: Arc::new(Mutex::new(left)),
        }
    }

    /// The cases of the next study begin; the outputs of the one before it are finished.
    pub fn begin(&mut self, source: &Source) {
        let mut left = lock(&self.left);
        if self.current > 0 {
            let amount = self.outputs as f64;
            left.written.add(amount, self.since.elapsed());
        }
        self.outputs = outputs(source);
        self.since = Instant::now();
        left.work -= self.works.get(self.current).copied().unwrap_or_default();
        left.outputs = left.outputs.saturating_sub(self.outputs);
        self.current += 1;
    }

    /// The next study is left out.
    pub fn skip(&mut self, source: &Source) {
        self.begin(source);
        // Nothing of it is written.
        self.outputs = 0;
    }

    /// The cases of the current study are finished.
    pub fn end_cases(&mut self, work: &WorkProgress) {
        let finished = work.finished();
        let time = self.since.elapsed();
        let mut left = lock(&self.left);
        // Reading stored cases says nothing about the speed of computing.
        match finished.computed > 0.0 {
            true => left.computed.add(finished.computed, time),
            false => left.stored.add(finished.stored, time),
        }
        drop(left);
        self.since = Instant::now();
    }

    /// How lines about the current study begin.
    pub fn name(&self, source: &Source) -> String {
        match self.count {
            1 => source.name.clone(),
            count => format!("{} of {count} studies, {}", self.current, source.name),
        }
    }

    /// Outputs of the current study.
    pub fn outputs(&self) -> usize {
        self.outputs
    }

    /// The estimate of the time left; `None` for one study, whose own bar has it.
    pub fn estimate(&self) -> Option<Estimate> {
        (self.count > 1).then(|| Estimate(self.left.clone()))
    }

    /// The time left after the cases of a study, for a log; `None` if the log had it a short time ago.
    pub fn estimate_for_log(&mut self) -> Option<String> {
        let estimate = self.estimate()?;
        if self.estimated.elapsed() < BETWEEN_ESTIMATES {
            return None;
        }
        self.estimated = Instant::now();
        Some(estimate.text(Some(Duration::ZERO), self.outputs))
    }
}

/// Work of the cases of a study, in steps times modes; 0 for the only one, after which nothing remains.
fn work(source: &Source, count: usize) -> f64 {
    match count {
        1 => 0.0,
        _ => cost::total(&source.study),
    }
}

/// Number of outputs of a study.
fn outputs(source: &Source) -> usize {
    source.study.figures.len() + 1
}

fn lock(left: &Mutex<Left>) -> MutexGuard<'_, Left> {
    left.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_left_has_cases_at_their_rate_and_outputs_at_theirs() {
        let mut left = Left {
            work: 300.0,
            outputs: 4,
            ..Left::default()
        };
        assert_eq!(left.seconds(1.0, 2), None);
        left.computed.add(100.0, Duration::from_secs(2));
        assert_eq!(left.seconds(1.0, 2), None);
        left.written.add(2.0, Duration::from_secs(1));
        // 1 s of the current study, 300 at 50 a second, 4 + 2 outputs of half a second.
        assert_eq!(left.seconds(1.0, 2), Some(1.0 + 6.0 + 3.0));
        // Nothing is left after the last study, whatever the rates.
        assert_eq!(Left::default().seconds(0.0, 0), Some(0.0));
    }
}
