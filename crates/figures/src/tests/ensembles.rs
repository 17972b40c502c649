//! Figures of ensembles: functions, quantiles and probabilities against what a hand computes.

use crate::{pdf, png, sheet, svg, with_hover};
use slipgap_drawing::layout::sheet::{Series, Sheet};
use slipgap_drawing::style::{self, Stroke};
use slipgap_drawing::text::markup::plain;
use slipgap_problem::problem::Case;
use slipgap_statistics::binomial;
use slipgap_statistics::empirical::half_band;
use slipgap_study::{self, Study};

/// Bars with gamma x mesh x gap; the gap is the ensemble. The figure has these keys.
fn bars(gaps: &str, figure: &str) -> Study {
    let text = format!(
        r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2, 4], "n": [4, 8], "gap": {gaps}, "dt": 0.01, "duration": 1}},
             "ensemble": "gap", "figures": [{{"name": "f", {figure}}}]}}"#
    );
    slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
}

fn number(case: &Case, name: &str) -> f64 {
    case.number(name).unwrap()
}

/// The sheet of the figure if peak_force has these values and other metrics are empty, and its texts for a pointer.
fn drawn(study: &Study, value: impl Fn(&Case) -> Option<f64>) -> (Sheet, String) {
    let figure = &study.figures[0];
    let cases: Vec<Case> = study.cases().filter(|c| figure.filter.matches(c)).collect();
    let row = |case: &Case| -> Vec<Option<f64>> {
        let table = study.problem.metrics().iter();
        let metric_value = |name: &str| value(case).filter(|_| name == "peak_force");
        table.map(|metric| metric_value(&metric.name)).collect()
    };
    let metrics: Vec<Vec<Option<f64>>> = cases.iter().map(row).collect();
    let shown = super::shown(study, &cases, &metrics);
    super::with_data(study, figure, &shown.all(), |data| {
        let sheet = sheet(data);
        let text = svg(&sheet, style::DPI).unwrap();
        let hover = with_hover(data, &sheet, &text);
        assert!(png(&sheet, style::DPI).is_ok() && pdf(&sheet, style::DPI).is_ok());
        (sheet, hover)
    })
}

fn small_print(sheet: &Sheet) -> String {
    let lines = sheet.small_print.iter().map(|line| line.text.as_str());
    plain(&lines.collect::<Vec<_>>().join(" "))
}

#[test]
fn a_distribution_rises_at_its_values_within_its_band() {
    let study = bars(
        "[0.1, 0.2, 0.3, 0.4]",
        r#""kind": "distribution", "y": ["peak_force", "max_overlap"], "where": {"gamma": 1}"#,
    );
    // Four values with a tie for n = 4, three and a gap for n = 8.
    let (sheet, hover) = drawn(&study, |case| {
        let gap = number(case, "gap");
        match case.number("n") == Some(4.0) {
            true => Some(if gap < 0.25 { 3.0 } else { 10.0 * gap }),
            false => (gap > 0.15).then_some(10.0 * gap),
        }
    });
    let panel = &sheet.panels[0];
    let labels: Vec<_> = sheet
        .legend
        .iter()
        .map(|key| (key.label.as_str(), key.stroke))
        .collect();
    assert_eq!(
        labels,
        [
            ("*n* = 4", Stroke::Colour(0)),
            ("*n* = 8", Stroke::Colour(1))
        ]
    );
    let [first, last] = panel.x.range;
    assert_eq!(
        panel.series[0].points,
        [
            [first, 0.0],
            [3.0, 0.0],
            [3.0, 0.75],
            [4.0, 0.75],
            [4.0, 1.0],
            [last, 1.0]
        ]
    );
    let third = 1.0 / 3.0;
    assert_eq!(
        panel.series[1].points,
        [
            [first, 0.0],
            [2.0, 0.0],
            [2.0, third],
            [3.0, third],
            [3.0, 2.0 * third],
            [4.0, 2.0 * third],
            [4.0, 1.0],
            [last, 1.0]
        ]
    );
    // Half a band of three values is 0.78, of four 0.68: cut at 0 and 1.
    let band = &panel.bands[0];
    let half = half_band(4);
    assert_eq!(band.upper[0], [first, half]);
    assert_eq!(band.upper[2], [3.0, 1.0]);
    assert_eq!(band.lower[2], [3.0, 0.75 - half]);
    assert_eq!(band.lower[5], [last, 1.0 - half]);
    assert_eq!(panel.bands.len(), 2);
    // A metric without values has no function; the sheet says how many there are.
    assert!(sheet.panels[1].series.is_empty());
    let words = small_print(&sheet);
    assert!(
        words.contains(
            "Each function has 4 cases. Without 1 of 8 cases, in which peak_force is empty."
        ),
        "{words}"
    );
    assert!(
        words.contains("Without 8 of 8 cases, in which max_overlap is empty."),
        "{words}"
    );
    // Each step shows its place to a pointer.
    assert_eq!(hover.matches("<circle").count(), 5);
    assert!(
        hover.contains("n = 4: ") && hover.contains("fraction of the cases = 0.75"),
        "{hover}"
    );
    // Panels do not overlap, each has its own axis.
    let [a, b] = [&sheet.panels[0], &sheet.panels[1]];
    assert!(a.frame.bottom() + 20.0 < b.frame.top && !a.x.title.is_empty());
}

