//! Supports with motions of their own: against the ground with the same motion, and against solutions that come from no method.

use super::{faults, solved, study};
use slipgap_solver::problem::Solution;

/// The channels of the history of a study.
fn channels(text: &str) -> Vec<Vec<f64>> {
    solved(&study(text)).computed.channels
}

/// A record with a jump at its start and a velocity that does not end at 0.
const SHAKE: &str =
    r#"{"table": {"t": [0, 0.31, 0.8, 1.1, 2.05, 3], "f": [0.6, 4, -7, 5, -2, 1]}, "scale": 1.3}"#;

/// Two blocks with a gap between them, one of them on springs, the other on a bearing, and a bar with stiffness damping.
fn chain(method: &str, laws: [&str; 2], shaken: &str, ends: [&str; 2], y: &str) -> String {
    let [left, right] = ends;
    let [stop, bearing] = laws;
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 6, "method": "{method}"}},
            "structure": {{"masses": {{"a": 2, "b": 3, "deck": 4}},
              "bars": {{"bar": {{"L": 3, "EA": 900, "mass": 1.5, "n": 4, "stiffness_damping": 0.002}}}},
              "springs": [{{"between": ["{left}", "a"], "k": 90, "c": 0.8}}, {{"between": ["a", "b"], "k": 40, "c": 0.3}},
                          {{"between": ["{right}", "bar.right"], "k": 300}}],
              "contacts": {{"gap": {{{stop}, "between": ["b", "bar.left"], "gap": 0.02}},
                            "bearing": {{{bearing}, "between": ["{right}", "deck"]}},
                            "other": {{{bearing}, "between": ["{left}", "deck"]}}}},
              {shaken}}},
            "metrics": ["energy_error", "numerical_dissipation", "impacts(gap)"],
            "figures": [{{"name": "h", "kind": "history", "y": {y}}}]}}"#
    )
}

const LAWS: [[&str; 2]; 2] = [
    [
        r#""law": "impact", "k": 4000"#,
        r#""law": "displacement-control", "k": 700, "limit": 6"#,
    ],
    [
        r#""law": "kelvin-voigt", "k": 4000, "restitution": 0.6"#,
        r#""law": "velocity-control", "limit": 6, "rdotE": 1e-3"#,
    ],
];

#[test]
fn supports_with_one_motion_are_the_ground_with_it() {
    let relative = r#"["a - left", "b - left", "bar.2 - right", "deck - left", "gap.r", "bearing.S", "b.v - left.v"]"#;
    let plain = r#"["a", "b", "bar.2", "deck", "gap.r", "bearing.S", "b.v"]"#;
    for method in ["average-acceleration", "bathe", "hht-alpha", "newmark"] {
        for laws in LAWS {
            let ground = format!(r#""ground": {SHAKE}"#);
            let supports = format!(r#""supports": {{"left": {SHAKE}, "right": {SHAKE}}}"#);
            let ground = solved(&study(&chain(method, laws, &ground, ["ground"; 2], plain)));
            let text = chain(method, laws, &supports, ["left", "right"], relative);
            let supports = solved(&study(&text));
            agree(&ground, &supports, 7, 1e-10);
            assert!(ground.metrics[2] > Some(1.0), "{method}");
            // The books close: round-off of 600 steps.
            assert!(
                supports.metrics[0].unwrap() < 1e-11,
                "{method}: {:?}",
                supports.metrics
            );
        }
    }
}

/// The first `count` channels of both agree within a part of their peaks.
fn agree(a: &Solution, b: &Solution, count: usize, part: f64) {
    for k in 0..count {
        let (a, b) = (&a.computed.channels[k], &b.computed.channels[k]);
        let peak = a.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
        let difference = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        let difference = difference.fold(0.0, f64::max);
        assert!(
            peak > 0.0 && difference < part * peak,
            "{k}: {difference:e} of {peak}"
        );
    }
}

#[test]
fn dummy() {
    let _ = channels;
    let _ = faults("{}");
}
