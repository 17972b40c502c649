//! Faults of the key `calibrate`, each at its place.

use crate::Bench;

/// Runs a study with this `calibrate`, in which ¶ marks the place of the fault.
#[track_caller]
fn refused(calibrate: &str, expected: &str) {
    in_study(calibrate, "", expected);
}

#[track_caller]
fn in_study(calibrate: &str, more: &str, expected: &str) {
    let marked = format!(
        r#"{{ "problem": "structure",
  "parameters": {{ "dt": 0.01, "duration": 1, "law": ["impact", "hertz"], "k": 1000, "k_h": 5000, "gap": [0.1, 0.2], "v0": "2*x", "x": 0.5,
    "n": 4 }},
  "structure": {{ "masses": {{ "m": 1 }}, "bars": {{ "b": {{ "L": 1, "EA": 1, "mass": 1, "n": "n" }} }},
    "springs": [{{ "between": ["ground", "m"], "k": 100 }}],
    "contacts": {{ "g": {{ "law": "law", "between": ["ground", "m"], "gap": "gap", "k": "k", "k_h": "k_h" }} }},
    "start": {{ "m": {{ "v": "v0" }} }} }},
  "calibrate": {calibrate}{more} }}"#
    );
    let (before, after) = marked.split_once('¶').unwrap();
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap().chars().count() + 1;
    let bench = Bench::new();
    bench.file("s.json", format!("{before}{after}"));
    for verb in ["run", "check", "explain", "calibrate"] {
        let done = bench.expect(2, &[verb, "s.json"]);
        let first = done.err.lines().next().unwrap_or_default();
        let expected = format!("s.json:{line}:{column}: {expected}");
        assert!(
            first.starts_with(&expected),
            "{verb}: {}\nexpected {expected}",
            done.err
        );
        let faults = done.err.lines().filter(|line| !line.starts_with("  | "));
        assert_eq!(faults.count(), 1, "{verb}: {}", done.err);
    }
    assert_eq!(bench.tree("."), ["s.json"], "nothing is written");
}

const MINIMISE: &str = r#""minimise": "peak(m.u)""#;

/// A range of one parameter.
#[track_caller]
fn range(free: &str, expected: &str) {
    refused(
        &format!("{{ {free}, {MINIMISE} }}"),
        &format!("calibrate.{expected}"),
    );
}

#[test]
fn parameters_that_cannot_be_free() {
    range(
        r#""K_h": ¶[1, 2]"#,
        "K_h: unknown key \"K_h\", did you mean \"k_h\"?",
    );
    range(
        r#"¶"gap": [0.1, 0.2]"#,
        "gap: \"gap\" is an axis; a free parameter has one value",
    );
    range(
        r#""k": [1, 2], "varies": ¶["k"]"#,
        "varies: needs several tests: \"file\" of \"measured\" as an axis",
    );
    range(
        r#"¶"v0": [0.1, 0.2]"#,
        "v0: \"v0\" is given by the expression \"2*x\"; name the parameters",
    );
    range(
        r#"¶"law": [1, 2]"#,
        "law: the values of \"law\" are names; only numbers can be free",
    );
    range(
        r#"¶"dt": [0.001, 0.01]"#,
        "dt: \"dt\" is no property of the structure",
    );
    range(
        r#"¶"duration": [1, 2]"#,
        "duration: \"duration\" is no property of the structure",
    );
    range(
        r#""k": [1, 2], "k": ¶[1, 3]"#.replace("\"k\": ¶[", "¶\"k\": [").as_str(),
        "k: key \"k\" is given twice",
    );
}