#[test]
fn many_values_have_as_many_steps_as_can_be_seen() {
    let study = bars(
        r#"{"linspace": [0, 1, 5001]}"#,
        r#""kind": "distribution", "y": "peak_force", "where": {"gamma": 1, "n": 4}, "x_scale": "log""#,
    );
    let (sheet, _) = drawn(&study, |case| Some(number(case, "gap")));
    let panel = &sheet.panels[0];
    // 0 has no place on a logarithmic axis: the function begins at its part.
    let points = &panel.series[0].points;
    assert_eq!(points[0], [panel.x.range[0], 1.0 / 5001.0]);
    assert!((1900..=2010).contains(&points.len()), "{}", points.len());
    // Between the ends of the axis a part is a value, up to a step.
    let inside = &points[1..points.len() - 1];
    assert!(inside.iter().all(|[x, y]| (x - y).abs() < 0.002));
    assert!(sheet.legend.is_empty());
}

#[test]
fn quantiles_are_those_of_the_cases_at_each_value() {
    let study = bars(
        "[0, 0.1, 0.2, 0.3, 0.4]",
        r#""kind": "quantiles", "x": "gamma", "y": "peak_force", "by": "n", "band": [0.25, 1]"#,
    );
    // At each gamma the values are gamma n + 0 .. 4; at gamma = 2 for n = 8 there are none.
    let (sheet, hover) = drawn(&study, |case| {
        let (gamma, n) = (number(case, "gamma"), number(case, "n"));
        let value = gamma * n + 10.0 * number(case, "gap");
        (gamma != 2.0 || n != 8.0).then_some(value)
    });
    let panel = &sheet.panels[0];
    let [four, eight] = [&panel.series[0], &panel.series[1]];
    assert_eq!(four.points, [[1.0, 6.0], [2.0, 10.0], [4.0, 18.0]]);
    assert_eq!(
        [eight.points[0], eight.points[2]],
        [[1.0, 10.0], [4.0, 34.0]]
    );
    assert!(eight.points[1][1].is_nan());
    assert_eq!([four.marker, eight.marker], [None, None]);
    let band = &panel.bands[0];
    assert_eq!(band.lower, [[1.0, 5.0], [2.0, 9.0], [4.0, 17.0]]);
    assert_eq!(band.upper, [[1.0, 8.0], [2.0, 12.0], [4.0, 20.0]]);
    // The gap splits the second band.
    let lengths: Vec<usize> = panel.bands.iter().map(|band| band.upper.len()).collect();
    assert_eq!(lengths, [3, 1, 1]);
    let words = small_print(&sheet);
    assert!(
        words.contains("from the 25 % to the 100 % quantile"),
        "{words}"
    );
    assert!(words.contains("Without 5 of 30 cases"), "{words}");
    assert!(hover.contains("n = 4: ") && hover.matches("<circle").count() >= 5);
}

