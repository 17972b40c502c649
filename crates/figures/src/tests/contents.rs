//! What maps, budgets, Sobol' figures and metrics show, held against values made up for the purpose.

use slipgap_drawing::layout::sheet::{PlacedText, Sheet};
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_problem::problem::Case;
use slipgap_study::{self, Study};

const FRICTION: &str = r#""problem": "friction-oscillator""#;
const LAW: &str = r#""law": "displacement-control", "duration": "8*pi""#;

fn parsed(problem: &str, rest: &str) -> Study {
    slipgap_study::parse("s", &format!("{{{problem}, {rest}}}")).unwrap_or_else(|e| panic!("{e}"))
}

/// The first figure of a study whose cases have these values of metrics, by name; all others are empty.
fn drawn(study: &Study, value: impl Fn(&Case, &str) -> Option<f64>) -> Sheet {
    let figure = &study.figures[0];
    let cases: Vec<Case> = study.cases().filter(|c| figure.filter.matches(c)).collect();
    let row = |case: &Case| -> Vec<Option<f64>> {
        let table = study.problem.metrics().iter();
        table.map(|metric| value(case, &metric.name)).collect()
    };
    let metrics: Vec<Vec<Option<f64>>> = cases.iter().map(row).collect();
    super::sheet_of(study, figure, &super::shown(study, &cases, &metrics).all())
}

fn number(case: &Case, name: &str) -> f64 {
    case.number(name).unwrap()
}

#[test]
fn a_map_rises_along_the_axis_that_its_metric_rises_along() {
    let map = |ridge: &str| {
        let figure = format!(
            r#"{{"name": "m", "kind": "map", "x": "dT", "y": "x0", "z": "rms_error"{ridge}}}"#
        );
        let study = parsed(
            FRICTION,
            &format!(
                r#""parameters": {{{LAW}, "alpha": 0.1, "dT": [0.1, 0.2, 0.3], "x0": [8, 9, 10]}}, "figures": [{figure}]"#
            ),
        );
        drawn(&study, |case, name| {
            let (x, y) = (number(case, "dT"), number(case, "x0"));
            (name == "rms_error").then_some(10.0 * x + 0.01 * (y - 9.0).powi(2))
        })
    };
    let sheet = map("");
    let panel = &sheet.panels[0];
    // From 1 to 3 along dT and next to nothing along x0: level 2 leans by 0.01/10 about dT = 0.2.
    let filled = panel.map.as_ref().unwrap();
    let level = filled.levels.iter().position(|z| *z == 2.0).unwrap();
    let lines = panel.series.iter().flat_map(|s| &s.points);
    let on_it: Vec<_> = lines.filter(|p| (p[0] - 0.2).abs() < 0.011).collect();
    assert!(on_it.iter().any(|p| p[1] == 8.0) && on_it.iter().any(|p| p[1] == 10.0));
    // The area above the level lies right of it, from the lowest x0 to the highest.
    let above = filled
        .areas
        .iter()
        .find(|area| area.0 == level + 1)
        .unwrap();
    let ends = |k: usize| {
        let heights = above.1.iter().map(|p| p[k]);
        [
            heights.clone().fold(f64::MAX, f64::min),
            heights.fold(f64::MIN, f64::max),
        ]
    };
    assert!(
        (ends(0)[0] - 0.2).abs() < 0.0011 && ends(0)[1] >= 0.3,
        "{:?}",
        ends(0)
    );
    assert!(ends(1)[0] <= 8.0 && ends(1)[1] >= 10.0, "{:?}", ends(1));
    // No ridge unless one is asked for; then at x0 = 9 in every column.
    assert!(sheet.legend.is_empty());
    let asked = map(r#", "ridge": "least""#);
    assert_eq!(asked.legend[0].label, "least at each Δ*T*");
    let line = asked.panels[0]
        .series
        .iter()
        .find(|s| s.width == style::RIDGE_LINE);
    assert_eq!(
        line.unwrap().points[..3],
        [[0.1, 9.0], [0.2, 9.0], [0.3, 9.0]]
    );
}

#[test]
fn a_budget_has_each_part_under_its_name() {
    let study = parsed(
        FRICTION,
        &format!(
            r#""parameters": {{{LAW}, "alpha": 0.1, "x0": 12, "dT": [0.1, 0.2, 0.3]}},
            "figures": [{{"name": "b", "kind": "budget", "x": "dT"}}]"#
        ),
    );
    let value = |case: &Case, name: &str| {
        let x = number(case, "dT");
        match name {
            "rms_error" => Some(x),
            "regularisation_error" => Some(2.0 * x),
            "step_error" => Some(3.0 * x),
            _ => None,
        }
    };
    let sheet = drawn(&study, value);
    let series = &sheet.panels[0].series;
    let named = |label: &str| {
        let found = series.iter().find(|s| s.label.contains(label));
        found.unwrap_or_else(|| panic!("{label}")).points.clone()
    };
    for (label, times) in [("total", 1.0), ("regularisation", 2.0), ("step", 3.0)] {
        let expected = [0.1, 0.2, 0.3].map(|x| [x, times * x]);
        assert_eq!(named(label), expected, "{label}");
    }
}

const DESIGN: &str = r#""parameters": {"gamma": {"uniform": [1, 2]}, "gap": {"uniform": [1, 2]}, "n": 4, "dt": 0.01,
    "duration": 1}, "design": {"kind": "saltelli", "n": 256, "seed": 2},
    "figures": [{"name": "s", "kind": "sobol", "y": ["peak_force", "max_overlap"]}]"#;

