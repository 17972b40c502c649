//! Curves, spectra and schemes of structures.

use super::{drawn, fig5};
use crate::{pdf, png, svg};
use slipgap_drawing::layout::sheet::{Anchor, Rect, Shape, Sheet};
use slipgap_drawing::style::{self, Stroke};
use slipgap_drawing::text;
use slipgap_study::kinds::Curve;
use slipgap_study::{self, FigureKind, Study};
use std::f64::consts::PI;

fn structure(parts: &str, figure: &str) -> Study {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1, "s": [1, 2], "n": [4, 5]}}, "metrics": ["energy_error"],
          "structure": {{"units": "t, kN, m, s", "rayleigh": {{"mass": "0*s*n"}}, {parts}}}, "figures": [{figure}]}}"#
    );
    slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
}

/// The sheet of the first figure, without motions.
fn unsolved(study: &Study) -> Sheet {
    let cases: Vec<_> = study.cases().collect();
    let none = vec![Vec::new(); cases.len()];
    super::sheet_of(
        study,
        &study.figures[0],
        &super::shown(study, &cases, &none).all(),
    )
}

#[test]
fn a_curve_shows_what_was_computed_over_the_exact_loop() {
    let run = fig5();
    let curve = FigureKind::Curve(Curve {
        x: 0,
        y: vec![2, 3],
        by: None,
        panels: None,
        in_units: false,
        times: None,
        section: false,
    });
    let sheet = run.sheet(curve);
    let [force, error] = sheet.panels.as_slice() else {
        panic!("{} panels", sheet.panels.len());
    };
    let curves = |panel: usize| -> Vec<_> {
        let drawn = sheet.panels[panel].series.iter();
        drawn.filter(|series| series.marker.is_some()).collect()
    };
    for (i, solution) in run.solutions.iter().enumerate() {
        let computed = &solution.computed;
        for k in 0..computed.time.len() {
            let (x, s) = (computed.channel(0)[k], computed.channel(2)[k]);
            assert_eq!(curves(0)[i].points[k], [x, s]);
            let exact = solution.exact.channel(0)[k];
            assert_eq!(curves(1)[i].points[k], [x, x - exact]);
        }
        assert!((6..=9).contains(&curves(0)[i].marked.len()));
    }
    // The exact force is that of Coulomb's law, except where the mass starts and rests, and is drawn once.
    let exact: Vec<_> = force.series.iter().filter(|s| s.label == "exact").collect();
    assert_eq!(exact.len(), 1);
    let sliding = exact[0].points.iter().filter(|p| p[1].abs() == 1.0);
    assert!(sliding.count() > 500);
    let reach = exact[0].points.iter().fold(0.0, |a: f64, p| a.max(p[0]));
    assert_eq!(reach, 12.0);
    assert!(error.series.iter().all(|s| s.label != "exact"));
    assert_eq!(
        (force.x.title.as_str(), error.x.title.as_str()),
        ("", "*X* = *x*/Δ")
    );
    assert_eq!(force.y.title, "*S*/*νN*");
    assert_eq!(sheet.description, "exact; α = 0.1; α = 1; α = 5");
    assert!(png(&sheet, style::DPI).is_ok());
}

#[test]
fn curves_have_panels_limits_and_units() {
    let parameters = r#""gamma": [0.5, 1], "n": 4, "dt": 0.02, "duration": 1, "L": 10, "E": 1000, "A": 2, "rho": 1, "V0": 1"#;
    let text = format!(
        r#"{{"problem": "bar-impact", "units": {{"length": "m", "force": "kN", "time": "s"}}, "parameters": {{{parameters}}},
          "figures": [{{"name": "f", "kind": "curve", "x": "r", "y": "force", "panels": "gamma", "in_units": true, "x_range": [-0.1, 0.1]}}]}}"#
    );
    let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    let sheet = drawn(&study, 0).0;
    assert_eq!(sheet.panels.len(), 2);
    for (panel, case) in sheet.panels.iter().zip(study.cases()) {
        assert_eq!(
            (panel.x.range, panel.y.title.as_str()),
            ([-0.1, 0.1], "*F* (kN)")
        );
        // In units S = -k_I r where the bars touch; the scaled force and displacement agree to round-off.
        let k = case.number("k_I").unwrap();
        let curve = panel.series.iter().find(|s| s.label == "computed").unwrap();
        let pressed: Vec<_> = curve.points.iter().filter(|p| p[1] != 0.0).collect();
        assert!(pressed.len() > 10);
        for point in pressed {
            assert!(
                (point[1].abs() - k * point[0].abs()).abs() <= 1e-9 * k,
                "{point:?}"
            );
        }
    }
}

