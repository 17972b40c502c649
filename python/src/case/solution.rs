//! One solved case.

use crate::given::{self, Origin};
use crate::{arrays, units};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyDict;
use slipgap::history::History;
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::numbers::unit::Dimension;
use slipgap::problem::{self, Case, Problem};
use slipgap::run::Source;
use std::sync::Arc;

/// A solved case, as `slipgap.solve` returns it.
///
/// All arrays have the shape (N + 1,) for N time steps. Quantities have the scales of docs/scope.md: for the oscillator T = omega_n t,
/// X = x/Delta, V = X' and S = force/(nu N); for bars t/T_I, r/(c T_I/2), rdot/c and force/F0. Structures have the units of their
/// study. A study with units has further columns in these units.
#[pyclass(frozen, module = "slipgap")]
pub struct Solution {
    problem: Arc<dyn Problem>,
    /// The study, if it is of one.
    source: Option<Arc<Source>>,
    case: Case,
    /// Number of the case in the study, from 0.
    #[pyo3(get)]
    case_number: u64,
    solution: problem::Solution,
    metrics: Vec<(String, Option<f64>)>,
    dicts: Dicts,
}

/// What was asked for already.
struct Dicts {
    parameters: PyOnceLock<Py<PyDict>>,
    channels: PyOnceLock<Py<PyDict>>,
    references: PyOnceLock<Py<PyDict>>,
    measured: PyOnceLock<Py<PyDict>>,
    metrics: PyOnceLock<Py<PyDict>>,
}

impl Solution {
    pub fn new(
        problem: Arc<dyn Problem>,
        source: Option<Arc<Source>>,
        (case_number, case): (u64, Case),
        solution: problem::Solution,
        metrics: Vec<(String, Option<f64>)>,
    ) -> Solution {
        Solution {
            problem,
            source,
            case,
            case_number,
            solution,
            metrics,
            dicts: Dicts {
                parameters: PyOnceLock::new(),
                channels: PyOnceLock::new(),
                references: PyOnceLock::new(),
                measured: PyOnceLock::new(),
                metrics: PyOnceLock::new(),
            },
        }
    }

    /// Puts a column into a dictionary, and the same in the units of the study.
    fn put(
        &self,
        dict: &Bound<'_, PyDict>,
        name: &str,
        dimension: Dimension,
        values: &[f64],
    ) -> PyResult<()> {
        let py = dict.py();
        dict.set_item(name, arrays::numbers(py, values.iter().copied())?)?;
        let units = self.source.as_ref();
        let Some(units) = units.and_then(|source| source.study.units.as_ref()) else {
            return Ok(());
        };
        if let Some(size) = self
            .problem
            .as_textbook()
            .and_then(|textbook| textbook.size(&self.case, dimension))
        {
            let values = arrays::numbers(py, values.iter().map(|x| x * size))?;
            dict.set_item(units.column(name, dimension), values)?;
        }
        Ok(())
    }

    /// The time and the channels of one of the two histories.
    fn history<'py>(
        &self,
        py: Python<'py>,
        history: &History,
        exact: bool,
    ) -> PyResult<Py<PyDict>> {
        let dict = PyDict::new(py);
        let time = &self.problem.schema().time.column;
        self.put(&dict, time, Dimension::Time, &history.time)?;
        for channel in self.problem.history_columns(&self.case) {
            let column = channel.column;
            if !exact || column.exact {
                let values = history.channel(channel.index);
                self.put(&dict, &column.name, column.dimension, values)?;
            }
        }
        Ok(dict.unbind())
    }
}

#[pymethods]
impl Solution {
    /// The computed motion: time and channels by name, each of shape (N + 1,).
    #[getter]
    fn channels(&self, py: Python<'_>) -> PyResult<&Py<PyDict>> {
        let new = || self.history(py, &self.solution.computed, false);
        self.dicts.channels.get_or_try_init(py, new)
    }

    /// The exact motion at the same times: time and channels by name, each of shape (N + 1,).
    #[getter]
    fn references(&self, py: Python<'_>) -> PyResult<&Py<PyDict>> {
        let new = || self.history(py, &self.solution.exact, true);
        self.dicts.references.get_or_try_init(py, new)
    }