#[test]
fn a_sobol_figure_has_first_order_left_and_total_right_of_each_parameter() {
    let study = parsed(r#""problem": "bar-impact""#, DESIGN);
    // u + sqrt(12) u v over two squares round 0: the variances of u and of u v are both 1/12, so that u explains one
    // half by itself and all with v, and v nothing by itself and one half with u.
    let sheet = drawn(&study, |case, name| {
        let [u, v] = ["gamma", "gap"].map(|p| number(case, p) - 1.5);
        (name == "peak_force").then_some(u + 12.0_f64.sqrt() * u * v)
    });
    let panel = &sheet.panels[0];
    let middle = |k: usize| (panel.bars[k].x[0] + panel.bars[k].x[1]) / 2.0;
    let expected = [
        (-0.5..0.0, Marker::Dark, 0.5),
        (0.0..0.5, Marker::Light, 1.0),
        (0.5..1.0, Marker::Dark, 0.0),
        (1.0..1.5, Marker::Light, 0.5),
    ];
    assert_eq!(panel.bars.len(), 4);
    for (k, (span, marker, height)) in expected.into_iter().enumerate() {
        let bar = &panel.bars[k];
        assert!(span.contains(&middle(k)), "{k}");
        assert_eq!(bar.shade, marker.shade());
        // 256 points; random ones would err by 0.06.
        let found = bar.y[0] + bar.y[1];
        assert!((found - height).abs() < 0.06, "{k}: {found}");
    }
    let keys: Vec<_> = sheet
        .legend
        .iter()
        .map(|e| (e.label.as_str(), e.marker))
        .collect();
    assert_eq!(
        keys,
        [
            ("first order", Some(Marker::Dark)),
            ("total", Some(Marker::Light))
        ]
    );
    let warned = |line: &PlacedText| line.text.contains("Not converged");
    assert!(!sheet.small_print.iter().any(warned));
    let labels: Vec<_> = panel.x.ticks.iter().map(|t| t.label.as_str()).collect();
    assert_eq!(labels.len(), 2);
    let table = study.problem.parameters();
    let symbol = |name: &str| &table.iter().find(|p| p.name == name).unwrap().symbol;
    assert_eq!(labels, [symbol("gamma"), symbol("gap")]);
    // The metric that is nowhere defined has no bars, and the panel says so.
    let bare = &sheet.panels[1];
    assert!(bare.bars.is_empty());
    assert_eq!(
        bare.notes[0].text,
        "no indices: empty in 1024 of 1024 cases"
    );
}

#[test]
fn a_curve_goes_through_cases_whose_other_parameters_follow_from_x() {
    let curves = |parameters: &str| {
        let study = parsed(
            r#""problem": "bar-impact""#,
            &format!(
                r#"{parameters}, "figures": [{{"name": "f", "kind": "metric", "x": "n", "y": "peak_force"}}]"#
            ),
        );
        let sheet = drawn(&study, |case, name| {
            (name == "peak_force").then(|| number(case, "n"))
        });
        let series = sheet.panels[0].series.iter();
        series.map(|s| s.points.len()).collect::<Vec<_>>()
    };
    // The step advances with n; gamma follows from k_I and n.
    let zipped = r#""parameters": {"k_I": 100, "n": [4, 8, 16], "dt": [0.04, 0.02, 0.01], "duration": 1},
        "zip": [["n", "dt"]]"#;
    assert_eq!(curves(zipped), [3]);
    let two = r#""parameters": {"k_I": [10, 100], "n": [4, 8, 16], "dt": "0.1/n", "duration": 1}"#;
    assert_eq!(curves(two), [3, 3]);
}

#[test]
fn many_curves_over_a_number_are_told_apart_by_lightness() {
    let curves = |count: usize| {
        // Not in rising order: the odd ones first.
        let values: Vec<String> = (0..count)
            .map(|i| ((2 * i + 1) % count + 1).to_string())
            .collect();
        let study = parsed(
            FRICTION,
            &format!(
                r#""parameters": {{{LAW}, "alpha": 0.1, "dT": [0.1, 0.2, 0.3], "x0": [{}]}},
                "figures": [{{"name": "m", "kind": "metric", "x": "dT", "y": "rms_error", "by": "x0"}}]"#,
                values.join(", ")
            ),
        );
        drawn(&study, |case, name| {
            (name == "rms_error").then(|| number(case, "x0") * number(case, "dT"))
        })
    };
    let sheet = curves(15);
    let labels: Vec<_> = sheet.legend.iter().map(|e| e.label.clone()).collect();
    let expected = (1..=15).map(|x0| format!("*X*_0_ = {x0}"));
    assert_eq!(labels, expected.collect::<Vec<_>>());
    let entries = &sheet.legend[..15];
    // Luma (ITU-R BT.709) rises from key to key; white paper has 255.
    let luma = |stroke: style::Stroke| {
        let [r, g, b] = stroke.colour().map(f64::from);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    };
    let lightness: Vec<f64> = entries.iter().map(|e| luma(e.stroke)).collect();
    assert!(
        lightness.windows(2).all(|pair| pair[1] > pair[0] + 3.0),
        "{lightness:?}"
    );
    assert!(lightness[14] < 200.0 && lightness[0] < 30.0);
    for entry in entries {
        assert_eq!(entry.marker, None);
        let mut series = sheet.panels[0].series.iter();
        let curve = series.find(|s| s.label == entry.label).unwrap();
        assert_eq!((curve.stroke, curve.marker), (entry.stroke, None));
        // The point at dT = 0.1 is a tenth of x0.
        let x0 = curve.points[0][1] * 10.0;
        assert_eq!(entry.label, format!("*X*_0_ = {x0:.0}"));
    }
    // As many as there are colours have colours.
    let few = curves(5);
    let strokes: Vec<_> = few.legend.iter().map(|entry| entry.stroke).collect();
    assert_eq!(strokes, [0, 1, 2, 3, 4].map(style::Stroke::Colour));
}

#[test]
fn a_colour_bar_has_the_levels_of_the_contours_and_the_limits_of_its_end_bands() {
    let study = parsed(
        FRICTION,
        &format!(
            r#""parameters": {{{LAW}, "alpha": 0.1, "dT": [0.1, 0.2, 0.3], "x0": [8, 9, 10]}},
            "figures": [{{"name": "m", "kind": "map", "x": "dT", "y": "x0", "z": "rms_error"}}]"#
        ),
    );
    // From 8/3 to 10, both between levels.
    let sheet = drawn(&study, |case, name| {
        (name == "rms_error").then(|| number(case, "x0") * number(case, "dT") / 0.3)
    });
    let map = sheet.panels[0].map.as_ref().unwrap();
    let ticks: Vec<f64> = map.colours.ticks.iter().map(|tick| tick.at).collect();
    let limits: Vec<f64> = [map.colours.range[0]]
        .into_iter()
        .chain(map.levels.iter().copied())
        .chain([map.colours.range[1]])
        .collect();
    assert_eq!(ticks, limits);
    let labels: Vec<&str> = map.colours.ticks.iter().map(|t| t.label.as_str()).collect();
    assert_eq!(labels, ["2.67", "3", "4", "5", "6", "7", "8", "9", "10"]);
    // The numbers on the lines are those at the bar.
    assert!(!map.labels.is_empty());
    assert!(
        map.labels
            .iter()
            .all(|tag| labels.contains(&tag.text.as_str()))
    );
}

#[test]
fn slopes_name_their_curve_and_the_legend_names_the_reference_lines() {
    let study = parsed(
        FRICTION,
        &format!(
            r#""parameters": {{{LAW}, "alpha": 0.1, "dT": [0.02, 0.05, 0.1, 0.2, 0.4], "x0": [8, 12]}},
            "figures": [{{"name": "c", "kind": "convergence", "y": ["rms_error", "max_error"], "by": "x0"}}]"#
        ),
    );
    // Order 1 for x0 = 8, far above order 2 for x0 = 12.
    let sheet = drawn(&study, |case, _| {
        let x = number(case, "dT");
        Some(if number(case, "x0") == 8.0 {
            100.0 * x
        } else {
            x * x
        })
    });
    for panel in &sheet.panels {
        let notes = panel.notes.iter().map(|words| words.text.as_str());
        let slopes: Vec<&str> = notes.filter(|text| text.contains("slope")).collect();
        assert_eq!(
            slopes,
            ["*X*_0_ = 8: slope 1.00", "*X*_0_ = 12: slope 2.00"]
        );
    }
    let labels: Vec<&str> = sheet.legend.iter().map(|e| e.label.as_str()).collect();
    assert_eq!(labels, ["*X*_0_ = 8", "*X*_0_ = 12", "orders 1 and 2"]);
    assert_eq!(sheet.legend[2].stroke, style::Stroke::Dotted);
}

#[test]
fn more_names_than_colours_are_panels_with_their_own_legends() {
    let methods = r#"["average-acceleration", "linear-acceleration", "newmark", "hht", "bathe", "generalized-alpha", "moreau-jean"]"#;
    let study = parsed(
        r#""problem": "bar-impact""#,
        &format!(
            r#""parameters": {{"method": {methods}, "gamma": 1, "n": [1, 2, 4], "dt": 0.01, "duration": 1}},
            "figures": [{{"name": "f", "kind": "metric", "x": "n", "y": ["peak_force"], "by": "method"}}]"#
        ),
    );
    let sheet = drawn(&study, |case, _| Some(number(case, "n")));
    let [left, right] = &sheet.panels[..] else {
        panic!("{} panels", sheet.panels.len());
    };
    assert_eq!([left.series.len(), right.series.len()], [4, 3]);
    assert_eq!(left.frame.top, right.frame.top);
    for panel in [left, right] {
        let strokes: Vec<Stroke> = panel.series.iter().map(|series| series.stroke).collect();
        assert_eq!(strokes, [0, 1, 2, 3].map(Stroke::Colour)[..strokes.len()]);
        // Its entries are over or in its own frame.
        for series in &panel.series {
            let entry = sheet
                .legend
                .iter()
                .find(|entry| entry.label == series.label);
            let at = entry.unwrap().at[0];
            assert!((panel.frame.left..panel.frame.right()).contains(&at));
        }
    }
}

#[test]
fn reductions_say_of_how_many_values_they_are() {
    for (x0, filter, words) in [
        ("[8, 12, 14]", "", "Each value is the median of 3 values of"),
        // A filter chooses from them.
        (
            "[8, 12, 14]",
            r#", "where": {"x0": [8, 12]}"#,
            "Each value is the median of 2 values of",
        ),
    ] {
        let study = parsed(
            FRICTION,
            &format!(
                r#""parameters": {{{LAW}, "alpha": 0.1, "dT": [0.1, 0.2], "x0": {x0}}}, "reductions": ["median rms_error over x0"],
                "figures": [{{"name": "m", "kind": "metric", "x": "dT", "y": "median rms_error over x0"{filter}}}]"#
            ),
        );
        let sheet = drawn(&study, |_, _| Some(1.0));
        assert!(sheet.description.contains(words), "{}", sheet.description);
    }
}
