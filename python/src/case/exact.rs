//! `slipgap.exact`: exact motions at given times.

use super::of_dict::case_of_dict;
use crate::arrays;
use crate::error::{raise, usage};
use crate::given;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use slipgap::contact::VelocityControl;
use slipgap::error::Error;
use slipgap::history::History;
use slipgap::problem::numbers::parameter::{Default, Kind};
use slipgap::problem::{self, Case, Jumps, PROBLEMS, Problem};

/// The law of an exact motion without `law`: friction without compliance.
const RIGID: &str = VelocityControl::RIGID_NAME;

/// The exact motion of a problem at these times, the bytes of an array, as a dictionary of channels.
#[pyfunction]
pub fn exact<'py>(
    py: Python<'py>,
    problem: &str,
    t: &[u8],
    parameters: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let Some(known) = problem::find(problem) else {
        let known: Vec<&str> = PROBLEMS.iter().map(|known| known.name()).collect();
        let names = known.join(", ");
        return Err(usage(
            py,
            format!("problem: unknown {problem:?}; allowed: {names}"),
        ));
    };
    let step = known.schema().step_name();
    let times = arrays::of_bytes(t);
    let rising = times.windows(2).all(|pair| pair[0] <= pair[1]);
    let last = times.last().copied().unwrap_or(0.0);
    if !rising || times.first().is_some_and(|first| *first < 0.0) || !last.is_finite() {
        return Err(usage(
            py,
            "t: must be finite numbers >= 0 that do not decrease",
        ));
    }
    for name in [step, "duration"] {
        if parameters.contains(name)? {
            let message = format!("{name}: an exact motion has no such parameter");
            return Err(usage(py, message));
        }
    }
    // What only the computation depends on: one step to the end.
    let end = if last > 0.0 { last } else { 1.0 };
    let given = parameters.copy()?;
    given.set_item("problem", problem)?;
    given.set_item(step, end)?;
    given.set_item("duration", end)?;
    let of_law = given.contains("law")?;
    add_numerical(&*known, &given)?;
    let case = case(py, &given)?;
    let history = py.detach(|| motion(&*known, &case, &times, of_law));
    let Some(history) = history else {
        let message = "this law has no exact motion; allowed: coulomb, displacement-control and velocity-control of the oscillator; bars have none";
        return Err(usage(py, message));
    };
    let dict = PyDict::new(py);
    for channel in known.history_columns(&case) {
        let samples = history.channel(channel.index);
        let values = arrays::numbers(py, samples.iter().copied())?;
        dict.set_item(&*channel.column.name, values)?;
    }
    Ok(dict)
}

/// Adds the parameters that a case needs and its exact motion does not depend on: numbers of elements, a stiffness of the contact,
/// and the law.
fn add_numerical(problem: &dyn Problem, given: &Bound<'_, PyDict>) -> PyResult<()> {
    for [one, other] in problem.schema().alternatives.iter() {
        if !given.contains(&**one)? && !given.contains(&**other)? {
            given.set_item(&**one, 1)?;
        }
    }
    for parameter in problem.parameters() {
        let needed = matches!(parameter.default, Default::Required);
        if !needed || given.contains(&*parameter.name)? {
            continue;
        }
        match parameter.kind {
            Kind::Whole { min, .. } => given.set_item(&*parameter.name, min)?,
            Kind::Choice(names) if names.iter().any(|name| name.0 == RIGID) => {
                given.set_item(&*parameter.name, RIGID)?;
            }
            Kind::Choice(_) | Kind::Number(_) => {}
        }
    }
    Ok(())
}

/// The completed case of these parameters.
fn case(py: Python<'_>, given: &Bound<'_, PyDict>) -> PyResult<Case> {
    if let Some((_, case)) = case_of_dict(given)? {
        return Ok(case);
    }
    let text = given::text_of_parameters(py, given)?;
    let source = given::of_dict(py, &text)?;
    let case = source.study.case(0);
    case.ok_or_else(|| raise(py, Error::Usage("exact: no case".into())))
}

/// The exact motion, that of the case's own law if it is `of_law`.
fn motion(problem: &dyn Problem, case: &Case, times: &[f64], of_law: bool) -> Option<History> {
    if times.is_empty() {
        let channels = vec![Vec::new(); problem.schema().channels.len()];
        let time = Vec::new();
        return Some(History { time, channels });
    }
    match of_law {
        true => problem
            .as_textbook()
            .and_then(|textbook| textbook.exact_of_law(case, times)),
        false => problem.exact(case, times, Jumps::RightLimit),
    }
}
