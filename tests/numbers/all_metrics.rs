//! Every metric that a problem lists has a value in some case: one that is listed and not computed would be an empty column.

use serde_json::{Value as Json, json};
use slipgap::problem::structure::metrics::metric::OF_PROGRAMS;
use slipgap::problem::structure::metrics::reduction::REDUCTIONS;
use slipgap::study::{self, Study};
use std::collections::BTreeSet;
use std::path::Path;

/// Shipped studies with a node, a contact, and values of their parameters, that have all that metrics are of: measured values, laws that
/// are integrated, reduced matrices, bars, sets of motions.
const STUDIES: [(&str, [&str; 2], &str); 5] = [
    (
        "calibrate/calibrate-pounding",
        ["light", "bumper"],
        r#"{"law": "hertz-damp", "duration": 2.5}"#,
    ),
    (
        "calibrate/calibrate-bearing",
        ["idle", "bearing"],
        r#"{"law": "displacement-control"}"#,
    ),
    (
        "structures/reduction-bar",
        ["bar.61.x", "stop"],
        r#"{"modes": 4, "gamma": 1}"#,
    ),
    (
        "structures/structure-bouncing-bar",
        ["bar.left", "floor"],
        r#"{"n": 20, "gamma": 1}"#,
    ),
    (
        "recorded/recorded-set",
        ["frame", "floor"],
        r#"{"nu": 0.1, "duration": 1}"#,
    ),
];

/// A shipped study with other metrics; `None` where it has no such metric.
fn shipped(name: &str, changed: &str, metrics: &[String]) -> Option<Study> {
    let file = Path::new(env!("SLIPGAP_ROOT")).join(format!("studies/{name}.json"));
    let text = std::fs::read_to_string(&file).unwrap();
    let mut study: Json = serde_json::from_str(&text).unwrap();
    let Json::Object(changed) = serde_json::from_str(changed).unwrap() else {
        panic!();
    };
    for (key, value) in changed {
        study["parameters"][key] = value;
    }
    let keys = study.as_object_mut().unwrap();
    for key in ["figures", "checks", "calibrate", "names", "reductions"] {
        keys.remove(key);
    }
    study["metrics"] = json!(metrics);
    study::parse(file.to_str().unwrap(), &study.to_string()).ok()
}

/// The metrics that have a value in a case; `None` if a case has no motion for them.
fn with_value(study: &Study) -> Option<BTreeSet<String>> {
    let mut found = BTreeSet::new();
    for case in study.cases() {
        let values = study.problem.solve(&case, &study.metrics).ok()?.metrics;
        let names = study.problem.metrics().iter();
        let with_values = names.zip(values).filter(|(_, value)| value.is_some());
        found.extend(with_values.map(|(metric, _)| metric.name.to_string()));
    }
    Some(found)
}

/// The reductions, but what only programs of others tell: the tests of these have them.
fn of_motions() -> impl Iterator<Item = &'static str> {
    let names = REDUCTIONS.iter().map(|reduction| reduction.0);
    names.filter(|name| !OF_PROGRAMS.contains(name))
}

#[test]
fn every_metric_of_structures_is_computed() {
    let forms = |name: &str, [node, contact]: [&str; 2]| {
        [
            name.to_owned(),
            format!("{name}({node})"),
            format!("{name}({contact})"),
            format!("{name}({node}, 1e-13)"),
            format!("{name}(0.5)"),
            format!("{name}({node}, measured)"),
            format!("{name}({contact}.S, measured)"),
            format!("{name}({contact}.r, {contact}.S, measured)"),
        ]
    };
    // Each by its name and the number of its form. Where a study has no such motion, it says nothing about the metric.
    let (mut known, mut computed) = (BTreeSet::new(), BTreeSet::new());
    for (study, parts, changed) in STUDIES {
        let parsed = |metrics: &[String]| shipped(study, changed, metrics);
        let open: Vec<((&str, usize), String)> = of_motions()
            .flat_map(|name| {
                let texts = forms(name, parts).into_iter().enumerate();
                texts.map(move |(form, text)| ((name, form), text))
            })
            .filter(|(metric, text)| {
                !computed.contains(metric) && parsed(std::slice::from_ref(text)).is_some()
            })
            .collect();
        let texts: Vec<String> = open.iter().map(|(_, text)| text.clone()).collect();
        let values = parsed(&texts).and_then(|study| with_value(&study)).unwrap();
        for (metric, text) in open {
            known.insert(metric);
            if values.contains(&text) {
                computed.insert(metric);
            }
        }
    }
    for name in of_motions() {
        assert!(
            known.iter().any(|metric| metric.0 == name),
            "{name} has no study here"
        );
    }
    let empty: Vec<_> = known.difference(&computed).collect();
    assert!(empty.is_empty(), "{empty:?}");
}

#[test]
fn every_metric_of_the_textbook_problems_is_computed() {
    let oscillator = [
        r#"{"law": "displacement-control", "x0": 12, "alpha": 0.1, "dT": 0.05, "duration": "12*pi"}"#,
        r#"{"law": "bouc-wen", "x0": 12, "alpha": 0.1, "dT": 0.05, "duration": "12*pi"}"#,
    ];
    let bars = [
        r#"{"gamma": 1, "n": 10, "dt": 0.0125, "duration": 4}"#,
        r#"{"law": "hertz-damp", "restitution": 0.8, "gamma": 1, "n": 10, "dt": 0.0125, "duration": 4}"#,
    ];
    for (problem, sets) in [("friction-oscillator", oscillator), ("bar-impact", bars)] {
        let mut computed = BTreeSet::new();
        let mut names: Vec<String> = Vec::new();
        for parameters in sets {
            let parse = |names: &[String]| {
                let text = format!(
                    r#"{{"problem": "{problem}", "parameters": {parameters}, "metrics": {}}}"#,
                    json!(names)
                );
                study::parse("s.json", &text).unwrap_or_else(|why| panic!("{why}"))
            };
            let text = format!(r#"{{"problem": "{problem}", "parameters": {parameters}}}"#);
            let default = study::parse("s.json", &text).unwrap();
            let rows = default.problem.metrics().iter();
            names = rows.map(|metric| metric.name.to_string()).collect();
            computed.extend(with_value(&parse(&names)).unwrap_or_default());
        }
        names.retain(|name| !computed.contains(name));
        assert!(names.is_empty(), "{problem}: {names:?}");
    }
}
