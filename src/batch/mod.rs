//! Runs a study: every case through its problem, in parallel, in an order that no result depends on.

pub mod chunk;
mod computed;
mod done;
pub mod output;
pub mod results;
pub mod sobol;
pub mod store;
pub mod whole;

pub use computed::solution;
pub use done::{Done, Outcome};

use crate::error::Error;
use crate::problem::cases::Cases;
use crate::problem::{Case, Solution};
use crate::study::Study;
use chunk::{Cut, Key};
use done::Solutions;
use indicatif::ProgressBar;
use rayon::prelude::*;
use store::Store;

/// Is shown a case's number and its solution.
pub type Visit<'a> = dyn Fn(u64, &Solution) -> Result<(), Error> + Sync + 'a;

/// What is done with cases while they are run.
pub struct Wishes<'a> {
    /// Where finished chunks are kept and looked for, if anywhere.
    pub store: Option<&'a Store>,
    /// Whether every case is computed, whatever the store has.
    pub anew: bool,
    /// Which cases keep their histories, where they are computed.
    pub keep: &'a (dyn Fn(&Case) -> bool + Sync),
    /// Is shown every solution that is computed, if anyone asks.
    pub visit: Option<&'a Visit<'a>>,
}

impl Wishes<'_> {
    /// Metrics, and nothing kept.
    pub const METRICS: Wishes<'static> = Wishes {
        store: None,
        anew: false,
        keep: &|_| false,
        visit: None,
    };
}

/// Runs every case, chunk by chunk; hands the chunks to `take` in order, as soon as they and those before them are done.
/// `take` may end the run by an error.
///
/// # Errors
/// The first of `visit`, of the store or of `take`.
pub fn run(
    study: &Study,
    bar: &ProgressBar,
    wishes: &Wishes,
    mut take: impl FnMut(Done) -> Result<(), Error> + Send,
) -> Result<(), Error> {
    keep_memory();
    let cut = Cut::new(study);
    let compute = |from: u64, count: u64| -> Vec<Result<Done, Error>> {
        (from..(from + count).min(cut.count()))
            .into_par_iter()
            .map(|chunk| one(study, chunk, cut.cases(study, chunk), bar, wishes))
            .collect()
    };
    // More and more chunks at a time, so that the first are seen soon and no thread waits often for the others; memory
    // does not grow with the number of cases.
    let threads = rayon::current_num_threads() as u64;
    let (mut from, mut window, most) = (0, threads, (4 * threads).max(16));
    let mut done = Vec::new();
    loop {
        // What is done is taken while the next is computed.
        let (taken, next) = rayon::join(
            || done.into_iter().try_for_each(|done| take(done?)),
            || compute(from, window),
        );
        taken?;
        if next.is_empty() {
            return Ok(());
        }
        (from, window, done) = (from + window, most.min(2 * window), next);
    }
}

/// Bytes, just below the most for which the C library lets its threshold rise.
const MAPPED: usize = 31 << 20;

/// Has the allocator keep the memory of one chunk for the next. glibc gives freed memory back to the system, which clears
/// it anew for every chunk, until a block as large as this was freed once; elsewhere nothing happens.
pub fn keep_memory() {
    drop(std::hint::black_box(Vec::<u8>::with_capacity(MAPPED)));
}

/// The outcomes of all cases at once, for studies that are known to be small.
pub fn all(study: &Study, bar: &ProgressBar) -> Result<Vec<Outcome>, Error> {
    let mut outcomes = Vec::new();
    run(study, bar, &Wishes::METRICS, |done| {
        let found = done.outcomes(study.problem).into_iter();
        outcomes.extend(found.map(|(_, outcome)| outcome));
        Ok(())
    })?;
    Ok(outcomes)
}

/// A chunk from the store, or computed and kept.
fn one(
    study: &Study,
    chunk: u64,
    (first, cases): (u64, Cases),
    bar: &ProgressBar,
    wishes: &Wishes,
) -> Result<Done, Error> {
    // Without cases, where a condition dropped them all, there is nothing to keep.
    let store = wishes.store.filter(|_| !cases.is_empty());
    let store = store.map(|store| (store, Key::new(study, first, &cases)));
    let found = match &store {
        Some((store, key)) if !wishes.anew => store.find(study, chunk, key, cases.len()),
        _ => Err(None),
    };
    let (found, solutions, kept) = match found {
        Ok(found) => {
            bar.inc(found.len() as u64);
            (found, Solutions::new(), Ok(()))
        }
        Err(why) => {
            let (found, solutions) = computed::computed(study, first, &cases, bar, wishes)?;
            if let Some((store, key)) = store {
                store.put(study, chunk, &key, (first, &cases), &found)?;
            }
            (found, solutions, Err(why))
        }
    };
    Ok(Done {
        first,
        cases,
        found,
        solutions,
        kept,
    })
}
