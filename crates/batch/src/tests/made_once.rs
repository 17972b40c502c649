//! What is made for a study: sampled signals and the pieces of exact motions, counted.

use crate::solve::cost::{self, measure, total};
use crate::{RunOptions, solve::divergence};
use slipgap_problem::problem::structure::MOST_SAMPLED;
use slipgap_study::{Study, parse};
use std::time::Duration;

/// A mass on a spring with friction, in a run of some steps.
fn study(parameters: &str, rest: &str, metrics: &str) -> Study {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{{parameters}, "dt": 0.01}}, "metrics": [{metrics}],
          "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 100, "c": 1}}], {rest}}}}}"#
    );
    parse("s", &text).unwrap_or_else(|why| panic!("{why}"))
}

#[test]
fn explaining_a_case_makes_its_own_records_only() {
    let study = study(
        r#""seed": {"linspace": [1, 20000, 20000]}, "duration": 0.1"#,
        r#""ground": {"synthetic": {"seed": "seed"}}"#,
        r#""peak(m)""#,
    );
    let made = || study.problem.as_structure().unwrap().sampled_so_far();
    assert_eq!((study.len(), made()), (20000, 0));
    let total = total(&study);
    assert_eq!(made(), 0);
    let case = study.case(7).unwrap();
    study
        .problem
        .as_structure()
        .unwrap()
        .description(&case)
        .unwrap();
    let options = RunOptions::METRICS;
    // 20000 records of 3 ms at 5e8 units in a second.
    assert_eq!(cost::sampling(&study), 20000.0 * 1.5e6);
    measure(
        &study,
        total,
        &options,
        (&case, Duration::from_millis(200), u64::MAX),
    )
    .unwrap();
    let found = divergence::sampled_like(&study, 7, 64).unwrap();
    assert_eq!((found.cases, found.looked_at), (20000, 1));
    assert_eq!(made(), 1);
}

#[test]
fn more_records_than_fit_in_memory_are_made_once() {
    // 1600 pulses of 6002 points are more than the 8 million numbers that are kept. The pulses are the last axis.
    let study = study(
        r#""k": [1, 2, 3], "a": {"linspace": [1, 2, 1600]}, "duration": 0.02"#,
        r#""loads": [{"at": "m", "pulse": {"cosine": {"amplitude": "a", "period": 600, "sampled": 0.1}}, "scale": "k"}]"#,
        r#""peak(m)""#,
    );
    let one = study
        .problem
        .as_structure()
        .unwrap()
        .samples(&study.case(0).unwrap())
        .numbers;
    assert!(1600 * one > MOST_SAMPLED);
    let mut values = Vec::new();
    let run = |values: &mut Vec<Option<f64>>| {
        crate::run(
            &study,
            &indicatif::ProgressBar::hidden(),
            &RunOptions::METRICS,
            |part| {
                values.extend(part.metrics.column(0));
                Ok(())
            },
        )
    };
    run(&mut values).unwrap();
    assert_eq!(study.problem.as_structure().unwrap().sampled_so_far(), 1600);
    // In the order of the cases: linear in the amplitude, up to the round-off of two products.
    assert_eq!(values.len(), 4800);
    let first = values[0].unwrap();
    for (case, value) in values.iter().enumerate() {
        let of_case = study.case(case as u64).unwrap();
        let factor = of_case.number("k").unwrap() * of_case.number("a").unwrap();
        assert!(
            (value.unwrap() / (first * factor) - 1.0).abs() < 1e-12,
            "{case}"
        );
    }
}

#[test]
fn the_pieces_of_an_exact_motion_are_counted_before_they_are_made() {
    let with = |omega: &str, metric: &str| {
        study(
            &format!(r#""omega": {omega}, "duration": 0.18"#),
            r#""loads": [{"at": "m", "sine": {"amplitude": 1, "omega": "omega"}}]"#,
            metric,
        )
    };
    let reference = |study: &Study| {
        let case = study.case(0).unwrap();
        study.problem.work(&case, &study.metrics).references as f64
    };
    // No piece is longer than 2/omega. 2000 units for a piece of one node; at the steps, 30 times the work of 18 steps of one node.
    let work = reference(&with("1e6", "\"step_error(m)\""));
    assert_eq!(work, (0.09e6 * 2000.0) as u64 as f64 + 18.0 * 30.0);
    // 3.6e8 pieces are more than the 5e6 that are allowed: none is made.
    let refused = with("4e9", "\"step_error(m)\"");
    assert_eq!(reference(&refused), 18.0 * 30.0);
    let case = refused.case(0).unwrap();
    let why = refused.problem.solve(&case, &[]).unwrap_err().to_string();
    assert!(
        why.contains("more than 5000000 pieces up to t = 0.18"),
        "{why}"
    );
}
