//! Figures of quantities along the structure: the data of their sheets, then pixels.

use super::drawn;
use crate::{png, svg};
use slipgap_drawing::colour_map::{Ridge, ridge};
use slipgap_drawing::{style, text};
use slipgap_problem::problem;
use slipgap_study::{self, Study};

const FIGURES: &str = r#"[
    { "name": "p", "kind": "profile", "times": [0, 0.25], "note": "a *note*" },
    { "name": "w", "kind": "wave", "where": { "n": 4 } },
    { "name": "h", "kind": "history", "y": ["r", "rdot"], "panels": "n" }
]"#;

fn bars() -> Study {
    let parameters = r#"{ "k_I": 100, "n": [4, 20], "dt": 0.05, "duration": 1 }"#;
    let text = format!(
        r#"{{ "problem": "bar-impact", "parameters": {parameters}, "figures": {FIGURES} }}"#
    );
    slipgap_study::parse("bars", &text).unwrap()
}

#[test]
fn a_profile_shows_the_snapshots() {
    let (sheet, snapshots) = drawn(&bars(), 0);
    assert_eq!(sheet.panels.len(), 4);
    for (i, panel) in sheet.panels.iter().enumerate() {
        let [row, quantity] = [i / 2, i % 2];
        let named: Vec<_> = panel
            .series
            .iter()
            .filter(|s| !s.label.is_empty())
            .collect();
        let labels: Vec<_> = named.iter().map(|s| s.label.as_str()).collect();
        // The right bar's mesh is as the left one's and not said again; the exact profile is the same for both.
        assert_eq!(
            labels,
            ["exact", "*γ* = 2.5, *n* = 4", "*γ* = 0.5, *n* = 20"]
        );
        for (curve, case) in named[1..].iter().zip(&snapshots) {
            let lines = &case[row].profiles[quantity].computed;
            let [left, right] = lines.as_slice() else {
                panic!("two bars");
            };
            let (first, rest) = curve.points.split_at(left.len());
            assert_eq!(first, left);
            assert!(rest[0][0].is_nan(), "a gap between the bars");
            assert_eq!(&rest[1..], right);
            assert!(curve.marked.iter().all(|k| curve.points[*k][0].is_finite()));
        }
        // Half a bar length behind the front after a quarter of T_I, the stress is -F0/A.
        if (row, quantity) == (1, 1) {
            assert!(
                named[0]
                    .points
                    .iter()
                    .any(|p| (p[0] + 0.5).abs() < 1e-9 && p[1] == -1.0)
            );
        }
        let rules = panel.series.iter().filter(|s| s.label.is_empty());
        let ends: Vec<_> = rules.map(|s| s.points[0][0]).collect();
        assert_eq!(ends, [-1.0, 0.0, 1.0]);
    }
    assert_eq!(sheet.panels[2].caption, "(c)  *t*/*T*_I_ = 1/4");
    assert_eq!(sheet.panels[0].frame.width, sheet.panels[1].frame.width);
    assert_eq!(sheet.small_print.last().unwrap().text, "a *note*");
    assert!(sheet.description.ends_with("a note"));
    assert!(svg(&sheet, style::DPI).is_ok_and(|text| !text.contains("NaN")));
}

#[test]
fn a_wave_has_a_cell_for_every_element_and_step() {
    let (sheet, snapshots) = drawn(&bars(), 1);
    let snapshots = &snapshots[0];
    assert_eq!(snapshots.len(), 21);
    let maps: Vec<_> = sheet.panels.iter().filter_map(|p| p.map.as_ref()).collect();
    let [computed, exact] = maps.as_slice() else {
        panic!("computed and exact");
    };
    assert_eq!(computed.cells.len(), 21 * 8);
    for (cells, snapshot) in computed.cells.chunks(8).zip(snapshots) {
        for cell in cells {
            assert!(cell.y[0] <= snapshot.time && snapshot.time <= cell.y[1]);
            let mut points = snapshot.profiles[1].computed.iter().flatten();
            let point = points
                .find(|p| cell.x[0] < p[0] && p[0] < cell.x[1])
                .unwrap();
            assert_eq!(cell.value, point[1]);
            // An element is a quarter of a bar.
            assert!((cell.x[1] - cell.x[0] - 0.25).abs() < 1e-12);
        }
    }
    // Two bars of two pieces each while the fronts run out: at rest ahead of them, -F0/A behind.
    let row: Vec<_> = exact
        .cells
        .iter()
        .filter(|c| c.y[0] < 0.25 && c.y[1] > 0.25)
        .collect();
    let mut pieces: Vec<_> = row.iter().map(|c| (c.x, c.value)).collect();
    pieces.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    let values: Vec<f64> = pieces.iter().map(|p| p.1).collect();
    assert_eq!(values, [0.0, -1.0, -1.0, 0.0]);
    assert!((pieces[1].0[0] + 0.5).abs() < 1e-9);
    assert_eq!(computed.colours, exact.colours);
    assert!(computed.bar.is_none() && exact.bar.is_some());
}

#[test]
fn compression_is_darker_than_none() {
    let (sheet, _) = drawn(&bars(), 1);
    let bytes = png(&sheet, style::DPI).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let exact = &sheet.panels[1];
    let grey = |point: [f64; 2]| {
        let [x, y] = exact
            .place(point)
            .map(|length| (length * style::pixels(style::DPI)) as usize);
        let at = 3 * (y * info.width as usize + x);
        let [r, g, b] = [0, 1, 2].map(|k| f64::from(pixels[at + k]));
        0.2126 * r + 0.7152 * g + 0.0722 * b
    };
    assert!(grey([-0.2, 0.5]) + 60.0 < grey([-0.8, 0.1]));
    // The same on both bars, and sharp next to the front.
    assert_eq!(grey([-0.2, 0.5]), grey([0.2, 0.5]));
    assert_eq!(grey([-0.45, 0.25]), grey([-0.2, 0.5]));
    assert_eq!(grey([-0.55, 0.25]), grey([-0.8, 0.1]));
}

#[test]
fn panels_that_show_one_case_say_which() {
    let (sheet, _) = drawn(&bars(), 2);
    let letters: Vec<_> = sheet.panels.iter().map(|p| p.caption.as_str()).collect();
    assert_eq!(
        letters[..2],
        ["(a)  *n* = 4, *γ* = 2.5", "(b)  *n* = 20, *γ* = 0.5"]
    );
    let labels: Vec<_> = sheet.legend.iter().map(|e| e.label.as_str()).collect();
    assert_eq!(labels, ["exact", "computed"]);
}

#[test]
fn every_label_of_a_ridge_fits_a_map() {
    let room = 1.3 * style::SINGLE - 2.0 * style::EDGE - style::SAMPLE - style::SAMPLE_GAP;
    for name in ["friction-oscillator", "bar-impact"] {
        for parameter in problem::find(name).unwrap().parameters() {
            for ridge in [Ridge::Least, Ridge::Greatest, Ridge::NearestToOne] {
                let label = ridge::label(ridge, &parameter.symbol);
                assert!(text::width(&label, style::LABEL) < room, "{label}");
            }
        }
    }
}
