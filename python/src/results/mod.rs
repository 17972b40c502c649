//! The results of a run.

pub(super) mod arrow_table;
pub(super) mod expand;
pub(super) mod figure;
pub(super) mod group_tables;
pub(super) mod result_columns;

use crate::case::solution::Solution;
use crate::case::solve;
use crate::error::raise;
use crate::given::{self, Origin};
use arrow_table::Table;
use figure::{Figure, Shown};
use group_tables::Groups;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyType};
use slipgap::batch::WarnedCases;
use slipgap::batch::output::manifest;
use slipgap::checks::{self, TestedValues};
use slipgap::error::Error;
use slipgap::problem::numbers::parameter::Value;
use std::path::PathBuf;
use std::sync::Arc;

/// The classes `slipgap.Check`, `slipgap.Failure` and `slipgap.WarnedCases`.
static CHECK: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static FAILURE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static WARNED: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// The results of a study, as `slipgap.run` returns them.
#[pyclass(frozen, module = "slipgap")]
pub struct Results {
    /// The table with one row for each case.
    #[pyo3(get)]
    pub table: Py<Table>,
    /// Figures by name.
    #[pyo3(get)]
    pub figures: Py<PyDict>,
    /// The folder with the files of the run; None without one.
    #[pyo3(get)]
    pub folder: Option<PathBuf>,
    pub shown: Arc<Shown>,
    pub failures: Vec<(u64, String)>,
    /// By check of the study: the cases and the values; NaN if a value is undefined.
    pub checked: TestedValues,
    pub without_contact: u64,
    pub warnings: Vec<WarnedCases>,
    pub groups: Groups,
}

impl Results {
    /// The figures by name.
    pub fn figures(
        py: Python<'_>,
        shown: &Arc<Shown>,
        folder: Option<&PathBuf>,
    ) -> PyResult<Py<PyDict>> {
        let figures = PyDict::new(py);
        for figure in Figure::all(shown, folder.map(PathBuf::as_path)) {
            let figure = Bound::new(py, figure)?;
            figures.set_item(figure.getattr("name")?, figure)?;
        }
        Ok(figures.unbind())
    }
}

#[pymethods]
impl Results {
    /// The checks of the study, each with its case, its value and whether it is met. They are made when they are asked for.
    #[getter]
    fn checks<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let class = CHECK.import(py, "slipgap._records", "Check")?;
        let study = &self.shown.source.study;
        let verdicts = self.checked.verdicts(study);
        let record = |verdict: checks::Verdict| {
            let met = verdict.holds();
            let checks::Verdict {
                case,
                metric,
                value,
                min,
                max,
            } = verdict;
            class.call1((case, metric, value, min, max, met))
        };
        verdicts.map(record).collect()
    }

    /// The cases that could not be solved.
    #[getter]
    fn failures<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let class = FAILURE.import(py, "slipgap._records", "Failure")?;
        let failures = self.failures.iter();
        failures
            .map(|failure| class.call1(failure.clone()))
            .collect()
    }

    /// The kinds of warnings, each with the number of its cases and one of them.
    #[getter]
    fn warnings<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let class = WARNED.import(py, "slipgap._records", "WarnedCases")?;
        let record = |warning: &WarnedCases| {
            let parameters = PyDict::new(py);
            for (name, value) in &warning.parameters {
                match value {
                    Value::Number(x) => parameters.set_item(name, x)?,
                    Value::Whole(n) => parameters.set_item(name, n)?,
                    Value::Name(text) => parameters.set_item(name, text)?,
                }
            }
            let message = warning.to_string();
            class.call1((
                warning.kind.name(),
                warning.cases,
                warning.case,
                parameters,
                message,
                warning.is_note,
            ))
        };
        self.warnings.iter().map(record).collect()
    }

    /// The tables over groups of cases by name, with the columns of the files: `quantiles`, `two_samples` and `tests` of an ensemble, `sobol` of
    /// a saltelli design, `reductions`, those that the study has; and `warnings`, one row for each kind.
    #[getter]
    fn tables(&self, py: Python<'_>) -> PyResult<Py<PyDict>> {
        self.groups.tables(py, &self.shown, &self.warnings)
    }

    /// A case of the study with its motion, as `slipgap.solve` gives it.
    fn solution(&self, py: Python<'_>, case: i64) -> PyResult<Solution> {
        solve::of_source(py, self.shown.source.clone(), case)
    }

    /// Names of the columns of the table that are parameters.
    #[getter]
    fn parameters(&self) -> Vec<String> {
        let study = &self.shown.source.study;
        let table = study.problem.parameters();
        let rows = study.parameter_columns().into_iter();
        rows.map(|row| table[row].column_name().to_owned())
            .collect()
    }

    /// Names of the columns of the table that are metrics.
    #[getter]
    fn metrics(&self) -> Vec<String> {
        let study = &self.shown.source.study;
        let columns = study.columns.iter();
        columns
            .map(|row| study.measures[*row].name.clone())
            .collect()
    }

    /// The origin of the results, as in manifest.json.
    #[getter]
    fn manifest<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let source = &self.shown.source;
        let read = py.detach(|| match &self.folder {
            Some(folder) => {
                let file = folder.join("manifest.json");
                std::fs::read_to_string(&file).map_err(Error::io("cannot read", file))
            }
            None => {
                let entries = {
                    let counted = self.without_contact;
                    manifest(&source.study, &source.file, &[], counted, &self.warnings)
                };
                Ok(serde_json::Value::Object(entries).to_string())
            }
        });
        let text = read.map_err(|error| raise(py, error))?;
        py.import("json")?.call_method1("loads", (text,))
    }

    /// The file of the study, its text, and the parameters that were set with their values.
    #[getter]
    fn source(&self) -> Origin {
        given::origin(&self.shown.source)
    }
}
