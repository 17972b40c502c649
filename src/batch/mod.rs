//! Runs a study: every case through its problem, in parallel, in an order that no result depends on.

pub mod chunk;
pub mod output;
pub mod results;
pub mod sobol;
pub mod store;
pub mod whole;

use crate::error::Error;
use crate::problem::sweep::Metrics;
use crate::problem::{Case, Solution};
use crate::study::Study;
use chunk::{Cut, Done, Key};
use indicatif::ProgressBar;
use rayon::prelude::*;
use store::Store;

/// What became of one case.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// In the order of `problem.metrics()`; `None` where one is undefined or the case could not be solved.
    pub metrics: Vec<Option<f64>>,
    /// The histories, where they were asked for.
    pub solution: Option<Box<Solution>>,
    /// Why the case could not be solved, if so.
    pub failure: Option<String>,
}

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
    // As many chunks at a time as keep all threads busy; memory does not grow with the number of cases.
    let window = 2 * rayon::current_num_threads() as u64;
    let compute = |start: u64| -> Vec<Result<Done, Error>> {
        (start..(start + window).min(cut.count()))
            .into_par_iter()
            .map(|chunk| one(study, chunk, cut.cases(study, chunk), bar, wishes))
            .collect()
    };
    let mut done = compute(0);
    for start in (0..cut.count()).step_by(window as usize) {
        // What is done is taken while the next is computed.
        let (taken, next) = rayon::join(
            || done.into_iter().try_for_each(|done| take(done?)),
            || compute(start + window),
        );
        taken?;
        done = next;
    }
    Ok(())
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
        outcomes.extend(done.outcomes);
        Ok(())
    })?;
    Ok(outcomes)
}

/// A chunk from the store, or computed and kept.
fn one(
    study: &Study,
    chunk: u64,
    cases: Vec<(u64, Case)>,
    bar: &ProgressBar,
    wishes: &Wishes,
) -> Result<Done, Error> {
    let Some(&(first, _)) = cases.first() else {
        // A condition dropped them all.
        return Ok(Done::kept(0, Vec::new()));
    };
    let store = wishes.store.map(|store| (store, Key::new(study, &cases)));
    let found = match &store {
        Some((store, key)) if !wishes.anew => store.find(study, chunk, key, &cases),
        _ => Err(None),
    };
    let why = match found {
        Ok(outcomes) => {
            bar.inc(outcomes.len() as u64);
            return Ok(Done::kept(first, outcomes));
        }
        Err(why) => why,
    };
    let outcomes = computed(study, cases, bar, wishes)?;
    if let Some((store, key)) = store {
        store.put(study, chunk, &key, first, &outcomes)?;
    }
    Ok(Done {
        outcomes,
        first,
        kept: Err(why),
    })
}

/// Cases that move side by side on one thread.
const SLICE: usize = 4096;

/// The outcomes of a chunk that has to be computed.
fn computed(
    study: &Study,
    cases: Vec<(u64, Case)>,
    bar: &ProgressBar,
    wishes: &Wishes,
) -> Result<Vec<Outcome>, Error> {
    let table = study.problem.metrics();
    // Histories, budgets and the papers' own iteration are for one case at a time.
    let beside = wishes.visit.is_none()
        && !study.once
        && study.metrics.iter().all(|row| table[*row].default);
    let alone: Vec<bool> = cases
        .iter()
        .map(|(_, case)| !beside || (wishes.keep)(case))
        .collect();
    let choose = |wanted: bool| {
        let pairs = cases.par_iter().zip(&alone);
        pairs.filter_map(move |(case, alone)| (*alone == wanted).then_some(case))
    };
    let together: Vec<&Case> = choose(false).map(|(_, case)| case).collect();
    let size = match rayon::current_num_threads() {
        1 => cases.len(),
        _ => SLICE,
    };
    let mut swept: Vec<Vec<Metrics>> = Vec::new();
    let sweep = |slice: &[&Case]| {
        bar.inc(slice.len() as u64);
        study.problem.sweep(slice)
    };
    together
        .par_chunks(size)
        .map(sweep)
        .collect_into_vec(&mut swept);
    let solved = choose(true).map(|(number, case)| {
        bar.inc(1);
        solve(study, *number, case, wishes)
    });
    let solved: Vec<Found> = solved.collect::<Result<_, Error>>()?;
    let (mut swept, mut solved) = (swept.into_iter().flatten(), solved.into_iter());
    let found: Vec<Found> = alone
        .iter()
        .filter_map(|alone| match alone {
            true => solved.next(),
            false => swept.next().map(|metrics| (metrics, None)),
        })
        .collect();
    let outcome = |((_, case), (metrics, solution)): ((u64, Case), Found)| {
        let (metrics, failure) = match metrics {
            Ok(metrics) => (metrics, None),
            Err(why) => (vec![None; table.len()], Some(why)),
        };
        Outcome {
            case,
            metrics,
            solution,
            failure,
        }
    };
    Ok(cases.into_iter().zip(found).map(outcome).collect())
}

/// What was found of a case, and its histories where they are kept.
type Found = (Metrics, Option<Box<Solution>>);

/// One case alone, with its histories on the way.
fn solve(study: &Study, number: u64, case: &Case, wishes: &Wishes) -> Result<Found, Error> {
    let solution = match solution(study, case) {
        Ok(solution) => solution,
        Err(why) => return Ok((Err(why), None)),
    };
    if let Some(visit) = wishes.visit {
        visit(number, &solution)?;
    }
    let metrics = solution.metrics.clone();
    Ok((Ok(metrics), (wishes.keep)(case).then(|| Box::new(solution))))
}

/// The solution of one case by the study's way of solving.
pub fn solution(study: &Study, case: &Case) -> Result<Solution, String> {
    match study.once {
        true => study.problem.solve_once(case, &study.metrics),
        false => study.problem.solve(case, &study.metrics),
    }
}
