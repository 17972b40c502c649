use crate::{Found, Partners, Reference, Rule, Study, parse};
use slipgap_problem::problem::Case;

/// A mass on a spring with friction, with these metrics and more keys.
fn text(metrics: &str, more: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"k": [100, 200], "h": [2, 4], "F1": "k*h", "seed": [1, 2, 3],
          "law": ["coulomb", "velocity-control"], "dt": 0.01, "duration": 1}}, "metrics": {metrics},
          "structure": {{"units": "t, kN, m, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": "k"}}],
          "contacts": {{"f": {{"law": "law", "between": ["ground", "m"], "limit": "F1", "c": 1000}}}},
          "start": {{"m": {{"v": "seed"}}}}}}{more}}}"#
    )
}

fn study(metrics: &str, more: &str) -> Result<Study, String> {
    parse("s", &text(metrics, more)).map_err(|why| why.to_string())
}

fn of_columns(study: &Study) -> Vec<&str> {
    let columns = study.columns.iter();
    columns
        .map(|row| study.measures[*row].name.as_str())
        .collect()
}

#[test]
fn columns_are_what_the_study_names_and_not_its_parts() {
    let decoded = study(
        r#"["peak(m)", "peak(m)/h", {"drift": {"value": "max(m)/h", "unit": "rad", "title": "drift_x"}, "same": "peak(m)"},
            {"twice": "2*late", "late": "drift relative to k = 100"}]"#,
        r#", "checks": [{"metric": "sqrt(peak(f.S)/F1)", "min": 0}, {"metric": "drift", "max": 1}],
           "reductions": ["median rms(m)/h over seed", "greatest peak(m)/h relative to k = 100, h = 2 over seed"]"#,
    );
    let study = decoded.unwrap_or_else(|why| panic!("{why}"));
    assert_eq!(
        of_columns(&study),
        [
            "peak(m)",
            "peak(m)/h",
            "drift",
            "same",
            "twice",
            "late",
            "rms(m)/h",
            "peak(m)/h relative to k = 100, h = 2",
            "sqrt(peak(f.S)/F1)",
        ]
    );
    // What they are made of is computed.
    let rows = study.metrics.iter();
    let metrics: Vec<&str> = rows
        .map(|row| &*study.problem.metrics()[*row].name)
        .collect();
    assert_eq!(metrics, ["peak(m)", "max(m)", "rms(m)", "peak(f.S)"]);
    let of = |name: &str| study.measures.iter().find(|m| m.name == name).unwrap();
    assert_eq!(
        [&*of("drift").symbol, &*of("drift").unit],
        ["drift\\_x, rad", "rad"]
    );
    assert_eq!([&*of("same").symbol, &*of("same").unit], ["same, m", "m"]);
    assert_eq!(of("late").symbol, "late");
    let ratio = of("peak(m)/h relative to k = 100, h = 2");
    assert_eq!(
        ratio.symbol,
        "peak displacement of m / *h* relative to *k* = 100, *h* = 2"
    );
    let marked = study.computed().filter(|(.., computed)| computed.late);
    let late: Vec<&str> = marked
        .map(|(_, measure, _)| measure.name.as_str())
        .collect();
    assert_eq!(late.len(), 3, "{late:?}");
    // Each stands behind those that it is computed from.
    for (row, _, computed) in study.computed() {
        let uses = computed.uses(study.problem.parameters().len());
        assert!(uses.iter().all(|used| *used < row));
    }
}

