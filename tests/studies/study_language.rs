//! Axes, groups, expressions, conditions and designs of studies, compared with lists of their cases.

use slipgap::problem::Case;
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::table::cases::Column;
use slipgap::study::{Filter, Study, parse};

/// A study of bars with these parameters and other keys.
fn study(parameters: &str, other_keys: &str) -> Study {
    let text = format!(
        r#"{{"problem": "bar-impact", "parameters": {{"duration": 1.5, {parameters}}}{other_keys}}}"#
    );
    parse("s.json", &text).unwrap_or_else(|e| panic!("{text}\n{e}"))
}

fn numbers(study: &Study, names: &[&str]) -> Vec<Vec<f64>> {
    let of = |case: Case| {
        names
            .iter()
            .map(|name| case.number(name).unwrap())
            .collect()
    };
    study.cases().map(of).collect()
}

#[test]
fn expressions_follow_the_parameters_they_name() {
    // In any order, by each other, by defaults (E A/L = 10), and as whole numbers: 100 * 0.07 is not 7.
    let study = study(
        r#""dt": "0.5/n", "k_I": "g2 * n * E * A / L", "n": "100*x + 1", "gap": [0.07, 0.02]"#
            .replace("g2", "(2 + gap)")
            .replace("100*x", "100*gap")
            .as_str(),
        "",
    );
    let expected = [0.07, 0.02].map(|gap: f64| {
        let n = (100.0 * gap).round() + 1.0;
        vec![gap, n, 0.5 / n, (2.0 + gap) * n * 100.0 / 10.0]
    });
    let found = numbers(&study, &["gap", "n", "dt", "k_I"]);
    for (found, expected) in found.iter().zip(&expected) {
        for (a, b) in found.iter().zip(expected) {
            assert!((a - b).abs() < 1e-14 * b, "{found:?} {expected:?}");
        }
    }
}

