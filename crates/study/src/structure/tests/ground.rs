//! The ground motion of a case.

use crate::parse;
use slipgap_problem::problem::structure::GroundMotion;

/// The ground motion of the first case of a study with one mass and this ground.
fn motion(ground: &str) -> GroundMotion {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 2}}, "metrics": ["peak(m)"],
          "structure": {{"units": "t, daN, cm, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 1}}],
            "ground": {ground}}}}}"#
    );
    let study = parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    study
        .problem
        .as_structure()
        .unwrap()
        .ground_motion(&study.case(0).unwrap())
        .unwrap()
}

#[test]
fn a_table_is_scaled_and_a_sine_acts_until_the_end() {
    let table = motion(r#"{"table": {"t": [0, 1], "f": [2, -4]}, "scale": 0.5}"#);
    assert_eq!(table.units, ["cm", "s"]);
    let table = table.acceleration;
    assert_eq!(
        (table.times(), table.values()),
        (&[0.0, 1.0][..], &[1.0, -2.0][..])
    );
    let sine = motion(r#"{"sine": {"amplitude": 3, "omega": 5, "phase": 0.5}}"#).acceleration;
    for t in [0.0, 0.123, 0.77, 1.999] {
        // The error of the chords, see POINTS.
        let exact = 3.0 * libm::sin(5.0 * t + 0.5);
        assert!((sine.at(t) - exact).abs() <= 3.0 * 3.1e-5, "{t}");
    }
    assert_eq!(sine.at(2.0), 0.0);
}
