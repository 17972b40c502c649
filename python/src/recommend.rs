//! `slipgap.recommend`: the candidates of a study, and the cheapest that keeps its metrics.

use crate::{given, worker};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyTuple, PyType};
use slipgap::problem::numbers::parameter::Value;
use slipgap::recommend::study::{Choice, advise};
use slipgap::recommend::{Stop, shipped};
use slipgap::solve::Warning;

/// The classes `slipgap.Recommendation` and `slipgap.Candidate`.
static RECOMMENDATION: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static CANDIDATE: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// Compares the candidates of a study.
#[pyfunction]
pub fn recommend<'py>(
    py: Python<'py>,
    study: &Bound<'py, PyAny>,
    jobs: Option<i64>,
    set: Option<&Bound<'py, PyAny>>,
    allow_programs: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let jobs = worker::jobs(py, jobs)?;
    let name: Option<String> = study.extract().ok();
    let text = name
        .as_deref()
        .and_then(|name| Some((name, shipped(name)?)));
    let source = match text {
        Some((name, text)) => given::shipped(py, name, text, set)?,
        None => given::computed(py, study, set, allow_programs)?,
    };
    let stop = Stop::default();
    let stops = stop.clone();
    let work = move || advise(&source.input(), &stops);
    let advice = worker::wait(py, jobs, work, || stop.stop(), |_| Ok(()))?;
    let table = advice.study.problem.parameters();
    let within: Vec<usize> = advice
        .study
        .recommend
        .iter()
        .flat_map(|recommend| &recommend.within)
        .map(|limit| limit.0)
        .collect();
    let class = CANDIDATE.import(py, "slipgap._records", "Candidate")?;
    let candidate = |(at, choice): (usize, &Choice)| {
        let (parameters, errors) = (PyDict::new(py), PyDict::new(py));
        for (row, value) in &choice.values {
            put(&parameters, &table[*row].name, *value)?;
        }
        for (row, error) in within.iter().zip(&choice.errors) {
            errors.set_item(advice.study.measures[*row].name.as_str(), error)?;
        }
        let converged = choice.trial.is_some_and(|trial| trial.holds());
        let warning_names: Vec<&str> = choice.warnings.iter().map(Warning::name).collect();
        let warnings = PyTuple::new(py, warning_names)?;
        class.call1((
            parameters,
            choice.cost,
            errors,
            choice.worst <= 1.0,
            converged,
            warnings,
            advice.verdict(at),
        ))
    };
    let candidates = advice.choices.iter().enumerate().map(candidate);
    let front = candidates.collect::<PyResult<Vec<_>>>()?;
    let order = |a: &usize, b: &usize| {
        advice.choices[*a]
            .worst
            .total_cmp(&advice.choices[*b].worst)
    };
    let nearest = (0..front.len())
        .min_by(order)
        .filter(|at| advice.choices[*at].worst.is_finite());
    let best = advice.chosen.or(nearest).map(|at| front[at].clone());
    let cheaper = &advice.choices[..advice.chosen.unwrap_or(0)];
    let position = cheaper.iter().position(|choice| choice.worst <= 1.0);
    let own_step = position.map(|at| front[at].clone());
    let class = RECOMMENDATION.import(py, "slipgap._records", "Recommendation")?;
    class.call1((
        advice.chosen.is_some(),
        best,
        front,
        advice.solved,
        own_step,
        PyTuple::new(py, advice.sentences())?,
    ))
}

/// Puts a value into a dictionary.
fn put(into: &Bound<'_, PyDict>, key: &str, value: Value) -> PyResult<()> {
    match value {
        Value::Number(x) => into.set_item(key, x),
        Value::Whole(n) => into.set_item(key, n),
        Value::Name(name) => into.set_item(key, name),
    }
}
