//! `slipgap recommend STUDY`: no candidate whose contacts make energy, no list that ends too early, fresh seeds, and neighbours.

use slipgap::problem::numbers::parameter::Value;
use slipgap::recommend::Stop;
use slipgap::recommend::study::{Advice, Choice, State, advise};
use slipgap::study::{Input, parse};

fn advice(text: &str) -> Advice {
    let advice = advise(&Input::new("s.json", text), &Stop::default());
    advice.unwrap_or_else(|why| panic!("{why}"))
}

fn number(advice: &Advice, choice: &Choice, name: &str) -> f64 {
    let mut table = advice.study.problem.parameters().iter();
    let row = table.position(|parameter| parameter.name == name).unwrap();
    choice.value(row).and_then(Value::as_f64).unwrap()
}

/// The study of docs/recommend.md with these seeds.
fn towers(seeds: &str, tolerance: f64) -> String {
    let page = include_str!("../../docs/recommend.md");
    let (_, rest) = page.split_once("```json\n").unwrap();
    let text = rest
        .split_once("```")
        .unwrap()
        .0
        .replace("[1, 2, 3]", seeds)
        .replace("0.0005, 0.0002]", "0.0005]");
    text.replace(
        "\"max(b - a)\": 0.1",
        &format!("\"max(b - a)\": {tolerance:?}"),
    )
}

#[test]
fn a_candidate_whose_contact_makes_energy_is_not_recommended() {
    let advice = advice(&towers("[1, 2, 3]", 0.1));
    // The work of the contact itself, over the largest energy of the structure.
    let gain = r#""metrics": [{"gain": "-min(joint.dissipated)/peak(energy.kinetic + energy.elastic)"}], "recommend": "#;
    let text = towers("[1, 2, 3]", 0.1).replace("\"recommend\": ", gain);
    let study = parse("s.json", &text).unwrap();
    let gain = study
        .measures
        .iter()
        .position(|measure| measure.name == "gain");
    let mut makes = 0;
    for choice in &advice.choices {
        let [k, dt] = ["k", "dt"].map(|name| number(&advice, choice, name));
        let cases = study
            .cases()
            .filter(|case| case.number("k").unwrap() == k && case.number("dt").unwrap() == dt);
        let of = |case| {
            let solved = study.problem.solve(&case, &study.metrics).unwrap().metrics;
            study.measure_value(gain.unwrap(), &case, &|at| solved[at])
        };
        let largest = cases.map(|case| of(case).unwrap()).fold(0.0, f64::max);
        let names = choice.warnings.names();
        // `contact-gain` takes its limit from 1 % of the largest energy up to the step, which is smaller before the peak.
        assert!(
            largest < 0.01 || names.contains("contact-gain"),
            "{k} {dt}: {largest}"
        );
        assert!(
            largest > 0.005 || !names.contains("contact-gain"),
            "{k} {dt}: {largest}"
        );
        if largest > 0.01 {
            makes += 1;
            assert!(matches!(choice.state, State::ContactEnergy), "{k} {dt}");
            assert!(choice.worst.is_infinite());
        }
    }
    assert_eq!(makes, 3);
    let chosen = &advice.choices[advice.chosen.unwrap()];
    assert!(chosen.warnings.is_empty());
    assert_eq!(number(&advice, chosen, "dt"), 5e-4);
}

/// A mass of 1 that hits a spring on a wall at velocity 1: the force is sqrt(k m) v, the velocity after it -1.
fn wall(k: &str, within: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"k": {k}, "dt": 1e-5, "duration": 0.1}},
            "structure": {{"masses": {{"a": 1}}, "start": {{"a": {{"v": 1}}}},
              "contacts": {{"wall": {{"law": "impact", "between": ["a", "ground"], "gap": 1e-3, "k": "k"}}}},
              "contacts_reference": "softened"}},
            "recommend": {{"over": "k", "within": {{{within}}}}}}}"#
    )
}

