//! `slipgap.animate`: a page that shows cases in motion.

use crate::error::{raise, usage};
use crate::given;
use crate::worker;
use pyo3::prelude::*;
use slipgap::animate::{Shown, animate as page_of};
use slipgap::batch::files::atomic::write_file;
use std::path::PathBuf;

/// A page that shows one case of a study in motion, or two beside each other. A notebook shows it.
///
/// The bytes are those of the file that the program writes.
#[pyclass(frozen, module = "slipgap")]
pub struct Animation {
    /// The page; it needs no other file.
    #[pyo3(get)]
    html: String,
    name: String,
}

/// Height of the page in a notebook, in pixels.
const HEIGHT: u32 = 860;

/// The animation of cases of a study.
#[pyfunction]
#[pyo3(signature = (study, cases, exact, set, allow_programs))]
pub fn animate(
    py: Python<'_>,
    study: &Bound<'_, PyAny>,
    cases: Vec<i64>,
    exact: bool,
    set: Option<&Bound<'_, PyAny>>,
    allow_programs: bool,
) -> PyResult<Animation> {
    let source = given::computed(py, study, set, allow_programs)?;
    let mut numbers = Vec::new();
    for case in cases {
        let number = u64::try_from(case);
        numbers
            .push(number.map_err(|_| usage(py, format!("case: must be 0 or more, got {case}")))?);
    }
    let shown = Shown {
        cases: numbers,
        exact,
    };
    let name = source.name.clone();
    let html = worker::wait(
        py,
        1,
        move || page_of(&source.study, &source.name, &shown),
        || (),
        |_| Ok(()),
    )?;
    Ok(Animation { html, name })
}

#[pymethods]
impl Animation {
    #[new]
    fn new(name: String, html: String) -> Animation {
        Animation { html, name }
    }

    /// Name and page: an animation is pickled with them.
    fn __getnewargs__(&self) -> (&str, &str) {
        (&self.name, &self.html)
    }

    /// Writes the page to a file.
    fn save(&self, py: Python<'_>, file: PathBuf) -> PyResult<()> {
        let written = py.detach(|| write_file(&file, self.html.as_bytes()));
        written.map_err(|error| raise(py, error))
    }

    /// A frame with the page, which has its own styles.
    fn _repr_html_(&self) -> String {
        let page = self.html.replace('&', "&amp;").replace('"', "&quot;");
        format!(
            "<iframe srcdoc=\"{page}\" sandbox=\"allow-scripts\" style=\"width: 100%; height: {HEIGHT}px; border: 0\" title=\"Animation\"></iframe>"
        )
    }

    fn __repr__(&self) -> String {
        format!("<slipgap.Animation {}>", self.name)
    }
}
