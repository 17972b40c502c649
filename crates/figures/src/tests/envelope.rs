//! Envelopes: metrics along the structure.

use super::{sheet_of, shown};
use slipgap_drawing::layout::sheet::Sheet;

/// The sheet of an envelope of two masses in the cases of the parameters, with metrics by case and column.
fn sheet(parameters: &str, figure: &str, value: impl Fn(usize, usize) -> Option<f64>) -> Sheet {
    let text = format!(
        r#"{{"problem": "structure", {parameters}, "metrics": ["max(a)", "max(b - a)", "min(a)", "min(b - a)"],
          "structure": {{"units": "t, kN, m, s", "masses": {{"a|b": 1}}, "rayleigh": {{"mass": "0*s*n"}},
            "springs": [{{"between": ["ground", "a"], "k": 1}}, {{"between": ["a", "b"], "k": 1}}]}},
          "figures": [{{"name": "f", "kind": "envelope", {figure}}}]}}"#
    );
    let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    let cases: Vec<_> = study.cases().collect();
    let row = |case: usize| (0..4).map(|column| value(case, column)).collect();
    let metrics: Vec<Vec<Option<f64>>> = (0..cases.len()).map(row).collect();
    sheet_of(
        &study,
        &study.figures[0],
        &shown(&study, &cases, &metrics).all(),
    )
}

const PARAMETERS: &str =
    r#""parameters": {"dt": 0.1, "duration": 1, "s": [1, 2, 3, 4, 5], "n": 7}"#;
const ALL: &str = r#""x": ["max(a)", "max(b - a)", "min(a)", "min(b - a)"], "at": [3, 6.5]"#;

#[test]
fn each_case_has_its_values_at_their_positions() {
    let number = |case: usize, column: usize| 10.0 * case as f64 - 3.0 * column as f64;
    let sheet = sheet(PARAMETERS, ALL, |case, column| Some(number(case, column)));
    let [panel] = &sheet.panels[..] else {
        panic!("{} panels", sheet.panels.len())
    };
    assert_eq!(
        [&*panel.x.title, &*panel.y.title],
        ["Displacement, m", "Position"]
    );
    let curves: Vec<_> = panel
        .series
        .iter()
        .filter(|curve| !curve.label.is_empty())
        .collect();
    for (i, curve) in curves.iter().enumerate() {
        let (case, first) = (i / 2, 2 * (i % 2));
        let expected = [[number(case, first), 3.0], [number(case, first + 1), 6.5]];
        assert_eq!(
            (&curve.label, &curve.points[..]),
            (&format!("*s* = {}", case + 1), &expected[..])
        );
    }
    assert_eq!(
        (curves.len(), panel.bands.len(), sheet.legend.len()),
        (10, 0, 5)
    );
}

#[test]
fn an_ensemble_has_its_median_on_a_band() {
    let ensemble = format!(r#"{PARAMETERS}, "ensemble": "s""#);
    let figure = r#""x": ["max(a)", "max(b - a)"], "band": [0, 0.75], "x_title": "Drift, m", "at_title": "Storey""#;
    // Without the value of a case the others count.
    let value = |case: usize, column: usize| match (case, column) {
        (4, 1) => None,
        _ => Some([5.0, 1.0, 9.0, 2.0, 7.0][case] + column as f64),
    };
    let sheet = sheet(&ensemble, figure, value);
    let panel = &sheet.panels[0];
    assert_eq!([&*panel.x.title, &*panel.y.title], ["Drift, m", "Storey"]);
    // 1, 2, 5, 7, 9, and 2, 3, 6, 10, whose median is 4.5 and 0.75 quantile 6 + 1/4 of 4.
    assert_eq!(panel.series[0].points, [[5.0, 1.0], [4.5, 2.0]]);
    assert_eq!(panel.bands[0].lower, [[1.0, 1.0], [2.0, 2.0]]);
    assert_eq!(panel.bands[0].upper, [[7.0, 1.0], [7.0, 2.0]]);
    assert_eq!(
        (panel.series.len(), panel.bands.len(), panel.x.range[0]),
        (1, 1, 0.0)
    );
    let words: Vec<&str> = sheet.small_print.iter().map(|line| &*line.text).collect();
    assert_eq!(
        words,
        [
            "Lines: medians of 4 to 5 cases. Bands: from the 0 % to the 75 % quantile.",
            "Without 1 of 5 cases, in which max(b - a) is empty."
        ]
    );
}