#[test]
fn the_spectra_of_a_set_are_those_of_its_motions_over_the_target() {
    let set = r#"{"rule": "EN 1998-1", "period": 1, "least_at_zero": 1e-9, "spectrum": {"T": [1], "Sa": [2]}}"#;
    let ground = format!(
        r#""masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 1}}],
        "ground": {{"synthetic": {{"seed": "s"}}, "scale_to": {{"pga": 1, "set": {set}}}}}"#
    );
    let figure = r#"{"name": "f", "kind": "set", "periods": [0.2, 2]}"#;
    let study = structure(&ground, figure);
    let sheet = unsolved(&study);
    // n does not change the set.
    let [panel] = sheet.panels.as_slice() else {
        panic!("{} panels", sheet.panels.len());
    };
    let labels: Vec<&str> = panel
        .series
        .iter()
        .map(|line| line.label.as_str())
        .collect();
    let expected = [
        "motions",
        "motions",
        "target",
        "0.9 × target",
        "mean",
        "",
        "",
    ];
    assert_eq!(labels, expected);
    let heights = |i: usize| panel.series[i].points.iter().map(|point| point[1]);
    for ((one, other), mean) in heights(0).zip(heights(1)).zip(heights(4)) {
        assert!((0.5 * (one + other) / mean - 1.0).abs() < 1e-15);
    }
    assert!(heights(2).all(|y| y == 2.0) && heights(3).all(|y| y == 1.8));
    // The rule holds exactly at one of 101 periods, and nearly at the 241 of the figure between the same ends.
    let least = heights(4).fold(f64::INFINITY, f64::min);
    assert!((1.75..1.83).contains(&least), "{least}");
    let range = [5, 6].map(|i| panel.series[i].points[0][0]);
    assert_eq!(range, [0.2, 2.0]);
    assert!(png(&sheet, style::DPI).is_ok());
}

#[test]
fn the_spectrum_of_a_suddenly_constant_acceleration_is_known() {
    let ground = r#""masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}],
        "ground": {"table": {"t": [0, 50], "f": [3, 3]}, "scale": "s"}"#;
    let figure = r#"{"name": "f", "kind": "spectrum", "y": ["pseudo-acceleration", "displacement"], "damping": [0, 0.2],
        "periods": [0.1, 10]}"#;
    let sheet = unsolved(&structure(ground, figure));
    let [above, below] = sheet.panels.as_slice() else {
        panic!("{} panels", sheet.panels.len());
    };
    // n does not change the ground: two motions with two ratios each.
    let labels: Vec<&str> = above.series.iter().map(|s| s.label.as_str()).collect();
    let expected = [
        "*s* = 1, *ζ* = 0",
        "*s* = 1, *ζ* = 0.2",
        "*s* = 2, *ζ* = 0",
        "*s* = 2, *ζ* = 0.2",
    ];
    assert_eq!(labels, expected);
    for (series, lower) in above.series.iter().zip(&below.series) {
        let scale = if series.label.contains("= 2,") {
            2.0
        } else {
            1.0
        };
        let ratio: f64 = if series.label.ends_with('2') {
            0.2
        } else {
            0.0
        };
        // u(t) overshoots a/omega^2 by exp(-pi ratio/sqrt(1 - ratio^2)).
        let overshoot = (-PI * ratio / (1.0 - ratio * ratio).sqrt()).exp();
        let expected = 3.0 * scale * (1.0 + overshoot);
        for (point, lower) in series.points.iter().zip(&lower.points) {
            // The Taylor pieces are exact to round-off.
            assert!(
                (point[1] / expected - 1.0).abs() < 1e-11,
                "{point:?} {expected}"
            );
            let omega = 2.0 * PI / point[0];
            assert!((lower[1] * omega * omega / point[1] - 1.0).abs() < 1e-12);
        }
        let [first, last] = [series.points[0], series.points[series.points.len() - 1]];
        assert_eq!([first[0], last[0]], [0.1, 10.0]);
    }
    assert_eq!(above.y.title, "Pseudo-acceleration *S*_a_, m/s^2^");
    assert_eq!(
        (below.y.title.as_str(), below.x.title.as_str()),
        ("Displacement *S*_d_, m", "Period *T*, s")
    );
    assert_eq!(above.y.range[0], 0.0);
    assert!(png(&sheet, style::DPI).is_ok());
}

