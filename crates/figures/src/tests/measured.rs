//! What was measured, in figures: the points of a file by a formula, in its own times and units.

use super::drawn;
use slipgap_drawing::layout::coincide::MEANING;
use slipgap_drawing::layout::sheet::{Series, Sheet};
use slipgap_drawing::style::Stroke;
use slipgap_study::{Study, read};
use std::path::Path;

/// The time of the file that is t = 0 of the motion.
const DELAY: f64 = 0.5;

/// Displacement in mm and force in N at a time of a file, in which all is `scale` times as large.
fn at(time: f64, scale: f64) -> [f64; 2] {
    [scale * (40.0 - 25.0 * time), scale * (300.0 * time * time)]
}

/// Times of a file: uneven, from before the motion to after its end, 1.5 s.
fn times() -> Vec<f64> {
    (0..60)
        .map(|i| f64::from(i) * (0.03 + 0.0005 * f64::from(i)))
        .collect()
}

/// A file, whose numbers are written with all digits.
fn write(folder: &Path, name: &str, scale: f64) {
    let row = |t: f64| {
        let [u, s] = at(t, scale);
        format!("{t:e};{u:e};{s:e}\n")
    };
    let rows: String = times().into_iter().map(row).collect();
    std::fs::write(
        folder.join(name),
        format!("# rig\nt;disp_mm;force_N\n{rows}"),
    )
    .unwrap();
}

fn study(folder: &Path, file: &str, figures: &str) -> Study {
    write(folder, "a.csv", 1.0);
    write(folder, "b.csv", 2.0);
    let text = format!(
        r#"{{ "problem": "structure",
             "parameters": {{ "k": [20, 30], "dt": 0.01, "duration": 1.5{file} }},
             "measured": {{ "file": "{}", "time": "t", "delay": {DELAY},
               "columns": {{ "m": {{ "column": "disp_mm", "unit": "mm" }}, "pad.r": {{ "column": "disp_mm", "unit": "mm" }},
                             "pad.S": {{ "column": "force_N", "unit": "N" }} }} }},
             "structure": {{ "units": "t, kN, m, s", "masses": {{ "m": 1, "other": 1 }},
               "springs": [{{ "between": ["ground", "m"], "k": "k" }}, {{ "between": ["ground", "other"], "k": 5 }}],
               "contacts": {{ "pad": {{ "law": "displacement-control", "between": ["ground", "m"], "limit": 0.2, "rE": 0.01 }} }},
               "start": {{ "m": {{ "u": 0.1 }}, "other": {{ "u": 0.1 }} }} }},
             "metrics": ["rms_error(m, measured)"], "figures": [{figures}] }}"#,
        if file.is_empty() { "a.csv" } else { "test" }
    );
    let path = folder.join("s.json");
    std::fs::write(&path, text).unwrap();
    read(&path).unwrap_or_else(|why| panic!("{why}"))
}

/// The measured curves of a panel.
fn measured(sheet: &Sheet, panel: usize) -> Vec<&Series> {
    let drawn = sheet.panels[panel].series.iter();
    drawn.filter(|series| series.label == "measured").collect()
}

fn assert_near(a: [f64; 2], b: [f64; 2]) {
    // A product with 1e-3 and a difference of times of about 1: some roundings.
    let far = a.iter().zip(&b).any(|(a, b)| (a - b).abs() > 1e-14);
    assert!(!far, "{a:?}, not {b:?}");
}

/// Times within the motion, as those of the file.
fn within([from, to]: [f64; 2]) -> Vec<f64> {
    let sampled = times().into_iter();
    sampled
        .filter(|t| (from..=to).contains(&(t - DELAY)))
        .collect()
}

