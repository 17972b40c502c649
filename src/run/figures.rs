//! The figures of a study, drawn and written.

use super::{Observer, OutputOptions, Source};
use crate::batch::groups::sobol::DesignMetrics;
use crate::batch::output::Folder;
use crate::batch::output::fragility::FragilityTable;
use crate::batch::{GroupResults, ShownCases};
use crate::figures::{self, FigureData};
use crate::study_figures;
use rayon::prelude::*;
use slipgap_figures::sheet::Sheet;
use slipgap_study::error::Error;
use slipgap_study::kinds::FigureKind;
use std::path::PathBuf;

/// Draws every figure of a study, writes the table of fragility figures, and adds the paths of the files to `paths`.
pub fn write(
    source: &Source,
    shown: &mut ShownCases,
    designs: &DesignMetrics,
    output: &OutputOptions,
    folder: &mut Folder,
    paths: &mut Vec<PathBuf>,
    observer: &mut dyn Observer,
) -> Result<(), Error> {
    let (study, dpi) = (&source.study, output.dpi);
    let mut table = FragilityTable::new(study)?;
    let bar = observer.begin_figures(source, study.figures.len());
    study_figures::add_histories(study, shown);
    let mut sheets = Vec::new();
    for figure in &study.figures {
        let draw = |data: &FigureData| {
            if let (Some(table), FigureKind::Fragility(kind), GroupResults::Fragility(curves)) =
                (&mut table, &figure.kind, data.groups)
            {
                table.add(&figure.name, kind, curves)?;
            }
            let data = FigureData {
                black: output.black,
                dpi,
                ..*data
            };
            Ok::<_, Error>(figures::sheet(&data))
        };
        sheets.push(study_figures::with_data(
            study, figure, shown, designs, draw,
        )?);
    }
    let drawn = sheets.par_iter().map(|sheet| {
        let files = files(sheet, dpi);
        bar.inc(1);
        files
    });
    for (figure, files) in study.figures.iter().zip(drawn.collect::<Vec<_>>()) {
        for (ending, bytes) in files? {
            paths.push(folder.write(&format!("{}.{ending}", figure.name), &bytes)?);
        }
    }
    bar.finish_and_clear();
    if let Some(table) = table {
        paths.extend(table.write(folder)?);
    }
    Ok(())
}

/// The files of a sheet with the endings of their names, each drawn by itself.
fn files(sheet: &Sheet, dpi: u32) -> Result<[(&'static str, Vec<u8>); 3], Error> {
    let (png, (svg, pdf)) = rayon::join(
        || figures::png(sheet, dpi),
        || rayon::join(|| figures::svg(sheet, dpi), || figures::pdf(sheet, dpi)),
    );
    Ok([("png", png?), ("svg", svg?.into_bytes()), ("pdf", pdf?)])
}
