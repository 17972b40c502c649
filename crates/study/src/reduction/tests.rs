use super::*;
use crate::parse;

/// Two laws with parameters of their own; `dT` and `duration` advance together in the first block.
fn study(reductions: &str, more: &str) -> Result<Study, String> {
    let text = format!(
        r#"{{"problem": "friction-oscillator", "blocks": [
          {{"parameters": {{"law": "displacement-control", "alpha": [0.1, 1, 10], "x0": [8, 12], "dT": ["pi/10", "pi/20"],
                           "duration": "80*dT"}}}},
          {{"parameters": {{"law": ["velocity-control", "tanh"], "beta": [0.1, 0.3], "x0": [8, 12], "dT": "pi/10",
                           "duration": "8*pi"}}}}],
          "reductions": [{reductions}]{more}}}"#
    );
    parse("s", &text).map_err(|e| e.to_string())
}

fn row(study: &Study, name: &str) -> usize {
    let mut table = study.problem.parameters().iter();
    table.position(|parameter| parameter.name == name).unwrap()
}

/// The values of a word for these values of six cases of one law, of which two have the same x0 and dT.
fn values(word: &str, values: [Option<f64>; 6]) -> Vec<Reduced> {
    let text = format!("\"{word} rms_error over alpha\"");
    let study = study(&text, "").unwrap();
    let (_, _, reduction) = study.reductions().next().unwrap();
    let mut groups = Groups::new(vec![reduction]);
    // alpha x x0 x dT: cases 0, 4 and 8 have x0 = 8, dT = pi/10, and 1, 5 and 9 have dT = pi/20.
    for (number, value) in [0, 4, 8, 1, 5, 9].into_iter().zip(values) {
        groups.add(number, &study.case(number).unwrap(), |metric| {
            assert_eq!(metric, reduction.of);
            value
        });
    }
    groups.values(0).collect()
}

#[test]
fn each_word_has_its_value_and_the_first_case_with_it() {
    let of = |word: &str| {
        let given = [
            Some(-3.0),
            Some(1.0),
            Some(5.0),
            Some(2.0),
            Some(-2.0),
            None,
        ];
        let both = values(word, given);
        assert_eq!([both[0].first, both[1].first], [0, 1]);
        assert_eq!([both[0].cases, both[1].cases], [3, 3]);
        assert_eq!([both[0].empty, both[1].empty], [0, 1]);
        [0, 1].map(|i| (both[i].value.unwrap(), both[i].at))
    };
    assert_eq!(of("least"), [(-3.0, Some(0)), (-2.0, Some(5))]);
    assert_eq!(of("greatest"), [(5.0, Some(8)), (2.0, Some(1))]);
    assert_eq!(of("best"), [(1.0, Some(4)), (2.0, Some(1))]);
    assert_eq!(of("worst"), [(5.0, Some(8)), (2.0, Some(1))]);
    assert_eq!(of("mean"), [(1.0, None), (0.0, None)]);
    assert_eq!(of("median"), [(1.0, None), (0.0, None)]);
    // A quarter from -3 to 5 over 1: half of the way from -3 to 1; a quarter from -2 to 2.
    assert_eq!(of("quantile 1/4 of"), [(-1.0, None), (-1.0, None)]);
}

#[test]
fn a_group_without_values_has_none_and_large_values_have_a_mean() {
    for word in ["least", "mean", "median"] {
        let reduced = values(
            word,
            [
                None,
                Some(f64::NAN),
                Some(f64::INFINITY),
                Some(1.0),
                Some(1.0),
                Some(1.0),
            ],
        );
        assert_eq!(
            (reduced[0].value, reduced[0].at, reduced[0].empty),
            (None, None, 3)
        );
        assert_eq!((reduced[1].value, reduced[1].empty), (Some(1.0), 0));
    }
    let large = values("mean", [Some(1.5e308); 6]);
    let mean = large[0].value.unwrap();
    assert!((mean / 1.5e308 - 1.0).abs() < 1e-15, "{mean}");
}

