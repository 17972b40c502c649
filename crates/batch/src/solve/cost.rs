//! The cost of a study: its work, and the time that some of its cases take on this machine.

use super::compute::{SWEEP_WORK, compute_rows, keep_memory, parallel_tasks, slice, solvable_rows};
use super::options::RunOptions;
use rayon::prelude::*;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Largest number of cases whose work is summed.
const MOST_SUMMED: u64 = 100_000;

/// Time for computing some cases, from which the time of all cases is estimated.
pub const MEASURING: Duration = Duration::from_millis(50);

/// Largest work of a case with a reference that is measured with its whole duration: about a second.
const LONGEST_CASE: f64 = 5e8;

/// A measurement of some cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement {
    /// Number of cases.
    pub cases: u64,
    /// Their steps times modes.
    pub work: f64,
    /// The time that all of them took together: of the processors where the system tells it, so that other programs do not count, over
    /// the number of threads.
    pub seconds: f64,
    /// Number of threads.
    pub threads: usize,
}

impl Measurement {
    /// Seconds for this work on as many threads; `None` if nothing was measured.
    pub fn seconds_for(&self, work: f64) -> Option<f64> {
        let seconds = work / self.work * self.seconds;
        seconds.is_finite().then_some(seconds)
    }
}

/// Steps times modes of all cases; an estimate from evenly spaced cases if there are very many.
pub fn total(study: &Study) -> f64 {
    let raw = study.raw_len();
    let stride = raw.div_ceil(MOST_SUMMED);
    let sampled = (0..raw)
        .step_by(stride as usize)
        .filter_map(|raw| study.enumeration().combination(raw));
    let work = sampled.map(|case| study.work(&case) as f64);
    work.sum::<f64>() * stride as f64
}

/// Work of making the sampled signals of all cases, each once; an estimate from evenly spaced cases if there are very many.
pub fn sampling(study: &Study) -> f64 {
    let raw = study.raw_len();
    let stride = raw.div_ceil(MOST_SUMMED);
    let sampled = (0..raw).step_by(stride as usize);
    let mut signals = BTreeSet::new();
    let mut cases = 0;
    for case in sampled.filter_map(|raw| study.enumeration().combination(raw)) {
        let samples = study.samples(&case);
        match (samples.key.is_empty(), cases) {
            (true, 0) => return 0.0,
            (true, _) => continue,
            (false, _) => {}
        }
        cases += 1;
        signals.insert(samples);
    }
    let work: f64 = signals.iter().map(|samples| samples.work as f64).sum();
    // Signals that most cases have for themselves are as many as the cases.
    match 2 * signals.len() > cases {
        true => work * stride as f64,
        false => work,
    }
}

/// Most cases with the signals of one case that stand in for others.
const MOST_ALIKE: usize = 512;

/// The measurement that a case is which one thread solved in so many seconds.
pub fn of_one(
    study: &Study,
    total: f64,
    options: &RunOptions,
    (case, seconds): (&Case, f64),
) -> Measurement {
    let threads = threads(study, options, total);
    Measurement {
        cases: 1,
        work: study.work(case) as f64,
        seconds: seconds / threads as f64,
        threads,
    }
}

/// The number of threads that a run can use.
fn threads(study: &Study, options: &RunOptions, total: f64) -> usize {
    let tasks = parallel_tasks(study, options, total).max(1);
    rayon::current_num_threads().min(tasks)
}

