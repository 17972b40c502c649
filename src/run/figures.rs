//! The figures of a study, drawn and written.

use super::{Observer, OutputOptions, Source};
use crate::batch::groups::sobol::DesignMetrics;
use crate::batch::output::Folder;
use crate::batch::output::fragility::FragilityTable;
use crate::batch::{GroupResults, ShownCases};
use crate::figures::{self, FigureData};
use crate::study_figures;
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
        let sheet = study_figures::with_data(study, figure, shown, designs, draw)?;
        let name = &figure.name;
        paths.push(folder.write(&format!("{name}.png"), &figures::png(&sheet, dpi)?)?);
        let svg = figures::svg(&sheet, dpi)?;
        paths.push(folder.write(&format!("{name}.svg"), svg.as_bytes())?);
        paths.push(folder.write(&format!("{name}.pdf"), &figures::pdf(&sheet, dpi)?)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    if let Some(table) = table {
        paths.extend(table.write(folder)?);
    }
    Ok(())
}
