//! Cases that have to be computed: side by side where they can be, else one at a time.

use super::Wishes;
use super::chunk::WORK;
use super::done::Solutions;
use crate::error::Error;
use crate::problem::cases::Cases;
use crate::problem::{Case, Solution};
use crate::solve::{MetricTable, Unsolvable};
use crate::study::Study;
use rayon::prelude::*;

/// Cases that move side by side on one of several threads.
pub(super) const SLICE: usize = 4096;

/// Whether cases of the study can be computed side by side: histories, budgets and the papers' own iteration are for one
/// case at a time.
fn side_by_side(study: &Study, wishes: &Wishes) -> bool {
    let table = study.problem.metrics();
    wishes.visit.is_none() && !study.once && study.metrics.iter().all(|row| table[*row].default)
}

/// Most pieces of the study that are computed at the same time, however many threads there are.
pub(super) fn pieces(study: &Study, wishes: &Wishes, all: f64) -> usize {
    let cases = study.len() as usize;
    let parts = (all / WORK as f64).ceil() as usize;
    match side_by_side(study, wishes) {
        true => cases.div_ceil(SLICE).max(parts).min(cases),
        false => cases,
    }
}

/// The rows of cases that break no rule.
pub(super) fn sound(cases: &Cases) -> Vec<u32> {
    let rows = 0..cases.len() as u32;
    rows.filter(|row| cases.may_be_solved(*row as usize))
        .collect()
}

/// What these rows of a part come to, and the histories that are kept of them; `tick` takes the number of rows that are
/// done, some at a time.
pub(super) fn computed(
    study: &Study,
    first: u64,
    (cases, rows): (&Cases, &[u32]),
    tick: &(dyn Fn(usize) + Sync),
    wishes: &Wishes,
) -> Result<(MetricTable, Solutions), Error> {
    let table = study.problem.metrics();
    let beside = side_by_side(study, wishes);
    let mut shown = cases.shown();
    let (together, alone): (Vec<u32>, Vec<u32>) = rows
        .iter()
        .partition(|row| beside && !(wishes.keep)(shown.at(**row as usize)));
    let size = match rayon::current_num_threads() {
        1 => cases.len().max(1),
        _ => SLICE,
    };
    let sweep = |rows: &[u32]| {
        let swept = study.problem.sweep(cases, rows);
        tick(rows.len());
        swept
    };
    let swept: Vec<MetricTable> = together.par_chunks(size).map(sweep).collect();
    let swept = swept.into_iter().reduce(MetricTable::followed_by);
    if together.len() == cases.len() {
        return Ok((swept.unwrap_or_default(), Solutions::new()));
    }
    let mut shown = cases.shown();
    let alone = alone.into_iter().map(|row| row as usize);
    let alone: Vec<(usize, Case)> = alone.map(|row| (row, shown.at(row).clone())).collect();
    let solve = |(row, case): &(usize, Case)| {
        let solved = solved(study, first + *row as u64, case, wishes);
        tick(1);
        solved.map(|solved| (*row, solved))
    };
    let solved: Vec<(usize, Solved)> = alone.par_iter().map(solve).collect::<Result<_, Error>>()?;
    let (mut found, mut solutions) = (MetricTable::new(cases.len(), table.len()), Solutions::new());
    for (place, row) in together.into_iter().enumerate() {
        if let Some(swept) = &swept {
            found.copy(row as usize, swept, place);
        }
    }
    for (row, why) in cases.refused() {
        found.fail(row, Unsolvable::BrokenRules(why.to_owned()));
    }
    for (row, (metrics, solution)) in solved {
        found.put(row, metrics);
        solutions.extend(solution.map(|solution| (row, solution)));
    }
    Ok((found, solutions))
}

/// The metrics of one case, or why there are none, and its histories where they are kept.
type Solved = (Result<Vec<Option<f64>>, Unsolvable>, Option<Box<Solution>>);

/// One case alone, with its histories on the way.
fn solved(study: &Study, number: u64, case: &Case, wishes: &Wishes) -> Result<Solved, Error> {
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
pub fn solution(study: &Study, case: &Case) -> Result<Solution, Unsolvable> {
    match study.once {
        true => study.problem.solve_once(case, &study.metrics),
        false => study.problem.solve(case, &study.metrics),
    }
}
