//! Runs one part: reads it from the store, or computes and stores it.

use super::options::RunOptions;
use super::part_result::{PartResult, Solutions};
use super::work_progress::WorkProgress;
use super::{compute, computed};
use crate::chunks::chunk::Part;
use crate::store::key::{CaseHash, Key};
use crate::store::{EarlierCases, Miss, Store};
use indicatif::ProgressBar;
use slipgap_motion::solve::MetricTable;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_study::Study;
use slipgap_study::error::Error;

/// Reads a part from the store, or computes and stores it.
pub(crate) fn run_part(
    study: &Study,
    part: Part,
    bar: &ProgressBar,
    options: &RunOptions,
) -> Result<PartResult, Error> {
    options.go_on()?;
    let (start, first, work) = (part.start, part.first, part.work as f64);
    let cases = part.cases();
    let store = options
        .store
        .map(|store| (store, Key::new(study, first, &cases)));
    let readable = store.as_ref().filter(|_| !options.recompute);
    let loaded = match readable {
        Some((store, key)) => store.load(study, start, key, cases.len()),
        None => Err(Miss::Absent),
    };
    let (metrics, solutions, stored, from_store) = match loaded {
        Ok(metrics) => {
            bar.inc(cases.len() as u64);
            if let Some(progress) = options.progress {
                progress.add_stored(work);
            }
            (metrics, Solutions::new(), Ok(()), cases.len() as u64)
        }
        Err(miss) => {
            miss.answered()?;
            let earlier = match readable {
                Some((store, key)) => store.earlier_cases(study, start, key),
                None => EarlierCases::default(),
            };
            let missing = Missing::new(&cases, &earlier);
            let (metrics, solutions) = missing.compute(study, (first, work), bar, options)?;
            if let Some((store, key)) = store {
                store.save(study, start, &key, (first, &cases), &metrics)?;
            }
            let from_store = missing.reused.len() as u64;
            (metrics, solutions, Err(miss), from_store)
        }
    };
    Ok(PartResult {
        first,
        metrics: computed::with_computed_columns(study, &cases, metrics),
        cases,
        solutions,
        stored,
        from_store,
    })
}

/// A part that is in the store now.
pub(crate) struct KeptPart {
    /// Whether it was computed; else it was there.
    pub computed: bool,
    /// Number of its computed cases that could not be solved.
    pub unsolved: u64,
}

/// Computes and stores a part unless the store has it. Cases of other parts are not used: a shard would read the parts of all
/// others for each of its own.
pub(crate) fn keep_part(
    study: &Study,
    part: Part,
    bar: &ProgressBar,
    store: &Store,
    progress: &WorkProgress,
) -> Result<KeptPart, Error> {
    let (start, first, work) = (part.start, part.first, part.work as f64);
    let cases = part.cases();
    let key = Key::new(study, first, &cases);
    match store.check(start, &key, cases.len()) {
        Ok(()) => {
            bar.inc(cases.len() as u64);
            return Ok(KeptPart {
                computed: false,
                unsolved: 0,
            });
        }
        Err(miss) => miss.answered()?,
    }
    let earlier = EarlierCases::default();
    let missing = Missing::new(&cases, &earlier);
    let options = RunOptions {
        progress: Some(progress),
        ..RunOptions::METRICS
    };
    let (metrics, _) = missing.compute(study, (first, work), bar, &options)?;
    store.save(study, start, &key, (first, &cases), &metrics)?;
    Ok(KeptPart {
        computed: true,
        unsolved: metrics.failures().count() as u64,
    })
}

/// The cases of a part that is not in the store.
struct Missing<'a> {
    cases: &'a Cases,
    /// Rows to compute.
    rows: Vec<u32>,
    /// Rows with metrics from other parts: the row, and the table and row of its metrics.
    reused: Vec<(u32, &'a MetricTable, usize)>,
}

impl<'a> Missing<'a> {
    fn new(cases: &'a Cases, earlier: &'a EarlierCases) -> Missing<'a> {
        let (mut rows, mut reused) = (Vec::new(), Vec::new());
        // A hash for each case is only made to look it up.
        if earlier.is_empty() {
            return Missing {
                cases,
                rows: compute::solvable_rows(cases),
                reused,
            };
        }
        let (mut shown, mut hash) = (cases.shown(), CaseHash::default());
        for row in compute::solvable_rows(cases) {
            match earlier.get(hash.of(&shown.at(row as usize).values)) {
                Some((metrics, from)) => reused.push((row, metrics, from)),
                None => rows.push(row),
            }
        }
        Missing {
            cases,
            rows,
            reused,
        }
    }

    /// The metrics of all cases of the part, which has the work `work`, and the histories to keep.
    fn compute(
        &self,
        study: &Study,
        (first, work): (u64, f64),
        bar: &ProgressBar,
        options: &RunOptions,
    ) -> Result<(MetricTable, Solutions), Error> {
        let (cases, rows) = (self.cases, &self.rows[..]);
        let solvable = rows.len() + self.reused.len();
        let work_per_case = work / solvable.max(1) as f64;
        let computed = work_per_case * rows.len() as f64;
        bar.inc((cases.len() - rows.len()) as u64);
        if let Some(progress) = options.progress {
            progress.add_stored(work_per_case * self.reused.len() as f64);
            progress.start_computing();
        }
        let tick = |rows: usize| {
            bar.inc(rows as u64);
            if let Some(progress) = options.progress {
                progress.add_computed(rows as u64, work_per_case * rows as f64);
            }
        };
        let (mut metrics, solutions) =
            compute::compute_rows(study, first, (cases, rows, computed), &tick, options)?;
        for (row, from, position) in &self.reused {
            metrics.copy(*row as usize, from, *position);
        }
        Ok((metrics, solutions))
    }
}