#[test]
fn more_than_two_curves_have_bars_instead_of_bands() {
    let bands = |kind: &str, count: usize| {
        let text = format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2, 4], "n": {{"linspace": [1, {count}, {count}]}},
                "gap": [0, 0.1, 0.2], "dt": 0.01, "duration": 1}},
                "ensemble": "gap", "figures": [{{"name": "f", {kind}}}]}}"#
        );
        let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
        let (sheet, _) = drawn(&study, |case| {
            Some(number(case, "gamma") * number(case, "n") + number(case, "gap"))
        });
        let panel = &sheet.panels[0];
        let curves = panel
            .series
            .iter()
            .filter(|series| !series.label.is_empty());
        assert_eq!(curves.count(), count);
        let bars: Vec<_> = panel
            .series
            .iter()
            .filter(|series| series.label.is_empty())
            .collect();
        for bar in &bars {
            let [a, b] = bar.points[..] else {
                panic!("{bar:?}");
            };
            // Upright, within 4 points of its place, and over the median gamma n + 0.1.
            let near =
                |x: f64| (panel.place([x, 0.0])[0] - panel.place([a[0], 0.0])[0]).abs() < 4.0;
            let gamma = [1.0, 2.0, 4.0].into_iter().find(|x| near(*x)).unwrap();
            assert_eq!(a[0], b[0]);
            let holds = |n: &u32| {
                let median = gamma * f64::from(*n) + 0.1;
                (a[1] - (median - 0.068)).abs() < 1e-9 && (b[1] - (median + 0.068)).abs() < 1e-9
            };
            assert!((1..=count as u32).any(|n| holds(&n)), "{bar:?}");
        }
        (panel.bands.len(), bars.len())
    };
    let quantiles = r#""kind": "quantiles", "x": "gamma", "y": "peak_force", "by": "n""#;
    let distribution =
        r#""kind": "distribution", "y": "peak_force", "by": "n", "where": {"gamma": 1}"#;
    // 16 % of three values is 0.32 of the way from the first to the second: 0.032.
    assert_eq!(bands(quantiles, 2), (2, 0));
    assert_eq!(bands(quantiles, 3), (0, 9));
    assert_eq!(bands(distribution, 2), (2, 0));
    assert_eq!(bands(distribution, 3), (0, 0));
}

#[test]
fn two_bands_show_where_they_overlap() {
    let study = bars(
        "[0, 1]",
        r#""kind": "quantiles", "x": "gamma", "y": "peak_force", "by": "n", "band": [0, 1]"#,
    );
    // From 0 to 8 for n = 4, and from 4 to 12 for n = 8.
    let (sheet, _) = drawn(&study, |case| {
        Some(number(case, "n") - 4.0 + 8.0 * number(case, "gap"))
    });
    let at = |y: f64| super::colour_at(&sheet, sheet.panels[0].place([2.5, y]));
    let [blue, orange] = [0, 1].map(|i| Stroke::Colour(i).fill());
    let mixed = |under: [u8; 3], (colour, opacity): ([u8; 3], f64)| -> [f64; 3] {
        let mix = |(a, b): (u8, u8)| f64::from(a) + opacity * (f64::from(b) - f64::from(a));
        [0, 1, 2].map(|k| mix((under[k], colour[k])))
    };
    // The medians are at 4 and 8, the places half-way between them and the edges. The backend rounds the opacity to 1/255 and
    // each blend to a whole number.
    let white = [255; 3];
    for (y, expected) in [
        (2.0, mixed(white, blue)),
        (10.0, mixed(white, orange)),
        (6.0, mixed(at(2.0), orange)),
    ] {
        let found = at(y).map(f64::from);
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
        assert!(
            off.fold(0.0, f64::max) <= 2.0,
            "{y}: {found:?} {expected:?}"
        );
    }
    // The vector files have the same opacity.
    let text = svg(&sheet, style::DPI).unwrap();
    assert_eq!(text.matches("fill-opacity=\"0.2\"").count(), 2);
    let file = pdf(&sheet, style::DPI).unwrap();
    assert!(file.windows(7).any(|bytes| bytes == b"/ca 0.2"));
}

#[test]
fn many_points_have_no_markers() {
    let text = r#"{"problem": "bar-impact", "parameters": {"gamma": {"linspace": [1, 2, 1000]}, "n": 4, "gap": [0, 0.1, 0.2],
        "dt": 0.01, "duration": 1}, "ensemble": "gap",
        "figures": [{"name": "f", "kind": "quantiles", "x": "gamma", "y": "peak_force", "x_range": [1, 1.5]}]}"#;
    let study = slipgap_study::parse("s", text).unwrap_or_else(|e| panic!("{e}"));
    let (sheet, _) = drawn(&study, |case| {
        Some(number(case, "gamma") + number(case, "gap"))
    });
    let line = &sheet.panels[0].series[0];
    assert_eq!((line.points.len(), line.marker), (1000, None));
    assert_eq!((line.stroke, sheet.legend.len()), (Stroke::Colour(0), 0));
    assert!(line.points.iter().all(|[x, y]| (y - x - 0.1).abs() < 1e-12));
}