    /// What was measured, at the same times: time and channels by name, each of shape (N + 1,), straight between the measured
    /// points and NaN outside of them. Empty for a study without `measured`.
    #[getter]
    fn measured(&self, py: Python<'_>) -> PyResult<&Py<PyDict>> {
        self.dicts.measured.get_or_try_init(py, || {
            let dict = PyDict::new(py);
            let measured = self
                .problem
                .as_structure()
                .map_or(Vec::new(), |structure| structure.measured(&self.case));
            let times = &self.solution.computed.time;
            if !measured.is_empty() {
                let schema = self.problem.schema();
                self.put(&dict, &schema.time.column, Dimension::Time, times)?;
                for channel in &measured {
                    let dimension = schema.channels[channel.column].dimension;
                    self.put(&dict, &channel.name, dimension, &channel.at(times))?;
                }
            }
            Ok(dict.unbind())
        })
    }

    /// The metrics by name; None where one is undefined.
    #[getter]
    fn metrics(&self, py: Python<'_>) -> PyResult<&Py<PyDict>> {
        self.dicts.metrics.get_or_try_init(py, || {
            let metrics = PyDict::new(py);
            for (name, value) in &self.metrics {
                metrics.set_item(name, value)?;
            }
            Ok(metrics.unbind())
        })
    }

    /// The parameters that apply, by name, with defaults and what follows from others.
    #[getter]
    fn parameters(&self, py: Python<'_>) -> PyResult<&Py<PyDict>> {
        self.dicts.parameters.get_or_try_init(py, || {
            let parameters = PyDict::new(py);
            for (parameter, value) in self.problem.parameters().iter().zip(&self.case.values) {
                let name = &*parameter.name;
                match value {
                    Some(Value::Number(x)) => parameters.set_item(name, x)?,
                    Some(Value::Whole(n)) => parameters.set_item(name, n)?,
                    Some(Value::Name(chosen)) => parameters.set_item(name, chosen)?,
                    None => {}
                }
            }
            Ok(parameters.unbind())
        })
    }

    /// The channels that the study draws or measures and that are no columns of a history, computed or exact, by name.
    fn drawn<'py>(&self, py: Python<'py>, exact: bool) -> PyResult<Bound<'py, PyDict>> {
        let (dict, schema) = (PyDict::new(py), self.problem.schema());
        if !schema.described {
            return Ok(dict);
        }
        let columns = self.problem.history_columns(&self.case);
        let history = match exact {
            true if columns.iter().any(|shown| shown.column.exact) => &self.solution.exact,
            true => return Ok(dict),
            false => &self.solution.computed,
        };
        let drawn = schema.quantities.iter().filter(|quantity| !quantity.error);
        for quantity in drawn.filter(|quantity| {
            columns
                .iter()
                .all(|column| column.column.name != quantity.name)
        }) {
            let values = history.channel(quantity.channel).iter().copied();
            dict.set_item(&*quantity.name, arrays::numbers(py, values)?)?;
        }
        Ok(dict)
    }

    /// Units by channel, of those whose unit is known.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (dict, schema) = (PyDict::new(py), self.problem.schema());
        let study = self
            .source
            .as_ref()
            .and_then(|opened| opened.study.units.as_ref());
        let put = |name: &str, dimension: Dimension| -> PyResult<()> {
            if let Some(unit) = units::of_dimension(&*self.problem, dimension) {
                dict.set_item(name, unit)?;
            }
            let known = study.filter(|_| {
                self.problem
                    .as_textbook()
                    .and_then(|textbook| textbook.size(&self.case, dimension))
                    .is_some()
            });
            known.map_or(Ok(()), |units| {
                dict.set_item(units.column(name, dimension), units.of(dimension))
            })
        };
        put(&schema.time.column, Dimension::Time)?;
        for channel in self.problem.history_columns(&self.case) {
            put(&channel.column.name, channel.column.dimension)?;
        }
        Ok(dict)
    }

    /// Name of the problem.
    #[getter]
    fn problem(&self) -> &str {
        self.problem.name()
    }

    /// The file of the study, its text, and the parameters that were set with their values; None without a study.
    #[getter]
    fn source(&self) -> Option<Origin> {
        self.source.as_deref().map(given::origin)
    }
}
