//! What a study costs: its work, and the time that some of its own cases take on this machine.

use super::computed::{SLICE, computed, pieces, sound};
use super::{Wishes, keep_memory};
use crate::error::Error;
use crate::problem::cases::Cases;
use crate::problem::parameter::Value;
use crate::study::Study;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Most cases whose work is summed up.
const MOST_SUMMED: u64 = 100_000;

/// Fewest neighbouring combinations that are measured together: as many as move side by side, several times.
const FEWEST: u64 = 64;

/// Most work of a group, which takes a part of a second.
const MOST_WORK: f64 = 2e7;

/// Work that was computed to measure it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Cases.
    pub cases: u64,
    /// Their steps times modes.
    pub work: f64,
    /// The time that they took together.
    pub seconds: f64,
    /// Threads that shared them.
    pub threads: usize,
}

impl Measured {
    /// Seconds for so much work of such cases, on as many threads; none where nothing was measured.
    pub fn seconds_for(&self, work: f64) -> Option<f64> {
        let seconds = work / self.work * self.seconds;
        seconds.is_finite().then_some(seconds)
    }
}

/// Steps times modes of all cases; of very many, as many times the mean of some as there are.
pub fn total(study: &Study) -> f64 {
    let raw = study.raw_len();
    let apart = raw.div_ceil(MOST_SUMMED);
    let sampled = (0..raw)
        .step_by(apart as usize)
        .filter_map(|raw| study.combination(raw));
    let work = sampled.map(|case| study.work(&case) as f64);
    work.sum::<f64>() * apart as f64
}

/// Computes groups of cases from all over the study, whose work is `all`, on as many threads as a run has work for, until
/// all are computed or the time is up.
///
/// # Errors
/// The first of `visit`.
pub fn measure(
    study: &Study,
    all: f64,
    wishes: &Wishes,
    limit: Duration,
) -> Result<Measured, Error> {
    keep_memory();
    let most = pieces(study, wishes, all).max(1);
    let threads = rayon::current_num_threads().min(most);
    let size = size(study, all);
    let groups = study.raw_len().div_ceil(size);
    let (next, sum) = (AtomicU64::new(0), Mutex::new((0_u64, 0.0)));
    let stride = stride(groups);
    let began = Instant::now();
    let one = |_| -> Result<(), Error> {
        while began.elapsed() < limit {
            let turn = next.fetch_add(1, Ordering::Relaxed);
            if turn >= groups {
                break;
            }
            let group = (u128::from(turn) * u128::from(stride) % u128::from(groups)) as u64;
            let cases = sample(study, group * size, size);
            let rows = sound(&cases);
            let work = work(study, &cases, &rows);
            computed(study, 0, (&cases, &rows), &|_| (), wishes)?;
            let mut sum = sum.lock().unwrap_or_else(PoisonError::into_inner);
            *sum = (sum.0 + rows.len() as u64, sum.1 + work);
        }
        Ok(())
    };
    (0..threads).into_par_iter().try_for_each(one)?;
    let (cases, work) = sum.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(Measured {
        cases,
        work,
        seconds: began.elapsed().as_secs_f64(),
        threads,
    })
}

/// Combinations of a group: as many as a run has side by side, where that is little work. Only bars of the same mesh move
/// side by side, so that few cases of a sample are slower than many.
fn size(study: &Study, all: f64) -> u64 {
    let cases = MOST_WORK / all * study.raw_len() as f64;
    (cases as u64).clamp(FEWEST, SLICE as u64)
}

/// The cases of `size` raw combinations from `from` on, for a shorter time where they are much work.
fn sample(study: &Study, from: u64, size: u64) -> Cases {
    let (_, cases) = study.columns(from, (from + size).min(study.raw_len()));
    let rows = sound(&cases);
    let share = MOST_WORK / work(study, &cases, &rows);
    if share >= 1.0 {
        return cases;
    }
    let schema = study.problem.schema();
    let duration = schema.duration;
    let (mut short, mut shown) = (Cases::new(schema), cases.shown());
    for row in rows {
        let mut case = shown.at(row as usize).clone();
        case.values[duration] = case.at(duration).map(|time| Value::Number(time * share));
        if study.problem.steps(&case) > 0 {
            short.push(&case);
        }
    }
    short
}

/// Steps times modes of some cases.
fn work(study: &Study, cases: &Cases, rows: &[u32]) -> f64 {
    let mut shown = cases.shown();
    let work = rows
        .iter()
        .map(|row| study.work(shown.at(*row as usize)) as f64);
    work.sum()
}

/// A stride that visits each of so many groups once, the first ones far from each other: near the golden section, and
/// without a common factor.
fn stride(groups: u64) -> u64 {
    let factor = |mut a: u64, mut b: u64| {
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let near = (groups as f64 * 0.618) as u64;
    let mut strides = near.max(1)..;
    strides.find(|s| factor(*s, groups) == 1).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::parse;
    use std::collections::BTreeSet;

    fn study(parameters: &str) -> Study {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", {parameters}}}}}"#
        );
        parse("s.json", &text).unwrap()
    }

    #[test]
    fn seconds_follow_from_measured_pairs() {
        let measured = Measured {
            cases: 3,
            work: 2e6,
            seconds: 0.25,
            threads: 2,
        };
        assert_eq!(measured.seconds_for(8e6), Some(1.0));
        let nothing = Measured {
            cases: 0,
            work: 0.0,
            ..measured
        };
        assert_eq!(nothing.seconds_for(8e6), None);
    }

    #[test]
    fn all_of_a_small_study_is_measured_once() {
        // 300 cases of 30 steps.
        let study = study(r#""beta": {"linspace": [1, 2, 300]}, "dT": 0.1, "duration": 3"#);
        let work = total(&study);
        assert_eq!(work, 9000.0);
        let all = measure(&study, work, &Wishes::METRICS, Duration::MAX).unwrap();
        assert_eq!((all.cases, all.work), (300, 9000.0));
        // One slice of a sweep is for one thread.
        assert_eq!(all.threads, 1);
        let none = measure(&study, work, &Wishes::METRICS, Duration::ZERO).unwrap();
        assert_eq!((none.cases, none.work), (0, 0.0));
    }

    #[test]
    fn cases_of_much_work_are_measured_for_a_shorter_time() {
        // 3e7 steps each, seconds for one; of 64 of them as many as make the bound together.
        let study = study(r#""beta": {"linspace": [1, 2, 64]}, "dT": 1e-7, "duration": 3"#);
        let cases = sample(&study, 0, size(&study, total(&study)));
        assert_eq!(cases.len(), 64);
        let work = work(&study, &cases, &sound(&cases));
        // Steps are whole: one of each case may be lost or won by rounding.
        assert!((work - MOST_WORK).abs() <= 64.0, "{work}");
    }

    #[test]
    fn every_group_has_its_turn() {
        for groups in [1, 2, 3, 7, 64, 100, 1001] {
            let stride = stride(groups);
            let seen: BTreeSet<u64> = (0..groups).map(|turn| turn * stride % groups).collect();
            assert_eq!(seen.len() as u64, groups, "{groups}");
        }
    }
}
