//! `slipgap.exact`: exact motions at given times.

use crate::arrays;
use crate::case_of_dict::case_of_dict;
use crate::error::{raise, usage};
use crate::given;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use slipgap::error::Error;
use slipgap::history::History;
use slipgap::problem::friction::FrictionOscillator;
use slipgap::problem::{Case, PROBLEMS, Problem};

/// Names of the time step, which no exact motion depends on.
const STEPS: [(&str, &str); 2] = [("friction-oscillator", "dT"), ("bar-impact", "dt")];

/// The exact motion of a problem at these times, the bytes of an array, as a dictionary of channels.
#[pyfunction]
pub fn exact<'py>(
    py: Python<'py>,
    problem: &str,
    t: &[u8],
    parameters: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let known = STEPS.iter().find(|known| known.0 == problem);
    let Some((_, step)) = known else {
        let names = STEPS.map(|known| known.0).join(", ");
        return Err(usage(
            py,
            format!("problem: unknown {problem:?}; allowed: {names}"),
        ));
    };
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
    let softened = given.contains("law")?;
    let usual = |name: &str, value: u32| match given.contains(name)? {
        true => Ok(()),
        false => given.set_item(name, value),
    };
    match problem {
        "bar-impact" => {
            usual("n", 1)?;
            if !given.contains("k_I")? {
                usual("gamma", 1)?;
            }
        }
        _ if softened => {}
        _ => given.set_item("law", "coulomb")?,
    }
    let case = case(py, &given)?;
    let problem = PROBLEMS.iter().find(|known| known.name() == problem);
    let history = py.detach(|| problem.and_then(|known| motion(&**known, &case, &times, softened)));
    let Some((history, problem)) = history.zip(problem) else {
        let message = "this law has no exact motion; allowed: coulomb, displacement-control and velocity-control of the oscillator; bars have none";
        return Err(usage(py, message));
    };
    let dict = PyDict::new(py);
    for channel in problem.history_columns(&case) {
        let values = history.channel(channel.index);
        let values = arrays::numbers(py, values.iter().copied())?;
        dict.set_item(&*channel.column.name, values)?;
    }
    Ok(dict)
}

/// The completed case of these parameters.
fn case(py: Python<'_>, given: &Bound<'_, PyDict>) -> PyResult<Case> {
    if let Some((_, case)) = case_of_dict(given)? {
        return Ok(case);
    }
    let text = given::text_of_parameters(py, given)?;
    let source = given::of_text(py, &text, &[])?;
    let case = source.study.case(0);
    case.ok_or_else(|| raise(py, Error::Usage("exact: no case".into())))
}

/// The exact motion, with the softened law if it is `softened`.
fn motion(problem: &dyn Problem, case: &Case, times: &[f64], softened: bool) -> Option<History> {
    if times.is_empty() {
        let channels = vec![Vec::new(); problem.schema().channels.len()];
        let time = Vec::new();
        return Some(History { time, channels });
    }
    let law = case.choice("law");
    if !softened || law == "coulomb" {
        return problem.exact_at(case, times);
    }
    match problem.name() == FrictionOscillator.name() {
        true => FrictionOscillator.softened(case, times),
        false => None,
    }
}
