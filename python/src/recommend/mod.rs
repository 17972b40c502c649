//! `slipgap.recommend`: the cheapest parameters that reach a target.

mod study;

use crate::error::{raise, usage};
use crate::worker;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyType};
use slipgap::problem::Case;
use slipgap::problem::numbers::parameter::Value;
use slipgap::recommend::friction::{FrictionTask, Releases};
use slipgap::recommend::impact::{ImpactTask, bar};
use slipgap::recommend::task::Search;
use slipgap::recommend::{Candidate, SearchSpace, recommend as best, robustness};

/// The classes `slipgap.Recommendation`, `slipgap.Candidate` and `slipgap.Robustness`.
static RECOMMENDATION: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static ROBUSTNESS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static CANDIDATE: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// Names of what may be given.
const FRICTION: [&str; 5] = ["rms", "law", "method", "x0", "energy_gain"];
const IMPACT: [&str; 13] = [
    "peak_force_error",
    "overlap",
    "r",
    "rdot",
    "law",
    "method",
    "energy_gain",
    "energy_loss",
    "n",
    "gamma",
    "k_I",
    "mass",
    "bars",
];

/// Searches.
#[pyfunction]
pub fn recommend<'py>(
    py: Python<'py>,
    problem: &Bound<'py, PyAny>,
    targets: &Bound<'py, PyDict>,
    jobs: Option<i64>,
    set: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let jobs = worker::jobs(py, jobs)?;
    let name: Option<String> = problem.extract().ok();
    let search = match name.as_deref() {
        Some("friction-oscillator") if set.is_none() => friction(py, targets)?,
        Some("bar-impact") if set.is_none() => impact(py, targets)?,
        _ if targets.is_empty() => return study::recommend(py, problem, jobs, set),
        _ => {
            let message = "only friction-oscillator and bar-impact have targets as arguments, and no set; a study has them in its key recommend";
            return Err(usage(py, message));
        }
    };
    let stop = search.request.stop.clone();
    let (search, found, robustness) = worker::wait(
        py,
        jobs,
        move || {
            let found = best(&*search.space, &search.request);
            let answer = &found.answer;
            let nearest = answer.front.len().checked_sub(1);
            let shown = answer.chosen().or(nearest);
            let shown = shown.and_then(|at| answer.front.get(at));
            let robustness =
                shown.and_then(|choice| robustness(search.space.space(), &search.request, choice));
            Ok((search, found, robustness))
        },
        || stop.stop(),
        |_| Ok(()),
    )?;
    let answer = &found.answer;
    let chosen = answer.chosen();
    let front = answer.front.iter();
    let front = front.map(|choice| candidate(py, &search, choice));
    let front = front.collect::<PyResult<Vec<_>>>()?;
    let nearest = chosen.or(front.len().checked_sub(1));
    let nearest = nearest.and_then(|at| front.get(at)).cloned();
    let surveyed = found.survey.as_ref().map_or(0, |survey| survey.solved);
    let solved = answer.solved + surveyed;
    let own_step = answer.own_step.as_ref();
    let own_step = own_step
        .map(|choice| candidate(py, &search, choice))
        .transpose()?;
    let robustness = robustness.map(|found| {
        let target = search.request.targets[found.target].name.replace(' ', "_");
        let class = ROBUSTNESS.import(py, "slipgap._records", "Robustness")?;
        let [first, last] = found.ends;
        let (name, at) = (found.parameter, found.at);
        class.call1((
            name,
            first,
            last,
            found.count,
            found.missed,
            target,
            found.error,
            at,
        ))
    });
    let robustness = robustness.transpose()?;
    let class = RECOMMENDATION.import(py, "slipgap._records", "Recommendation")?;
    class.call1((
        chosen.is_some(),
        nearest,
        front,
        solved,
        own_step,
        robustness,
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

/// A `slipgap.Candidate`.
fn candidate<'py>(
    py: Python<'py>,
    search: &Search,
    candidate: &Candidate,
) -> PyResult<Bound<'py, PyAny>> {
    let space = search.space.space();
    let parameters = match candidate.cases.first() {
        Some(case) => parameters(py, space, case)?,
        None => PyDict::new(py),
    };
    let errors = PyDict::new(py);
    for (target, error) in search.request.targets.iter().zip(&candidate.errors) {
        errors.set_item(target.name.replace(' ', "_"), error)?;
    }
    let class = CANDIDATE.import(py, "slipgap._records", "Candidate")?;
    let reached = candidate.worst <= 1.0;
    class.call1((
        parameters,
        candidate.cost,
        errors,
        reached,
        candidate.converged,
    ))
}

