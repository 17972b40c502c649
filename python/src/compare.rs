//! `slipgap.compare`: two folders of results.

use crate::error::{raise, usage};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;
use slipgap::compare::{Finding, compare_folders};
use std::path::PathBuf;

/// The classes `slipgap.Comparison` and `slipgap.Change`.
static COMPARISON: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static CHANGE: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// Compares two folders.
#[pyfunction]
pub fn compare<'py>(
    py: Python<'py>,
    a: PathBuf,
    b: PathBuf,
    tolerance: f64,
) -> PyResult<Bound<'py, PyAny>> {
    if !(tolerance >= 0.0 && tolerance.is_finite()) {
        let message = format!("tolerance: must be a number >= 0, got {tolerance}");
        return Err(usage(py, message));
    }
    let findings = py
        .detach(|| compare_folders(&a, &b, tolerance))
        .map_err(|error| raise(py, error))?;
    let sides = [a, b];
    let class = CHANGE.import(py, "slipgap._records", "Change")?;
    let (mut equal, mut changes, mut notes) = (Vec::new(), Vec::new(), Vec::new());
    for (name, finding) in findings {
        if finding.same() {
            equal.push(name.clone());
        }
        let shown = if name.is_empty() { "." } else { &name };
        let comparison = match finding {
            Finding::OnlyIn(side) => {
                notes.push(format!("{shown}: only in {}", sides[side].display()));
                continue;
            }
            Finding::OtherProblem => {
                notes.push(format!(
                    "{shown}: the two results are of different problems"
                ));
                continue;
            }
            Finding::Compared(comparison) => comparison,
        };
        let origins = comparison.origins.iter();
        notes.extend(origins.map(|origin| format!("{shown}: {origin}")));
        let alone = comparison.alone.iter().zip(&comparison.columns);
        for ((cases, metrics), side) in alone.zip(&sides) {
            let side = side.display();
            if *cases > 0 {
                notes.push(format!("{shown}: {cases} cases only in {side}"));
            }
            if !metrics.is_empty() {
                notes.push(format!("{shown}: {} only in {side}", metrics.join(", ")));
            }
        }
        for change in comparison.changes {
            let [first, second] = change.cells.each_ref().map(|cell| cell.parse::<f64>().ok());
            let case: Option<u64> = change.case.parse().ok();
            let numbers = (change.cases, comparison.common, change.largest);
            let record = (
                &name,
                change.metric,
                numbers.0,
                numbers.1,
                numbers.2,
                case,
                first,
                second,
            );
            changes.push(class.call1(record)?);
        }
    }
    let class = COMPARISON.import(py, "slipgap._records", "Comparison")?;
    class.call1((equal, changes, notes))
}
