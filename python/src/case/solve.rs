//! `slipgap.solve`: one case with its motion.

use super::of_dict::case_of_dict;
use super::solution::Solution;
use crate::error::{unsolved, usage};
use crate::given;
use crate::worker;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use slipgap::batch;
use slipgap::problem::table::cases::Cases;
use slipgap::problem::{self, Case, Problem};
use slipgap::run::Source;
use slipgap::solve::{MetricTable, Unsolvable};
use slipgap::study::Study;
use std::sync::Arc;

/// Work from which a case is solved on another thread, so that Ctrl-C is heard: some tens of milliseconds.
const LONG: u64 = 10_000_000;

/// Keys of a study, which no parameter has.
const OF_STUDIES: [&str; 3] = ["parameters", "blocks", "structure"];

/// A case of a study, or of a dictionary of parameters.
#[pyfunction]
#[pyo3(signature = (study, case, allow_programs))]
pub fn solve(
    py: Python<'_>,
    study: &Bound<'_, PyAny>,
    case: i64,
    allow_programs: bool,
) -> PyResult<Solution> {
    let parameters = match study.cast::<PyDict>() {
        Ok(dict) if !is_study(dict)? => dict,
        Ok(_) | Err(_) => {
            let source = given::computed(py, study, None, allow_programs)?;
            // A solution has all channels.
            if let Some(programs) = source.study.programs() {
                programs.ask_for_all();
            }
            return of_study(py, source, case);
        }
    };
    if case == 0
        && let Some((problem, case)) = case_of_dict(parameters)?
    {
        return of_case(py, problem, case);
    }
    let text = given::text_of_parameters(py, parameters)?;
    of_study(py, given::of_dict(py, &text)?, case)
}

fn is_study(dict: &Bound<'_, PyDict>) -> PyResult<bool> {
    for key in OF_STUDIES {
        if dict.contains(key)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// A case without a study: its default metrics.
fn of_case(py: Python<'_>, problem: Arc<dyn Problem>, case: Case) -> PyResult<Solution> {
    let (problem_copy, copy) = (problem.clone(), case.clone());
    let solution = solved(py, &problem, &case, 0, move || {
        problem_copy.solve(&copy, &[])
    })?;
    let table = problem.metrics().iter().zip(&solution.metrics);
    let defaults = table
        .filter(|(metric, _)| metric.default)
        .map(|(metric, value)| (metric.name.to_string(), *value));
    let metrics = defaults.collect();
    Ok(Solution::new(problem, None, (0, case), solution, metrics))
}

/// A case of a study that was read.
fn of_study(py: Python<'_>, source: Source, number: i64) -> PyResult<Solution> {
    of_source(py, Arc::new(source), number)
}

/// A case of a study: the metrics that are columns of its results.
pub fn of_source(py: Python<'_>, source: Arc<Source>, number: i64) -> PyResult<Solution> {
    let cases = source.study.len();
    let valid = u64::try_from(number).ok().filter(|number| *number < cases);
    let found = valid.and_then(|number| Some((number, source.study.case(number)?)));
    let Some((number, case)) = found else {
        let last = cases.saturating_sub(1);
        return Err(usage(
            py,
            format!("case: must be 0 to {last}, got {number}"),
        ));
    };
    if let Some(why) = problem::Violation::all(&source.study.violations(number)) {
        return Err(unsolved(py, number, &Unsolvable::BrokenRules(why)));
    }
    let (study, copy) = (source.clone(), case.clone());
    let problem = source.study.problem.clone();
    let solution = solved(py, &problem, &case, number, move || {
        study.study.solve(&copy)
    })?;
    let metrics = columns(&source.study, &case, &solution);
    Ok(Solution::new(
        problem,
        Some(source),
        (number, case),
        solution,
        metrics,
    ))
}

/// The metrics of a case that are columns of the results of the study.
fn columns(study: &Study, case: &Case, solution: &problem::Solution) -> Vec<(String, Option<f64>)> {
    let mut cases = Cases::new(study.problem.schema());
    cases.push(case);
    let mut table = MetricTable::new(1, study.problem.metrics().len());
    table.put(0, Ok(solution.metrics.clone()));
    let table = batch::with_computed_columns(study, &cases, table);
    let row: Vec<Option<f64>> = table.row(0).collect();
    let columns = study.columns.iter();
    let value = |metric: usize| row.get(metric).copied().flatten();
    columns
        .map(|&metric| (study.measures[metric].name.clone(), value(metric)))
        .collect()
}

/// The solution; a long case is solved on another thread.
fn solved(
    py: Python<'_>,
    problem: &Arc<dyn Problem>,
    case: &Case,
    number: u64,
    solve: impl FnOnce() -> Result<problem::Solution, Unsolvable> + Send + 'static,
) -> PyResult<problem::Solution> {
    let solution = match problem.work(case, &[]).steps < LONG {
        true => py.detach(solve),
        false => worker::wait(py, 1, || Ok(solve()), || (), |_| Ok(()))?,
    };
    solution.map_err(|why| unsolved(py, number, &why))
}
