//! Response figures and Poincare sections of structures.

use super::drawn;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_study::{self, Study};
use std::f64::consts::{PI, TAU};

/// The points of each curve with a label, in the order of drawing.
fn points(panel: &Panel) -> Vec<(String, Vec<[f64; 2]>)> {
    let curves = panel
        .series
        .iter()
        .filter(|series| !series.label.is_empty());
    let points = |series: &Series| {
        let finite = series
            .points
            .iter()
            .copied()
            .filter(|point| point[0].is_finite());
        (series.label.clone(), finite.collect())
    };
    curves.map(points).collect()
}

fn sheet(study: &Study) -> Sheet {
    drawn(study, 0).0
}

/// Half the largest difference of points that count as one, as part of the axis: a tenth of a typographic point on a panel of 130
/// points or more.
const ONE: f64 = 0.1 / 130.0;

/// Sweeps in steps of 0.1 of the frequency.
fn swept(sweeps: &str, parts: &str, figure: &str) -> Study {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{{sweeps}}},
          "zip": [["from", "to"]], "metrics": ["peak(x)"],
          "structure": {{"units": "kg, N, m, s", "masses": {{"x": 1}}, {parts},
            "loads": [{{"at": "x", "pulse": {{"stepped_sweep": {{"amplitude": 1, "from": "from", "to": "to", "steps": "steps",
              "duration": "duration", "sampled": "dt"}}}}}}]}}, "figures": [{{"name": "f", {figure}}}]}}"#
    );
    slipgap_study::parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn a_linear_oscillator_has_its_amplification_up_and_down() {
    let (ratio, dt) = (0.1, 0.01);
    let spring =
        r#""springs": [{"between": ["ground", "x"], "mass": 1, "period": 1, "ratio": 0.1}]"#;
    let amplitude = |f: f64| {
        // The average acceleration has the steady motion of the frequency (2/dt) tan(omega dt/2), with the load at the steps.
        let omega = 2.0 / dt * (PI * f * dt).tan();
        let k = TAU * TAU;
        let (real, imaginary) = (k - omega * omega, 2.0 * ratio * TAU * omega);
        let size = real.hypot(imaginary);
        (1.0 / size, -imaginary / (size * size))
    };
    for each in ["peak", "max", "min", "start"] {
        let study = swept(
            r#""from": [0.5, 1.5], "to": [1.5, 0.5], "steps": 11, "dt": 0.01, "duration": "30*steps""#,
            spring,
            &format!(r#""kind": "response", "y": "x", "each": "{each}""#),
        );
        let sheet = sheet(&study);
        let panel = &sheet.panels[0];
        assert_eq!(panel.x.title, "Frequency of the excitation, Hz");
        let curves = points(panel);
        assert_eq!(curves.len(), 2);
        let height = panel.y.range[1] - panel.y.range[0];
        for (_, points) in &curves {
            let mut frequencies: Vec<f64> = points.iter().map(|point| point[0]).collect();
            frequencies.dedup();
            assert_eq!(frequencies.len(), 11);
            for [f, value] in points {
                let (size, sine) = amplitude(*f);
                // Steps miss the peak by up to half a step; a start is straight between two steps. What remains of the start after 22
                // periods is exp(-0.1 2 pi 22) = 1e-6.
                let missed = size * 0.5 * (PI * f * dt).powi(2);
                let (expected, error) = match each {
                    "peak" | "max" => (size - 0.5 * missed, 0.5 * missed),
                    "min" => (0.5 * missed - size, 0.5 * missed),
                    _ => (sine, size * (TAU * f * dt).powi(2) / 8.0),
                };
                let error = error + 2e-6 * size;
                assert!(
                    (value - expected).abs() < error,
                    "{each} {f}: {value} {expected}"
                );
            }
            // Each frequency has one place: the motion repeats.
            for pair in points.windows(2).filter(|pair| pair[0][0] == pair[1][0]) {
                assert!(
                    (pair[0][1] - pair[1][1]).abs() < 4.0 * ONE * height,
                    "{pair:?}"
                );
            }
        }
    }
}

#[test]
fn a_damped_oscillator_with_friction_has_den_hartogs_amplitude() {
    // Den Hartog (1931), with the viscous damping z and without stops: x0 = sqrt((a V)^2 - (x_f H)^2) - x_f G, x_f = limit/k.
    let (k, z, friction, dt) = (TAU * TAU, 0.05, 0.3, 0.005);
    let root = (1.0f64 - z * z).sqrt();
    let parts = r#""springs": [{"between": ["ground", "x"], "mass": 1, "period": 1, "ratio": 0.05}],
      "contacts": {"f": {"law": "coulomb", "between": ["ground", "x"], "limit": 0.3}}"#;
    let study = swept(
        r#""from": [0.7, 1.5], "to": [1.5, 0.7], "steps": 9, "dt": 0.005, "duration": "60*steps""#,
        parts,
        r#""kind": "response", "y": "x""#,
    );
    let curves = points(&sheet(&study).panels[0]);
    assert_eq!(curves.len(), 2);
    for [rho, peak] in curves.into_iter().flat_map(|(_, points)| points) {
        let [decay, turn] = [z * PI / rho, root * PI / rho];
        let below = decay.cosh() + turn.cos();
        let g = (decay.sinh() - z / root * turn.sin()) / below;
        let h = turn.sin() / (rho * root) / below;
        let v = (1.0 - rho * rho).hypot(2.0 * z * rho).recip();
        let expected = ((v * v - (friction * h).powi(2)).sqrt() - friction * g) / k;
        // The force turns at a step, up to half of it too late or early, as if a part of 2 pi rho dt were missing; steps miss the peak.
        let turn_error = friction / k * TAU * rho * dt * v;
        let missed = 0.5 * (PI * rho * dt).powi(2) * expected;
        assert!(
            (peak - expected).abs() < turn_error + missed,
            "{rho}: {peak} {expected}"
        );
    }
}

#[test]
fn a_section_has_the_points_at_the_start_of_each_cycle() {
    // Undamped from its steady motion X sin(omega t): at the start of a cycle x = 0 and v = omega X.
    let text = |sine: &str, figure: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 20.25, "omega": ["pi", "3*pi"], "v": "omega/(4*pi^2 - omega^2)"}},
              "metrics": ["peak(x)"],
              "structure": {{"masses": {{"x": 1}}, "springs": [{{"between": ["ground", "x"], "mass": 1, "period": 1, "ratio": 0}}],
                "loads": [{{"at": "x", "sine": {{"amplitude": 1, {sine}}}}}], "start": {{"x": {{"v": "v"}}}}}},
              "figures": [{{"name": "f", {figure}}}]}}"#
        )
    };
    let section = r#""kind": "curve", "x": "x", "y": "x.v", "section": true"#;
    let parsed = |sine, figure: &str| slipgap_study::parse("s", &text(sine, figure));
    let study = parsed(r#""omega": "omega""#, section).unwrap_or_else(|e| panic!("{e}"));
    let sheet = sheet(&study);
    let curves = points(&sheet.panels[0]);
    for ((_, points), (omega, cycles)) in curves.iter().zip([(PI, 10), (3.0 * PI, 30)]) {
        assert_eq!(points.len(), cycles);
        let size = 1.0 / (TAU * TAU - omega * omega);
        for [x, v] in points {
            // The steps are of second order: a phase of omega t (omega dt)^2/12 after 20, and a free motion of the same size.
            let error = 20.0 * TAU * (TAU * 0.015).powi(2) / 12.0 * 2.0 * size.abs();
            assert!(
                x.abs() < error && (v - omega * size).abs() < TAU * error,
                "{omega}: {x} {v}"
            );
        }
    }
    // A response over a parameter.
    let over = r#""kind": "response", "y": "x", "x": "omega", "cycles": 3"#;
    let study = parsed(r#""omega": "omega""#, over).unwrap_or_else(|e| panic!("{e}"));
    let response = drawn(&study, 0).0;
    assert_eq!(
        response.small_print[0].text,
        "Points: the last 3 cycles of each omega."
    );
    let curves = points(&response.panels[0]);
    let mut at: Vec<f64> = curves[0].1.iter().map(|point| point[0]).collect();
    at.dedup();
    assert_eq!((curves.len(), at), (1, vec![PI, 3.0 * PI]));
    for (sine, figure, message) in [
        (
            r#""omega": 0"#,
            section,
            "figures[0].section: needs a sine, sweep or stepped_sweep",
        ),
        (
            r#""omega": 0.1"#,
            section,
            "figures[0].section: needs a sine",
        ),
        (
            r#""omega": 200"#,
            over,
            "figures[0].kind: needs at least 4 steps in a cycle",
        ),
        (
            r#""omega": "omega""#,
            r#""kind": "response", "y": "x", "cycles": 0.5"#,
            "figures[0].cycles: must be a whole number >= 1",
        ),
        (
            r#""omega": "omega""#,
            r#""kind": "response", "y": "x", "x_range": [2, 3]"#,
            "figures[0].x_range: shows nothing: the frequency is from 0.5 to 1.5",
        ),
        (
            r#""omega": "omega""#,
            r#""kind": "response", "y": "x", "each": "middle""#,
            "figures[0].each: unknown value \"middle\"",
        ),
    ] {
        let wrong = parsed(sine, figure)
            .err()
            .map(|e| e.to_string())
            .unwrap_or_default();
        assert!(wrong.contains(message), "{wrong}");
    }
}