#[test]
fn a_history_has_the_measured_points_at_their_own_times() {
    let folder = tempfile::tempdir().unwrap();
    let figure = r#"{ "name": "h", "kind": "history", "y": ["m", "other", "pad.S"] },
        { "name": "w", "kind": "history", "y": ["m"], "where": { "k": 20 }, "x_range": [0.5, 1] }"#;
    let study = study(folder.path(), "", figure);
    let (sheet, _) = drawn(&study, 0);
    // One file for both cases: one curve. It was not measured at the other mass.
    let counts = [0, 1, 2].map(|panel| measured(&sheet, panel).len());
    assert_eq!(counts, [1, 0, 1]);
    for (panel, of) in [(0, 0), (2, 1)] {
        let line = measured(&sheet, panel)[0];
        assert_eq!((line.stroke, line.marker), (Stroke::Grey, None));
        let times = within([0.0, 1.5]);
        assert_eq!(line.points.len(), times.len());
        for (point, t) in line.points.iter().zip(times) {
            assert_near(*point, [t - DELAY, 1e-3 * at(t, 1.0)[of]]);
        }
    }
    assert_eq!(
        sheet.description,
        format!("measured; k = 20 kN/m; k = 30 kN/m; {MEANING}")
    );
    // A part of the time has the points beside its ends, so that the line does not end within the frame.
    let (sheet, _) = drawn(&study, 1);
    let line = measured(&sheet, 0)[0];
    assert_eq!(line.points.len(), within([0.5, 1.0]).len() + 2);
    assert!(line.points[0][0] < 0.5 && line.points[line.points.len() - 1][0] > 1.0);
    // A single computed curve needs no marker beside a grey one.
    assert!(
        sheet.panels[0]
            .series
            .iter()
            .all(|series| series.marker.is_none())
    );
}

#[test]
fn each_test_has_its_own_curve() {
    let folder = tempfile::tempdir().unwrap();
    let figure = r#"{ "name": "h", "kind": "history", "y": ["m"], "where": { "k": 20 } },
        { "name": "p", "kind": "history", "y": ["m"], "where": { "k": 20 }, "panels": "test" }"#;
    let study = study(folder.path(), r#", "test": ["a.csv", "b.csv"]"#, figure);
    let (sheet, _) = drawn(&study, 0);
    assert_eq!(measured(&sheet, 0).len(), 2);
    let (sheet, _) = drawn(&study, 1);
    for (panel, scale) in [(0, 1.0), (1, 2.0)] {
        let [line] = measured(&sheet, panel)[..] else {
            panic!("one curve in a panel");
        };
        let first = within([0.0, 1.5])[0];
        assert_near(line.points[0], [first - DELAY, 1e-3 * at(first, scale)[0]]);
    }
    assert_eq!(
        sheet
            .legend
            .iter()
            .filter(|entry| entry.label == "measured")
            .count(),
        1
    );
}

#[test]
fn loops_and_sums_have_what_was_measured_of_all_their_quantities() {
    let folder = tempfile::tempdir().unwrap();
    let figures = r#"{ "name": "c", "kind": "curve", "x": "pad.r", "y": ["pad.S", "m.v"] },
        { "name": "s", "kind": "history", "y": ["m", "pad.r"], "stacked": true, "where": { "k": 20 } },
        { "name": "n", "kind": "history", "y": ["m", "other"], "stacked": true, "where": { "k": 20 } }"#;
    let study = study(folder.path(), "", figures);
    let (sheet, _) = drawn(&study, 0);
    let [line] = measured(&sheet, 0)[..] else {
        panic!("one loop");
    };
    let times = within([0.0, 1.5]);
    assert_eq!(line.points.len(), times.len());
    for (point, t) in line.points.iter().zip(&times) {
        assert_near(*point, at(*t, 1.0).map(|x| 1e-3 * x));
    }
    assert!(measured(&sheet, 1).is_empty());
    let (sheet, _) = drawn(&study, 1);
    let line = measured(&sheet, 0)[0];
    for (point, t) in line.points.iter().zip(&times) {
        assert_near(*point, [t - DELAY, 2e-3 * at(*t, 1.0)[0]]);
    }
    // Two areas, none of what was measured.
    assert_eq!(sheet.panels[0].bands.len(), 2);
    let (sheet, _) = drawn(&study, 2);
    assert!(measured(&sheet, 0).is_empty());
}