/// Computes groups of cases from the whole study, which has the work `total`, until all are computed or the time is over.
/// It uses as many threads as a run can use. Cases with a reference are computed one by one with their whole duration, since its cost
/// is that of the events of a motion, which the first steps of a record do not have.
///
/// No sampled signals are made but those of `like`: a case with others is left out if it has a reference, else the one with the signals of
/// `like` that is most like it, such as one with the same law, is computed in its place.
///
/// # Errors
/// The first of `on_solution`.
pub fn measure(
    study: &Study,
    total: f64,
    options: &RunOptions,
    (like, limit, most_at_once): (&Case, Duration, u64),
) -> Result<Measurement, Error> {
    keep_memory();
    let threads = threads(study, options, total);
    let one_by_one = study.problem.work(like, &study.metrics).references > 0;
    let instead = match one_by_one || limit.is_zero() {
        true => Vec::new(),
        false => with_signals_of(study, like),
    };
    // As many combinations as in one sweep of a run, if there is time for so many.
    let size = match one_by_one {
        true => 1,
        false => slice(study.raw_len(), total).min(most_at_once.max(1)),
    };
    let most = if one_by_one { LONGEST_CASE } else { SWEEP_WORK };
    let groups = study.raw_len().div_ceil(size);
    let (next, sum) = (AtomicU64::new(0), Mutex::new((0_u64, 0.0)));
    let stride = stride(groups);
    let (start, before) = (Instant::now(), processor_time());
    let compute = |cases: Cases| -> Result<(), Error> {
        let rows = solvable_rows(&cases);
        let work = work(study, &cases, &rows);
        compute_rows(study, 0, (&cases, &rows, work), &|_| (), options)?;
        let mut sum = sum.lock().unwrap_or_else(PoisonError::into_inner);
        *sum = (sum.0 + rows.len() as u64, sum.1 + work);
        Ok(())
    };
    let measure_groups = |_| -> Result<(), Error> {
        while start.elapsed() < limit {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= groups {
                break;
            }
            let group = (u128::from(index) * u128::from(stride) % u128::from(groups)) as u64;
            let first = group * size;
            let (_, cases) = study.columns(first, (first + size).min(study.raw_len()));
            let cases = alike(study, like, &cases, &instead);
            compute(shortened(study, cases, most))?;
        }
        Ok(())
    };
    (0..threads).into_par_iter().try_for_each(measure_groups)?;
    let none = sum.lock().unwrap_or_else(PoisonError::into_inner).0 == 0;
    if none && !limit.is_zero() {
        let mut one_case = Cases::new(study.problem.schema());
        one_case.push(like);
        compute(shortened(study, one_case, most))?;
    }
    let used = before
        .zip(processor_time())
        .map(|(before, after)| (after - before) / threads as f64);
    let (cases, work) = sum.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(Measurement {
        cases,
        work,
        seconds: used.unwrap_or_else(|| start.elapsed().as_secs_f64()),
        threads,
    })
}

/// The time that all threads of this process have run, in seconds; `None` where the system does not tell it.
pub fn processor_time() -> Option<f64> {
    let mut nanoseconds = 0.0;
    for thread in std::fs::read_dir("/proc/self/task").ok()? {
        let path = thread.ok()?.path().join("schedstat");
        // A thread may have ended.
        let text = std::fs::read_to_string(path).unwrap_or_default();
        let first = text.split_ascii_whitespace().next().unwrap_or("0");
        nanoseconds += first.parse::<f64>().ok()?;
    }
    (nanoseconds > 0.0).then_some(nanoseconds * 1e-9)
}

/// The cases, with a shorter duration if they are more work than this.
fn shortened(study: &Study, cases: Cases, most: f64) -> Cases {
    let rows = solvable_rows(&cases);
    let share = most / work(study, &cases, &rows);
    if share.is_nan() || share >= 1.0 {
        return cases;
    }
    let schema = study.problem.schema();
    let duration = schema.duration;
    let (mut short, mut shown) = (Cases::new(schema), cases.shown());
    for row in rows {
        let mut case = shown.at(row as usize).clone();
        case.values[duration] = case.at(duration).map(|time| Value::Number(time * share));
        if case.steps() > 0 {
            short.push(&case);
        }
    }
    short
}

/// Cases that need the sampled signals of `like`, evenly spaced; only `like` if the study has no such signals.
fn with_signals_of(study: &Study, like: &Case) -> Vec<Case> {
    let samples = study.samples(like);
    if samples.key.is_empty() {
        return vec![like.clone()];
    }
    let raw = study.raw_len();
    let stride = raw.div_ceil(MOST_SUMMED);
    let cases = (0..raw)
        .step_by(stride as usize)
        .filter_map(|raw| study.enumeration().combination(raw));
    let found: Vec<Case> = cases
        .filter(|case| study.samples(case) == samples)
        .collect();
    let every = found.len().div_ceil(MOST_ALIKE).max(1);
    match found.is_empty() {
        true => vec![like.clone()],
        false => found.into_iter().step_by(every).collect(),
    }
}

/// The cases that need no other sampled signals than those of `like`; in the places of the others those of `instead` with the most of
/// their values, or nothing.
fn alike(study: &Study, like: &Case, cases: &Cases, instead: &[Case]) -> Cases {
    let samples = study.samples(like);
    let rows = solvable_rows(cases);
    let (mut found, mut shown) = (Cases::new(study.problem.schema()), cases.shown());
    for row in rows {
        let case = shown.at(row as usize);
        if study.samples(case) == samples {
            found.push(case);
            continue;
        }
        let differing = |other: &&Case| {
            let values = other.values.iter().zip(&case.values);
            values.filter(|(value, other)| value != other).count()
        };
        let nearest = instead.iter().min_by_key(differing);
        nearest.into_iter().for_each(|other| found.push(other));
    }
    found
}

