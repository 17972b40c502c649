//! Studies too large to be checked case by case when they are read: a case that breaks a rule is named where it is solved.
//! Each study has more than 10^6 combinations, of which a condition keeps a few, and the ends of its axes break no rule.

use indicatif::ProgressBar;
use slipgap::batch::{Outcome, all};
use slipgap::study::{Study, parse};
use std::process::Command;

/// A list of 1001 numbers: the greatest first, the least next, one in the middle, and all others as usual. Together with
/// another list the ends of both break no rule, and what is in the middle is the end of neither.
fn list(greatest: f64, least: f64, middle: f64, usual: f64) -> String {
    let number = |i: usize| match i {
        0 => greatest,
        1 => least,
        500 => middle,
        _ => usual,
    };
    let numbers: Vec<String> = (0..1001).map(|i| number(i).to_string()).collect();
    format!("[{}]", numbers.join(", "))
}

/// A study of bars: 1001 x 1000 combinations, those with the gap 1 are cases mostly.
fn text(parameters: &str, keys: &str) -> String {
    let gap = r#""gap": {"linspace": [0.001, 1, 1000]}"#;
    format!(r#"{{"problem": "bar-impact", "parameters": {{"n": 2, {gap}, {parameters}}}, {keys}}}"#)
}

/// What became of the cases of a study.
fn run(text: &str) -> (Study, Vec<Outcome>) {
    let study = parse("s.json", text).unwrap_or_else(|e| panic!("{e}"));
    assert!(study.raw_len() > 1_000_000);
    let outcomes = all(&study, None, &ProgressBar::hidden()).unwrap();
    assert_eq!(outcomes.len() as u64, study.len());
    (study, outcomes)
}

/// The failures say this and nothing else fails; of these there are no metrics, of the others there are.
#[track_caller]
fn assert_refused(text: &str, message: &str, broken: impl Fn(&Outcome) -> bool) {
    let (study, outcomes) = run(text);
    let mut failed = 0;
    for (number, outcome) in (0..).zip(&outcomes) {
        match &outcome.failure {
            Some(why) => assert_eq!(why.to_string(), message),
            None => assert!(outcome.metrics.iter().any(Option::is_some)),
        }
        let fails = outcome.failure.is_some();
        assert_eq!(fails, broken(outcome), "{:?}", outcome.case);
        assert_eq!(fails, !study.violations(number).is_empty());
        assert!(!fails || outcome.metrics.iter().all(Option::is_none));
        failed += usize::from(fails);
    }
    assert!(
        failed > 0 && failed < outcomes.len(),
        "{failed} of {}",
        outcomes.len()
    );
}

#[test]
fn a_step_longer_than_the_run_in_the_middle_of_a_group() {
    let (dt, duration) = (list(4.0, 0.1, 3.0, 0.5), list(5.0, 1.5, 2.0, 2.5));
    let text = text(
        &format!(r#""gamma": 1, "dt": {dt}, "duration": {duration}"#),
        r#""zip": [["dt", "duration"]], "when": "gap == 1""#,
    );
    assert_refused(
        &text,
        "dt: must be at most duration = 2, got 3",
        |outcome| outcome.case.number("dt") == Some(3.0),
    );
}

#[test]
fn so_many_steps_that_no_memory_holds_them() {
    let (dt, duration) = (list(0.5, 1e-11, 1e-10, 0.25), list(2.5, 1e-10, 2.0, 2.25));
    let text = text(
        &format!(r#""gamma": 1, "dt": {dt}, "duration": {duration}"#),
        r#""zip": [["dt", "duration"]], "when": "gap == 1 and dt != 1e-11""#,
    );
    let message = "dt: gives 2.000e10 steps, at most 30000000 fit in memory";
    assert_refused(&text, message, |outcome| {
        outcome.case.number("dt") == Some(1e-10)
    });
}

#[test]
fn bars_that_move_apart() {
    let (left, right) = (list(0.5, -0.5, 0.1, 0.1), list(0.3, -0.9, 0.2, -0.1));
    let text = text(
        &format!(
            r#""gamma": 1, "dt": 0.5, "duration": 2.5, "V0": {left}, "right": {{"V0": {right}}}"#
        ),
        r#""zip": [["V0", "right.V0"]], "when": "gap == 1""#,
    );
    let message = "right.V0: the bars must close: V0 of the left bar (0.1) must be greater than that of the right (0.2)";
    assert_refused(&text, message, |outcome| {
        outcome.case.number("right.V0") == Some(0.2)
    });
}

#[test]
fn a_stiffness_that_contradicts_the_ratio_that_it_follows_from() {
    // k_I is gamma n E A/L = 10 n gamma, but ten times that where gamma is 7.
    let text = text(
        r#""gamma": {"linspace": [1, 1001, 1001]}, "dt": 0.5, "duration": 2.5,
           "k_I": "gamma*n*10*(1 + 9*max(0, 1 - abs(gamma - 7)))""#,
        r#""when": "gap == 1""#,
    );
    let message = "k_I: gives 1400, but 140 follows from the other parameters";
    assert_refused(&text, message, |outcome| {
        outcome.case.number("gamma") == Some(7.0)
    });
}

#[test]
fn an_expression_out_of_range_is_not_replaced_by_a_default() {
    // Over 2^20 sets of gap and A, so that nothing is known when the study is read. Where A is 500, E of the right bar
    // is -1; left out, it would be as in the left bar.
    let text = text(
        r#""gamma": 1, "A": {"linspace": [1, 1049, 1049]}, "dt": 0.5, "duration": 2.5,
           "right": {"A": 1000, "E": "abs(A - 500)*100 - 1 + 0*gap"}"#,
        r#""when": "gap == 1 and A > 490 and A < 511""#,
    );
    let message =
        "right.E: must be > 0, got \"abs(A - 500)*100 - 1 + 0*gap\" = -1 with A = 500, gap = 1";
    assert_refused(&text, message, |outcome| {
        outcome.case.number("A") == Some(500.0)
    });
}

#[test]
fn sound_cases_among_refused_ones_have_the_numbers_of_a_study_without_those() {
    let (dt, duration) = (list(4.0, 0.1, 3.0, 0.5), list(5.0, 1.5, 2.0, 2.5));
    let study = text(
        &format!(r#""gamma": 1, "dt": {dt}, "duration": {duration}"#),
        r#""zip": [["dt", "duration"]], "when": "gap == 1""#,
    );
    let (_, among) = run(&study);
    let text = r#"{"problem": "bar-impact", "parameters": {"n": 2, "gap": 1, "gamma": 1, "dt": 0.5, "duration": 2.5}}"#;
    let study = parse("s.json", text).unwrap();
    let alone = all(&study, None, &ProgressBar::hidden()).unwrap();
    let bits = |outcome: &Outcome| -> Vec<Option<u64>> {
        let metrics = outcome.metrics.iter();
        metrics.map(|metric| metric.map(f64::to_bits)).collect()
    };
    let sound: Vec<&Outcome> = among.iter().filter(|o| o.failure.is_none()).collect();
    assert_eq!(sound.len(), 1000);
    // The first two are others.
    assert!(
        sound[2..]
            .iter()
            .all(|outcome| bits(outcome) == bits(&alone[0]))
    );
}

#[test]
fn the_program_names_the_case_and_ends_with_3() {
    let folder = tempfile::tempdir().unwrap();
    let study = text(
        r#""gamma": {"linspace": [1, 1001, 1001]}, "dt": 0.5, "duration": 2.5,
           "k_I": "gamma*n*10*(1 + 9*max(0, 1 - abs(gamma - 7)))""#,
        r#""when": "gap == 1 and gamma < 9""#,
    );
    std::fs::write(folder.path().join("s.json"), study).unwrap();
    let run = |words: &[&str]| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"));
        let done = program
            .current_dir(folder.path())
            .args(words)
            .output()
            .unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (done.status.code(), text(done.stdout), text(done.stderr))
    };
    let why = "k_I: gives 1400, but 140 follows from the other parameters";
    // The second time from the store.
    for _ in 0..2 {
        let (code, _, errors) = run(&["run", "s.json"]);
        assert_eq!(code, Some(3), "{errors}");
        let line = format!("s.json: case 6 could not be solved: {why}");
        assert!(errors.contains(&line), "{errors}");
        let table = std::fs::read_to_string(folder.path().join("figures/s/results.csv")).unwrap();
        let rows: Vec<&str> = table.lines().skip(1).collect();
        assert_eq!(rows.len(), 8);
        let empty: Vec<bool> = rows.iter().map(|row| row.ends_with(",,,")).collect();
        assert_eq!(
            empty,
            [false, false, false, false, false, false, true, false]
        );
    }
    let (code, told, _) = run(&["explain", "s.json", "6"]);
    assert_eq!(code, Some(3));
    assert!(
        told.contains(&format!("this case cannot be solved: {why}")),
        "{told}"
    );
    assert_eq!(run(&["explain", "s.json", "5"]).0, Some(0));
}