#[test]
fn the_spectrum_of_a_floor_is_that_of_its_acceleration() {
    // A free mass of 1.5 under a constant force.
    let parts = r#""masses": {"m": 1.5}, "loads": [{"at": "m", "table": {"t": [0, 50], "f": [3, 3]}, "scale": "s"}]"#;
    let figure = r#"{"name": "f", "kind": "spectrum", "of": "m.a", "y": "pseudo-acceleration", "damping": 0.1, "periods": [0.1, 1.9],
        "where": {"n": 4}}"#;
    let (sheet, _) = super::drawn(&structure(parts, figure), 0);
    // Within the duration of 1 an oscillator overshoots once.
    let overshoot = (-PI * 0.1 / (1.0f64 - 0.01).sqrt()).exp();
    let series = &sheet.panels[0].series;
    assert_eq!(series.len(), 2);
    for (series, s) in series.iter().zip([1.0, 2.0]) {
        assert!(
            series.label.starts_with("Acceleration of m, "),
            "{}",
            series.label
        );
        for point in &series.points {
            // Round-off of the accelerations of the steps.
            assert!(
                (point[1] / (2.0 * s * (1.0 + overshoot)) - 1.0).abs() < 1e-11,
                "{point:?}"
            );
        }
    }
}

/// The boxes of a picture, and its words with their areas.
fn contents(sheet: &Sheet) -> (Vec<Rect>, Vec<(String, Rect)>) {
    let shapes = sheet.picture.shapes.iter();
    let boxes = shapes.filter_map(|shape| match shape {
        Shape::Box(rect, _) => Some(*rect),
        Shape::Line(..) | Shape::Arrow(_) | Shape::DoubleArrow(_) => None,
    });
    let words = sheet.picture.words.iter().map(|words| {
        let length = text::width(&words.text, words.size);
        let left = match words.anchor {
            Anchor::Start => words.at[0],
            Anchor::Middle => words.at[0] - length / 2.0,
            Anchor::End => words.at[0] - length,
        };
        let top = words.at[1] - style::CAP_HEIGHT * words.size;
        let area = Rect {
            left,
            top,
            width: length,
            height: words.at[1] - top,
        };
        (words.text.clone(), area)
    });
    (boxes.collect(), words.collect())
}

/// No line runs through a part: only the elements of bars have lines inside, which end at their edges.
fn assert_no_crossing(sheet: &Sheet) {
    for shape in &sheet.picture.shapes {
        let Shape::Box(rect, grey) = shape else {
            continue;
        };
        // Lines that end at an edge are up to half a point inside.
        let inner = Rect {
            left: rect.left + 1.0,
            top: rect.top + 1.0,
            width: rect.width - 2.0,
            height: rect.height - 2.0,
        };
        for line in &sheet.picture.shapes {
            if let Shape::Line(points, _) = line
                && (*grey < 255 || !points.iter().all(|point| rect.contains(*point)))
            {
                let crossing = slipgap_drawing::layout::clip::inside(points, &inner);
                assert!(crossing.is_empty(), "{points:?} in {rect:?}");
            }
        }
    }
}

