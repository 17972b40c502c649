//! Names of thin lines, headings of several lines, and the band of a computed history, on sheets of whole studies.

use crate::{FigureData, png, sheet, svg};
use slipgap_drawing::layout::envelope::IN_COLOUR;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_drawing::style;
use slipgap_drawing::text;

/// The sheet of the figure of a study that is solved first.
fn drawn(problem: &str, parameters: &str, figure: &str) -> Sheet {
    let text = format!(
        r#"{{"problem": "{problem}", "parameters": {{{parameters}}}, "figures": [{{"name": "f", {figure}}}]}}"#
    );
    let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    super::drawn(&study, 0).0
}

const BARS: &str = r#""k_I": 100, "n": 10, "dt": 0.05, "duration": 1"#;
const FRICTION: &str =
    r#""law": "displacement-control", "alpha": [0.1, 1], "dT": 0.3, "x0": 12, "duration": "8*pi""#;

#[test]
fn every_thin_line_but_zero_has_a_name() {
    let (bars, friction) = ("bar-impact", "friction-oscillator");
    for (problem, parameters, figure, name) in [
        (friction, FRICTION, r#""kind": "history""#, None),
        (friction, FRICTION, r#""kind": "law""#, None),
        (bars, BARS, r#""kind": "history""#, None),
        (
            bars,
            BARS,
            r#""kind": "profile", "times": [0.25]"#,
            Some("ends of the bars"),
        ),
        (bars, BARS, r#""kind": "wave""#, Some("contact")),
    ] {
        let sheet = drawn(problem, parameters, figure);
        let thin = |panel: &slipgap_drawing::layout::sheet::Panel| {
            let rules = panel.series.iter().filter(|s| s.label.is_empty());
            panel.zero || rules.count() > 0
        };
        assert!(sheet.panels.iter().any(thin), "{figure}");
        let mut entries = sheet.legend.iter();
        let thin: Vec<&str> = entries
            .clone()
            .filter(|entry| entry.width == style::ZERO_LINE)
            .map(|entry| entry.label.as_str())
            .collect();
        assert_eq!(thin, Vec::from_iter(name), "{figure}");
        assert!(entries.all(|entry| !entry.label.contains("zero")));
        let Some(name) = name else { continue };
        let text = svg(&sheet, style::DPI).unwrap();
        let parts = text.split(['<', '>']).skip_while(|part| *part != "desc");
        let description = parts.collect::<Vec<_>>()[1];
        assert!(
            description.split("; ").any(|part| part == name),
            "{description}"
        );
    }
}

#[test]
fn a_long_heading_takes_lines_that_fit() {
    let title = "Left bar of length 10; the exact restitution is the ratio of the shorter to the longer bar";
    let figure = |title: &str| {
        let figure = r#""kind": "metric", "x": "dT", "y": "rms_error""#;
        let parameters = FRICTION.replace("0.3", "[0.1, 0.2]");
        let figure = format!(r#"{figure}, "title": "{title}""#);
        drawn("friction-oscillator", &parameters, &figure)
    };
    let [long, short] = [title, "Short, with a thin\u{2009}space"].map(figure);
    assert_eq!(short.heading.len(), 1);
    assert_eq!(short.heading[0].text, "Short, with a thin\u{2009}space");
    let words: Vec<&str> = long.heading.iter().map(|line| line.text.as_str()).collect();
    assert_eq!(words.join(" "), title);
    assert_eq!(words.len(), 2);
    for line in &long.heading {
        let half = text::width(&line.text, line.size) / 2.0;
        assert!(line.at[0] - half >= style::EDGE - 1e-9);
        assert!(line.at[0] + half <= long.width - style::EDGE + 1e-9);
        // Over the line with the panel's letter.
        assert!(line.at[1] < long.panels[0].frame.top - style::LABEL_GAP);
    }
    assert!(long.heading[1].at[1] - long.heading[0].at[1] >= style::TITLE);
    assert!(long.panels[0].frame.top > short.panels[0].frame.top);
}

/// The contact mode keeps |rdot|/(2 V0) = 0.553 for gamma = 1, whatever n: see studies/impact-fig4-constant-gamma.json.
#[test]
fn a_stiff_contact_on_a_fine_mesh_is_a_band_as_high_as_its_mode() {
    let parameters = r#""gamma": 1, "n": [2, 10, 40], "dt": 0.002, "duration": 1.5"#;
    let figure = r#""kind": "history", "y": ["r", "rdot"], "panels": "n""#;
    let text = format!(
        r#"{{"problem": "bar-impact", "parameters": {{{parameters}}}, "figures": [{{"name": "f", {figure}}}]}}"#
    );
    let study = slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    // A period takes 3 points: 1 pixel of 20 an inch, and 8 of 192.
    let with = |dpi: u32| {
        let draw = |data: &FigureData| sheet(&FigureData { dpi, ..*data });
        super::drawn_by(&study, 0, draw).0
    };
    let fine = with(style::DPI);
    assert!(fine.panels.iter().all(|panel| panel.envelopes.is_empty()));
    assert!(!fine.description.contains(IN_COLOUR));
    let sheet = with(20);
    let bands: Vec<usize> = sheet.panels.iter().map(|p| p.envelopes.len()).collect();
    assert_eq!(bands, [0, 0, 0, 0, 0, 1]);
    let panel = &sheet.panels[5];
    let band = &panel.envelopes[0];
    let points = &panel.series[band.series].points;
    for edge in [&band.upper, &band.lower] {
        let within: Vec<f64> = edge
            .iter()
            .map(|i| points[*i])
            .filter(|p| (0.2..0.8).contains(&p[0]))
            .map(|p| p[1].abs())
            .collect();
        assert!(within.len() > 4);
        // Three digits, and what the waves of the mesh add.
        assert!(
            within.iter().all(|y| (y - 0.553).abs() < 0.01),
            "{within:?}"
        );
    }
    assert!(sheet.description.contains(IN_COLOUR));
    assert!(!sheet.small_print.is_empty());
    assert!(png(&sheet, style::DPI).is_ok());
}
