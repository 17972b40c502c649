//! The exact motion of dampers in series.

use serde_json::{Value as Json, json};
use slipgap::study;

/// The metrics of the first case of a study.
fn solved(study: &Json) -> Vec<f64> {
    let study = study::parse("study.json", &study.to_string()).unwrap();
    let solution = study.problem.solve(&study.case(0).unwrap(), &study.metrics);
    let metrics = solution.unwrap_or_else(|why| panic!("{why}")).metrics;
    metrics.into_iter().map(Option::unwrap).collect()
}

/// A damper behind an elastic contact, behind a spring at a node without mass, and on the ground beside a node with mass.
#[test]
fn dampers_in_series_have_the_exact_motion_of_a_node_between_them() {
    let asked = |damper: &str| -> Vec<String> {
        let names = [
            "step_error(a)",
            "step_error(S)",
            "peak_error(S)",
            "last_error(r)",
        ];
        let named = names.map(|name| name.replace('S', &format!("{damper}.S")));
        named
            .map(|name| name.replace("(r)", &format!("({damper}.r)")))
            .to_vec()
    };
    let viscous = json!({"law": "viscous", "c": 30, "a": 0.35});
    let mut errors = Vec::new();
    for dt in [0.004, 0.002] {
        let study = |contacts: Json, massless: bool, damper: &str| {
            let mut study = json!({
                "problem": "structure", "parameters": {"dt": dt, "duration": 2},
                "structure": {
                    "masses": {"a": 20},
                    "springs": [{"between": ["ground", "a"], "k": 2200, "c": 8}],
                    "contacts": contacts,
                    "ground": {"pulse": {"ricker": {"amplitude": 6, "frequency": 1.5, "at": 0.8, "sampled": 0.01}}}
                },
                "metrics": asked(damper)
            });
            if massless {
                study["structure"]["masses"]["n"] = json!(0);
                let brace = json!({"between": ["ground", "n"], "k": 8000});
                study["structure"]["springs"]
                    .as_array_mut()
                    .unwrap()
                    .push(brace);
            }
            solved(&study)
        };
        let elastic = json!({"law": "displacement-control", "k": 8000, "limit": 1e6});
        let mut at_node = viscous.clone();
        at_node["between"] = json!(["n", "a"]);
        let node = study(json!({"d": at_node}), true, "d");
        let list = |laws: [&Json; 2]| json!({"d": {"between": ["ground", "a"], "series": laws}});
        let chains = [
            study(list([&elastic, &viscous]), false, "d.2"),
            study(list([&viscous, &elastic]), false, "d.1"),
        ];
        for chain in chains {
            for (chain, node) in chain.iter().zip(&node) {
                // The step's forces at 1e-12 of their sizes, over errors of 1e-4.
                assert!((chain - node).abs() <= 1e-7 * node.abs(), "{chain} {node}");
            }
        }
        errors.push(node[0]);
    }
    let ratio = errors[0] / errors[1];
    assert!((3.3..4.7).contains(&ratio), "{errors:?}");
}

#[test]
fn an_elastic_contact_that_slides_before_a_damper_has_no_exact_motion() {
    let laws = [
        json!({"law": "displacement-control", "k": 8000, "limit": 5}),
        json!({"law": "viscous", "c": 30, "a": 0.5}),
    ];
    let written = json!({
        "problem": "structure", "parameters": {"dt": 0.004, "duration": 2},
        "structure": {
            "masses": {"a": 20}, "springs": [{"between": ["ground", "a"], "k": 2200}],
            "contacts": {"d": {"between": ["ground", "a"], "series": laws}}, "start": {"a": {"v": 1}}
        },
        "metrics": ["step_error(a)"]
    });
    let study = study::parse("study.json", &written.to_string()).unwrap();
    let why = study
        .problem
        .solve(&study.case(0).unwrap(), &[])
        .unwrap_err();
    let text = why.to_string();
    assert!(
        text.contains("contact d.1 slides in series with a damper"),
        "{text}"
    );
}
