//! Errors as exceptions of Python.

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyType};
use slipgap::error::{Error, Fault};
use slipgap::solve::Unsolvable;
use std::path::Path;

/// Name of a dictionary in place of a file.
pub const DICT: &str = "<dict>";

/// The class `slipgap.SlipgapError`.
static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
/// The class `slipgap.Fault`.
static FAULT: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// A `SlipgapError` with this message.
pub fn usage(py: Python<'_>, message: impl Into<String>) -> PyErr {
    raise(py, Error::Usage(message.into()))
}

/// A `SlipgapError` about a case without a solution.
pub fn unsolved(py: Python<'_>, number: u64, why: &Unsolvable) -> PyErr {
    let message = format!("case {number} could not be solved: {why}");
    raise(py, Error::Unsolved(message))
}

/// The exception of an error.
pub fn raise(py: Python<'_>, error: Error) -> PyErr {
    exception(py, &error).unwrap_or_else(|other| other)
}

fn exception(py: Python<'_>, error: &Error) -> PyResult<PyErr> {
    let class = CLASS.import(py, "slipgap._errors", "SlipgapError")?;
    let fields = PyDict::new(py);
    let message = match error {
        Error::Faults(faults) => {
            let of_faults = faults.iter().map(|fault| record(py, fault));
            let records = of_faults.collect::<PyResult<Vec<_>>>()?;
            fields.set_item("faults", records)?;
            let lines: Vec<String> = faults.iter().map(text).collect();
            lines.join("\n")
        }
        Error::Io { path, .. } | Error::Busy(path) => {
            fields.set_item("file", path.display().to_string())?;
            error.to_string()
        }
        Error::Usage(_)
        | Error::Unsolved(_)
        | Error::PartsMissing(_)
        | Error::Interrupted
        | Error::Internal(_) => error.to_string(),
    };
    let exception = class.call((message,), Some(&fields))?;
    Ok(PyErr::from_value(exception))
}

/// Whether a file is a dictionary, or a study that was changed after it was read, as in `studies/<name>`.
fn is_dict(file: &str) -> bool {
    let name = Path::new(file).file_name().and_then(|name| name.to_str());
    name.is_some_and(|name| name.starts_with('<') && name.ends_with('>'))
}

/// The place of a fault. A dictionary has no lines, only paths.
fn place(fault: &Fault) -> Option<(usize, usize)> {
    (!is_dict(&fault.file)).then_some((fault.line, fault.column))
}

/// A setting as a caller of Python writes it: without the dashes of the command line.
fn file(fault: &Fault) -> Option<&str> {
    let file = fault.file.strip_prefix("--").unwrap_or(&fault.file);
    (!is_dict(file)).then_some(file)
}

/// A fault as a line, with the place in the file below it.
fn text(fault: &Fault) -> String {
    match (place(fault), file(fault)) {
        (Some((line, column)), Some(file)) => {
            let path = match fault.path.is_empty() {
                true => String::new(),
                false => format!("{}: ", fault.path),
            };
            let shown = match fault.shown.is_empty() {
                true => String::new(),
                false => format!("\n{}", fault.shown.trim_end()),
            };
            format!("{file}:{line}:{column}: {path}{}{shown}", fault.message)
        }
        _ if fault.path.is_empty() => fault.message.clone(),
        _ => format!("{}: {}", fault.path, fault.message),
    }
}

/// A `slipgap.Fault`.
fn record<'py>(py: Python<'py>, fault: &Fault) -> PyResult<Bound<'py, PyAny>> {
    let class = FAULT.import(py, "slipgap._errors", "Fault")?;
    let (line, column) = place(fault).unzip();
    class.call1((file(fault), line, column, &fault.path, &fault.message))
}