#[test]
fn groups_have_the_same_values_of_what_neither_is_reduced_nor_changes_with_it() {
    let names = |study: &Study, rows: &[usize]| -> Vec<String> {
        let table = study.problem.parameters();
        let mut names: Vec<String> = rows
            .iter()
            .map(|row| table[*row].name.to_string())
            .collect();
        names.sort();
        names
    };
    let study = study(
        r#""best rms_error over alpha, beta", "least max_error over dT", "mean rms_error over law, alpha, beta""#,
        "",
    )
    .unwrap();
    let reductions: Vec<&Reduction> = study
        .reductions()
        .map(|(_, _, reduction)| reduction)
        .collect();
    assert_eq!(
        names(&study, &reductions[0].kept),
        ["dT", "duration", "law", "x0"]
    );
    assert_eq!(names(&study, &reductions[0].lost), ["alpha", "beta"]);
    assert_eq!(
        names(&study, &reductions[1].kept),
        ["alpha", "beta", "law", "x0"]
    );
    assert_eq!(names(&study, &reductions[1].lost), ["dT", "duration"]);
    assert_eq!(names(&study, &reductions[2].kept), ["dT", "duration", "x0"]);
    assert!(!reductions[0].groups_like(reductions[1]));
    // The first block has 12 cases in 4 groups; the second 8 in 2 for each law.
    let count = |reduction| {
        let mut groups = Groups::new(vec![reduction]);
        for (number, case) in (0..).zip(study.cases()) {
            groups.add(number, &case, |_| None);
        }
        groups
            .values(0)
            .map(|reduced| reduced.cases)
            .collect::<Vec<_>>()
    };
    assert_eq!(count(reductions[0]), [3, 3, 3, 3, 2, 2, 2, 2]);
    // "80*dT" is 8 pi to the last bit for dT = pi/10.
    let case = |number| study.case(number).unwrap().values[row(&study, "duration")];
    assert_eq!(case(0), case(12));
    assert_eq!(count(reductions[2]), [3 + 4, 3, 3 + 4, 3]);
    // What is reduced is computed, also if it is in no other list.
    let metric = study
        .problem
        .metrics()
        .iter()
        .position(|m| m.name == "max_error");
    assert!(study.metrics.contains(&metric.unwrap()));
}

