//! Values of metrics that are computed from others, against arithmetic on the columns of the plain ones.

use crate::batch::{self, Outcome};
use crate::checks::{CheckCollector, Verdict};
use indicatif::ProgressBar;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::{Study, parse};

/// A mass that hits a stop: 3 stiffnesses, 2 gaps and 2 speeds, of which the smaller one never closes the larger gap.
fn study(metrics: &str, more: &str) -> Study {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"gamma": [1, 2, 4], "gap": [0.01, 0.05], "speed": [0.1, 1], "h": 3.2,
          "F1": "1000*gamma + h", "dt": 0.01, "duration": 2}}, "metrics": [{metrics}, "peak(m)", "max(m)", "peak(stop.S)"],
          "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": "20 + 0*F1"}}],
          "contacts": {{"stop": {{"law": "impact", "between": ["ground", "m"], "gap": "gap", "k": "1000*gamma"}}}},
          "start": {{"m": {{"v": "-speed"}}}}}}{more}}}"#
    );
    parse("s", &text).unwrap_or_else(|why| panic!("{why}"))
}

fn outcomes(study: &Study) -> Vec<Outcome> {
    batch::all(study, None, &ProgressBar::hidden()).unwrap_or_else(|why| panic!("{why}"))
}

fn column(study: &Study, outcomes: &[Outcome], name: &str) -> Vec<Option<f64>> {
    let found = study.measures.iter().position(|m| m.name == name);
    let row = found.unwrap_or_else(|| panic!("{name}"));
    outcomes
        .iter()
        .map(|outcome| outcome.metrics[row])
        .collect()
}

fn parameter(outcome: &Outcome, name: &str) -> f64 {
    outcome.case.number(name).unwrap()
}

#[test]
fn arithmetic_has_the_bits_of_the_same_on_the_columns() {
    let study = study(
        r#""max(m)/3.2", "peak(stop.S)/F1", {"drift": "max(m)/h", "more": "2*drift^2 - peak(m)*max(gap, h)"},
           "peak(m)/peak(stop.S)", {"deep": "sqrt(abs(more)) + drift"}"#,
        "",
    );
    let solved = outcomes(&study);
    let of = |name: &str| column(&study, &solved, name);
    let [peak, largest, force] = ["peak(m)", "max(m)", "peak(stop.S)"].map(of);
    assert!(force.contains(&Some(0.0)) && force.iter().any(|x| *x > Some(1.0)));
    for (i, outcome) in solved.iter().enumerate() {
        let (p, m, s) = (peak[i].unwrap(), largest[i].unwrap(), force[i].unwrap());
        let [f1, gap] = ["F1", "gap"].map(|name| parameter(outcome, name));
        let drift = m / 3.2;
        let more = 2.0 * (drift * drift) - p * gap.max(3.2);
        for (name, expected) in [
            ("max(m)/3.2", Some(m / 3.2)),
            ("peak(stop.S)/F1", Some(s / f1)),
            ("drift", Some(drift)),
            ("more", Some(more)),
            // A division by zero has no value.
            ("peak(m)/peak(stop.S)", (s != 0.0).then(|| p / s)),
            ("deep", Some(more.abs().sqrt() + drift)),
        ] {
            let found = of(name)[i];
            match (found, expected) {
                // pow may round the square in another way.
                (Some(a), Some(b)) => {
                    assert!((a - b).abs() <= 4e-16 * b.abs().max(1.0), "{name}: {a} {b}")
                }
                (a, b) => assert_eq!(a, b, "{name}"),
            }
        }
        assert_eq!(of("max(m)/3.2")[i], of("drift")[i]);
    }
}

