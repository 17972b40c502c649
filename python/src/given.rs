//! Studies as callers give them: a path, or a dictionary like the JSON of a study file.

use crate::error::{DICT, raise, usage};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyMapping, PyString, PyType};
use slipgap::run::{Source, check_printable, results_name};
use slipgap::study::{Input, MOST_CASES, Setting};
use std::path::{Path, PathBuf};

/// Name of the folder of results of a dictionary.
const FOLDER: &str = "study";

/// `json.dumps` for what studies have in them.
static DUMPS: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

/// The class `slipgap.Study`.
static STUDY: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// The JSON of an object.
pub fn json(py: Python<'_>, object: &Bound<'_, PyAny>) -> PyResult<String> {
    let dumps = DUMPS.get_or_try_init(py, || {
        let dumps = py.import("slipgap._json")?.getattr("dumps")?;
        PyResult::Ok(dumps.unbind())
    })?;
    let text = dumps.bind(py).call1((object,)).map_err(|error| {
        match error.is_instance_of::<PyValueError>(py) {
            true => usage(py, error.value(py).to_string()),
            false => error,
        }
    })?;
    text.extract()
}

/// The study that a caller gives, with the parameters that `set` gives.
pub fn source(
    py: Python<'_>,
    study: &Bound<'_, PyAny>,
    set: Option<&Bound<'_, PyAny>>,
) -> PyResult<Source> {
    let settings = settings(py, set)?;
    if study.is_instance(STUDY.import(py, "slipgap._study", "Study")?)? {
        let source = study.call_method0("_source")?;
        let (file, name, text): (String, String, String) = source.extract()?;
        return of_text(py, (&file, &name), &text, &settings);
    }
    if study.cast::<PyMapping>().is_ok() {
        let text = json(py, study)?;
        return of_text(py, (DICT, FOLDER), &text, &settings);
    }
    let Ok(file) = study.extract::<PathBuf>() else {
        let class = study.get_type();
        let message = format!("a study is a path or a dict, not {class}");
        return Err(PyTypeError::new_err(message));
    };
    let read = py.detach(|| match file.is_dir() {
        true => Err(slipgap::error::Error::Usage(format!(
            "{} is a folder; name one study",
            file.display()
        ))),
        false => Source::read(&file, &settings, MOST_CASES),
    });
    read.map_err(|error| raise(py, error))
}

/// The same, with the programs of others that it has started where that is allowed.
///
/// It is an error if the study has programs, and they are not allowed.
pub fn computed(
    py: Python<'_>,
    study: &Bound<'_, PyAny>,
    set: Option<&Bound<'_, PyAny>>,
    allow_programs: bool,
) -> PyResult<Source> {
    let source = source(py, study, set)?;
    let allowed = slipgap::batch::programs::allow(&source.file, &source.study, allow_programs);
    allowed.map_err(|error| raise(py, error))?;
    Ok(source)
}

/// A study that is part of the program.
pub fn shipped(
    py: Python<'_>,
    name: &str,
    text: &str,
    set: Option<&Bound<'_, PyAny>>,
) -> PyResult<Source> {
    let settings = settings(py, set)?;
    of_text(py, (&format!("{name}.json"), name), text, &settings)
}

/// The study of a dictionary in a text.
pub fn of_dict(py: Python<'_>, text: &str) -> PyResult<Source> {
    of_text(py, (DICT, FOLDER), text, &[])
}

/// The study in a text, with its file and the name of its results. Files in it are relative to the folder of its file.
fn of_text(
    py: Python<'_>,
    (file, name): (&str, &str),
    text: &str,
    settings: &[Setting],
) -> PyResult<Source> {
    let read = py.detach(|| {
        check_printable(Path::new(file))?;
        let name = results_name(&Path::new(file).with_file_name(format!("{name}.json")))?;
        let input = Input::new(file, text).with(settings);
        Source::of_input(PathBuf::from(file), name, input, MOST_CASES)
    });
    read.map_err(|error| raise(py, error))
}

/// The file of a study, its text, and the parameters that were set with their values.
pub type Origin = (String, String, Vec<(String, String)>);

/// What a study was made of.
pub fn origin(source: &Source) -> Origin {
    let settings = source
        .study
        .settings
        .iter()
        .filter_map(|setting| setting.text().split_once('='))
        .map(|(name, value)| (name.trim().to_owned(), value.to_owned()));
    let file = source.file.display().to_string();
    (file, source.text.clone(), settings.collect())
}

/// The parameters to set, from a dictionary of names and values.
fn settings(py: Python<'_>, set: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<Setting>> {
    let Some(set) = set else {
        return Ok(Vec::new());
    };
    let Ok(given) = set.cast::<PyMapping>() else {
        let message = "set must be a dict of names and values";
        return Err(PyTypeError::new_err(message));
    };
    let mut settings = Vec::new();
    for item in given.items()?.try_iter()? {
        let (name, value): (String, Bound<'_, PyAny>) = item?.extract()?;
        // A name or an expression is text of the command line as it is.
        let value = match value.cast::<PyString>() {
            Ok(text) => text.to_string(),
            Err(_) => json(py, &value)?,
        };
        let setting = Setting::new(&format!("{name}={value}"));
        settings.push(setting.map_err(|why| usage(py, format!("set {name:?}: {why}")))?);
    }
    Ok(settings)
}

/// The text of a study with these parameters, which is slower than [`crate::case::of_dict`] and reports all faults.
pub fn text_of_parameters(py: Python<'_>, given: &Bound<'_, PyDict>) -> PyResult<String> {
    let (study, parameters) = (PyDict::new(py), given.copy()?);
    if let Some(problem) = parameters.get_item("problem")? {
        study.set_item("problem", problem)?;
        parameters.del_item("problem")?;
    }
    study.set_item("parameters", parameters)?;
    json(py, &study)
}
