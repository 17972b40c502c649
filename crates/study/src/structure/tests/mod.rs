//! Metrics that compare with a run with start and loads 1e-10 larger, and labels of cases.

mod assembled;
mod channels;
mod contact_duration;
mod directions;
mod ground;
mod initial;
mod measured;
mod parts;
mod recorded;
mod samples;
mod supports;
mod ties;
mod titles;
mod windows;

use crate::{Study, parse};
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{Case, Solution};

fn study(text: &str) -> Study {
    parse("s", text).unwrap_or_else(|e| panic!("{e}"))
}

fn faults(text: &str) -> String {
    parse("s", text).unwrap_err().to_string()
}

/// An oscillator that is driven from a start against a stop of stiffness 1000, with start and load times a factor.
fn oscillator(omega: f64, gap: f64, factor: &str) -> Study {
    study(&format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.005, "duration": 400}},
            "structure": {{"masses": {{"x": 1}}, "springs": [{{"between": ["ground", "x"], "k": 1, "c": 0.02}}],
            "contacts": {{"stop": {{"law": "impact", "between": ["x", "ground"], "gap": {gap}, "k": 1000}},
                          "brake": {{"law": "velocity-control", "between": ["x", "ground"], "limit": 1e-9, "rdotE": 1}}}},
            "loads": [{{"at": "x", "sine": {{"amplitude": 1, "omega": {omega}}}, "scale": "1*{factor}"}}],
            "start": {{"x": {{"u": "0.01*{factor}"}}}}}},
            "metrics": ["difference(x)", "divergence(x, 0.01)", "impacts_before_divergence(x, 0.01)", "impacts(stop)",
                        "impacts_before_divergence(x, 1e300)"],
            "figures": [{{"name": "h", "kind": "history", "y": ["x", "stop.S"]}}]}}"#
    ))
}

fn solved(study: &Study) -> Solution {
    let case = study.case(0).unwrap();
    study.problem.solve(&case, &[]).unwrap()
}

#[test]
fn a_change_of_1e_10_stays_in_a_linear_structure_and_grows_in_chaos() {
    // Linear: the difference is 1e-10 of the motion, with a round-off of some 1e-16 of the peak in each of 80 000 steps at most.
    let solution = solved(&oscillator(2.85, 1000.0, "1"));
    let difference = solution.metrics[0].unwrap();
    // The brake has 1e-9 of the load and is not linear.
    assert!((difference - 1e-10).abs() < 1e-14, "{difference}");
    assert_eq!(
        solution.metrics[1..],
        [None, Some(0.0), Some(0.0), Some(0.0)]
    );
    // The driven oscillator with a one-sided stop is chaotic in bands of omega, periodic in others (Thompson and Ghaffari 1982).
    let chaotic = solved(&oscillator(2.85, 0.0, "1"));
    assert!(chaotic.metrics[0].unwrap() > 0.3, "{:?}", chaotic.metrics);
    assert!(chaotic.metrics[1].is_some());
    let periodic = solved(&oscillator(3.0, 0.0, "1"));
    let difference = periodic.metrics[0].unwrap();
    assert!(difference < 1e-9, "{difference}");
    let impacts = periodic.metrics[3];
    assert!(impacts.unwrap() > 100.0);
    assert_eq!(periodic.metrics[1..], [None, impacts, impacts, impacts]);
}

#[test]
fn the_metrics_of_divergence_are_those_of_two_separate_runs() {
    let (run, other) = (
        solved(&oscillator(2.85, 0.0, "1")),
        solved(&oscillator(2.85, 0.0, "(1 + 1e-10)")),
    );
    let [x, force] = [0, 1].map(|channel| run.computed.channel(channel));
    let peak = x.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
    let differences: Vec<f64> = x
        .iter()
        .zip(other.computed.channel(0))
        .map(|(x, other)| (x - other).abs())
        .collect();
    let first = differences.iter().position(|d| *d > 0.01 * peak).unwrap();
    let largest = differences.iter().fold(0.0, |a: f64, b| a.max(*b));
    // It starts closed, which counts.
    assert!(force[0] < 0.0);
    let closings = |until: usize| {
        let pairs = force[..until].windows(2);
        1.0 + pairs.filter(|s| s[0] == 0.0 && s[1] < 0.0).count() as f64
    };
    let expected = [
        largest / peak,
        first as f64 * 0.005,
        closings(first),
        closings(force.len()),
        closings(force.len()),
    ];
    assert_eq!(run.metrics, expected.map(Some));
    assert!(closings(first) > 10.0 && closings(first) < closings(force.len()));
}

#[test]
fn a_channel_that_is_always_0_has_no_difference() {
    let study = study(
        r#"{"problem": "structure", "parameters": {"dt": 0.1, "duration": 1}, "structure": {"masses": {"m": 1}},
            "metrics": ["difference(m)", "impacts_before_divergence(m, 1e-3)"]}"#,
    );
    assert_eq!(solved(&study).metrics, [None, Some(0.0)]);
}

/// Three oscillators with labels; `more` follows the parameters.
fn labelled(parameters: &str, more: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{{parameters}, "k": [1, 2, 3], "scale": [1, 4], "dt": 0.1, "duration": 5}},
            {more}, "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": "k"}}],
            "start": {{"m": {{"u": "scale"}}}}}}, "metrics": ["peak(m.v)", "difference(m)"]}}"#
    )
}

const BRIDGES: &str = r#""bridge": ["short", "long, soft", "2 unequal"]"#;
const ZIP: &str = r#""zip": [["bridge", "k"]]"#;

