//! Runs a study: every case through its problem, in parallel, in an order that no result depends on.

pub mod chunk;
mod computed;
pub mod cost;
mod done;
pub mod key;
mod manifest;
pub mod output;
pub mod pace;
pub mod results;
pub mod sobol;
pub mod store;
#[cfg(test)]
mod tests_columns;
mod units;
pub mod whole;

pub use computed::solution;
pub use done::{Done, Outcome};

use crate::error::Error;
use crate::problem::{Case, Solution};
use crate::study::Study;
use chunk::Part;
use done::Solutions;
use indicatif::ProgressBar;
use key::{Key, identity};
use pace::Pace;
use rayon::prelude::*;
use std::collections::VecDeque;
use std::ops::Range;
use store::{Former, Store};

/// Is shown a case's number and its solution.
pub type Visit<'a> = dyn Fn(u64, &Solution) -> Result<(), Error> + Sync + 'a;

/// What is done with cases while they are run.
pub struct Wishes<'a> {
    /// Where finished parts are kept and looked for, if anywhere.
    pub store: Option<&'a Store>,
    /// Whether every case is computed, whatever the store has.
    pub anew: bool,
    /// Which cases keep their histories, where they are computed.
    pub keep: &'a (dyn Fn(&Case) -> bool + Sync),
    /// Is shown every solution that is computed, if anyone asks.
    pub visit: Option<&'a Visit<'a>>,
    /// Is told the work of cases as they are done, if anyone asks.
    pub pace: Option<&'a Pace>,
}

impl Wishes<'_> {
    /// Metrics, and nothing kept.
    pub const METRICS: Wishes<'static> = Wishes {
        store: None,
        anew: false,
        keep: &|_| false,
        visit: None,
        pace: None,
    };
}

/// Runs every case, part by part; hands the parts to `take` in order, as soon as they and those before them are done.
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
    let mut queue = Queue::new(study);
    let mut compute = |count: usize| -> Vec<Result<Done, Error>> {
        let parts = queue.next(count).into_par_iter();
        parts.map(|part| one(study, part, bar, wishes)).collect()
    };
    // More and more parts at a time, so that the first are seen soon and no thread waits often for the others; memory
    // does not grow with the number of cases.
    let threads = rayon::current_num_threads();
    let (mut window, most) = (threads, (4 * threads).max(16));
    let mut done = Vec::new();
    loop {
        // What is done is taken while the next is computed.
        let (taken, next) = rayon::join(
            || done.into_iter().try_for_each(|done| take(done?)),
            || compute(window),
        );
        taken?;
        if next.is_empty() {
            return Ok(());
        }
        (window, done) = (most.min(2 * window), next);
    }
}

/// The parts of a study, made from its chunks as they are asked for.
struct Queue<'a> {
    study: &'a Study,
    chunks: Range<u64>,
    waiting: VecDeque<Part>,
}

impl<'a> Queue<'a> {
    fn new(study: &'a Study) -> Queue<'a> {
        Queue {
            study,
            chunks: 0..chunk::count(study),
            waiting: VecDeque::new(),
        }
    }

    /// The next `count`, fewer at the end.
    fn next(&mut self, count: usize) -> Vec<Part> {
        while self.waiting.len() < count && !self.chunks.is_empty() {
            let missing = (count - self.waiting.len()) as u64;
            let end = self.chunks.end.min(self.chunks.start + missing);
            let chunks = (self.chunks.start..end).into_par_iter();
            let parts = |chunk| chunk::parts(self.study, chunk);
            let new: Vec<Vec<Part>> = chunks.map(parts).collect();
            self.waiting.extend(new.into_iter().flatten());
            self.chunks.start = end;
        }
        let count = count.min(self.waiting.len());
        self.waiting.drain(..count).collect()
    }
}

/// Bytes, just below the most for which the C library lets its threshold rise.
const MAPPED: usize = 31 << 20;

/// Has the allocator keep the memory of one part for the next. glibc gives freed memory back to the system, which clears
/// it anew for every part, until a block as large as this was freed once; elsewhere nothing happens.
pub fn keep_memory() {
    drop(std::hint::black_box(Vec::<u8>::with_capacity(MAPPED)));
}

/// The outcomes of all cases at once, for studies that are known to be small.
pub fn all(study: &Study, bar: &ProgressBar) -> Result<Vec<Outcome>, Error> {
    let mut outcomes = Vec::new();
    run(study, bar, &Wishes::METRICS, |done| {
        let found = done.outcomes(study).into_iter();
        outcomes.extend(found.map(|(_, outcome)| outcome));
        Ok(())
    })?;
    Ok(outcomes)
}

/// A part from the store, or computed and kept.
fn one(study: &Study, part: Part, bar: &ProgressBar, wishes: &Wishes) -> Result<Done, Error> {
    let (start, first, work) = (part.start, part.first, part.work as f64);
    let cases = part.cases();
    let store = wishes.store;
    let store = store.map(|store| (store, Key::new(study, first, &cases)));
    let found = match &store {
        Some((store, key)) if !wishes.anew => store.find(study, start, key, cases.len()),
        _ => Err(None),
    };
    let (found, solutions, kept, from_store) = match found {
        Ok(found) => {
            bar.inc(found.len() as u64);
            if let Some(pace) = wishes.pace {
                pace.found(work);
            }
            let from_store = found.len() as u64;
            (found, Solutions::new(), Ok(()), from_store)
        }
        Err(why) => {
            let sound = computed::sound(&cases);
            let of_one = work / sound.len().max(1) as f64;
            let former = match &store {
                Some((store, key)) if !wishes.anew => store.former(study, start, key),
                _ => Former::default(),
            };
            let mut shown = cases.shown();
            let known = |row: &u32| {
                let case = shown.at(*row as usize);
                former.get(identity(&case.values))
            };
            let known: Vec<_> = sound.iter().map(known).collect();
            let rows = sound
                .iter()
                .zip(&known)
                .filter(|(_, known)| known.is_none());
            let rows: Vec<u32> = rows.map(|(row, _)| *row).collect();
            let from_store = sound.len() - rows.len();
            let tick = |rows: usize| {
                bar.inc(rows as u64);
                if let Some(pace) = wishes.pace {
                    pace.computed(of_one * rows as f64);
                }
            };
            bar.inc((cases.len() - rows.len()) as u64);
            if let Some(pace) = wishes.pace {
                pace.found(of_one * from_store as f64);
                pace.begin();
            }
            let (mut found, solutions) =
                computed::computed(study, first, (&cases, &rows), &tick, wishes)?;
            for (row, known) in sound.iter().zip(known) {
                if let Some((former, place)) = known {
                    found.copy(*row as usize, former, place);
                }
            }
            if let Some((store, key)) = store {
                store.put(study, start, &key, (first, &cases), &found)?;
            }
            (found, solutions, Err(why), from_store as u64)
        }
    };
    Ok(Done {
        first,
        found: units::added(study, &cases, found),
        cases,
        solutions,
        kept,
        from_store,
    })
}
