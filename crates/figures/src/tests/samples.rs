//! Scatters and matrices of samples: their dots against the columns of the cases, then the size of the SVG.

use crate::{png, svg};
use slipgap_drawing::layout::cloud::{Cloud, MOST_SHAPES};
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_drawing::style;
use slipgap_problem::problem::Case;
use slipgap_study::{self, Scale, Study};

/// A study of friction with `n` samples of alpha, dT and x0, and one figure.
fn sampled(n: usize, figure: &str) -> Study {
    let text = format!(
        r#"{{"problem": "friction-oscillator",
          "parameters": {{"law": "displacement-control", "duration": "8*pi", "alpha": {{"loguniform": [0.01, 1]}},
                          "dT": {{"uniform": [0.1, 0.5]}}, "x0": {{"uniform": [3, 15]}}}},
          "design": {{"kind": "latin-hypercube", "n": {n}, "seed": 3}}, "figures": [{{"name": "f", {figure}}}]}}"#
    );
    slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
}

fn number(case: &Case, name: &str) -> f64 {
    case.number(name).unwrap()
}

/// A metric made up: undefined for large x0, 0 for the next.
fn rms(case: &Case) -> Option<f64> {
    match number(case, "x0") {
        x0 if x0 > 14.0 => None,
        x0 if x0 > 13.0 => Some(0.0),
        x0 => Some(number(case, "alpha") * x0),
    }
}

/// The sheet, and the cases that it shows.
fn drawn(study: &Study) -> (Sheet, Vec<Case>) {
    let cases: Vec<Case> = study.cases().collect();
    let table = study.problem.metrics();
    let row = |case: &Case| -> Vec<Option<f64>> {
        let value = |name: &str| match name {
            "rms_error" => rms(case),
            "max_error" => Some(2.0 * number(case, "dT")),
            _ => None,
        };
        table.iter().map(|metric| value(&metric.name)).collect()
    };
    let metrics: Vec<_> = cases.iter().map(row).collect();
    let drawn = super::shown(study, &cases, &metrics);
    let shown = drawn.all();
    (super::sheet_of(study, &study.figures[0], &shown), cases)
}

/// Places and values of the dots.
fn dots(cloud: &Cloud) -> Vec<([f64; 2], Option<f64>)> {
    cloud.dots.iter().map(|dot| (dot.at, dot.value)).collect()
}

#[test]
fn a_scatter_has_a_dot_for_every_case_that_has_a_value() {
    let study = sampled(
        200,
        r#""kind": "scatter", "x": "rms_error", "y": "dT", "colour": "x0""#,
    );
    let (sheet, cases) = drawn(&study);
    let panel = &sheet.panels[0];
    let expected: Vec<_> = cases
        .iter()
        .filter_map(|c| Some(([rms(c)?, number(c, "dT")], Some(number(c, "x0")))))
        .collect();
    let cloud = panel.cloud.as_ref().unwrap();
    assert_eq!(dots(cloud), expected);
    // One slice in twelve of x0 has no metric: 16 or 17 whole slices of 200, and a part of one.
    let lacking = 200 - expected.len();
    assert!((16..=17).contains(&lacking), "{lacking}");
    assert_eq!(
        panel.caption,
        format!("{lacking} of 200 cases without a value")
    );
    // Colours from the least x0 to the greatest.
    let colours = &panel.map.as_ref().unwrap().colours;
    for dot in &cloud.dots {
        let [low, high] = colours.range;
        let shade = (dot.value.unwrap() - low) / (high - low);
        assert!((0.0..=1.0).contains(&shade) && (dot.shade - shade).abs() < 1e-15);
        // Within the frame, so that every dot is drawn.
        assert!(panel.frame.contains(panel.place(dot.at)));
    }
    assert!(!cloud.image);
    // A circle and its outline each.
    let text = svg(&sheet, style::DPI).unwrap();
    assert_eq!(text.matches("<circle").count(), 2 * expected.len());
}

#[test]
fn a_scatter_without_colour_has_no_bar_and_metrics_may_have_logarithms() {
    let study = sampled(
        200,
        r#""kind": "scatter", "x": "max_error", "y": "rms_error", "y_scale": "log""#,
    );
    let (sheet, cases) = drawn(&study);
    let positive = |c: &&Case| rms(c).is_some_and(|x| x > 0.0);
    let expected: Vec<_> = cases
        .iter()
        .filter(positive)
        .map(|c| ([2.0 * number(c, "dT"), rms(c).unwrap()], None))
        .collect();
    let panel = &sheet.panels[0];
    assert_eq!(dots(panel.cloud.as_ref().unwrap()), expected);
    assert!(panel.map.is_none());
    assert_eq!(panel.y.scale, Scale::Log);
}