#[test]
fn a_label_tells_cases_apart_and_changes_no_result() {
    let plain = study(&labelled(
        r#""number": [1, 2, 3]"#,
        r#""zip": [["k", "number"]]"#,
    ));
    let study_of = |more: &str| study(&labelled(BRIDGES, &format!("{ZIP}{more}")));
    let labels = study_of("");
    assert_eq!(labels.len(), 6);
    let names: Vec<&str> = labels.cases().map(|case| case.choice("bridge")).collect();
    let (short, long, unequal) = ("short", "long, soft", "2 unequal");
    assert_eq!(names, [short, short, long, long, unequal, unequal]);
    let metrics = |study: &Study, case: &Case| study.problem.solve(case, &[]).unwrap().metrics;
    for (a, b) in plain.cases().zip(labels.cases()) {
        assert_eq!(a.number("k"), b.number("k"));
        assert_eq!(metrics(&plain, &a), metrics(&labels, &b));
    }
    // Conditions and filters name them.
    let some = study_of(r#", "when": "bridge != 'long, soft' and scale > 2""#);
    let ks: Vec<_> = some.cases().map(|case| case.number("k").unwrap()).collect();
    assert_eq!(ks, [1.0, 3.0]);
    let figure = r#", "figures": [{"name": "p", "kind": "metric", "x": "scale", "y": "peak(m.v)", "by": "bridge",
        "where": {"bridge": ["short", "2 unequal"]}}]"#;
    assert_eq!(study_of(figure).figures.len(), 1);
    let wrong = labelled(
        BRIDGES,
        &format!("{ZIP}{}", figure.replace("\"short\"", "\"shor\"")),
    );
    assert!(
        faults(&wrong).contains("bridge \"shor\""),
        "{}",
        faults(&wrong)
    );
    // Other labels are other values.
    let other = study(&labelled(&BRIDGES.replace("short", "stiff"), ZIP));
    let value = other.case(0).unwrap().get("bridge");
    assert_eq!(value, Some(Value::Name("stiff")));
}

#[test]
fn a_label_needs_a_zip_with_a_parameter_that_is_used() {
    let alone = "\"bridge\" is not used: no part of the structure and no expression contains it; a label of the cases is allowed \
                 as a list in a \"zip\" with a parameter that is used";
    let one = BRIDGES.replace("[\"short\", \"long, soft\", \"2 unequal\"]", "\"short\"");
    let two = format!("{BRIDGES}, \"other\": [1, 2, 3]");
    for (parameters, more) in [
        (BRIDGES, r#""title": "t""#),
        (BRIDGES, r#""when": "bridge == 'short'""#),
        (&one, r#""title": "t""#),
        (&two, r#""zip": [["bridge", "other"]]"#),
    ] {
        let found = faults(&labelled(parameters, more));
        assert!(found.contains(alone), "{found}");
    }
    // A text that is no number is still a fault where the structure contains the parameter.
    let number = labelled(BRIDGES, ZIP).replace("\"u\": \"scale\"", "\"u\": \"scale*bridge\"");
    let found = faults(&number);
    assert!(found.contains("\"short\": unknown name"), "{found}");
}

/// A closed form as a column: 2 pi (m/k)^(1/2) of a mass of 1.
#[test]
fn an_expression_of_parameters_may_only_compare() {
    let text = |more: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"k": [4, 9], {more} "dt": 0.01, "duration": 1}}, "metrics": ["peak(m)"],
              "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": "k"}}], "start": {{"m": {{"v": 1}}}}}}}}"#
        )
    };
    let compared = study(&text(r#""exact": "2*pi/sqrt(k)","#));
    let values = compared.cases().map(|case| case.number("exact"));
    let omega = [2.0, 3.0];
    let wanted = omega.map(|omega: f64| Some(2.0 * std::f64::consts::PI / omega));
    assert_eq!(values.collect::<Vec<_>>(), wanted);
    // A number alone, and a name that is nearly that of another parameter, are mistakes.
    for (more, part) in [
        (r#""exact": 3,"#, "\"exact\" is not used"),
        (r#""durations": "1/k","#, "did you mean \"duration\"?"),
    ] {
        let found = faults(&text(more));
        assert!(found.contains(part), "{found}");
    }
}

#[test]
fn a_synthetic_motion_has_a_seed_and_a_frequency() {
    let text = |synthetic: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"omega": 15.6, "dt": 0.01, "duration": 3}}, "metrics": ["peak(m)"],
              "structure": {{"units": "t, daN, cm, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": "omega"}}],
                "ground": {{"synthetic": {synthetic}}}}}}}"#
        )
    };
    let peak = |synthetic| solved(&study(&text(synthetic))).metrics[0];
    assert_eq!(peak(r#"{"seed": 3}"#), peak("3"));
    assert_eq!(
        peak(r#"{"seed": 3}"#),
        peak(r#"{"seed": 3, "omega": "omega"}"#)
    );
    assert_ne!(peak(r#"{"seed": 3}"#), peak(r#"{"seed": 3, "omega": 8}"#));
    for (synthetic, expected) in [
        (
            r#"{"seed": 1.5, "omega": -8}"#,
            "omega: must be > 0, got -8",
        ),
        (
            r#"{"seed": 1.5, "omega": -8}"#,
            "seed: must be a whole number from 0 to 4294967295, got 1.5",
        ),
        (r#"{"seed": -1}"#, "seed: must be >= 0, got -1"),
        (
            "\"omega/10\"",
            "synthetic: must be a whole number from 0 to 4294967295, got 1.56",
        ),
        (
            r#"{"seed": 1, "omega": 1e200}"#,
            "no motion from 1/30 to 25 Hz",
        ),
        (
            r#"{"seed": 1, "omega": 1e-200}"#,
            "no motion from 1/30 to 25 Hz",
        ),
        (r#"{"omega": 8}"#, "seed: missing"),
    ] {
        let found = faults(&text(synthetic));
        assert!(found.contains(expected), "{found}");
    }
}