/// Steps times modes of some cases.
fn work(study: &Study, cases: &Cases, rows: &[u32]) -> f64 {
    let mut shown = cases.shown();
    let work = rows
        .iter()
        .map(|row| study.work(shown.at(*row as usize)) as f64);
    work.sum()
}

/// A stride that visits each group once, the first ones far from each other: near the golden section, and without a
/// common factor with `groups`.
fn stride(groups: u64) -> u64 {
    let common_factor = |mut a: u64, mut b: u64| {
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let near = (groups as f64 * 0.618) as u64;
    let mut strides = near.max(1)..;
    strides
        .find(|s| common_factor(*s, groups) == 1)
        .unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipgap_study::parse;

    fn study(parameters: &str) -> Study {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", {parameters}}}}}"#
        );
        parse("s.json", &text).unwrap()
    }

    #[test]
    fn seconds_are_proportional_to_work() {
        let measured = Measurement {
            cases: 3,
            work: 2e6,
            seconds: 0.25,
            threads: 2,
        };
        assert_eq!(measured.seconds_for(8e6), Some(1.0));
        let nothing = Measurement {
            cases: 0,
            work: 0.0,
            ..measured
        };
        assert_eq!(nothing.seconds_for(8e6), None);
    }

    #[test]
    fn every_case_of_a_small_study_is_measured_once() {
        // 300 cases of 30 steps.
        let study = study(r#""beta": {"linspace": [1, 2, 300]}, "dT": 0.1, "duration": 3"#);
        let work = total(&study);
        assert_eq!(work, 9000.0);
        let like = study.case(0).unwrap();
        let within =
            |limit| measure(&study, work, &RunOptions::METRICS, (&like, limit, u64::MAX)).unwrap();
        let estimate = within(Duration::MAX);
        assert_eq!((estimate.cases, estimate.work), (300, 9000.0));
        // A sweep of one slice uses one thread.
        assert_eq!(estimate.threads, 1);
        let none = within(Duration::ZERO);
        assert_eq!((none.cases, none.work), (0, 0.0));
    }

    #[test]
    fn cases_of_much_work_are_measured_with_a_shorter_duration() {
        // 3e7 steps in each of 64 cases. All together are shortened to the limit.
        let study = study(r#""beta": {"linspace": [1, 2, 64]}, "dT": 1e-7, "duration": 3"#);
        let like = study.case(0).unwrap();
        let (_, cases) = study.columns(0, slice(study.raw_len(), total(&study)));
        let alike_cases = alike(&study, &like, &cases, std::slice::from_ref(&like));
        let cases = shortened(&study, alike_cases, SWEEP_WORK);
        assert_eq!(cases.len(), 64);
        let work = work(&study, &cases, &solvable_rows(&cases));
        // The number of steps is rounded: up to one step in each case.
        assert!((work - SWEEP_WORK).abs() <= 64.0, "{work}");
    }

    #[test]
    fn cases_with_other_signals_are_replaced_by_those_with_the_same_law() {
        let text = r#"{"problem": "structure", "parameters": {"seed": {"range": [1, 40, 1]}, "law": ["hertz", "ye", "impact"],
              "restitution": 0.6, "dt": 0.01, "duration": 1},
              "structure": {"masses": {"a": 1}, "springs": [{"between": ["ground", "a"], "k": 40}],
              "contacts": {"c": {"law": "law", "between": ["ground", "a"], "gap": 0.01, "k": 100, "k_h": 100, "restitution": "restitution"}},
              "ground": {"synthetic": "seed"}}, "metrics": ["peak(a)"]}"#;
        let study = parse("s.json", text).unwrap();
        let like = study.case(0).unwrap();
        let instead = with_signals_of(&study, &like);
        assert_eq!(instead.len(), 3);
        let (_, cases) = study.columns(0, study.raw_len());
        let cases = alike(&study, &like, &cases, &instead);
        let schema = study.problem.schema();
        let row = |name: &str| {
            schema
                .parameters
                .iter()
                .position(|parameter| parameter.name == name)
        };
        let (law, seed) = (row("law").unwrap(), row("seed").unwrap());
        let mut shown = cases.shown();
        let mut laws = [0; 3];
        for row in 0..cases.len() {
            let case = shown.at(row);
            assert_eq!(case.values[seed], like.values[seed]);
            let of = |other: &Case| other.values[law] == case.values[law];
            laws[instead.iter().position(of).unwrap()] += 1;
        }
        assert_eq!(laws, [40; 3]);
    }

    #[test]
    fn every_group_is_visited() {
        for groups in [1, 2, 3, 7, 64, 100, 1001] {
            let stride = stride(groups);
            let seen: BTreeSet<u64> = (0..groups).map(|index| index * stride % groups).collect();
            assert_eq!(seen.len() as u64, groups, "{groups}");
        }
    }
}
