//! Runs the cases of a study in parallel. No result depends on the order or on the number of threads.

pub mod chunk;
mod compute;
pub mod cost;
pub mod key;
pub mod output;
mod part_result;
pub mod store;
mod units;
pub mod work_progress;

pub use compute::solution;
pub use part_result::{Outcome, PartResult};

use crate::error::Error;
use crate::problem::cases::Cases;
use crate::problem::{Case, Solution};
use crate::solve::MetricTable;
use crate::study::Study;
use chunk::Part;
use indicatif::ProgressBar;
use key::{Key, case_hash};
use part_result::Solutions;
use rayon::prelude::*;
use std::collections::VecDeque;
use std::ops::Range;
use store::{EarlierCases, Miss, Store};
use work_progress::WorkProgress;

/// Called with the number and the solution of each computed case.
pub type OnSolution<'a> = dyn Fn(u64, &Solution) -> Result<(), Error> + Sync + 'a;

/// How the cases of a study are run.
pub struct RunOptions<'a> {
    /// The store from which results are read and to which they are written, if any.
    pub store: Option<&'a Store>,
    /// Whether every case is computed, also those in the store.
    pub recompute: bool,
    /// Selects the computed cases whose histories are kept.
    pub keep_history: &'a (dyn Fn(&Case) -> bool + Sync),
    /// Called with every computed solution, if any.
    pub on_solution: Option<&'a OnSolution<'a>>,
    /// Counts the work of finished cases, if any.
    pub progress: Option<&'a WorkProgress>,
}

impl RunOptions<'_> {
    /// Only metrics, without a store.
    pub const METRICS: RunOptions<'static> = RunOptions {
        store: None,
        recompute: false,
        keep_history: &|_| false,
        on_solution: None,
        progress: None,
    };
}

/// Runs every case, part by part. `take` receives the parts in order, each as soon as it and all parts before it are
/// finished. An error of `take` ends the run.
///
/// # Errors
/// The first of `on_solution`, of the store or of `take`.
pub fn run(
    study: &Study,
    bar: &ProgressBar,
    options: &RunOptions,
    mut take: impl FnMut(PartResult) -> Result<(), Error> + Send,
) -> Result<(), Error> {
    keep_memory();
    let mut queue = PartQueue::new(study);
    let mut compute = |count: usize| -> Vec<Result<PartResult, Error>> {
        let parts = queue.next(count).into_par_iter();
        parts
            .map(|part| run_part(study, part, bar, options))
            .collect()
    };
    // The number of parts at a time grows: the first results come soon, and later no thread waits often for the others.
    // Memory does not grow with the number of cases.
    let threads = rayon::current_num_threads();
    let (mut window, largest) = (threads, (4 * threads).max(16));
    let mut finished = Vec::new();
    loop {
        // `take` receives finished parts while the next ones are computed.
        let (taken, next) = rayon::join(
            || finished.into_iter().try_for_each(|part| take(part?)),
            || compute(window),
        );
        taken?;
        if next.is_empty() {
            return Ok(());
        }
        (window, finished) = (largest.min(2 * window), next);
    }
}

/// The parts of a study, made from its chunks on demand.
struct PartQueue<'a> {
    study: &'a Study,
    chunks: Range<u64>,
    parts: VecDeque<Part>,
}

impl<'a> PartQueue<'a> {
    fn new(study: &'a Study) -> PartQueue<'a> {
        PartQueue {
            study,
            chunks: 0..chunk::count(study),
            parts: VecDeque::new(),
        }
    }

    /// The next `count` parts, fewer at the end.
    fn next(&mut self, count: usize) -> Vec<Part> {
        while self.parts.len() < count && !self.chunks.is_empty() {
            let missing = (count - self.parts.len()) as u64;
            let end = self.chunks.end.min(self.chunks.start + missing);
            let chunks = (self.chunks.start..end).into_par_iter();
            let parts = |chunk| chunk::parts(self.study, chunk);
            let new: Vec<Vec<Part>> = chunks.map(parts).collect();
            self.parts.extend(new.into_iter().flatten());
            self.chunks.start = end;
        }
        let count = count.min(self.parts.len());
        self.parts.drain(..count).collect()
    }
}

/// Bytes, slightly below the largest size for which the C library raises its threshold.
const MAPPED: usize = 31 << 20;

/// Makes the allocator keep the memory of one part for the next. glibc returns freed memory to the system, which clears
/// it again for every part, until a block of this size was freed once. Other allocators are not affected.
pub fn keep_memory() {
    drop(std::hint::black_box(Vec::<u8>::with_capacity(MAPPED)));
}

/// The outcomes of all cases at once, for small studies.
pub fn all(study: &Study, bar: &ProgressBar) -> Result<Vec<Outcome>, Error> {
    let mut outcomes = Vec::new();
    run(study, bar, &RunOptions::METRICS, |part| {
        let numbered = part.outcomes(study).into_iter();
        outcomes.extend(numbered.map(|(_, outcome)| outcome));
        Ok(())
    })?;
    Ok(outcomes)
}

/// Reads a part from the store, or computes and stores it.
fn run_part(
    study: &Study,
    part: Part,
    bar: &ProgressBar,
    options: &RunOptions,
) -> Result<PartResult, Error> {
    let (start, first, work) = (part.start, part.first, part.work as f64);
    let cases = part.cases();
    let store = options.store;
    let store = store.map(|store| (store, Key::new(study, first, &cases)));
    let loaded = match &store {
        Some((store, key)) if !options.recompute => store.load(study, start, key, cases.len()),
        _ => Err(Miss::Absent),
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
            let earlier = match &store {
                Some((store, key)) if !options.recompute => store.earlier_cases(study, start, key),
                _ => EarlierCases::default(),
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
        metrics: units::with_unit_columns(study, &cases, metrics),
        cases,
        solutions,
        stored,
        from_store,
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
        let mut shown = cases.shown();
        for row in compute::solvable_rows(cases) {
            match earlier.get(case_hash(&shown.at(row as usize).values)) {
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
        bar.inc((cases.len() - rows.len()) as u64);
        if let Some(progress) = options.progress {
            progress.add_stored(work_per_case * self.reused.len() as f64);
            progress.start_computing();
        }
        let tick = |rows: usize| {
            bar.inc(rows as u64);
            if let Some(progress) = options.progress {
                progress.add_computed(work_per_case * rows as f64);
            }
        };
        let (mut metrics, solutions) =
            compute::compute_rows(study, first, (cases, rows), &tick, options)?;
        for (row, from, place) in &self.reused {
            metrics.copy(*row as usize, from, *place);
        }
        Ok((metrics, solutions))
    }
}