#[test]
fn a_list_that_ends_before_a_metric_converges_gives_no_answer() {
    for (k, from, to) in [("[1e4, 1e6]", 1e4_f64, 1e6), ("[1e4, 3e5, 4e5]", 3e5, 4e5)] {
        let advice = advice(&wall(k, r#""peak(wall.S)": 0.1, "last(a.v)": 0.1"#));
        assert_eq!(advice.chosen, None);
        let [found] = &advice.not_converged[..] else {
            panic!("{:?}", advice.not_converged);
        };
        assert_eq!(found.metric, 0);
        assert_eq!(
            found.values.map(|value| value.as_f64().unwrap()),
            [from, to]
        );
        let change = 1.0 - (from / to).sqrt();
        // The force is that at the steps.
        assert!(
            (found.change - change).abs() < 1e-4,
            "{} {change}",
            found.change
        );
        let last = advice.choices.len() - 1;
        assert_eq!(advice.verdict(last), "not converged in k");
        assert!(
            advice
                .sentences()
                .iter()
                .any(|line| line.starts_with("Not converged in k: "))
        );
    }
    // The last two differ by 0.0465 in the force; of the velocity nothing changes.
    for (k, within) in [
        ("[1e4, 9.09e5, 1e6]", r#""peak(wall.S)": 0.1"#),
        ("[1e4, 1e6]", r#""last(a.v)": 0.1"#),
    ] {
        let advice = advice(&wall(k, within));
        assert!(advice.not_converged.is_empty());
        assert!(advice.chosen.is_some());
    }
}

#[test]
fn the_answer_holds_for_seeds_that_the_study_does_not_have() {
    let known = advice(&towers("[1, 2, 3]", 0.1));
    let trial = known.choices[known.chosen.unwrap()].trial.unwrap();
    let fresh = advice(&towers("[4, 5, 6, 7, 8]", 0.1));
    let of = |advice: &Advice, k: f64, dt: f64| {
        let mut choices = advice.choices.iter();
        let candidate = choices
            .find(|choice| number(advice, choice, "k") == k && number(advice, choice, "dt") == dt);
        candidate.unwrap().worst
    };
    let (of_known, other) = (of(&known, 4e7, 5e-4), of(&fresh, 4e7, 5e-4));
    assert_eq!(trial.fresh, Some(other));
    assert!(other > of_known);
    // A tolerance between the errors of both samples: the seeds of the study keep it, the others do not.
    let between = 0.1 * 0.5 * (of_known + other);
    let text = towers("[1, 2, 3]", between)
        .replace("\"peak(a)\": 0.1", &format!("\"peak(a)\": {between:?}"));
    let refused = advice(&text);
    assert_eq!(refused.chosen, None);
    let last = refused.choices.len() - 1;
    assert!(refused.choices[last].trial.unwrap().fresh.unwrap() > 1.0);
    assert_eq!(refused.verdict(last), "only with the seeds of the study");
    // One motion is no ensemble.
    let one = advice(&towers("1", 0.1));
    assert_eq!(one.choices[one.chosen.unwrap()].trial.unwrap().fresh, None);
}

#[test]
fn neighbours_must_keep_the_metrics_too() {
    // cos(sqrt(k) t) is the same at k = 1 and at k = 5 at this time by chance, and not at k = 3.
    let end = 2.0 * std::f64::consts::PI / (5.0_f64.sqrt() - 1.0);
    let text = |neighbours: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"k": [1, 3, 4.99999, 5], "dt": "{end:?}/4000", "duration": {end:?}}},
               "structure": {{"masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": "k"}}], "start": {{"a": {{"u": 1}}}},
                              "contacts_reference": "softened"}},
               "recommend": {{"over": ["k"], {neighbours} "within": {{"last(a)": 0.01}}}}}}"#
        )
    };
    let alone = advice(&text(""));
    assert_eq!(
        number(&alone, &alone.choices[alone.chosen.unwrap()], "k"),
        1.0
    );
    let together = advice(&text(r#""neighbours": "k","#));
    assert_eq!(
        number(&together, &together.choices[together.chosen.unwrap()], "k"),
        5.0
    );
    assert_eq!(together.verdict(0), "a neighbour does not keep all");
    let fault = advise(
        &Input::new("s.json", &text(r#""neighbours": "dt","#)),
        &Stop::default(),
    )
    .unwrap_err()
    .to_string();
    assert!(
        fault.contains("recommend.neighbours: unknown number in over \"dt\""),
        "{fault}"
    );
}
