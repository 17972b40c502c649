//! Computes cases: in lanes if possible, else one at a time.

use super::options::RunOptions;
use super::part_result::Solutions;
use super::signal_order::signal_order;
use crate::chunks::chunk::WORK;
use crate::programs::go_on;
use rayon::prelude::*;
use slipgap_motion::solve::{MetricTable, Unsolvable, Warnings};
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Solution};
use slipgap_study::Study;
use slipgap_study::error::Error;

/// Largest number of cases of one sweep if there are several threads.
const MOST_CASES: u64 = 4096;

/// Smallest number of cases of one sweep: several times the number of lanes.
const FEWEST_CASES: u64 = 64;

/// Largest work of one sweep of more cases, which takes a fraction of a second.
pub(crate) const SWEEP_WORK: f64 = 2e7;

/// Largest work of one sweep on a single thread: a fraction of a second, after which a run can be stopped.
const LONGEST_SWEEP: f64 = 1e8;

/// Cases of one sweep if there are several threads, of `cases` with this work together. Only cases with the same modes share
/// lanes, so that each case of a small sweep takes longer than in a large one.
pub(crate) fn slice(cases: u64, work: f64) -> u64 {
    let slice = SWEEP_WORK / work * cases as f64;
    (slice as u64).clamp(FEWEST_CASES, MOST_CASES)
}

/// Whether cases of the study can be computed in lanes. Histories, budgets and the papers' own iteration need one case
/// at a time.
fn lanes_possible(study: &Study, options: &RunOptions) -> bool {
    let table = study.problem.metrics();
    options.on_solution.is_none()
        && !study.once
        && study.metrics.iter().all(|row| table[*row].default)
}

/// Largest number of tasks of the study, with the work `total`, that can run at the same time on any number of threads.
pub(crate) fn parallel_tasks(study: &Study, options: &RunOptions, total: f64) -> usize {
    let cases = study.len() as usize;
    let parts = (total / WORK as f64).ceil() as usize;
    match lanes_possible(study, options) {
        true => cases
            .div_ceil(slice(cases as u64, total) as usize)
            .max(parts)
            .min(cases),
        false => cases,
    }
}

/// The rows of cases that break no rule.
pub(crate) fn solvable_rows(cases: &Cases) -> Vec<u32> {
    let rows = 0..cases.len() as u32;
    match cases.refused().next() {
        None => rows.collect(),
        Some(_) => rows
            .filter(|row| cases.may_be_solved(*row as usize))
            .collect(),
    }
}

