//! The files of a calibration in the folder of the study.

use super::{Calibration, Fit, figure_data, tables};
use crate::batch::files::place::is_object;
use crate::batch::output::Folder;
use crate::figures::{pdf, png, svg};
use crate::run::Source;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_recommend::format::digits;
use slipgap_study::error::Error;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Names of the figures. No figure of a study may have them, because both are in one folder.
pub use slipgap_study::CALIBRATION_FIGURES as FIGURES;

/// Refuses an object store: the studies with the best values name their files relative to their folder.
///
/// # Errors
/// The path names objects.
pub fn check_folder(path: &Path) -> Result<(), Error> {
    let why = "calibrate writes studies that name files in folders; give a folder";
    match is_object(path) {
        true => Err(Error::Usage(format!("{}: {why}", path.display()))),
        false => Ok(()),
    }
}

/// Writes tables, figures and the studies with the best values into the folder at `path`; returns the paths of the files.
///
/// # Errors
/// A file that cannot be written.
pub fn write(
    found: &Calibration,
    source: &Source,
    path: &Path,
    dpi: u32,
) -> Result<Vec<PathBuf>, Error> {
    check_folder(path)?;
    let mut folder = Folder::open(path)?;
    let mut written = vec![
        folder.write("calibration.csv", &tables::parameters(found)?)?,
        folder.write("alternatives.csv", &tables::alternatives(found)?)?,
        folder.write("profiles.csv", &tables::profiles(found)?)?,
        folder.write("correlation.csv", &tables::correlation(found)?)?,
    ];
    if found.fits.iter().any(|fit| !fit.each.is_empty()) {
        written.push(folder.write("each-test.csv", &tables::each_test(found)?)?);
        written.push(folder.write("scatter.csv", &tables::scatter(found)?)?);
    }
    for (name, text) in studies(found, source, path)?.values() {
        written.push(folder.write(name, text.as_bytes())?);
    }
    let misfits = figure_data::misfits(found);
    let drawn = misfits
        .alternatives
        .iter()
        .any(|alternative| !alternative.panels.is_empty());
    let misfits = drawn.then(|| misfits.sheet());
    let measured = figure_data::measured(found).map(|figure| figure.sheet());
    for (name, sheet) in FIGURES.iter().zip([misfits, measured]) {
        if let Some(sheet) = sheet {
            written.extend(draw(&mut folder, name, &sheet, dpi)?);
        }
    }
    Ok(written)
}

fn draw(folder: &mut Folder, name: &str, sheet: &Sheet, dpi: u32) -> Result<[PathBuf; 3], Error> {
    Ok([
        folder.write(&format!("{name}.png"), &png(sheet, dpi)?)?,
        folder.write(&format!("{name}.svg"), svg(sheet, dpi)?.as_bytes())?,
        folder.write(&format!("{name}.pdf"), &pdf(sheet, dpi)?)?,
    ])
}

/// The studies of the alternatives with their best values by the positions of the fits, each with the name of its file in `folder`.
///
/// # Errors
/// As of reading the study.
pub fn studies(
    found: &Calibration,
    source: &Source,
    folder: &Path,
) -> Result<BTreeMap<usize, (String, String)>, Error> {
    let input = source.input();
    let mut files: BTreeMap<usize, (String, String)> = BTreeMap::new();
    let calibrate = found.study.calibrate.as_ref();
    let minimised = calibrate.map_or("", |calibrate| {
        &found.study.measures[calibrate.minimise].name
    });
    for (i, fit) in found.fits.iter().enumerate() {
        if !fit.misfit().is_finite() {
            continue;
        }
        let remark = format!(
            "values by slipgap calibrate of {}: {minimised} is {}",
            source.name,
            digits(fit.misfit())
        );
        let text =
            input.with_values(&source.study, &fit.alternative, &best(fit), folder, &remark)?;
        let mut name = match fit.alternative.file_name() {
            name if name.is_empty() => "best.json".to_owned(),
            name => format!("best-{name}.json"),
        };
        if files.values().any(|known| known.0 == name) {
            name = format!("best-{}.json", i + 1);
        }
        files.insert(i, (name, text));
    }
    Ok(files)
}

/// The rows of the searched parameters with their best values.
fn best(fit: &Fit) -> Vec<(usize, f64)> {
    let free = fit.free.iter().map(|free| free.parameter);
    free.zip(fit.values.iter().copied()).collect()
}