#[test]
fn a_group_advances_together_at_the_place_of_its_first_member() {
    let axes = r#""gamma": [1, 2], "n": [2, 4, 8], "gap": [0, 1], "dt": [0.1, 0.2, 0.3]"#;
    let study = study(axes, r#", "zip": [["dt", "n"]]"#);
    let mut expected = Vec::new();
    for gamma in [1.0, 2.0] {
        for (n, dt) in [(2.0, 0.1), (4.0, 0.2), (8.0, 0.3)] {
            for gap in [0.0, 1.0] {
                expected.push(vec![gamma, n, dt, gap]);
            }
        }
    }
    assert_eq!(numbers(&study, &["gamma", "n", "dt", "gap"]), expected);
    assert_eq!((study.len(), study.raw_len()), (12, 12));
}

#[test]
fn a_condition_drops_combinations_and_numbers_those_left() {
    let axes = r#""gamma": [1, 2, 3], "n": {"range": [1, 60, 1]}, "dt": {"linspace": [0.001, 0.1, 50]}, "mass": ["lumped", "consistent"]"#;
    let condition = "dt <= 0.5/n and (gamma != 2 or mass == 'lumped') or n == 60";
    let study = study(axes, &format!(r#", "when": "{condition}""#));
    let met = |case: &Case| {
        let [gamma, n, dt] = ["gamma", "n", "dt"].map(|name| case.number(name).unwrap());
        dt <= 0.5 / n && (gamma != 2.0 || case.choice("mass") == "lumped") || n == 60.0
    };
    let cases: Vec<Case> = self::study(axes, "").cases().collect();
    let values = |case: &Case| format!("{:?}", case.values);
    let expected: Vec<String> = cases.iter().filter(|case| met(case)).map(values).collect();
    assert!(expected.len() > 4096 && expected.len() < cases.len());
    assert_eq!(study.len(), expected.len() as u64);
    assert_eq!(study.raw_len(), cases.len() as u64);
    let found: Vec<String> = study.cases().map(|case| values(&case)).collect();
    assert_eq!(found, expected);
    for index in [0, 1, 4000, 4097, expected.len() - 1] {
        let case = study.case(index as u64).unwrap();
        assert_eq!(values(&case), expected[index], "{index}");
    }
    assert!(study.case(study.len()).is_none());
    let (first, columns) = study.columns(0, study.raw_len());
    let mut shown = columns.shown();
    let columns: Vec<String> = (0..columns.len()).map(|i| values(shown.at(i))).collect();
    assert_eq!((first, &columns), (0, &expected));
    // Ranges of raw combinations have the cases among them, with their numbers.
    let mut pieces = Vec::new();
    for start in (0..study.raw_len()).step_by(777) {
        pieces.extend(
            study
                .range(start, start + 777)
                .map(|(n, case)| (n, values(&case))),
        );
    }
    let numbered: Vec<(u64, String)> = (0..).zip(expected.clone()).collect();
    assert_eq!(pieces, numbered);
    // A filter chooses by the numbers of the cases that are left.
    let gamma = study
        .problem
        .parameters()
        .iter()
        .position(|p| p.name == "gamma")
        .unwrap();
    let filter = Filter(vec![(gamma, vec![Value::Number(2.0)])]);
    let chosen: Vec<u64> = study.select(&filter).collect();
    let looked: Vec<u64> = (0..study.len())
        .filter(|i| filter.matches(&study.case(*i).unwrap()))
        .collect();
    assert_eq!(chosen, looked);
}

#[test]
fn blocks_with_conditions_follow_one_another() {
    let text = r#"{"problem": "bar-impact", "blocks": [
        {"parameters": {"gamma": [1, 2, 3], "n": 2, "dt": 0.1, "duration": 1}, "when": "gamma != 2"},
        {"parameters": {"gamma": [4, 5, 6], "n": 2, "dt": [0.1, 0.2, 0.3], "duration": 1},
         "zip": [["gamma", "dt"]], "when": "gamma > 4"}]}"#;
    let study = parse("s.json", text).unwrap();
    let found = numbers(&study, &["gamma", "dt"]);
    assert_eq!(found, [[1.0, 0.1], [3.0, 0.1], [5.0, 0.2], [6.0, 0.3]]);
    let range: Vec<u64> = study.range(2, 5).map(|(number, _)| number).collect();
    assert_eq!(range, [1, 2]);
    // The same as columns; of what all share there is one value.
    for (from, to, first, gammas) in [
        (2, 5, 1, &[3.0, 5.0][..]),
        (0, 6, 0, &[1.0, 3.0, 5.0, 6.0]),
        (3, 4, 2, &[]),
    ] {
        let (number, columns) = study.columns(from, to);
        assert_eq!((number, columns.len()), (first, gammas.len()));
        let mut shown = columns.shown();
        for (i, case) in study.range(from, to).enumerate() {
            assert_eq!(shown.at(i).values, case.1.values);
            assert_eq!(case.1.number("gamma"), Some(gammas[i]));
        }
        let shared = |column: &&Column| matches!(column, Column::Same(Some(Value::Whole(2))));
        // n of both bars
        let count = columns.columns().iter().filter(shared).count();
        assert_eq!(count, if gammas.is_empty() { 0 } else { 2 });
    }
    assert_eq!(study.case(3).unwrap().number("gamma"), Some(6.0));
}

#[test]
fn designs_fill_their_ranges_in_addition_to_a_grid() {
    let parameters = r#""gamma": {"loguniform": [0.01, 100]}, "mass": ["lumped", "consistent"], "n": {"uniform": [3, 6]}, "dt": "0.1/n""#;
    for kind in ["latin-hypercube", "sobol"] {
        let design = |seed: u32| {
            let other_keys =
                format!(r#", "design": {{"kind": "{kind}", "n": 400, "seed": {seed}}}"#);
            study(parameters, &other_keys)
        };
        let study = design(1);
        assert_eq!(study.len(), 800);
        let rows = numbers(&study, &["gamma", "n", "dt"]);
        // The point is the slower axis: each with both mass matrices.
        assert!(rows.chunks(2).all(|pair| pair[0] == pair[1]));
        // Evenly in the logarithm: a quarter in each two decades, to the Latin hypercube's and the net's precision.
        for quarter in 0..4 {
            let within = |x: &f64| {
                let position = (x.log10() + 2.0) / 4.0;
                (position * 4.0).floor() as i32 == quarter
            };
            let count = rows.iter().filter(|row| within(&row[0])).count();
            assert!((count as i32 - 200).abs() <= 4, "{kind} {quarter}: {count}");
        }
        for n in [3.0, 4.0, 5.0, 6.0] {
            let count = rows.iter().filter(|row| row[1] == n).count() as i32;
            assert!((count - 200).abs() <= 4, "{kind} n = {n}: {count}");
        }
        assert!(rows.iter().all(|row| row[2] == 0.1 / row[1]));
        assert_eq!(rows, numbers(&design(1), &["gamma", "n", "dt"]));
        assert_ne!(rows, numbers(&design(2), &["gamma", "n", "dt"]));
    }
}

#[test]
fn a_saltelli_design_has_n_times_k_plus_2_cases() {
    let parameters = r#""gamma": {"uniform": [1, 2]}, "n": 4, "gap": {"uniform": [0, 1]}, "dt": {"uniform": [0.01, 0.02]}"#;
    let study = study(parameters, r#", "design": {"kind": "saltelli", "n": 8}"#);
    assert_eq!(study.len(), 8 * 5);
}

#[test]
fn a_million_cases_are_made_one_at_a_time() {
    // Every case by its number.
    let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control",
        "beta": {"geomspace": [0.001, 10, 1000]}, "dT": {"geomspace": [0.001, 1, 1000]}, "duration": "100*dT", "x0": 12}}"#;
    let study = parse("s.json", text).unwrap();
    assert_eq!(study.len(), 1_000_000);
    let last = study.case(999_999).unwrap();
    assert_eq!(
        ["beta", "dT", "duration"].map(|n| last.number(n).unwrap()),
        [10.0, 1.0, 100.0]
    );
}

#[test]
fn a_stiffness_may_be_given_together_with_its_alternative() {
    let axes = r#""gamma": [0.3, 1, 7], "n": [2, 10], "dt": "0.5 / n""#;
    let given = study(&format!(r#"{axes}, "k_I": "gamma * n * E * A / L""#), "");
    let computed = study(axes, "");
    let columns = ["gamma", "k_I", "n", "dt"];
    assert_eq!(numbers(&given, &columns), numbers(&computed, &columns));
    // In the other direction, and through another parameter.
    let turned = study(
        r#""k_I": [30, 100], "n": 10, "dt": 0.1, "gamma": "gap * L / (n*E*A)", "gap": "k_I""#,
        "",
    );
    assert_eq!(numbers(&turned, &["gamma"]), [[0.3], [1.0]]);
}

#[test]
fn a_rule_ends_on_the_number_given_to_the_bit() {
    // a (b/a) is not always b: for these ends it is off by a bit.
    let mut off = 0;
    for (a, b) in [
        (0.3, 0.7),
        (0.3, 0.9),
        (0.3, 47.0),
        (0.7, 47.0),
        (1e-3, 2.3),
        (1.3, 11.7),
        (1e-200, 3e-190),
    ] {
        off += usize::from(a * libm::pow(b / a, 1.0) != b);
        for count in [2, 3, 7] {
            for rule in ["geomspace", "linspace"] {
                let axis = format!(
                    r#""gamma": 1, "n": 2, "dt": 1, "E": {{"{rule}": [{a}, {b}, {count}]}}"#
                );
                let study = study(&axis, "");
                let ends = [0, count - 1].map(|i| study.case(i).and_then(|c| c.number("E")));
                assert_eq!(ends, [Some(a), Some(b)], "{axis}");
            }
        }
    }
    assert!(off >= 5, "{off} ends would not notice");
    // Ten steps of 0.1 are not 1 in doubles (0.1 added up, or 10 * 0.1 - 1e-16 and so on), nor three from 0.7 to 1.
    for (a, step) in [(0.1, 0.1), (0.7, 0.1), (0.3, 0.07)] {
        let axis = format!(r#""gamma": 1, "n": 2, "dt": 0.01, "E": {{"range": [{a}, 1, {step}]}}"#);
        let study = study(&axis, "");
        let last = study.case(study.len() - 1).and_then(|c| c.number("E"));
        assert_eq!(last, Some(1.0), "{axis}");
    }
}

#[test]
fn cases_under_a_condition_are_numbered_without_making_the_others() {
    // Axes that the condition names, between others that it does not: against all combinations one after the other.
    let axes = r#""E": [1, 2, 3], "gamma": [1, 2, 3, 4], "A": [1, 2], "n": [2, 4, 8], "dt": 0.1, "gap": [0, 0.1, 0.2]"#;
    for when in [
        "gamma > 2 or n == 4",
        "n != 4",
        "E + gap > 1.15 and gamma < 4",
        "gap > 0.1",
        "gamma*n > 31",
    ] {
        let study = study(axes, &format!(r#", "when": "{when}""#));
        let points: Vec<Vec<f64>> = numbers(&study, &["E", "gamma", "A", "n", "gap"]);
        assert_eq!(points.len() as u64, study.len(), "{when}");
        assert!(
            points.len() < 216 && points.is_sorted_by(|a, b| a < b),
            "{when}"
        );
        for from in [0, 5, 40, 107, 108, 215] {
            let mut numbered = study.range(from, 216);
            let skipped = (0..from)
                .filter_map(|raw| study.enumeration().combination(raw))
                .count() as u64;
            let first = numbered.next().map_or(skipped, |(number, _)| number);
            assert_eq!(first, skipped, "{when}");
        }
        for (number, values) in (0..).zip(&points) {
            let case = study.case(number).unwrap();
            let found = ["E", "gamma", "A", "n", "gap"].map(|name| case.number(name).unwrap());
            assert_eq!(&found[..], &values[..], "{when}");
        }
        assert!(study.case(study.len()).is_none());
    }
}