/// Nothing overlaps and nothing is off the sheet.
fn assert_clear(sheet: &Sheet) {
    assert_no_crossing(sheet);
    let (boxes, words) = contents(sheet);
    for (i, a) in boxes.iter().enumerate() {
        assert!(boxes[..i].iter().all(|b| !a.overlaps(b)), "{a:?}");
    }
    let page = Rect {
        width: sheet.width,
        height: sheet.height,
        ..Rect::default()
    };
    for (i, (text, area)) in words.iter().enumerate() {
        assert!(
            page.contains([area.left, area.top]) && page.contains([area.right(), area.bottom()]),
            "{text}"
        );
        let inside = |rect: &&Rect| {
            rect.contains([area.left, area.top]) && rect.contains([area.right(), area.bottom()])
        };
        let inside_count = boxes.iter().filter(inside).count();
        let met = boxes.iter().filter(|rect| area.overlaps(rect)).count();
        assert_eq!(met, inside_count, "{text}");
        assert!(
            words[..i].iter().all(|(_, other)| !area.overlaps(other)),
            "{text}"
        );
        for shape in &sheet.picture.shapes {
            let points = match shape {
                Shape::Line(points, _) => points.clone(),
                Shape::Arrow(ends) | Shape::DoubleArrow(ends) => ends.to_vec(),
                Shape::Box(..) => continue,
            };
            assert!(points.iter().all(|point| page.contains(*point)));
            let crossing = slipgap_drawing::layout::clip::inside(&points, area);
            assert!(crossing.is_empty(), "{text}: {points:?}");
        }
    }
}

const SPRING: &str = r#""k": 1, "c": 1"#;
const IMPACT: &str = r#""law": "impact", "k": 1"#;
const FRICTION: &str = r#""law": "coulomb", "limit": 1"#;

fn scheme(parts: &str) -> Sheet {
    let sheet = unsolved(&structure(
        parts,
        r#"{"name": "f", "kind": "scheme", "title": "A scheme"}"#,
    ));
    assert_clear(&sheet);
    for written in [
        png(&sheet, style::DPI).is_ok(),
        pdf(&sheet, style::DPI).is_ok(),
        svg(&sheet, style::DPI).is_ok(),
    ] {
        assert!(written);
    }
    sheet
}

