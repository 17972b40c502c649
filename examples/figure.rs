//! A figure: the curves of three cases and the exact one, as SVG and PNG.
//!
//! `cargo run --example figure FOLDER` writes both files to a folder.

use slipgap::batch::{GroupResults, ShownCases};
use slipgap::figures::{FigureData, png, sheet, svg};
use slipgap::study::parse;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let study = parse(
        "figure.json",
        r#"{ "problem": "friction-oscillator",
             "parameters": { "law": "displacement-control", "alpha": [0.1, 1, 5], "dT": "pi/20", "duration": "8*pi" },
             "figures": [{ "name": "history", "kind": "history", "y": ["X", "S"] }] }"#,
    )?;
    let mut shown = ShownCases::new(study.problem.schema());
    for case in study.cases() {
        let solution = study.problem.solve(&case, &study.metrics)?;
        shown.push(&case, &solution.metrics.clone(), Some(solution));
    }
    let dots_per_inch = 192;
    let sheet = sheet(&FigureData {
        study: &study,
        figure: &study.figures[0],
        cases: &shown.all(),
        groups: &GroupResults::None,
        black: false,
        dpi: dots_per_inch,
    });
    let (vector, pixels) = (svg(&sheet, dots_per_inch)?, png(&sheet, dots_per_inch)?);

    // One panel for each quantity.
    assert_eq!(sheet.panels.len(), 2);
    assert!(vector.starts_with("<svg") && pixels.starts_with(b"\x89PNG"));
    println!(
        "SVG of {} bytes, PNG of {} bytes",
        vector.len(),
        pixels.len()
    );
    if let Some(folder) = std::env::args().nth(1).map(PathBuf::from) {
        std::fs::write(folder.join("history.svg"), vector)?;
        std::fs::write(folder.join("history.png"), pixels)?;
    }
    Ok(())
}