/// The metrics of these rows of a part, which have this work, and the histories to keep. `tick` receives the number of finished rows, some at a
/// time.
pub(crate) fn compute_rows(
    study: &Study,
    first: u64,
    (cases, rows, work): (&Cases, &[u32], f64),
    tick: &(dyn Fn(usize) + Sync),
    options: &RunOptions,
) -> Result<(MetricTable, Solutions), Error> {
    let table = study.problem.metrics();
    let lanes = lanes_possible(study, options);
    let mut shown = cases.shown();
    let programs = study.programs();
    let mut kept = |row: &u32| {
        let case = shown.at(*row as usize);
        let keep = options.keep_history;
        // Each worker asks its own process.
        keep.is_some_and(|keep| keep(case))
            || programs.is_some_and(|programs| programs.named(case.choice("method")).is_some())
    };
    let (in_lanes, single): (Vec<u32>, Vec<u32>) = match options.keep_history {
        None if lanes && programs.is_none() => (rows.to_vec(), Vec::new()),
        _ => rows.iter().partition(|row| lanes && !kept(row)),
    };
    let slice = match rayon::current_num_threads() {
        1 if work <= LONGEST_SWEEP => cases.len().max(1),
        1 => (LONGEST_SWEEP / work * rows.len() as f64).max(FEWEST_CASES as f64) as usize,
        _ => slice(rows.len() as u64, work) as usize,
    };
    let sweep = |rows: &[u32]| {
        options.go_on()?;
        let swept = study.problem.sweep(cases, rows);
        tick(rows.len());
        Ok(swept)
    };
    let mut in_lanes = signal_order(study, cases, in_lanes);
    let mut swept: Vec<MetricTable> = Vec::new();
    for block in &in_lanes {
        // All threads work at a block.
        let slice = match in_lanes.len() {
            1 => slice,
            _ => slice.min(block.len().div_ceil(rayon::current_num_threads())),
        };
        let tables = block.par_chunks(slice).map(sweep);
        swept.extend(tables.collect::<Result<Vec<_>, Error>>()?);
    }
    let in_lanes = match &mut in_lanes[..] {
        [only] => std::mem::take(only),
        _ => in_lanes.concat(),
    };
    let swept = MetricTable::joined(swept);
    if in_lanes.len() == cases.len() && in_lanes.is_sorted() {
        return Ok((swept, Solutions::new()));
    }
    let mut shown = cases.shown();
    let solve = |(row, case): &(usize, Case)| {
        options.go_on()?;
        let number = first + cases.offset(*row);
        let solved = match programs {
            None => solve_case(study, number, case, options),
            Some(_) => {
                let numbered = Case {
                    number,
                    ..case.clone()
                };
                let solved = solve_case(study, number, &numbered, options);
                go_on(study)?;
                solved
            }
        };
        tick(1);
        solved.map(|solved| (*row, solved))
    };
    let mut solved: Vec<(usize, SolvedCase)> = Vec::new();
    for block in signal_order(study, cases, single) {
        let rows = block.into_iter().map(|row| row as usize);
        let block: Vec<(usize, Case)> = rows.map(|row| (row, shown.at(row).clone())).collect();
        let solutions = block.par_iter().map(solve);
        solved.extend(solutions.collect::<Result<Vec<_>, Error>>()?);
    }
    let (mut metrics, mut solutions) =
        (MetricTable::new(cases.len(), table.len()), Solutions::new());
    for (lane, row) in in_lanes.into_iter().enumerate() {
        metrics.copy(row as usize, &swept, lane);
    }
    for (row, why) in cases.refused() {
        metrics.fail(row, Unsolvable::BrokenRules(why.to_owned()));
    }
    for (row, (values, warnings, solution)) in solved {
        metrics.put(row, values);
        metrics.warn(row, warnings);
        solutions.extend(solution.map(|solution| (row, solution)));
    }
    Ok((metrics, solutions))
}

/// The metrics of one case, or why it has none, its warnings, and its histories if they are kept.
type SolvedCase = (
    Result<Vec<Option<f64>>, Unsolvable>,
    Warnings,
    Option<Box<Solution>>,
);

/// Solves one case with its histories.
fn solve_case(
    study: &Study,
    number: u64,
    case: &Case,
    options: &RunOptions,
) -> Result<SolvedCase, Error> {
    let is_kept = options.keep_history.is_some_and(|keep| keep(case));
    let structure = study.problem.as_structure();
    // Programs are only asked for what is needed.
    if let (Some(_), Some(structure)) = (study.programs(), structure)
        && !is_kept
        && options.on_solution.is_none()
    {
        return Ok(match structure.solve_metrics(case) {
            Ok((metrics, warnings)) => (Ok(metrics), warnings, None),
            Err(why) => (Err(why), Warnings::NONE, None),
        });
    }
    let solution = match study.solve(case) {
        Ok(solution) => solution,
        Err(why) => return Ok((Err(why), Warnings::NONE, None)),
    };
    if let Some(on_solution) = options.on_solution {
        on_solution(number, &solution)?;
    }
    let (metrics, warnings) = (solution.metrics.clone(), solution.warnings);
    let kept = is_kept.then(|| Box::new(solution));
    Ok((Ok(metrics), warnings, kept))
}

/// Bytes, slightly below the largest size for which the C library raises its threshold.
const MAPPED: usize = 31 << 20;

/// Makes the allocator keep the memory of one part for the next. glibc returns freed memory to the system, which clears
/// it again for every part, until a block of this size was freed once. Other allocators are not affected.
pub fn keep_memory() {
    drop(std::hint::black_box(Vec::<u8>::with_capacity(MAPPED)));
}
