//! The figures of a study, drawn when they are asked for, or read from the folder of the run.

use crate::error::{raise, usage};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use slipgap::batch::ShownCases;
use slipgap::batch::files::atomic::write_file;
use slipgap::batch::groups::sobol::DesignMetrics;
use slipgap::error::Error;
use slipgap::figures::{self, style};
use slipgap::run::Source;
use slipgap::study_figures;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The cases that the figures of a study show.
pub struct Shown {
    pub source: Arc<Source>,
    pub cases: ShownCases,
    /// The metrics of its saltelli designs.
    pub designs: DesignMetrics,
}

/// Where the drawing comes from.
enum Origin {
    /// The figure of this index in the study.
    Cases(Arc<Shown>, usize),
    /// The files of a run.
    Folder(PathBuf),
    /// The drawings in the order of the formats, as of a figure that was pickled.
    Drawn([Vec<u8>; 3]),
}

/// A figure of a study. A notebook shows it.
///
/// The figure of a run in memory is drawn when it is asked for; that of a run with `out` is read from its folder.
#[pyclass(frozen, module = "slipgap")]
pub struct Figure {
    /// Its name in the study.
    #[pyo3(get)]
    name: String,
    origin: Origin,
}

/// The name and the drawings of a figure.
type Pickled<'py> = (String, String, Bound<'py, PyBytes>, Bound<'py, PyBytes>);

/// The formats of figures.
#[derive(Clone, Copy)]
enum Format {
    Svg,
    Png,
    Pdf,
}

impl Format {
    const ALL: [(&'static str, Format); 3] = [
        ("svg", Format::Svg),
        ("png", Format::Png),
        ("pdf", Format::Pdf),
    ];
}

impl Figure {
    /// The figures of a study, drawn from these cases or read from the folder of the run.
    pub fn all(shown: &Arc<Shown>, folder: Option<&Path>) -> Vec<Figure> {
        let figures = shown.source.study.figures.iter().enumerate();
        let figure = |(index, figure): (usize, &slipgap::study::Figure)| Figure {
            name: figure.name.clone(),
            origin: match folder {
                Some(folder) => Origin::Folder(folder.to_owned()),
                None => Origin::Cases(shown.clone(), index),
            },
        };
        figures.map(figure).collect()
    }

    fn bytes(&self, py: Python<'_>, format: Format) -> PyResult<Vec<u8>> {
        let bytes = py.detach(|| match &self.origin {
            Origin::Cases(shown, index) => draw(shown, *index, format),
            Origin::Folder(folder) => {
                let known = Format::ALL
                    .iter()
                    .find(|known| known.1 as u8 == format as u8);
                let ending = known.map_or("svg", |known| known.0);
                let file = folder.join(format!("{}.{ending}", self.name));
                fs::read(&file).map_err(Error::io("cannot read", file))
            }
            Origin::Drawn(drawings) => Ok(drawings[format as usize].clone()),
        });
        bytes.map_err(|error| raise(py, error))
    }
}

/// Draws a figure of the study.
fn draw(shown: &Shown, index: usize, format: Format) -> Result<Vec<u8>, Error> {
    let study = &shown.source.study;
    let figure = &study.figures[index];
    let (cases, designs) = (&shown.cases, &shown.designs);
    let sheet = study_figures::with_data(study, figure, cases, designs, figures::sheet);
    Ok(match format {
        Format::Svg => figures::svg(&sheet, style::DPI)?.into_bytes(),
        Format::Png => figures::png(&sheet, style::DPI)?,
        Format::Pdf => figures::pdf(&sheet, style::DPI)?,
    })
}

#[pymethods]
impl Figure {
    #[new]
    fn new(name: String, svg: String, png: Vec<u8>, pdf: Vec<u8>) -> Figure {
        let origin = Origin::Drawn([svg.into_bytes(), png, pdf]);
        Figure { name, origin }
    }

    /// The drawings: a figure is pickled with them.
    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<Pickled<'py>> {
        let bytes = |format| Ok::<_, PyErr>(PyBytes::new(py, &self.bytes(py, format)?));
        let (png, pdf) = (bytes(Format::Png)?, bytes(Format::Pdf)?);
        Ok((self.name.clone(), self.svg(py)?, png, pdf))
    }

    /// The figure as SVG.
    #[getter]
    fn svg(&self, py: Python<'_>) -> PyResult<String> {
        let bytes = self.bytes(py, Format::Svg)?;
        String::from_utf8(bytes).map_err(|e| raise(py, Error::Internal(e.to_string())))
    }

    /// The figure as PNG.
    #[getter]
    fn png(&self, py: Python<'_>) -> PyResult<Vec<u8>> {
        self.bytes(py, Format::Png)
    }

    /// The figure as PDF.
    #[getter]
    fn pdf(&self, py: Python<'_>) -> PyResult<Vec<u8>> {
        self.bytes(py, Format::Pdf)
    }

    /// Writes the figure to a file; its ending says the format.
    fn save(&self, py: Python<'_>, file: PathBuf) -> PyResult<()> {
        let ending = file.extension().and_then(|ending| ending.to_str());
        let format = Format::ALL.iter().find(|known| Some(known.0) == ending);
        let Some((_, format)) = format else {
            let message = format!("{}: must end in .svg, .png or .pdf", file.display());
            return Err(usage(py, message));
        };
        let bytes = self.bytes(py, *format)?;
        let written = py.detach(|| write_file(&file, &bytes));
        written.map_err(|error| raise(py, error))
    }

    fn _repr_svg_(&self, py: Python<'_>) -> PyResult<String> {
        self.svg(py)
    }

    fn __repr__(&self) -> String {
        format!("<slipgap.Figure {}>", self.name)
    }
}
