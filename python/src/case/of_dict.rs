//! A case from a dictionary of parameters, without the text of a study: what a caller of `solve` in a loop pays for. It takes
//! only what is valid without doubt. All else is decoded as a study, which reports what is wrong.

use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyString};
use slipgap::problem::numbers::parameter::{Default, Kind, Value};
use slipgap::problem::{self, Case, Problem};
use std::sync::Arc;

/// The problem and its completed case; `None` if the dictionary has to be decoded as a study.
pub fn case_of_dict(given: &Bound<'_, PyDict>) -> PyResult<Option<(Arc<dyn Problem>, Case)>> {
    let Some(name) = given.get_item("problem")? else {
        return Ok(None);
    };
    let Ok(name) = name.cast::<PyString>() else {
        return Ok(None);
    };
    let Some(problem) = problem::find(name.to_str()?) else {
        return Ok(None);
    };
    let mut case = Case::new(problem.schema());
    if !put(&*problem, &mut case, given, "")? {
        return Ok(None);
    }
    Ok(complete(&*problem, &mut case).then_some((problem, case)))
}

/// Puts the parameters of an object with this prefix into the case; returns whether all are valid.
fn put(
    problem: &dyn Problem,
    case: &mut Case,
    given: &Bound<'_, PyDict>,
    prefix: &str,
) -> PyResult<bool> {
    for (key, value) in given {
        let Ok(key) = key.cast::<PyString>() else {
            return Ok(false);
        };
        let key = key.to_str()?;
        if prefix.is_empty() && key == "problem" {
            continue;
        }
        if prefix.is_empty()
            && let Ok(inner) = value.cast::<PyDict>()
        {
            if !put(problem, case, inner, key)? {
                return Ok(false);
            }
            continue;
        }
        let table = problem.parameters();
        let row = match prefix {
            "" => table.iter().position(|p| p.name == key),
            _ => {
                let parts = |name: &str| name.split_once('.') == Some((prefix, key));
                table.iter().position(|p| parts(&p.name))
            }
        };
        let value = row.map(|row| (row, decode(&table[row].kind, &value)));
        match value {
            Some((row, Some(value))) => case.values[row] = Some(value),
            _ => return Ok(false),
        }
    }
    Ok(true)
}

/// A value of this kind; `None` if it is not valid without doubt.
fn decode(kind: &Kind, value: &Bound<'_, PyAny>) -> Option<Value> {
    if value.is_instance_of::<PyBool>() {
        return None;
    }
    match kind {
        Kind::Number(range) => {
            let x: f64 = value.extract().ok()?;
            (x.is_finite() && range.contains(x)).then_some(Value::Number(x))
        }
        Kind::Whole { min, max } => {
            let n: u64 = value.extract().ok()?;
            (*min..=*max).contains(&n).then_some(Value::Whole(n))
        }
        Kind::Choice(names) => {
            let name = value.cast::<PyString>().ok()?.to_str().ok()?;
            let known = names.iter().find(|known| known.0 == name)?;
            Some(Value::Name(known.0))
        }
    }
}

/// Fills in what is not given; returns whether the case is complete and breaks no rule.
fn complete(problem: &dyn Problem, case: &mut Case) -> bool {
    let schema = problem.schema();
    let given = |case: &Case, name: &str| case.get(name).is_some();
    let both =
        |pair: &[slipgap::problem::table::schema::Text; 2]| pair.iter().all(|n| given(case, n));
    if schema.alternatives.iter().any(both) {
        return false;
    }
    for (row, parameter) in schema.parameters.iter().enumerate() {
        // The name that decides whether a parameter applies is earlier in the table.
        let on = parameter.applies.as_ref();
        let applies = on.is_none_or(|on| on.allows(case.choice(on.governor)));
        match (case.values[row], applies, &parameter.default) {
            (Some(_), false, _) | (None, true, Default::Required) => return false,
            (None, _, _) => case.values[row] = case.default_at(row),
            (Some(_), true, _) => {}
        }
    }
    problem.complete(case).is_empty()
}