#[test]
fn a_node_between_laws_in_series_is_a_dot() {
    let series = |laws: &str| {
        scheme(&format!(
            r#""masses": {{"a": 1, "b": 1}}, "springs": [{{"between": ["ground", "a"], {SPRING}}}],
              "contacts": {{"link": {{"between": ["a", "b"], {laws}}}}}"#
        ))
    };
    let boxes = |sheet: &Sheet| {
        let shapes = sheet.picture.shapes.iter();
        shapes
            .filter(|shape| matches!(shape, Shape::Box(..)))
            .count()
    };
    let together =
        series(r#""series": [{"law": "coulomb", "limit": 1}, {"law": "impact", "k": 1}]"#);
    let alone = series(IMPACT);
    assert_eq!(boxes(&alone), 2);
    let named = |sheet: &Sheet| {
        contents(sheet)
            .1
            .iter()
            .any(|(text, _)| text.contains("node"))
    };
    assert!(!named(&together) && !together.description.contains("node"));
    // The two masses, and what a dot is drawn with is no box.
    assert_eq!(boxes(&together), 2);
}

/// The middle of a name, which is that of its part.
fn middle(sheet: &Sheet, name: &str) -> [f64; 2] {
    let words = contents(sheet).1.into_iter();
    let areas = words.filter(|(text, _)| text == name).map(|(_, area)| area);
    let found: Vec<Rect> = areas.collect();
    assert_eq!(found.len(), 1, "{name}");
    [
        found[0].left + found[0].width / 2.0,
        found[0].top + found[0].height / 2.0,
    ]
}

#[test]
fn girders_are_in_a_row_on_their_piers() {
    let pier = |p: &str| format!(r#"{{"between": ["ground", "{p}"], {SPRING}}}"#);
    let piers: Vec<String> = ["p1", "p2", "p3", "p4"].iter().map(|p| pier(p)).collect();
    let sheet = scheme(&format!(
        r#""masses": {{"p1|p2|p3|p4": 1}}, "bars": {{"g1|g2|g3": {{"L": 40, "EA": 1, "mass": 1, "n": "n"}}}},
          "springs": [{}, {{"between": ["p1", "g1.left"], {SPRING}}}, {{"between": ["g2.left", "p2"], "k": 1}}],
          "contacts": {{"gap12": {{{IMPACT}, "between": ["g1.right", "g2.left"]}}, "gap23": {{{IMPACT}, "between": ["g2.right", "g3.left"]}},
            "bearing1": {{{FRICTION}, "between": ["p2", "g1.right"]}}, "bearing2": {{{FRICTION}, "between": ["p3", "g2.right"]}},
            "bearing3": {{{FRICTION}, "between": ["g3.left", "p3"]}}, "bearing4": {{{FRICTION}, "between": ["p4", "g3.right"]}},
            "key": {{{IMPACT}, "between": ["p4", "g3.right"]}}, "abutment": {{{IMPACT}, "between": ["g3.right", "ground"]}}}},
          "ground": {{"synthetic": {{"seed": 1}}}}"#,
        piers.join(", ")
    ));
    let at = |name: &str| middle(&sheet, name);
    let row = ["g1", "gap12", "g2", "gap23", "g3", "abutment"].map(|name| at(name)[0]);
    assert!(row.is_sorted(), "{row:?}");
    let piers = ["p1", "p2", "p3", "p4"].map(at);
    assert!(
        piers
            .iter()
            .all(|p| p[1] == piers[0][1] && p[1] > at("g1")[1])
    );
    // A pier between two girders is under the gap.
    assert!(
        (piers[1][0] - at("gap12")[0]).abs() < 15.0 && (piers[2][0] - at("gap23")[0]).abs() < 15.0
    );
    assert!(["g1", "g2", "g3"].iter().all(|g| at(g)[1] == at("g1")[1]));
    at("ground motion");
}

/// A bearing on the ground is led around the piers that are between the girder and the ground.
#[test]
fn no_bearing_is_drawn_through_a_pier() {
    let pier = |p: &str| format!(r#"{{"between": ["ground", "{p}"], {SPRING}}}"#);
    for girder in ["g1.left", "g1.right", "g2.left", "g2.right", "g1.2"] {
        for more in [
            "",
            r#""key": {"law": "impact", "k": 1, "between": ["p2", "g1.right"]},"#,
        ] {
            let sheet = scheme(&format!(
                r#""masses": {{"p1|p2|p3": 1}}, "bars": {{"g1|g2": {{"L": 40, "EA": 1, "mass": 1, "n": "n"}}}},
                  "springs": [{}, {{"between": ["p1", "g1.left"], {SPRING}}}, {{"between": ["p2", "g2.left"], "k": 1}}, {{"between": ["p1", "g1.2"], "k": 1}}],
                  "contacts": {{"gap": {{{IMPACT}, "between": ["g1.right", "g2.left"]}}, {more}
                    "b1": {{{FRICTION}, "between": ["ground", "{girder}"]}}, "b2": {{{FRICTION}, "between": ["p2", "g1.right"]}},
                    "b3": {{{FRICTION}, "between": ["p3", "g2.right"]}}, "b4": {{{FRICTION}, "between": ["g2.right", "ground"]}}}}"#,
                ["p1", "p2", "p3"].map(pier).join(", ")
            ));
            let named = contents(&sheet).1.into_iter().map(|(text, _)| text);
            assert_eq!(named.filter(|text| text == "b1").count(), 1);
        }
    }
}

#[test]
fn storeys_are_above_one_another_and_buildings_side_by_side() {
    let spring = |i: &str, j: &str| format!(r#"{{"between": ["{i}", "{j}"], {SPRING}}}"#);
    let springs = ["a", "b"].map(|x| {
        let floors = [format!("{x}1"), format!("{x}2"), format!("{x}3")];
        [
            spring("ground", &floors[0]),
            spring(&floors[1], &floors[0]),
            spring(&floors[1], &floors[2]),
        ]
        .join(", ")
    });
    let gaps: Vec<String> = (1..=3)
        .map(|i| format!(r#""gap{i}": {{{IMPACT}, "between": ["a{i}", "b{i}"]}}"#))
        .collect();
    let sheet = scheme(&format!(
        r#""masses": {{"b1|b2|b3": 1, "a1|a2|a3": 1}}, "springs": [{}], "contacts": {{{}}},
          "loads": [{{"at": "a3", "sine": {{"amplitude": 1, "omega": 1}}}}, {{"at": "a3", "sine": {{"amplitude": 1, "omega": 1}}}}]"#,
        springs.join(", "),
        gaps.join(", ")
    ));
    let at = |name: &str| middle(&sheet, name);
    for i in 1..=3 {
        let [a, b, gap] = ["a", "b", "gap"].map(|name| at(&format!("{name}{i}")));
        assert!(a[0] < gap[0] && gap[0] < b[0] && a[1] == b[1]);
        // Names have different widths; the floors share a middle.
        assert!((a[0] - at("a1")[0]).abs() < 1e-9);
    }
    assert!(at("a3")[1] < at("a2")[1] && at("a2")[1] < at("a1")[1]);
    let arrows = sheet
        .picture
        .shapes
        .iter()
        .filter(|shape| matches!(shape, Shape::Arrow(_)));
    assert_eq!(arrows.count(), 1);
}

#[test]
fn bars_blocks_and_stops_have_their_places() {
    let bars = scheme(&format!(
        r#""bars": {{"b3|b2|b1": {{"L": 1, "EA": 1, "mass": 1, "n": "50*n"}}}}, "contacts":
          {{"c12": {{{IMPACT}, "between": ["b1.right", "b2.left"]}}, "c23": {{{IMPACT}, "between": ["b2.right", "b3.left"]}}}}"#
    ));
    let [first, second, third] =
        ["b1", "b2", "b3"].map(|b| middle(&bars, &format!("{b} (*n* = 200)"))[0]);
    assert!(first < second && second < third);
    let block = scheme(&format!(
        r#""masses": {{"block": 1}}, "springs": [{{"between": ["ground", "block"], "k": 1}}],
          "contacts": {{"surface": {{{FRICTION}, "between": ["ground", "block"]}}}}"#
    ));
    assert!(middle(&block, "surface")[1] > middle(&block, "block")[1]);
    for (ends, side) in [(r#""m", "ground""#, 1.0), (r#""ground", "m""#, -1.0)] {
        let stop = scheme(&format!(
            r#""masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], {SPRING}}}],
              "contacts": {{"stop": {{{IMPACT}, "between": [{ends}]}}}}, "loads": [{{"at": "m", "sine": {{"amplitude": 1, "omega": 1}}}}]"#
        ));
        assert!(side * (middle(&stop, "stop")[0] - middle(&stop, "m")[0]) > 0.0);
    }
}

#[test]
fn a_contact_between_the_ground_and_a_support_is_drawn() {
    let sheet = scheme(
        r#""masses": {"idle": 1}, "springs": [{"between": ["ground", "idle"], "k": 1}],
          "supports": {"ram": {"displacement": {"t": [0, 1], "u": [0, 0.1]}}},
          "contacts": {"bearing": {"law": "displacement-control", "k": 1, "limit": 1, "between": ["ground", "ram"]}}"#,
    );
    let [idle, bearing, ram] = ["idle", "bearing", "ram.x"].map(|name| middle(&sheet, name)[0]);
    assert!(idle < bearing && bearing < ram, "{idle}, {bearing}, {ram}");
}

#[test]
fn any_links_are_drawn_in_a_narrow_sheet_too() {
    let study = structure(
        &format!(
            r#""masses": {{"m1|m2|m3": 1}}, "bars": {{"deck": {{"L": 40, "EA": 1, "mass": 1, "n": 30}}}},
              "springs": [{{"between": ["m1", "m3"], "k": 1}}, {{"between": ["ground", "deck.left"], {SPRING}}},
                {{"between": ["m1", "deck.5"], "k": 1}}, {{"between": ["ground", "m1"], "c": 1}}, {{"between": ["deck.left", "deck.right"], "k": 1}}],
              "contacts": {{"i12": {{{IMPACT}, "between": ["m1", "m2"]}}, "i23": {{{IMPACT}, "between": ["m2", "m3"]}},
                "i31": {{{IMPACT}, "between": ["m3", "m1"]}}, "key": {{{IMPACT}, "between": ["m2", "deck.20"]}},
                "slide": {{{FRICTION}, "between": ["deck.20", "m2"]}}}},
              "loads": [{{"at": "deck.10", "sine": {{"amplitude": 1, "omega": 1}}}}, {{"at": "m2", "sine": {{"amplitude": 1, "omega": 1}}}}]"#
        ),
        r#"{"name": "f", "kind": "scheme", "width": 70}"#,
    );
    let sheet = unsolved(&study);
    let (boxes, words) = contents(&sheet);
    assert_eq!(boxes.len(), 4);
    for (i, a) in boxes.iter().enumerate() {
        assert!(boxes[..i].iter().all(|b| !a.overlaps(b)), "{a:?}");
    }
    assert_eq!(words.len(), 4 + 5);
    assert!(png(&sheet, style::DPI).is_ok());
}

#[test]
fn stacked_energies_reach_up_to_the_input() {
    // The load is a sine and not a ground motion, so that the work has both signs.
    let parts = r#""masses": {"m": 2}, "springs": [{"name": "k", "between": ["ground", "m"], "k": "80*s", "c": 0.5}],
                   "loads": [{"at": "m", "sine": {"amplitude": 3, "omega": 9}}]"#;
    let energies = r#"["energy.damping", "energy.elastic", "energy.kinetic", "energy.method"]"#;
    let figure = format!(
        r#"{{"name": "e", "kind": "history", "stacked": true, "y": {energies}, "where": {{"n": 4}}}},
           {{"name": "i", "kind": "history", "y": ["energy.input", "k.S"], "where": {{"n": 4}}}}"#
    );
    let study = structure(parts, &figure);
    let [(sheet, _), (input, _)] = [0, 1].map(|figure| drawn(&study, figure));
    let [first, second] = sheet.panels.as_slice() else {
        panic!("{} panels", sheet.panels.len());
    };
    for (panel, input) in [first, second].into_iter().zip(&input.panels[0].series) {
        let labels: Vec<&str> = panel.series.iter().map(|line| &*line.label).collect();
        assert_eq!(
            labels,
            [
                "Energy dissipated by damping",
                "+ elastic energy",
                "+ kinetic energy",
                "+ energy taken by the method"
            ]
        );
        let top = &panel.series[3].points;
        assert_eq!(top.len(), input.points.len());
        for (top, input) in top.iter().zip(&input.points) {
            // Round-off of 100 steps.
            assert!(top[0] == input[0] && (top[1] - input[1]).abs() < 1e-14);
        }
        // Each area begins where the one below it ends.
        assert!(panel.bands[0].lower.iter().all(|point| point[1] == 0.0));
        for pair in panel.bands.windows(2) {
            assert_eq!(pair[0].upper, pair[1].lower);
        }
        assert_eq!(panel.bands[3].upper, *top);
    }
    assert_eq!(first.y.title, "Sum, kN·m");
    for (y, by, what) in [
        (
            r#"["energy.input", "k.S"]"#,
            "",
            "quantities of one dimension",
        ),
        (energies, r#""by": "s", "#, "one panel for each case"),
    ] {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1, "s": [1, 2]}}, "structure": {{"units": "t, kN, m, s", {}}},
                "figures": [{{"name": "e", "kind": "history", {by}"stacked": true, "y": {y}}}]}}"#,
            parts
        );
        let why = slipgap_study::parse("s", &text).unwrap_err().to_string();
        assert!(why.contains(what), "{why}");
    }
}

#[test]
fn one_ground_motion_is_drawn_once_in_grey() {
    let history = |ground: &str, dt: &str| {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"k": [50, 200], "dt": {dt}, "duration": 1}},
              "structure": {{"masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": "k"}}], "ground": {{"sine": {{"amplitude": {ground}, "omega": 7}}}}}},
              "metrics": ["peak(a)"], "figures": [{{"name": "h", "kind": "history", "y": ["ground", "a"], "by": "k"}}]}}"#
        );
        let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
        drawn(&study, 0).0
    };
    for dt in ["0.01", "\"2/k\""] {
        let sheet = history("3", dt);
        let [input, answers] = &sheet.panels[..] else {
            panic!("{} panels", sheet.panels.len());
        };
        let [curve] = &input.series[..] else {
            panic!("{} curves", input.series.len());
        };
        assert_eq!((curve.stroke, &*curve.label), (Stroke::Grey, ""));
        // The finest steps, at which it is the sine itself.
        assert_eq!(curve.points.len(), 101);
        let [t, a] = curve.points[60];
        assert!((a - 3.0 * libm::sin(7.0 * t)).abs() < 1e-12);
        assert_eq!(answers.series.len(), 2);
        assert_eq!(sheet.legend.len(), 2);
    }
    // Two motions are two curves.
    let two = history("\"k\"", "0.01");
    assert_eq!(two.panels[0].series.len(), 2);
}
