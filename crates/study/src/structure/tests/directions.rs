//! Springs with a direction at supports that are named without one.

use super::{faults, solved, study};

fn text(spring: &str, support: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}},
            "structure": {{"masses": {{"a": {{"mass": 2, "direction": "y"}}}},
              "springs": [{{{spring}, "k": 90, "c": 0.8}}],
              "supports": {{"left": {support}}}}},
            "metrics": ["peak(a)"],
            "figures": [{{"name": "h", "kind": "history", "y": "a"}}]}}"#
    )
}

const BOTH: &str =
    r#"{"x": {"sine": {"amplitude": 1, "omega": 3}}, "y": {"sine": {"amplitude": 2, "omega": 5}}}"#;

#[test]
fn a_spring_acts_in_its_direction_of_a_support() {
    let channels = |spring: &str| solved(&study(&text(spring, BOTH))).computed.channels;
    let named = channels(r#""between": ["left.y", "a"]"#);
    assert_ne!(named, channels(r#""between": ["left", "a"]"#));
    for spring in [
        r#""between": ["left", "a"], "direction": "y""#,
        r#""between": ["left.y", "a"], "direction": "y""#,
        r#""along": {"left": -1, "a": 1}, "direction": "y""#,
    ] {
        assert_eq!(named, channels(spring), "{spring}");
    }
}

#[test]
fn a_support_that_does_not_move_in_the_direction_is_a_fault() {
    let only_x = r#"{"sine": {"amplitude": 1, "omega": 3}}"#;
    let says = "left does not move in y; the node \"left.y\" is held there";
    for (spring, at) in [
        (
            r#""between": ["left", "a"], "direction": "y""#,
            "3:40: structure.springs[0].between[0]: ",
        ),
        (
            r#""along": {"left": -1, "a": 1}, "direction": "y""#,
            "3:38: structure.springs[0].along.left: ",
        ),
    ] {
        let found = faults(&text(spring, only_x));
        assert!(found.contains(&format!("{at}{says}")), "{found}");
    }
    assert_eq!(
        study(&text(r#""between": ["left.y", "a"]"#, only_x)).len(),
        1
    );
}