#[test]
fn a_matrix_of_samples_has_every_pair_once_and_the_metric_last() {
    let study = sampled(
        100,
        r#""kind": "samples", "y": "rms_error", "y_scale": "log""#,
    );
    let (sheet, cases) = drawn(&study);
    let shown: Vec<&Case> = cases
        .iter()
        .filter(|c| rms(c).is_some_and(|x| x > 0.0))
        .collect();
    let column = |name: &'static str| {
        shown.iter().map(move |c| match name {
            "rms_error" => rms(c).unwrap(),
            name => number(c, name),
        })
    };
    // In the order of the file; the metric's row is the last.
    let pairs = [
        ("alpha", "dT"),
        ("alpha", "x0"),
        ("dT", "x0"),
        ("alpha", "rms_error"),
        ("dT", "rms_error"),
        ("x0", "rms_error"),
    ];
    assert_eq!(sheet.panels.len(), pairs.len());
    for (panel, (x, y)) in sheet.panels.iter().zip(pairs) {
        let places = column(x).zip(column(y)).map(|(x, y)| [x, y]);
        let expected: Vec<_> = places.zip(column("rms_error").map(Some)).collect();
        assert_eq!(dots(panel.cloud.as_ref().unwrap()), expected, "{x} {y}");
        let log = |name| match name {
            "alpha" | "rms_error" => Scale::Log,
            _ => Scale::Linear,
        };
        assert_eq!([panel.x.scale, panel.y.scale], [log(x), log(y)], "{x} {y}");
    }
    // Parameters are named once, below their column and left of their row; one bar has the colours.
    let titles = |of: fn(&slipgap_drawing::layout::sheet::Panel) -> &str| -> Vec<&str> {
        let titles = sheet.panels.iter().map(of);
        titles.filter(|title| !title.is_empty()).collect()
    };
    assert_eq!(titles(|p| &p.x.title), ["*α*", "Δ*T*", "*X*_0_"]);
    assert_eq!(titles(|p| &p.y.title), ["Δ*T*", "*X*_0_", "rms error"]);
    let maps: Vec<bool> = sheet.panels.iter().map(|p| p.map.is_some()).collect();
    assert_eq!(maps, [false, false, false, false, false, true]);
}

#[test]
fn many_dots_are_one_image_of_the_same_dots() {
    let study = sampled(
        20_000,
        r#""kind": "scatter", "x": "alpha", "y": "x0", "x_scale": "log", "colour": "max_error""#,
    );
    let (mut sheet, _) = drawn(&study);
    let text = svg(&sheet, style::DPI).unwrap();
    assert_eq!(text.matches("<circle").count(), 0);
    assert_eq!(
        text.matches("<image").count() + text.matches("data:image/png;base64,").count(),
        2
    );
    // Colours independent of places are the hardest to compress. No number of dots gives more than 690 x 507 pixels of 3
    // bytes, which are 1.4 MB as base64.
    assert!(text.len() < 1_000_000, "{}", text.len());
    // The PNG has the image where it has the shapes: dots drawn alone, without an outline, differ at the edges of
    // pixels only.
    let cloud = sheet.panels[0].cloud.as_mut().unwrap();
    assert!(cloud.image && cloud.dots.len() == 20_000);
    cloud.dots.truncate(MOST_SHAPES);
    let dark = |sheet: &Sheet| -> f64 {
        let bytes = png(sheet, style::DPI).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        pixels.iter().map(|x| 255.0 - f64::from(*x)).sum()
    };
    let image = dark(&sheet);
    let cloud = sheet.panels[0].cloud.as_mut().unwrap();
    let dots = std::mem::take(&mut cloud.dots);
    let empty = dark(&sheet);
    let cloud = sheet.panels[0].cloud.as_mut().unwrap();
    (cloud.dots, cloud.image) = (dots, false);
    let shapes = dark(&sheet);
    // Outlines make the shapes darker: of a radius of 0.6 they take 0.48 to 0.73, black, and colours are half dark.
    assert!(image > 1.1 * empty, "{empty} {image}");
    assert!(
        shapes > image && shapes - empty < 3.0 * (image - empty),
        "{empty} {image} {shapes}"
    );
}