#[test]
fn one_object_is_a_list_of_one() {
    let both = [r#"{"drift": "max(m)/h"}"#, r#"[{"drift": "max(m)/h"}]"#];
    for metrics in both {
        let study = study(metrics, "").unwrap();
        assert_eq!(of_columns(&study), ["drift"]);
    }
}

#[test]
fn the_value_of_arithmetic_is_undefined_where_a_part_is() {
    let study = study(r#"["max(m)/h", "h/(max(m) - 2)"]"#, "").unwrap();
    let case = study.case(0).unwrap();
    let values = |x: Option<f64>| -> Vec<Option<f64>> {
        let computed = study.computed();
        computed
            .map(|(_, _, computed)| computed.value(&case, &|_| x))
            .collect()
    };
    assert_eq!(values(Some(5.0)), [Some(2.5), Some(2.0 / 3.0)]);
    assert_eq!(values(Some(2.0)), [Some(1.0), None]);
    assert_eq!(values(None), [None, None]);
}

#[test]
fn faults_have_their_place_in_the_text() {
    for (metrics, offset, says) in [
        (
            r#"["max(m)/hh"]"#,
            9,
            "unknown name \"hh\"; allowed: pi, e, ",
        ),
        (
            r#"["max(m)/peak(q)"]"#,
            9,
            "\"peak(q)\": no node or contact 'q'",
        ),
        (r#"["2*(max(m)"]"#, 11, "a ')' is missing"),
        (r#"["peek(m)"]"#, 1, "no metric 'peek'"),
        (r#"["peek(m)/2"]"#, 2, "unknown name \"peek\""),
        (
            r#"{"a": "b + 1", "b": "2*a"}"#,
            20,
            "\"a\" is computed from itself: a, b",
        ),
        (r#"{"a": "a + 1"}"#, 6, "\"a\" is computed from itself: a"),
        (r#"{"h": "max(m)"}"#, 1, "\"h\" is a parameter"),
        (r#"{"pi": "max(m)"}"#, 1, "\"pi\" has a meaning of its own"),
        (r#"{"2a": "max(m)"}"#, 1, "\"2a\" cannot name a metric"),
        (
            r#"[{"a": "max(m)"}, {"a": "peak(m)"}]"#,
            19,
            "\"a\" given twice",
        ),
        (r#"{"a": {"unit": "m"}}"#, 6, "missing: the metric"),
        (r#"{"a": 3}"#, 6, "must be a string, or an object"),
        (r#"3"#, 0, "a list of metrics, or an object"),
        (
            r#"["max(m) relative to k"]"#,
            21,
            "must be \"METRIC relative to PARAMETER = VALUE",
        ),
        (
            r#"["max(m) relative to kk = 100"]"#,
            21,
            "unknown key \"kk\"; allowed: k, h",
        ),
        (
            r#"["max(m) relative to k = 300"]"#,
            21,
            "no case has k = 300; the values are 100, 200",
        ),
        (
            r#"["max(m) relative to law = coulomb, law = coulomb"]"#,
            36,
            "given twice",
        ),
    ] {
        let why = study(metrics, "").err().unwrap_or_default();
        assert!(why.contains(says), "{metrics}: {why}");
        let written = text(metrics, "");
        let line = written.lines().nth(1).unwrap_or_default();
        let column = line.find(metrics).unwrap() + offset + 1;
        let start = format!("s:2:{column}: metrics");
        assert!(why.starts_with(&start), "{metrics}: {column} {why}");
        assert_eq!(why.matches("s:2:").count(), 1, "{metrics}: {why}");
    }
}

#[test]
fn arithmetic_is_of_all_problems() {
    let study = |metrics: &str| {
        let text = format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2], "n": 4, "dt": 0.01, "duration": 1.5}},
              "metrics": {metrics}, "units": {{"length": "m", "force": "kN", "time": "s"}}}}"#
        );
        parse("s", &text).map_err(|why| why.to_string())
    };
    let found =
        study(r#"["peak_force/gamma", {"r": "max_overlap relative to gamma = 1"}]"#).unwrap();
    let columns = of_columns(&found);
    assert_eq!(columns[columns.len() - 2..], ["peak_force/gamma", "r"]);
    // The usual columns stay.
    assert!(columns.contains(&"peak_force") && columns.contains(&"max_overlap"));
    let why = study(r#"["peak-force"]"#).unwrap_err();
    assert!(
        why.contains("unknown metric \"peak-force\", did you mean \"peak_force\"?"),
        "{why}"
    );
    let why = study(r#"["peak_forc"]"#).unwrap_err();
    assert!(why.contains("did you mean \"peak_force\"?"), "{why}");
    let parsed = parse(
        "s",
        r#"{"problem": "bar-impact", "parameters": {"gamma": 1, "n": 4, "dt": 0.01, "duration": 1.5}, "names": {"n": ["a"]}}"#,
    );
    let why = parsed.unwrap_err().to_string();
    assert!(
        why.contains("only a study with \"problem\": \"structure\" names"),
        "{why}"
    );
}

#[test]
fn several_reference_cases_are_a_fault_and_a_missing_one_is_not() {
    let blocks = |second: &str, reference: &str| {
        let text = format!(
            r#"{{"problem": "structure", "blocks": [
              {{"parameters": {{"k": [100, 200], "h": 1, "dt": 0.01, "duration": 1}}}}, {{"parameters": {second}}}],
              "metrics": ["peak(m)", "peak(m) relative to {reference}"],
              "structure": {{"masses": {{"m": "h"}}, "springs": [{{"between": ["ground", "m"], "k": "k"}}], "start": {{"m": {{"v": 1}}}}}}}}"#
        );
        parse("s", &text)
            .err()
            .map(|why| why.to_string())
            .unwrap_or_default()
    };
    let other = r#"{"k": 300, "h": 2, "dt": 0.01, "duration": 1}"#;
    assert_eq!(blocks(other, "k = 100"), "");
    let same = r#"{"k": 100, "h": 1, "dt": 0.01, "duration": 1}"#;
    let why = blocks(same, "k = 100");
    assert!(
        why.contains("several cases with k = 100 are otherwise the same as the case with k = 100")
            && why.contains("they have the same parameters"),
        "{why}"
    );
    let why = blocks(other, "k = 100, h = 2");
    assert!(why.contains("no case has all these values"), "{why}");
}

/// The reference cases by comparing every case with every other one.
fn by_comparison(reference: &Reference, case: &Case, others: &[Case]) -> Found {
    let mut found = (0..others.len()).filter(|i| reference.pairs(case, &others[*i]));
    match (found.next(), found.next()) {
        (None, _) => Found::None,
        (Some(one), None) => Found::One(one),
        (Some(one), Some(two)) => Found::Several(one, two),
    }
}

#[test]
fn partners_are_those_of_a_comparison_with_all() {
    // Blocks with parameters of their own laws, and derived values that differ in the last bit.
    let text = r#"{"problem": "friction-oscillator", "blocks": [
        {"parameters": {"law": "displacement-control", "alpha": [0.1, 1, 10], "x0": [8, 12, 16], "dT": ["pi/10", "pi/20"], "duration": "80*dT"}},
        {"parameters": {"law": ["velocity-control", "tanh"], "beta": [0.1, 0.3], "x0": [8, 12], "dT": ["0.1*pi", 0.15707963267948966],
                        "duration": ["8*pi", "4*pi"]}, "zip": [["dT", "duration"]]}],
        "metrics": ["rms_error relative to alpha = 1", "rms_error relative to law = tanh, beta = 0.1", "max_error relative to x0 = 8"]}"#;
    let study = parse("s", text).unwrap_or_else(|why| panic!("{why}"));
    let cases: Vec<Case> = study.cases().collect();
    let (mut found, mut missing) = (0, 0);
    for (_, measure, computed) in study.computed() {
        let Rule::Ratio(_, reference) = &computed.rule else {
            panic!("{}", measure.name);
        };
        let matching = cases.iter().filter(|case| reference.filter.matches(case));
        let others: Vec<Case> = matching.cloned().collect();
        let mut partners = Partners::new(&reference.shared, &others.iter().collect::<Vec<_>>());
        for case in &cases {
            let partner = partners.find(case);
            assert_eq!(
                partner,
                by_comparison(reference, case, &others),
                "{}",
                measure.name
            );
            match partner {
                Found::One(_) => found += 1,
                Found::None => missing += 1,
                Found::Several(..) => {}
            }
        }
    }
    assert!(found > 60 && missing > 0, "{found} {missing}");
}

#[test]
fn names_are_those_of_figures() {
    let with = |names: &str| study(r#"["peak(m)"]"#, &format!(r#", "names": {names}"#));
    let found = with(r#"{"h": ["height_1", "m"], "k": ["stiffness"]}"#).unwrap();
    let titles = |name: &str| {
        let table = found.problem.parameters();
        let metric = table.iter().find(|metric| metric.name == name).unwrap();
        (metric.title(), metric.symbol.to_string())
    };
    assert_eq!(titles("h"), ("height\\_1, m".into(), "height\\_1".into()));
    assert_eq!(titles("k"), ("Stiffness".into(), "stiffness".into()));
    assert_eq!(titles("seed"), ("seed, m/s".into(), "seed".into()));
    for (names, says) in [
        (
            r#"{"hh": ["a", "m"]}"#,
            "names.hh: unknown key \"hh\"; allowed: k, h",
        ),
        (
            r#"{"h": "a"}"#,
            "names.h: must be a list of a name and a unit",
        ),
        (
            r#"{"h": ["a", "b", "c"]}"#,
            "names.h: must be a list of a name and a unit",
        ),
        (r#"{"h": ["a", 2]}"#, "names.h[1]: must be a string"),
        (r#"[]"#, "names: must be an object"),
    ] {
        let why = with(names).err().unwrap_or_default();
        assert!(why.contains(says), "{names}: {why}");
    }
}
