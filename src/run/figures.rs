//! The figures of a study, drawn and written.

use crate::batch::ShownCases;
use crate::batch::output::Folder;
use crate::figures;
use crate::study_figures;
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::path::PathBuf;

/// Draws every figure of a study with `dpi` pixels per inch, and adds the paths of the files to `paths`.
pub fn write(
    study: &Study,
    shown: &mut ShownCases,
    dpi: u32,
    folder: &mut Folder,
    paths: &mut Vec<PathBuf>,
) -> Result<(), Error> {
    study_figures::add_histories(study, shown);
    for figure in &study.figures {
        let sheet = study_figures::with_cases(study, figure, shown, |cases| {
            figures::sheet(study, figure, cases)
        });
        let name = &figure.name;
        paths.push(folder.write(&format!("{name}.png"), &figures::png(&sheet, dpi)?)?);
        let svg = figures::svg(&sheet, dpi)?;
        paths.push(folder.write(&format!("{name}.svg"), svg.as_bytes())?);
        paths.push(folder.write(&format!("{name}.pdf"), &figures::pdf(&sheet, dpi)?)?);
    }
    Ok(())
}
