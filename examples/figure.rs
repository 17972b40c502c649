//! A figure: the curves of three cases and the exact one, as SVG and PNG.
//!
//! `cargo run --example figure FOLDER` writes both files to a folder.

use slipgap::figures::{DrawnCase, png, sheet, svg};
use slipgap::study::parse;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let study = parse(
        "figure.json",
        r#"{ "problem": "friction-oscillator",
             "parameters": { "law": "displacement-control", "alpha": [0.1, 1, 5], "dT": "pi/20", "duration": "8*pi" },
             "figures": [{ "name": "history", "kind": "history", "y": ["X", "S"] }] }"#,
    )?;
    let cases: Vec<_> = study.cases().collect();
    let mut solutions = Vec::new();
    for case in &cases {
        solutions.push(study.problem.solve(case, &study.metrics)?);
    }
    let drawn: Vec<DrawnCase> = cases
        .iter()
        .zip(&solutions)
        .map(|(case, solution)| DrawnCase {
            case,
            metrics: &solution.metrics,
            solution: Some(solution),
            snapshots: &[],
        })
        .collect();
    let sheet = sheet(&study, &study.figures[0], &drawn);
    let (vector, pixels) = (svg(&sheet, 192)?, png(&sheet, 192)?);

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
