//! Bar impact studies with faults.

use crate::bad::files::refused;
use crate::{Bench, bars};

/// A study of bars with these parameters; see [`refused`].
#[track_caller]
fn bad(parameters: &str, expected: &[&str]) {
    refused(&bars(parameters, ""), expected);
}

/// The same with valid values of the required parameters.
#[track_caller]
fn bad_with_required(more: &str, expected: &[&str]) {
    bad(
        &format!("\"gamma\": 1, \"n\": 10, \"dt\": 0.1, \"duration\": 1.5, {more}"),
        expected,
    );
}

#[test]
fn number_of_elements() {
    for n in ["0", "2.5", "-3", "1e9", "1000001", "\"1/3\""] {
        let parameters = format!("\"n\": ¶{n}, \"gamma\": 1, \"dt\": 0.1, \"duration\": 1.5");
        let expected = format!("parameters.n: must be a whole number from 1 to 1000000, got {n}");
        bad(&parameters, &[&expected]);
    }
}

#[test]
fn stiffness() {
    let rest = r#""n": 10, "dt": 0.1, "duration": 1.5"#;
    bad(
        &format!("\"gamma\": 1, \"k_I\": ¶100, {rest}"),
        &["parameters.k_I: cannot be given together with gamma; give exactly one of gamma, k_I"],
    );
    let neither = bars(rest, "").replace(": { ", ": ¶{ ");
    refused(
        &neither,
        &["parameters.gamma: missing: give exactly one of gamma, k_I"],
    );
    bad(
        &format!("\"k_I\": ¶0, {rest}"),
        &["parameters.k_I: must be > 0, got 0"],
    );
    let misspelt = bars(&format!("\"k_i\": ¶5, {rest}"), "").replace(": { ", ": ¶{ ");
    refused(
        &misspelt,
        &[
            "parameters.gamma: missing: give exactly one of gamma, k_I",
            "parameters.k_i: unknown key \"k_i\", did you mean \"k_I\"?",
        ],
    );
}

#[test]
fn times_and_gap() {
    bad(
        r#""gamma": 1, "n": 10, "dt": ¶1.6, "duration": 1.5"#,
        &["parameters.dt: must be at most duration = 1.5, got 1.6"],
    );
    bad_with_required(
        "\"gap\": ¶-1e-9",
        &["parameters.gap: must be >= 0, got -1e-9"],
    );
}

#[test]
fn bars_that_do_not_approach() {
    let left = "parameters.V0: the bars must close: V0 of the left bar (";
    bad_with_required("\"V0\": ¶-0.1", &[left]);
    bad_with_required("\"V0\": ¶0", &[left]);
    bad_with_required("\"V0\": ¶0, \"right\": \"wall\"", &[left]);
    bad_with_required("\"V0\": ¶1, \"right\": { \"V0\": 1 }", &[left]);
    bad_with_required(
        "\"V0\": [¶0.2, 0.4, ¶-3], \"right\": { \"V0\": 0.3 }",
        &[
            "parameters.V0[0]: the bars must close",
            "parameters.V0[2]: the bars must close",
        ],
    );
    // The left bar has its default velocity, so the fault is in the right bar.
    bad_with_required(
        "\"right\": { \"V0\": ¶0.1 }",
        &[
            "parameters.right.V0: the bars must close: V0 of the left bar (0.1) must be greater than that of the right (0.1)",
        ],
    );
}

#[test]
fn mass_and_right_bar() {
    bad_with_required(
        "\"mass\": ¶\"lumpd\"",
        &[
            "parameters.mass: unknown mass \"lumpd\", did you mean \"lumped\"?; allowed: lumped, consistent, massless-contact",
        ],
    );
    bad_with_required(
        "\"right\": ¶\"wal\"",
        &["parameters.right: unknown right \"wal\", did you mean \"wall\"?"],
    );
    bad_with_required(
        "\"right\": { \"L\": ¶-1, \"n\": ¶0, \"m\": ¶1 }",
        &[
            "parameters.right.L: must be > 0, got -1",
            "parameters.right.n: must be a whole number from 1 to 1000000, got 0",
            "parameters.right.m: unknown key \"m\"; allowed: E, A, rho, L, n, V0",
        ],
    );
}

#[test]
fn cases_too_large_for_memory_are_faults() {
    bad(
        r#""gamma": 1, "n": 10, "dt": ¶1e-12, "duration": 1.5"#,
        &["parameters.dt: gives 1.500e12 steps, at most "],
    );
    bad(
        r#""gamma": 1, "n": 10, "dt": 0.1, "duration": ¶1.5, "right": { "L": 1e-9 }"#,
        &[
            "parameters.duration: waves would travel 1.500e10 times through the shorter bar; allowed: at most 1e5;",
        ],
    );
}

#[test]
fn numbers_beyond_double_precision() {
    bad_with_required(
        "\"V0\": ¶1e308",
        &["parameters.V0: the closing speed is outside the range of double precision"],
    );
    let unlike = bars(
        r#""gamma": 1, "n": 10, "dt": 0.1, "duration": 1.5, "right": { "E": 1e-300, "rho": 1e-300 }"#,
        "",
    );
    refused(
        &unlike.replace(": { \"gamma", ": ¶{ \"gamma"),
        &["parameters.right: the bars differ too much"],
    );
}

#[test]
fn filters_use_dotted_names_for_the_right_bar() {
    let lengths = r#""gamma": 1, "n": 10, "dt": 0.1, "duration": 1.5, "right": { "L": [10, 20] }"#;
    let check = r#", "checks": [{ "metric": "restitution", "max": 2, "where": { FILTER } }]"#;
    refused(
        &bars(
            lengths,
            &check.replace("FILTER", "\"right\": ¶{ \"L\": 20 }"),
        ),
        &["checks[0].where.right: must be a value; write \"right.L\" as one key"],
    );
    let bench = Bench::new();
    bench.file(
        "s.json",
        bars(lengths, &check.replace("FILTER", "\"right.L\": \"2*10\"")),
    );
    let done = bench.expect(0, &["check", "s.json"]);
    assert!(
        done.out.contains("\ns      1     restitution"),
        "{}",
        done.out
    );
}
