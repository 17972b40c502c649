//! Fronts: their points against the columns of the cases, then the places of the legends.

use super::colour_at;
use crate::with_hover;
use slipgap_drawing::layout::sheet::{Rect, Sheet};
use slipgap_drawing::style::{self, Stroke};
use slipgap_drawing::text;
use slipgap_problem::problem::Case;
use slipgap_study::{self, Study};
use std::collections::HashMap;

/// Laws of friction with several widths, steps and releases, and one figure.
fn laws(figure: &str) -> Study {
    let text = format!(
        r#"{{"problem": "friction-oscillator", "blocks": [
          {{"parameters": {{"law": "displacement-control", "alpha": [0.01, 0.1, 1], "dT": ["pi/5", "pi/10", "pi/20"],
                           "x0": [8, 12], "duration": "x0*pi"}}}},
          {{"parameters": {{"law": "velocity-control", "beta": [0.01, 0.1, 1], "dT": ["pi/5", "pi/10", "pi/20"],
                           "x0": [8, 12], "duration": "x0*pi"}}}}],
          "figures": [{{"name": "f", "kind": "front", "x": "max_error", "y": "rms_error", {figure}}}]}}"#
    );
    slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
}

fn number(case: &Case, name: &str) -> f64 {
    case.number(name).unwrap()
}

/// Metrics made up: a cost that rises with the duration, an error that depends on the width and the release.
fn metrics(case: &Case) -> [Option<f64>; 2] {
    let (step, x0) = (number(case, "dT"), number(case, "x0"));
    let width = case.number("alpha").or(case.number("beta")).unwrap();
    let factor = if case.choice("law") == "velocity-control" {
        0.7
    } else {
        1.0
    };
    // At the largest step the law with beta is the worse one.
    let coarse = if factor < 1.0 && step > 0.5 { 5.0 } else { 1.0 };
    let error = factor * coarse * (step * step + 0.1 * width + 1.3e-4 / width) * (x0 - 7.0);
    let lacking = width == 1.0 && x0 == 12.0 && factor == 1.0;
    [Some(x0 / step), (!lacking).then_some(error)]
}

/// The sheet, and the cases that it shows.
fn drawn(study: &Study) -> (Sheet, Vec<Case>, String) {
    let cases: Vec<Case> = study.cases().collect();
    let table = study.problem.metrics();
    let row = |case: &Case| -> Vec<Option<f64>> {
        let [x, y] = metrics(case);
        let value = |name: &str| match name {
            "max_error" => x,
            "rms_error" => y,
            _ => None,
        };
        table.iter().map(|metric| value(&metric.name)).collect()
    };
    let metrics: Vec<_> = cases.iter().map(row).collect();
    let drawn = super::shown(study, &cases, &metrics);
    let shown = drawn.all();
    let figure = &study.figures[0];
    let (sheet, hover) = super::with_data(study, figure, &shown, |data| {
        let sheet = crate::sheet(data);
        let hover = with_hover(data, &sheet, "<svg></svg>");
        (sheet, hover)
    });
    (sheet, cases, hover)
}

/// The points that no other surpasses, by the definition.
fn best(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let surpasses = |a: &[f64; 2], b: &[f64; 2]| a != b && a[0] <= b[0] && a[1] <= b[1];
    let mut best: Vec<[f64; 2]> = points.to_vec();
    best.retain(|b| !points.iter().any(|a| surpasses(a, b)));
    best.sort_by(|a, b| a[0].total_cmp(&b[0]));
    best
}