#[test]
fn faults_say_what_is_allowed() {
    let wrong = |text: &str| study(text, "").err().unwrap_or_default();
    for (text, message) in [
        (r#""least rms_error over alpha""#, ""),
        (r#""quantile 0.84 of rms_error over alpha , beta""#, ""),
        // One value, as the command line may set it.
        (r#""mean rms_error over duration""#, ""),
        (
            r#""minimum rms_error over alpha""#,
            "reductions[0]: unknown word \"minimum\", did you mean \"least\"?",
        ),
        (
            r#""leest rms_error over alpha""#,
            "s:6:26: reductions[0]: unknown word \"leest\", did you mean \"least\"?; allowed: least, greatest, best, worst, mean, median, quantile P of",
        ),
        (
            r#""least rms_eror over alpha""#,
            "reductions[0]: unknown metric \"rms_eror\", did you mean \"rms_error\"?",
        ),
        (
            r#""least rms_error over alfa""#,
            "reductions[0]: unknown parameter \"alfa\", did you mean \"alpha\"?",
        ),
        (
            r#""mean rms_error over alpha, alpha""#,
            "reductions[0]: alpha given twice",
        ),
        (
            r#""mean rms_error over alpha", "mean rms_error over alpha""#,
            "reductions[1]: \"mean rms_error over alpha\" given twice",
        ),
        (
            r#""mean rms_error""#,
            "reductions[0]: must be \"WORD METRIC over PARAMETER, PARAMETER ...\", as in \"least rms_error over alpha\", got \"mean rms_error\"",
        ),
        (
            r#""mean over alpha""#,
            "reductions[0]: must be \"WORD METRIC over PARAMETER",
        ),
        (
            r#""quantile rms_error over alpha""#,
            "reductions[0]: must be \"WORD METRIC over PARAMETER",
        ),
        (
            r#""quantile 84 of rms_error over alpha""#,
            "reductions[0]: a quantile needs a number from 0 to 1, as in \"quantile 0.84 of\", got \"84\"",
        ),
        (
            r#""mean rms_error over static_ratio""#,
            "reductions[0]: static_ratio is not given; a reduction is over parameters that the study gives",
        ),
        (r#"7"#, "reductions[0]: must be a string, got 7"),
    ] {
        let told = wrong(text);
        assert!(
            told.contains(message) && message.is_empty() == told.is_empty(),
            "{text}: {told}"
        );
        // A figure that shows a text with a fault adds no other fault.
        assert!(told.matches("s:").count() <= 1, "{told}");
    }
    let computed = parse(
        "s",
        r#"{"problem": "bar-impact", "parameters": {"gamma": [1, 2], "n": 4, "dt": 0.01, "duration": 1},
            "reductions": ["least peak_force over k_I"]}"#,
    );
    let told = computed.unwrap_err().to_string();
    assert!(
        told.contains("k_I is computed from other parameters; name one that the study gives"),
        "{told}"
    );
    let figure = r#", "figures": [{"name": "f", "kind": "metric", "x": "dT", "y": "leest rms_error over alpha"}],
                     "checks": [{"metric": "leest rms_error over alpha", "max": 1}]"#;
    let told = study(r#""leest rms_error over alpha""#, figure).unwrap_err();
    assert_eq!(told.matches(": unknown").count(), 1, "{told}");
}

#[test]
fn figures_show_reductions_over_the_same_parameters_and_nothing_of_these() {
    let wrong = |figure: &str| {
        let texts = r#""least rms_error over alpha, beta", "mean max_error over beta, alpha", "mean max_error over dT""#;
        let figures = format!(r#", "figures": [{{"name": "f", {figure}}}]"#);
        study(texts, &figures).err().unwrap_or_default()
    };
    let (least, mean) = (
        "\"least rms_error over alpha, beta\"",
        "\"mean max_error over beta, alpha\"",
    );
    let over_steps = "\"mean max_error over dT\"";
    for (figure, message) in [
        (
            format!(r#""kind": "metric", "x": "dT", "y": [{least}, {mean}]"#),
            "",
        ),
        (
            format!(
                r#""kind": "metric", "x": "x0", "by": "dT", "y": {least}, "where": {{"law": "displacement-control"}}"#
            ),
            "",
        ),
        (
            format!(r#""kind": "convergence", "y": {least}, "by": "law", "where": {{"x0": 8}}"#),
            "",
        ),
        (
            format!(
                r#""kind": "map", "x": "dT", "y": "x0", "z": {least}, "where": {{"law": "displacement-control"}}"#
            ),
            "",
        ),
        (
            format!(r#""kind": "scatter", "x": "dT", "y": {least}, "colour": {mean}"#),
            "",
        ),
        (
            format!(r#""kind": "front", "x": {mean}, "y": {least}, "by": ["law", "x0"]"#),
            "",
        ),
        // The cases are chosen by what they are reduced over.
        (
            format!(r#""kind": "metric", "x": "dT", "y": {least}, "where": {{"alpha": [0.1, 1]}}"#),
            "",
        ),
        (
            format!(r#""kind": "metric", "x": "x0", "by": "law", "y": {least}"#),
            "figures[0].where: a metric figure with \"by\" shows one case at each point of a curve, but dT, duration vary; choose one value in \"where\"",
        ),
        (
            format!(r#""kind": "metric", "x": "alpha", "y": {least}"#),
            "figures[0].x: the metrics are reduced over alpha",
        ),
        (
            format!(r#""kind": "metric", "x": "x0", "by": "alpha", "y": {least}"#),
            "figures[0].by: the metrics are reduced over alpha",
        ),
        (
            format!(r#""kind": "scatter", "x": "alpha", "y": {least}"#),
            "figures[0].x: the metrics are reduced over alpha",
        ),
        (
            format!(r#""kind": "map", "x": "x0", "y": "beta", "z": {least}"#),
            "figures[0].y: the metrics are reduced over beta",
        ),
        (
            format!(r#""kind": "front", "x": {mean}, "y": {least}, "by": ["law", "beta"]"#),
            "figures[0].by[1]: the metrics are reduced over beta",
        ),
        (
            format!(r#""kind": "convergence", "y": {over_steps}"#),
            "figures[0].x: the metrics are reduced over dT",
        ),
        (
            format!(r#""kind": "metric", "x": "duration", "y": {over_steps}"#),
            "figures[0].x: duration changes with dT, which the metrics are reduced over",
        ),
        (
            format!(r#""kind": "metric", "x": "x0", "y": [{least}, "rms_error"]"#),
            "figures[0].y[1]: rms_error is not reduced, but \"least rms_error over alpha, beta\" is; a figure shows reductions only, or none",
        ),
        (
            format!(r#""kind": "front", "x": "max_error", "y": {least}, "by": "law""#),
            "figures[0].x: max_error is not reduced, but",
        ),
        (
            format!(r#""kind": "metric", "x": "x0", "y": [{least}, {over_steps}]"#),
            "figures[0].y[1]: \"mean max_error over dT\" and \"least rms_error over alpha, beta\" are over different parameters; a figure needs",
        ),
        (
            format!(
                r#""kind": "front", "x": {mean}, "y": {least}, "by": "law", "mean_over": "x0""#
            ),
            "figures[0].mean_over: a figure of reductions has no further means",
        ),
        (
            format!(r#""kind": "samples", "y": {least}"#),
            "figures[0].y: \"least rms_error over alpha, beta\" is a reduction; kinds that show them: metric, convergence, map, scatter, front",
        ),
        (
            r#""kind": "metric", "x": "x0", "y": "leest rms_error over alpha, beta""#.into(),
            "did you mean \"least rms_error over alpha, beta\"?",
        ),
    ] {
        let told = wrong(&figure);
        assert!(
            told.contains(message) && message.is_empty() == told.is_empty(),
            "{figure}: {told}"
        );
    }
}

#[test]
fn what_the_problem_computes_is_shown_if_all_cases_of_each_group_share_it() {
    let wrong = |over: &str| {
        let text = format!(
            r#"{{"problem": "bar-impact", "parameters": {{"k_I": [10, 100], "n": [4, 8], "dt": [0.01, 0.02], "duration": 1}},
              "reductions": ["mean peak_force over {over}"],
              "figures": [{{"name": "f", "kind": "metric", "x": "gamma", "y": "mean peak_force over {over}"}}]}}"#
        );
        let wrong = parse("s", &text).err().map(|e| e.to_string());
        wrong.unwrap_or_default()
    };
    // gamma follows from k_I and n.
    assert_eq!(wrong("dt"), "");
    let told = wrong("dt, n");
    let message = "figures[0].x: gamma changes with dt, n, which the metrics are reduced over";
    assert!(told.contains(message), "{told}");
}