#[test]
fn a_fragility_has_parts_intervals_and_a_fit() {
    let study = bars(
        r#"{"linspace": [0, 0.9, 10]}"#,
        r#""kind": "fragility", "x": "gamma", "y": "peak_force", "limit": 1, "by": "n""#,
    );
    // Of ten cases 1, 5 and 9 exceed for n = 4; none for n = 8, where a tenth is empty. The limit itself does not exceed.
    let (sheet, hover) = drawn(&study, |case| {
        let (gamma, gap) = (number(case, "gamma"), number(case, "gap"));
        let exceeding = match gamma {
            1.0 => 0.85,
            2.0 => 0.45,
            _ => 0.05,
        };
        match number(case, "n") == 4.0 {
            true => Some(if gap > exceeding { 1.1 } else { 1.0 }),
            false => (gap < 0.85).then_some(0.5),
        }
    });
    let panel = &sheet.panels[0];
    // The curve of n = 4 through 200 parts of the axis, then the intervals at each gamma of both, then the points, those of n = 4 last.
    let sizes: Vec<usize> = panel
        .series
        .iter()
        .map(|series| series.points.len())
        .collect();
    assert_eq!(sizes, [&[201][..], &[6; 6], &[1; 6]].concat());
    // Symmetric about gamma = 2 in logarithms: the median is 2, and Phi(ln 2/dispersion) = 0.9 up to the fit, which has three
    // parts for two numbers: by symmetry it goes through all.
    let dispersion = std::f64::consts::LN_2 / 1.281_551_565_544_600_4;
    let labels: Vec<&str> = sheet.legend.iter().map(|key| key.label.as_str()).collect();
    // Intervals by the information n phi(u)^2/(p (1 - p)) of probit regression at each gamma, phi(0)^2 = 1/(2 pi): the variance
    // of ln(median) is dispersion^2 over its sum, that of ln(dispersion) 1 over its sum times u^2.
    let end = 10.0 * 0.175_498_331_932_486_85_f64.powi(2) / 0.09;
    let sum = 2.0 * end + 10.0 / (2.0 * std::f64::consts::PI) / 0.25;
    let u = std::f64::consts::LN_2 / dispersion;
    let factor = |variance: f64| libm::exp(1.959_963_984_540_054 * variance.sqrt());
    let median = factor(dispersion * dispersion / sum);
    let spread = factor(1.0 / (2.0 * end * u * u));
    let expected = format!(
        "*n* = 4: median 2 [{:.2}, {:.2}], dispersion {dispersion:.3} [{:.3}, {:.2}]",
        2.0 / median,
        2.0 * median,
        dispersion / spread,
        dispersion * spread
    );
    assert_eq!(
        labels,
        [
            expected.as_str(),
            "*n* = 8: no fit, no case exceeds the limit"
        ]
    );
    let curve: &Series = &panel.series[0];
    for [x, y] in &curve.points {
        let expected = slipgap_statistics::normal::cumulative(libm::log(x / 2.0) / dispersion);
        assert!((y - expected).abs() < 1e-9, "{x}: {y} {expected}");
    }
    let point = |i: usize| panel.series[7 + (i + 3) % 6].points[0];
    let interval = |i: usize| &panel.series[1 + i].points;
    let ends = |i: usize| [interval(i)[2][1], interval(i)[3][1]];
    for (i, exceeded) in [1, 5, 9].into_iter().enumerate() {
        assert_eq!(point(i)[1], exceeded as f64 / 10.0);
        assert_eq!(ends(i), binomial::interval(exceeded, 10));
        assert_eq!(ends(3 + i), binomial::interval(0, 9));
        // At their place, with ends of different widths around it.
        let gamma = [1.0, 2.0, 4.0][i];
        for curve in [i, 3 + i] {
            assert!(
                [point(curve), interval(curve)[2], interval(curve)[3]]
                    .iter()
                    .all(|at| at[0] == gamma)
            );
        }
        let centre = panel.place([gamma, 0.0])[0];
        let caps =
            [i, 3 + i].map(|curve| [0, 1].map(|end| panel.place(interval(curve)[end])[0] - centre));
        assert!(caps.iter().all(|[left, right]| (left + right).abs() < 1e-9));
        assert!(caps[1][1] > caps[0][1] + 0.4 * style::MARKER && caps[0][1] > 0.0);
    }
    assert!(panel.y.title.ends_with("> 1)"), "{}", panel.y.title);
    assert!(
        hover.contains("n = 4: γ = 1, 1 of 10 cases exceed, interval"),
        "{hover}"
    );
    assert!(
        small_print(&sheet).contains("Without 3 of 60 cases"),
        "{}",
        small_print(&sheet)
    );
}
