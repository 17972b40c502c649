//! `slipgap.calibrate`: the values of free parameters with which a study comes nearest to what was measured.

use crate::given;
use crate::worker;
use indicatif::ProgressBar;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyType};
use slipgap::calibrate::{
    Calibration, Fit, calibrate as best, sentences, state_name, studies, verdict, write,
};
use slipgap::figures::style::DPI;
use slipgap::recommend::Stop;
use slipgap::recommend::calibrate::End;
use std::path::{Path, PathBuf};

/// The classes `slipgap.Calibration`, `slipgap.Alternative` and `slipgap.FreeParameter`.
static CALIBRATION: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static ALTERNATIVE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static FREE: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// Calibrates a study; `progress` is called with the number of solved cases and the most that the search takes.
#[pyfunction]
#[pyo3(signature = (study, out, jobs, set, progress, allow_programs))]
pub fn calibrate<'py>(
    py: Python<'py>,
    study: &Bound<'py, PyAny>,
    out: Option<PathBuf>,
    jobs: Option<i64>,
    set: Option<&Bound<'py, PyAny>>,
    progress: Option<&Bound<'py, PyAny>>,
    allow_programs: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let jobs = worker::jobs(py, jobs)?;
    let source = given::computed(py, study, set, allow_programs)?;
    let folder = out.map(|out| out.join(&source.name));
    let (stop, bar) = (Stop::default(), ProgressBar::hidden());
    let (stops, path, counter) = (stop.clone(), folder.clone(), bar.clone());
    let each = source
        .study
        .calibrate
        .as_ref()
        .map_or(0, |calibrate| calibrate.cases);
    let most = each * source.study.alternatives().len() as u64;
    let report = |done: u64, count: u64| match progress {
        Some(progress) => progress.call1((done, count)).map(|_| ()),
        None => Ok(()),
    };
    let (found, texts) = worker::wait(
        py,
        jobs,
        move || {
            let found = best(&source, &counter, &stops)?;
            if let Some(path) = &path {
                write(&found, &source, path, DPI)?;
            }
            // Files of a dictionary are relative to the current folder.
            let texts = studies(&found, &source, Path::new(""))?;
            Ok((found, texts))
        },
        || stop.stop(),
        |_| report(bar.position().min(most), most),
    )?;
    report(most, most)?;
    let fits = found
        .order
        .iter()
        .map(|at| alternative(py, &found, *at, texts.get(at)))
        .collect::<PyResult<Vec<_>>>()?;
    let class = CALIBRATION.import(py, "slipgap._records", "Calibration")?;
    class.call1((fits, sentences(&found), found.solved(), folder))
}

/// A `slipgap.Alternative`.
fn alternative<'py>(
    py: Python<'py>,
    found: &Calibration,
    at: usize,
    text: Option<&(String, String)>,
) -> PyResult<Bound<'py, PyAny>> {
    let fit = &found.fits[at];
    let table = found.study.problem.parameters();
    let solved = fit.misfit().is_finite();
    let parameters = PyDict::new(py);
    for (index, free) in fit.free.iter().enumerate().filter(|_| solved) {
        parameters.set_item(&*table[free.parameter].name, parameter(py, fit, index)?)?;
    }
    let unused: Vec<&str> = fit
        .unused
        .iter()
        .map(|parameter| &*table[parameter.parameter].name)
        .collect();
    let json = py.import("json")?.getattr("loads")?;
    let study = text.map(|(_, text)| json.call1((text,))).transpose()?;
    let residuals = fit.residuals.as_ref();
    let class = ALTERNATIVE.import(py, "slipgap._records", "Alternative")?;
    class.call1((
        fit.alternative.name.as_str(),
        solved.then(|| fit.misfit()),
        fit.numerical.as_ref().map(|error| error.total()),
        residuals.map(|found| found.correlation),
        parameters,
        unused,
        fit.found.correlation.clone(),
        verdict(found, at),
        fit.solved,
        study,
    ))
}

/// A `slipgap.FreeParameter`.
fn parameter<'py>(py: Python<'py>, fit: &Fit, index: usize) -> PyResult<Bound<'py, PyAny>> {
    let profile = fit.found.profiles.get(index);
    let range = fit.free[index].range;
    let ends = |ends: [End; 2]| {
        let [from, to] = ends.map(|end| fit.value(index, end));
        (from.unwrap_or(range.ends[0]), to.unwrap_or(range.ends[1]))
    };
    let points: Vec<(f64, f64)> = profile
        .iter()
        .flat_map(|profile| &profile.points)
        .filter(|point| point.misfit.is_finite())
        .map(|point| (range.at(point.at), point.misfit))
        .collect();
    let class = FREE.import(py, "slipgap._records", "FreeParameter")?;
    class.call1((
        fit.values[index],
        profile.and_then(|profile| profile.interval).map(ends),
        profile.map(|profile| ends(profile.within_tenth)),
        fit.state(index).map(state_name),
        points,
    ))
}