/// The parameters of a study with this case: numbers, names, and objects of them.
fn parameters<'py>(
    py: Python<'py>,
    space: &dyn SearchSpace,
    case: &Case,
) -> PyResult<Bound<'py, PyDict>> {
    let parameters = PyDict::new(py);
    for name in space.study_parameters() {
        let Some(value) = case.get(name) else {
            continue;
        };
        let (into, key) = match name.split_once('.') {
            None => (parameters.clone(), name),
            Some((object, key)) => {
                if !parameters.contains(object)? {
                    parameters.set_item(object, PyDict::new(py))?;
                }
                let inner = parameters.as_any().get_item(object)?;
                (inner.cast_into()?, key)
            }
        };
        put(&into, key, value)?;
    }
    Ok(parameters)
}

/// Refuses names that the problem does not have.
fn check_names(targets: &Bound<'_, PyDict>, allowed: &[&str]) -> PyResult<()> {
    for key in targets.keys() {
        let key: String = key.extract()?;
        if !allowed.contains(&key.as_str()) {
            let message = format!("unknown {key}; allowed: {}", allowed.join(", "));
            return Err(usage(targets.py(), message));
        }
    }
    Ok(())
}

/// A value of the dictionary, if it is given.
fn get<'py, T: for<'a> FromPyObject<'a, 'py, Error: Into<PyErr>>>(
    targets: &Bound<'py, PyDict>,
    name: &str,
) -> PyResult<Option<T>> {
    match targets.get_item(name)? {
        Some(value) if !value.is_none() => Ok(Some(value.extract().map_err(Into::into)?)),
        Some(_) | None => Ok(None),
    }
}

/// One release, a number, or a range of them, a pair of numbers.
fn releases(targets: &Bound<'_, PyDict>) -> PyResult<Option<Releases>> {
    let given: Option<Bound<'_, PyAny>> = get(targets, "x0")?;
    let Some(given) = given else {
        return Ok(None);
    };
    if let Ok((from, to)) = given.extract() {
        return Ok(Some(Releases::Range(from, to)));
    }
    match given.extract() {
        Ok(one) => Ok(Some(Releases::One(one))),
        Err(_) => {
            let message = "x0: must be a number, or a pair of numbers such as (8, 20)";
            Err(usage(targets.py(), message))
        }
    }
}

fn friction(py: Python<'_>, targets: &Bound<'_, PyDict>) -> PyResult<Search> {
    check_names(targets, &FRICTION)?;
    let Some(rms) = get(targets, "rms")? else {
        return Err(usage(py, "friction-oscillator needs the target rms"));
    };
    let usual = FrictionTask::new(rms);
    let task = FrictionTask {
        law: get(targets, "law")?,
        method: get(targets, "method")?,
        x0: releases(targets)?.unwrap_or(usual.x0),
        energy_gain: get(targets, "energy_gain")?.unwrap_or(usual.energy_gain),
        rms,
    };
    py.detach(|| task.search())
        .map_err(|error| raise(py, error))
}

fn impact(py: Python<'_>, targets: &Bound<'_, PyDict>) -> PyResult<Search> {
    check_names(targets, &IMPACT)?;
    let usual = ImpactTask::default();
    let mut task = ImpactTask {
        peak_force_error: get(targets, "peak_force_error")?,
        overlap: get(targets, "overlap")?,
        r: get(targets, "r")?,
        rdot: get(targets, "rdot")?,
        law: get(targets, "law")?,
        method: get(targets, "method")?,
        energy_gain: get(targets, "energy_gain")?.unwrap_or(usual.energy_gain),
        energy_loss: get(targets, "energy_loss")?.unwrap_or(usual.energy_loss),
        n: get(targets, "n")?,
        gamma: get(targets, "gamma")?,
        k_i: get(targets, "k_I")?,
        mass: get(targets, "mass")?,
        bars: Vec::new(),
    };
    if let Some(bars) = get::<Bound<'_, PyDict>>(targets, "bars")? {
        add_bars(&mut task, &bars, "")?;
    }
    py.detach(|| task.search())
        .map_err(|error| raise(py, error))
}

/// Adds the data of the bars, as in a study.
fn add_bars(task: &mut ImpactTask, bars: &Bound<'_, PyDict>, prefix: &str) -> PyResult<()> {
    for (key, value) in bars {
        let key = format!("{prefix}{}", key.extract::<String>()?);
        if let Ok(inner) = value.cast::<PyDict>() {
            add_bars(task, inner, &format!("{key}."))?;
            continue;
        }
        let text = value.str()?.to_string();
        let read = bar(&key, &text);
        task.bars
            .push(read.map_err(|why| usage(bars.py(), format!("bars: {why}")))?);
    }
    Ok(())
}