#[test]
fn ratios_are_of_the_case_that_is_otherwise_the_same() {
    let study = study(
        r#""peak(stop.S) relative to gamma = 1", {"one": "peak(m)/h relative to gamma = 2, gap = 0.01", "change": "100*(one - 1)"},
           "peak(m) relative to speed = 1 relative to gamma = 4""#,
        "",
    );
    let solved = outcomes(&study);
    let value = |i: usize, name: &str| column(&study, &solved, name)[i].unwrap();
    // The other case by a search through the values.
    let other = |i: usize, change: &[(&str, f64)]| {
        let wanted = |name: &str| {
            let new = change.iter().find(|changed| changed.0 == name);
            new.map_or(parameter(&solved[i], name), |changed| changed.1)
        };
        let is = |outcome: &Outcome| {
            ["gamma", "gap", "speed"]
                .iter()
                .all(|name| parameter(outcome, name) == wanted(name))
        };
        let mut found = (0..solved.len()).filter(|index| is(&solved[*index]));
        let one = found.next().unwrap();
        assert_eq!(found.next(), None);
        one
    };
    let mut undefined = 0;
    for i in 0..solved.len() {
        let reference = value(other(i, &[("gamma", 1.0)]), "peak(stop.S)");
        let expected = Some(value(i, "peak(stop.S)") / reference).filter(|x| x.is_finite());
        assert_eq!(
            column(&study, &solved, "peak(stop.S) relative to gamma = 1")[i],
            expected
        );
        undefined += usize::from(expected.is_none());
        let j = other(i, &[("gamma", 2.0), ("gap", 0.01)]);
        let one = (value(i, "peak(m)") / 3.2) / (value(j, "peak(m)") / 3.2);
        assert_eq!(value(i, "one"), one);
        assert_eq!(value(i, "change"), 100.0 * (one - 1.0));
        // A ratio of ratios.
        let speed = |i: usize| value(i, "peak(m)") / value(other(i, &[("speed", 1.0)]), "peak(m)");
        let both = speed(i) / speed(other(i, &[("gamma", 4.0)]));
        assert_eq!(
            value(i, "peak(m) relative to speed = 1 relative to gamma = 4"),
            both
        );
    }
    // 3 stiffnesses with the gap that the slow mass does not close.
    assert_eq!(undefined, 3);
}

#[test]
fn reductions_and_checks_see_ratios_and_a_store_gives_the_same() {
    let study = study(
        r#"{"force": "peak(stop.S) relative to gamma = 1"}"#,
        r#", "reductions": ["median force over speed"],
           "checks": [{"metric": "force", "where": {"gamma": 1, "gap": 0.01}, "min": 1, "max": 1},
                      {"metric": "median force over speed", "where": {"gap": 0.01}, "min": 1, "max": 4},
                      {"metric": "force", "where": {"gap": 0.05, "speed": 0.1}, "min": 0}]"#,
    );
    let folder = tempfile::tempdir().unwrap();
    let run = || {
        let store = batch::store::Store::open(folder.path()).unwrap();
        let options = batch::RunOptions {
            store: Some(&store),
            ..batch::RunOptions::METRICS
        };
        let (mut collector, mut from_store) = (CheckCollector::new(&study), 0);
        let mut values: Vec<Option<f64>> = Vec::new();
        let row = study
            .measures
            .iter()
            .position(|m| m.name == "force")
            .unwrap();
        batch::run(&study, &ProgressBar::hidden(), &options, |part| {
            from_store += part.from_store;
            values.extend(part.metrics.column(row));
            collector.add(&part);
            Ok(())
        })
        .unwrap();
        let verdicts: Vec<Verdict> = collector.finish().verdicts(&study).collect();
        (values, verdicts, from_store)
    };
    let (first, again) = (run(), run());
    assert_eq!((first.2, again.2), (0, 12));
    assert_eq!((&first.0, &first.1), (&again.0, &again.1));
    let holds: Vec<bool> = first.1.iter().map(Verdict::holds).collect();
    // Two cases, three groups, and three cases whose reference has no force: an undefined value fails.
    assert_eq!(holds, [true, true, true, true, true, false, false, false]);
    assert_eq!(first.1[0].value, Some(1.0));
    assert!(first.1.iter().any(|finding| finding.value > Some(1.2)));
    let case = study.case(0).unwrap();
    assert_eq!(case.values[0], Some(Value::Number(1.0)));
}
