//! Colours, windows of time, insets, panels of metrics and limits of checks.

use super::{drawn, sheet_of, shown};
use crate::{FigureData, sheet, svg};
use slipgap_drawing::layout::inset;
use slipgap_drawing::layout::sheet::{Series, Sheet};
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_study::{self, Study};

/// Bars with these parameters and a figure.
fn bars(parameters: &str, more: &str, figure: &str) -> Study {
    let text = format!(
        r#"{{"problem": "bar-impact", "parameters": {{"n": 4, "dt": 0.02, "duration": 1.5, {parameters}}}{more},
          "figures": [{{"name": "f", {figure}}}]}}"#
    );
    slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
}

/// The curves of cases.
fn computed(sheet: &Sheet) -> Vec<&Series> {
    let drawn = sheet.panels[0].series.iter();
    drawn
        .filter(|series| series.label != "exact" && !series.label.is_empty())
        .collect()
}

const HISTORY: &str = r#""kind": "history", "y": "rdot""#;

#[test]
fn curves_are_unbroken_in_colour_and_have_markers_only_where_asked() {
    let look = |keys: &str, black: bool| -> Vec<(Stroke, Option<Marker>)> {
        let study = bars(r#""gamma": [0.5, 1, 2]"#, "", &format!("{HISTORY}{keys}"));
        let cases: Vec<_> = study.cases().collect();
        let solutions = cases
            .iter()
            .map(|case| study.problem.solve(case, &[]).unwrap());
        let mut shown = crate::ShownCases::new(study.problem.schema());
        for (case, solution) in cases.iter().zip(solutions) {
            shown.push(case, &[], Some(solution));
        }
        let sheet = super::with_data(&study, &study.figures[0], &shown.all(), |data| {
            sheet(&FigureData { black, ..*data })
        });
        // The exact curve stays black.
        assert_eq!(sheet.panels[0].series[0].stroke, Stroke::Solid);
        let series = computed(&sheet).into_iter();
        let looks = Vec::from_iter(series.map(|series| (series.stroke, series.marker)));
        let named = sheet.legend.iter().filter(|key| key.label.contains('='));
        let keys: Vec<_> = named.map(|key| (key.stroke, key.marker)).collect();
        assert_eq!(keys, looks);
        looks
    };
    let colours = [0, 1, 2].map(Stroke::Colour);
    let plain = colours.map(|stroke| (stroke, None)).to_vec();
    let black = [0, 1, 2].map(|i| (Stroke::of_case(i), Some(Marker::of_case(i))));
    let marked = [0, 1, 2].map(|i| (colours[i], Some(Marker::of_case(i))));
    assert_eq!(look("", false), plain);
    assert_eq!(look(r#", "colour": true"#, false), plain);
    assert_eq!(look(r#", "markers": true"#, false), marked);
    assert_eq!(look(r#", "colour": false"#, false), black);
    // Black for print is black everywhere.
    assert_eq!(look("", true), black);
    assert_eq!(look(r#", "colour": true"#, true), black);
}

#[test]
fn a_single_computed_curve_is_unbroken() {
    for keys in [HISTORY, r#""kind": "curve", "x": "r", "y": "force""#] {
        let study = bars(r#""gamma": 1"#, "", &format!(r#"{keys}, "colour": false"#));
        let sheet = drawn(&study, 0).0;
        let strokes: Vec<Stroke> = computed(&sheet).iter().map(|s| s.stroke).collect();
        assert_eq!(strokes, [Stroke::Solid], "{keys}");
        // With the exact one it has markers, too.
        assert!(computed(&sheet)[0].marker.is_some());
    }
    let structure = slipgap_study::parse(
        "s",
        r#"{"problem": "structure", "parameters": {"dt": 0.1, "duration": 3, "mass": 1}, "metrics": ["energy_error"],
          "structure": {"masses": {"m": "mass"}, "springs": [{"between": ["ground", "m"], "k": 1}], "rayleigh": {"mass": 0.1},
            "contacts": {"s": {"law": "coulomb", "between": ["ground", "m"], "limit": 0.1}},
            "ground": {"synthetic": {"seed": 1}}},
          "figures": [{"name": "f", "kind": "curve", "x": "s.r", "y": "s.S", "colour": false}]}"#,
    );
    let sheet = drawn(&structure.unwrap_or_else(|e| panic!("{e}")), 0).0;
    let series = computed(&sheet);
    assert_eq!(
        (series.len(), series[0].stroke, series[0].marker),
        (1, Stroke::Solid, None)
    );
}

#[test]
fn curves_and_waves_show_a_window_of_time() {
    let study = |keys: &str| bars(r#""gamma": 1"#, "", keys);
    let curve = r#""kind": "curve", "x": "r", "y": "force""#;
    let part = drawn(&study(&format!(r#"{curve}, "time_range": [0.4, 0.8]"#)), 0).0;
    let whole = drawn(&study(curve), 0).0;
    // Steps of 0.02: 20 to 40.
    let points = &computed(&whole)[0].points;
    assert_eq!(computed(&part)[0].points, points[20..=40]);
    let exact = |sheet: &Sheet| {
        sheet.panels[0]
            .series
            .iter()
            .find(|s| s.label == "exact")
            .unwrap()
            .points
            .len()
    };
    assert!(exact(&part) > 100 && exact(&part) < exact(&whole) / 2);
    let wave = drawn(
        &study(r#""kind": "wave", "x_range": [-0.5, 0.25], "y_range": [0.4, 0.8]"#),
        0,
    )
    .0;
    for panel in &wave.panels {
        assert_eq!((panel.x.range, panel.y.range), ([-0.5, 0.25], [0.4, 0.8]));
        let cells = &panel.map.as_ref().unwrap().cells;
        assert!(
            cells
                .iter()
                .all(|cell| cell.x[0] >= -0.5 && cell.x[1] <= 0.25)
        );
        // The cells cover the frame once.
        let area: f64 = cells
            .iter()
            .map(|c| (c.x[1] - c.x[0]) * (c.y[1] - c.y[0]))
            .sum();
        assert!((area - 0.75 * 0.4).abs() < 1e-9, "{area}");
    }
}

#[test]
fn an_inset_enlarges_a_window_where_no_curve_is() {
    let figure = r#""kind": "history", "y": ["force", "rdot"], "inset": [0.9, 1.2]"#;
    let sheet = drawn(&bars(r#""gamma": [1, 2]"#, "", figure), 0).0;
    assert_eq!(sheet.panels.len(), 2);
    for panel in &sheet.panels {
        let part = panel.inset.as_ref().unwrap();
        assert_eq!(part.x.range, [0.9, 1.2]);
        let points = |panel: &slipgap_drawing::layout::sheet::Panel| -> Vec<Vec<[f64; 2]>> {
            panel
                .series
                .iter()
                .map(|series| series.points.clone())
                .collect()
        };
        assert_eq!(points(panel), points(part));
        // Everything inside of the window is inside of its vertical axis, and outside of the inset in the panel.
        let area = inset::area(part);
        for [t, y] in points(panel).into_iter().flatten() {
            if (0.9..=1.2).contains(&t) {
                assert!((part.y.range[0]..=part.y.range[1]).contains(&y));
            }
            assert!(!area.contains(panel.place([t, y])));
        }
        let frame = &panel.frame;
        assert!(
            frame.contains([area.left, area.top]) && frame.contains([area.right(), area.bottom()])
        );
        for line in inset::joins(panel, part) {
            assert!(
                line.iter()
                    .all(|corner| frame.inflated(1e-9).contains(*corner))
            );
        }
        for key in &sheet.legend {
            let bounds = slipgap_drawing::layout::sheet::Rect {
                left: key.at[0],
                top: key.at[1] - 4.0,
                width: style::SAMPLE,
                height: 8.0,
            };
            assert!(!bounds.overlaps(&area));
        }
    }
    assert!(svg(&sheet, style::DPI).is_ok());
}

/// The sheet of a metric figure over gamma and the mesh, if peak_force is gamma n.
fn metric(keys: &str) -> Sheet {
    let text = format!(
        r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2, 4], "n": [4, 8], "gap": [0, 1], "dt": 0.01, "duration": 1}},
          "checks": [{{"metric": "peak_force", "where": {{"n": 4, "gamma": [1, 2]}}, "min": 3, "max": 9}},
                     {{"metric": "peak_force", "where": {{"n": 8}}, "max": 40}}, {{"metric": "max_overlap", "min": 0}}],
          "figures": [{{"name": "f", "kind": "metric", "x": "gamma", "y": "peak_force", {keys}}}]}}"#
    );
    let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    let figure = &study.figures[0];
    let cases: Vec<_> = study.cases().filter(|c| figure.filter.matches(c)).collect();
    let row = study
        .measures
        .iter()
        .position(|m| m.name == "peak_force")
        .unwrap();
    let metrics = cases.iter().map(|case| {
        let number = |name: &str| case.number(name).unwrap();
        let mut values = vec![None; study.measures.len()];
        values[row] = Some(number("gamma") * number("n"));
        values
    });
    let metrics: Vec<_> = metrics.collect();
    sheet_of(&study, figure, &shown(&study, &cases, &metrics).all())
}

#[test]
fn a_metric_has_a_panel_for_each_value_of_a_parameter() {
    let sheet = metric(r#""panels": "n""#);
    let captions: Vec<&str> = sheet.panels.iter().map(|p| p.caption.as_str()).collect();
    assert_eq!(captions, ["(a)  *n* = 4", "(b)  *n* = 8"]);
    for (panel, n) in sheet.panels.iter().zip([4.0, 8.0]) {
        // A curve for each gap, which the metric does not depend on.
        let labels: Vec<&str> = panel.series.iter().map(|s| s.label.as_str()).collect();
        assert_eq!(labels.len(), 2);
        assert_ne!(labels[0], labels[1]);
        for series in &panel.series {
            assert_eq!(
                series.points,
                [1.0, 2.0, 4.0].map(|gamma| [gamma, gamma * n])
            );
        }
        assert_eq!(panel.y.range, sheet.panels[0].y.range);
    }
}

#[test]
fn limits_of_checks_are_drawn_where_they_apply() {
    let sheet = metric(r#""panels": "n", "checks": true, "where": {"gap": 0}"#);
    let lines = |k: usize| -> Vec<Vec<[f64; 2]>> {
        let rules = sheet.panels[k].series.iter().filter(|s| s.label.is_empty());
        rules.map(|series| series.points.clone()).collect()
    };
    // For n = 4 a stem and two caps at both gammas; for n = 8 a stem and a cap at all three.
    let stems = |k: usize| -> Vec<Vec<[f64; 2]>> {
        lines(k)
            .into_iter()
            .filter(|line| line[0][0] == line[1][0])
            .collect()
    };
    assert_eq!([lines(0).len(), lines(1).len()], [6, 6]);
    assert_eq!(
        stems(0),
        [1.0, 2.0].map(|gamma| vec![[gamma, 3.0], [gamma, 9.0]])
    );
    for (stem, gamma) in stems(1).iter().zip([1.0, 2.0, 4.0]) {
        assert!(stem[0][0] == gamma && stem[0][1] < 40.0 && stem[1][1] == 40.0);
    }
    let [low, high] = sheet.panels[1].y.range;
    assert!(low <= 3.0 && high >= 40.0);
    assert!(
        sheet
            .legend
            .iter()
            .any(|key| key.label == "limits of the checks")
    );
    assert!(lines_of(&metric(r#""by": "n", "where": {"gap": 0}"#)).is_empty());
}

/// The lines without a label.
fn lines_of(sheet: &Sheet) -> Vec<&Series> {
    let lines = sheet.panels.iter().flat_map(|panel| &panel.series);
    lines.filter(|series| series.label.is_empty()).collect()
}

#[test]
fn keys_that_show_nothing_are_faults() {
    for (keys, says) in [
        (
            r#""kind": "metric", "x": "gamma", "y": "max_overlap", "checks": true"#,
            "figures[0].checks: the study has no check of a metric of this figure",
        ),
        (
            r#""kind": "history", "inset": [2, 3]"#,
            "figures[0].inset: shows nothing: the time is from 0 to 1.5 in the cases shown",
        ),
        (
            r#""kind": "curve", "x": "r", "y": "force", "time_range": [2, 3]"#,
            "figures[0].time_range: shows nothing: the time is from 0 to 1.5",
        ),
        (
            r#""kind": "wave", "y_range": [2, 3], "where": {"gamma": 1}"#,
            "figures[0].y_range: shows nothing: the time is from 0 to 1.5",
        ),
        (
            r#""kind": "history", "colour": "red""#,
            "figures[0].colour: must be true or false",
        ),
        (
            r#""kind": "map", "x": "gamma", "y": "dt", "z": "peak_force", "colour": true"#,
            "a map figure has no key \"colour\"",
        ),
    ] {
        let text = format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2], "n": 4, "dt": [0.02, 0.05], "duration": 1.5}},
              "figures": [{{"name": "f", {keys}}}]}}"#
        );
        let told = slipgap_study::parse("s", &text).unwrap_err().to_string();
        assert!(told.contains(says), "{keys}: {told}");
    }
}