#[test]
fn ranges() {
    range(
        r#""k": ¶5"#,
        "k: must be a range [a, b] or {\"log\": [a, b]}, got 5",
    );
    range(
        r#""k": ¶[1, 2, 3]"#,
        "k: must be a range [a, b] or {\"log\": [a, b]}, got a list of 3",
    );
    range(r#""k": [5, ¶2]"#, "k[1]: must be greater than a = 5, got 2");
    range(
        r#""k": {"log": [¶0, 2]}"#,
        "k.log[0]: must be > 0 for a logarithm, got 0",
    );
    range(r#""k": {"log": ¶7}"#, "k.log: must be [a, b], got 7");
    range(r#""k": ¶{}"#, "k.log: missing");
    range(
        r#""k": {"logarithmic": ¶[1, 2]}"#,
        "k.logarithmic: unknown key \"logarithmic\", did you mean \"log\"?",
    );
    range(
        r#""k": [¶"1 mm", 2]"#,
        "k[0]: \"1 mm\": a number is written without a unit",
    );
}

#[test]
fn what_is_minimised() {
    refused(
        r#"¶{ "k": [1, 2] }"#,
        "calibrate.minimise: missing: the metric",
    );
    refused(
        &format!("¶{{ {MINIMISE} }}"),
        "calibrate: names no free parameter; give the range of one",
    );
    refused("¶[]", "calibrate: must be an object");
    let minimise = |metric: &str, expected: &str| {
        let calibrate = format!(r#"{{ "k": [1, 2], "minimise": ¶"{metric}" }}"#);
        refused(&calibrate, &format!("calibrate.minimise: {expected}"));
    };
    minimise("misfit", "unknown metric \"misfit\"");
    minimise("peak(q.u)", "\"peak(q.u)\": ");
    minimise(
        "peak(m.u) relative to law = impact",
        "\"peak(m.u) relative to law = impact\" needs several cases",
    );
    minimise(
        "rms_error(m.u, measured)",
        "\"rms_error(m.u, measured)\" needs the key \"measured\"",
    );
    refused(
        r#"{ "k": [1, 2], "minimise": ¶3 }"#,
        "calibrate.minimise: must be a string",
    );
}

#[test]
fn numbers_of_the_search() {
    let with = |key: &str, expected: &str| {
        refused(
            &format!(r#"{{ "k": [1, 2], {MINIMISE}, {key} }}"#),
            &format!("calibrate.{expected}"),
        );
    };
    with(
        r#""seed": ¶1.5"#,
        "seed: must be a whole number from 0 to 9007199254740992, got 1.5",
    );
    with(
        r#""cases": ¶10"#,
        "cases: must be a whole number from 100 to 1000000000, got 10",
    );
}

#[test]
fn more_alternatives_than_searches() {
    let calibrate = format!(r#"¶{{ "k": [1, 2], {MINIMISE} }}"#);
    in_blocks(
        &calibrate,
        "calibrate: 1001 combinations; a study with \"calibrate\" has at most 1000 tests",
    );
}

/// The same with an axis of 1001 values.
#[track_caller]
fn in_blocks(calibrate: &str, expected: &str) {
    let marked = format!(
        r#"{{ "problem": "structure", "parameters": {{ "dt": 0.01, "duration": 1, "k": 5, "m": {{"linspace": [1, 2, 1001]}} }},
  "structure": {{ "masses": {{ "m": "m" }}, "springs": [{{ "between": ["ground", "m"], "k": "k" }}] }},
  "calibrate": {calibrate} }}"#
    );
    let bench = Bench::new();
    bench.file("s.json", marked.replace('¶', ""));
    let done = bench.expect(2, &["calibrate", "s.json"]);
    let expected = format!("s.json:3:16: {expected}");
    assert!(done.err.starts_with(&expected), "{}", done.err);
}

#[test]
fn figures_with_a_name_of_a_calibration() {
    in_study(
        &format!(r#"{{ "k": [1, 2], {MINIMISE} }}"#),
        r#", "figures": [{ "name": ¶"measured", "kind": "history", "y": "m.u" }]"#,
        "figures[0].name: \"measured\" is the name of a figure of `slipgap calibrate`",
    );
}

#[test]
fn other_problems_have_no_calibration() {
    let bench = Bench::new();
    let study = r#"{ "problem": "friction-oscillator", "parameters": { "law": "velocity-control", "beta": 1, "dT": 0.1, "duration": 9 },
  "calibrate": { "beta": [1, 2], "minimise": "rms_error" } }"#;
    bench.file("s.json", study);
    let done = bench.expect(2, &["run", "s.json"]);
    let expected =
        "s.json:2:16: calibrate: only a study with \"problem\": \"structure\" has this key";
    assert!(done.err.starts_with(expected), "{}", done.err);
}