#[test]
fn each_line_has_the_best_cases_of_its_value_and_the_band_those_of_all() {
    let (sheet, cases, _) = drawn(&laws(r#""by": ["law", "dT"]"#));
    let value = |case: &Case, of: usize| match of {
        0 => case.choice("law").to_owned(),
        _ => number(case, "dT").to_string(),
    };
    let point = |case: &Case| match metrics(case) {
        [Some(x), Some(y)] => Some([x, y]),
        _ => None,
    };
    let points: Vec<[f64; 2]> = cases.iter().filter_map(point).collect();
    assert_eq!(sheet.panels.len(), 2);
    for (of, panel) in sheet.panels.iter().enumerate() {
        let band = &panel.series[0];
        assert_eq!(
            (band.points.clone(), band.stroke),
            (best(&points), Stroke::LIGHT)
        );
        let mut values: Vec<String> = cases.iter().map(|case| value(case, of)).collect();
        values.dedup();
        values.sort();
        values.dedup();
        assert_eq!(panel.series.len(), 1 + values.len());
        let found: Vec<Vec<[f64; 2]>> =
            panel.series[1..].iter().map(|s| s.points.clone()).collect();
        for wanted in values {
            let of_design = cases.iter().filter(|case| value(case, of) == wanted);
            let chosen: Vec<[f64; 2]> = of_design.filter_map(point).collect();
            assert!(found.contains(&best(&chosen)), "{wanted}");
        }
    }
    let captions: Vec<&str> = sheet.panels.iter().map(|p| p.caption.as_str()).collect();
    assert_eq!(captions, ["(a)  law", "(b)  Δ*T*"]);
    let lines: Vec<&str> = sheet
        .small_print
        .iter()
        .map(|words| words.text.as_str())
        .collect();
    let small = lines.join(" ");
    // The band begins at the largest step, where alpha is better.
    assert!(
        small.contains("law: displacement control, velocity control; Δ*T* = π/5, π/10, π/20"),
        "{small}"
    );
    assert!(small.ends_with("3 of 36 cases without a value"), "{small}");
}

#[test]
fn means_are_over_cases_that_are_otherwise_the_same() {
    let (sheet, cases, hover) = drawn(&laws(r#""by": "law", "mean_over": "x0""#));
    let mut means: HashMap<String, Vec<[Option<f64>; 2]>> = HashMap::new();
    for case in &cases {
        let width = (case.number("alpha"), case.number("beta"));
        let key = format!("{width:?} {}", number(case, "dT"));
        means.entry(key).or_default().push(metrics(case));
    }
    let mut points = Vec::new();
    for mean in means.values() {
        let [[Some(a), Some(b)], [Some(c), Some(d)]] = mean[..] else {
            continue;
        };
        points.push([(a + c) / 2.0, ((b * b + d * d) / 2.0).sqrt()]);
    }
    assert_eq!((means.len(), points.len()), (18, 15));
    let band = &sheet.panels[0].series[0].points;
    let expected = best(&points);
    assert_eq!(band.len(), expected.len());
    for (a, b) in band.iter().zip(expected) {
        // The two sums are of the same two numbers.
        assert_eq!(*a, b);
    }
    let small: Vec<&str> = sheet
        .small_print
        .iter()
        .map(|words| words.text.as_str())
        .collect();
    assert!(
        small[0].starts_with("Root mean square of rms error and mean of "),
        "{small:?}"
    );
    assert!(small[0].ends_with("over *X*_0_"), "{small:?}");
    assert_eq!(small.last(), Some(&"6 of 36 cases without a value"));
    // The values that a reader wants of a point; not those that were averaged.
    assert!(
        hover.contains("velocity control: ") && hover.contains("; β = 0.1, ΔT = π/20"),
        "{hover}"
    );
    assert!(!hover.contains("X0 ="), "{hover}");
}

/// A study with a figure of 12 laws' lines, as names of the widths, in so many panels.
fn crowded(width: &str, by: &str) -> Sheet {
    let text = format!(
        r#"{{"problem": "friction-oscillator",
          "parameters": {{"law": "displacement-control", "alpha": {{"geomspace": [0.01, 1, 12]}}, "dT": ["pi/5", "pi/10", "pi/20"],
                          "x0": [8, 12], "duration": "x0*pi"}},
          "figures": [{{"name": "f", "kind": "front", "x": "max_error", "y": "rms_error", "by": {by} {width}, "title": "A title"}}]}}"#
    );
    let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    drawn(&study).0
}

#[test]
fn twelve_entries_are_readable_beside_or_over_their_panel() {
    for width in ["", ", \"width\": 70", ", \"width\": 90", ", \"width\": 190"] {
        for (by, panels) in [("\"alpha\"", 1), ("[\"alpha\", \"dT\"]", 2)] {
            let sheet = crowded(width, by);
            assert_eq!(sheet.panels.len(), panels);
            assert_eq!(sheet.legend.len(), if panels == 1 { 13 } else { 17 });
            let areas: Vec<Rect> = sheet
                .legend
                .iter()
                .map(|entry| Rect {
                    left: entry.at[0],
                    top: entry.at[1] - style::LABEL / 2.0,
                    width: style::SAMPLE
                        + style::SAMPLE_GAP
                        + text::width(&entry.label, style::LABEL),
                    height: style::LABEL,
                })
                .collect();
            let headings = sheet.heading.iter().map(|words| words.at[1]);
            let heading = headings.fold(0.0, f64::max);
            for (i, area) in areas.iter().enumerate() {
                assert!(
                    area.left >= 0.0 && area.right() <= sheet.width,
                    "{width}: {area:?}"
                );
                assert!(area.top > heading, "{width}: {area:?}");
                for other in &areas[..i] {
                    assert!(!area.overlaps(other), "{width}: {area:?} {other:?}");
                }
                for panel in &sheet.panels {
                    assert!(
                        !area.overlaps(&panel.frame),
                        "{width}: {area:?} {:?}",
                        panel.frame
                    );
                    assert!(panel.frame.width >= 100.0, "{width}: {:?}", panel.frame);
                }
            }
            // No two lines look the same.
            let styles: Vec<_> = sheet.legend[..13]
                .iter()
                .map(|e| (e.marker, e.stroke.colour()))
                .collect();
            for (i, style) in styles.iter().enumerate() {
                assert!(!styles[..i].contains(style), "{style:?}");
            }
        }
    }
}

#[test]
fn lines_are_black_on_the_light_band() {
    let (sheet, ..) = drawn(&laws(r#""by": "law""#));
    let panel = &sheet.panels[0];
    let mut bare = sheet.clone();
    bare.panels[0].series.truncate(1);
    let points = &panel.series[0].points;
    assert!(points.len() > 1);
    let [a, b] = [0, 1].map(|i| panel.place(points[i]));
    let between = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    assert_eq!(colour_at(&bare, between), Stroke::LIGHT.colour());
    // As light as grey that black shows on: the usual weights of red, green and blue.
    let [r, g, b] = Stroke::LIGHT.colour().map(f64::from);
    let grey = 0.299 * r + 0.587 * g + 0.114 * b;
    assert!((150.0..225.0).contains(&grey), "{grey}");
}
