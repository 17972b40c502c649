//! Reductions: the table, figures, checks and faults. The expected values are computed here, from the rows of results.csv.

use crate::{Bench, bars};

/// Two laws with widths of their own, and a metric that is empty in the cases that end too early.
const LAWS: &str = r#"{"problem": "friction-oscillator", "blocks": [
  {"parameters": {"law": "displacement-control", "alpha": [0.3, 1, 3], "dT": ["pi/10", "pi/20"], "duration": "8*pi"}},
  {"parameters": {"law": "velocity-control", "beta": [0.1, 0.3], "dT": ["pi/10", "pi/20"], "duration": ["8*pi", "2*pi"]},
   "zip": [["beta", "duration"]]}]"#;

/// The rows of a table as cells; cells in quotes may have commas.
fn table(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let rows = reader.records().map(Result::unwrap);
    let lines = std::iter::once(header).chain(rows);
    lines
        .map(|row| row.iter().map(String::from).collect())
        .collect()
}

/// The cells of a column.
fn column(table: &[Vec<String>], name: &str) -> Vec<String> {
    let column = table[0]
        .iter()
        .position(|cell| cell == name)
        .unwrap_or_else(|| panic!("{name} in {:?}", table[0]));
    table[1..].iter().map(|row| row[column].clone()).collect()
}

fn numbers(table: &[Vec<String>], name: &str) -> Vec<Option<f64>> {
    let cells = column(table, name).into_iter();
    cells.map(|cell| cell.parse().ok()).collect()
}

#[test]
fn the_table_has_every_reduction_of_every_group() {
    let bench = Bench::new();
    let study = format!(
        r#"{LAWS}, "reductions": ["least rms_error over alpha, beta", "mean rms_error over alpha, beta",
            "quantile 0.25 of rms_error over alpha, beta", "worst rest_error over alpha, beta"]}}"#
    );
    bench.file("s.json", &study);
    let done = bench.expect(0, &["run", "s.json", "--verbose"]);
    let note = "s.json: \"worst rest_error over alpha, beta\" leaves out 2 of 10 cases, which have no value";
    assert!(done.err.contains(note), "{}", done.err);
    assert!(done.out.contains("reductions.csv"));
    assert!(
        bench
            .text("figures/s/manifest.json")
            .contains("\"reductions.csv\"")
    );
    let results = table(&bench.text("figures/s/results.csv"));
    let text = bench.text("figures/s/reductions.csv");
    let found = table(&text);
    assert_eq!(
        found[0].join(","),
        "reduction,law,alpha,beta,dT,duration,cases,empty,value"
    );
    // The duration advances with beta, so that it is reduced over, too: two groups of three cases, two of two.
    let groups: [&[usize]; 4] = [&[0, 2, 4], &[1, 3, 5], &[6, 8], &[7, 9]];
    let errors = numbers(&results, "rms_error");
    let rests = numbers(&results, "rest_error");
    let value = numbers(&found, "value");
    let cells = |name: &str| column(&found, name);
    let (alpha, beta, cases, empty) = (
        cells("alpha"),
        cells("beta"),
        cells("cases"),
        cells("empty"),
    );
    assert_eq!(found.len(), 1 + 4 * groups.len());
    for (i, group) in groups.into_iter().enumerate() {
        let mut of: Vec<f64> = group.iter().map(|case| errors[*case].unwrap()).collect();
        let mean = of.iter().sum::<f64>() / of.len() as f64;
        let found = group
            .iter()
            .min_by(|a, b| errors[**a].unwrap().total_cmp(&errors[**b].unwrap()));
        let best = *found.unwrap();
        assert_eq!(cells("law")[i], column(&results, "law")[best]);
        assert_eq!(cells("dT")[i], column(&results, "dT")[best]);
        assert_eq!(value[i], errors[best]);
        assert_eq!(alpha[i], column(&results, "alpha")[best]);
        assert_eq!(beta[i], column(&results, "beta")[best]);
        assert_eq!(cells("duration")[i], column(&results, "duration")[best]);
        // The others are of no single case.
        assert_eq!(value[4 + i], Some(mean));
        assert_eq!(
            [&alpha[4 + i], &beta[4 + i], &cells("duration")[4 + i]],
            ["", "", ""]
        );
        of.sort_by(f64::total_cmp);
        // A quarter of the way along three values is half-way from the first to the second; along two a quarter.
        let part = 0.25 * (of.len() - 1) as f64;
        let quantile = of[0] + part * (of[1] - of[0]);
        assert!((value[8 + i].unwrap() - quantile).abs() <= 1e-15 * quantile);
        let worst = group
            .iter()
            .filter_map(|case| rests[*case])
            .max_by(|a, b| a.abs().total_cmp(&b.abs()));
        assert_eq!(value[12 + i], worst);
        assert_eq!(cases[12 + i], group.len().to_string());
        let lacking = group.iter().filter(|case| rests[**case].is_none()).count();
        assert_eq!(empty[12 + i], lacking.to_string());
    }
    assert_eq!(empty[14..], ["1", "1"]);
    // The same from other threads and from the store; no table without the key.
    bench.expect(0, &["run", "s.json", "--out", "one", "--jobs", "1"]);
    bench.expect(0, &["run", "s.json", "--out", "seven", "--jobs", "7"]);
    bench.expect(0, &["run", "s.json"]);
    for folder in ["one", "seven", "figures"] {
        assert_eq!(bench.text(&format!("{folder}/s/reductions.csv")), text);
    }
    bench.file("s.json", format!("{LAWS}}}"));
    bench.expect(0, &["run", "s.json"]);
    assert!(!bench.path("figures/s/reductions.csv").exists());
}

#[test]
fn checks_choose_cases_before_they_are_reduced() {
    let bench = Bench::new();
    let reduction = "best rms_error over alpha, beta";
    let study = |checks: &str| {
        let text = format!(r#"{LAWS}, "reductions": ["{reduction}"], "checks": [{checks}]}}"#);
        bench.file("s.json", text);
    };
    study("");
    bench.expect(0, &["run", "s.json"]);
    let results = table(&bench.text("figures/s/results.csv"));
    let errors = numbers(&results, "rms_error");
    let least = |cases: &[usize]| {
        let errors = cases.iter().map(|case| (*case, errors[*case].unwrap()));
        errors.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
    };
    let (of_three, two) = (least(&[0, 2, 4]), least(&[2, 4]));
    assert_ne!(of_three.0, two.0);
    let check = |filter: &str, max: f64| {
        format!(r#"{{"metric": "{reduction}", "where": {{{filter}}}, "max": {max}}}"#)
    };
    let chosen = r#""dT": "pi/10", "law": "displacement-control""#;
    let fewer = format!(r#"{chosen}, "alpha": [1, 3]"#);
    study(
        &[
            check(chosen, of_three.1),
            check(&fewer, of_three.1),
            check("", 1.0),
        ]
        .join(","),
    );
    let done = bench.expect(5, &["check", "s.json"]);
    let rows: Vec<&str> = done.out.lines().skip(1).collect();
    // One check of one group, another, and four groups.
    assert_eq!(rows.len(), 6, "{}", done.out);
    let starts = |row: &str, case: usize| {
        let mut words = row.split_whitespace();
        words.nth(1) == Some(&case.to_string())
    };
    assert!(
        starts(rows[0], of_three.0) && rows[0].ends_with("ok"),
        "{}",
        done.out
    );
    assert!(
        starts(rows[1], two.0) && rows[1].ends_with("NOT MET"),
        "{}",
        done.out
    );
    assert!(done.err.contains("6 checks, 1 not met"), "{}", done.err);
    // What is left out is reported.
    let rest = r#"{"metric": "worst rest_error over alpha, beta", "max": 1}"#;
    let text = format!(
        r#"{LAWS}, "reductions": ["worst rest_error over alpha, beta"], "checks": [{rest}]}}"#
    );
    bench.file("rest.json", text);
    let done = bench.expect(0, &["check", "rest.json"]);
    let note = "rest.json: \"worst rest_error over alpha, beta\" leaves out 2 of 10 cases";
    assert!(done.err.contains(note), "{}", done.err);
    // The page has the same verdicts.
    bench.expect(0, &["report", "s.json"]);
    let page = bench.text("figures/report.html");
    assert!(page.contains("Checks: 5 of 6 met"));
}

#[test]
fn figures_show_groups_of_samples_and_of_structures_once() {
    let bench = Bench::new();
    // Samples of gamma are reduced, the list of n remains; in units, F0 = A V0 sqrt(E rho) = 0.1.
    let more = r#", "design": {"kind": "latin-hypercube", "n": 8}, "units": {"length": "m", "force": "kN", "time": "s"},
        "reductions": ["worst peak_force over gamma", "worst peak_force_in_kN over gamma"],
        "figures": [{"name": "m", "kind": "metric", "x": "n", "y": ["worst peak_force over gamma", "worst peak_force_in_kN over gamma"]}]"#;
    let cases = r#""gamma": {"uniform": [0.5, 2]}, "n": [4, 8, 12], "dt": 0.01, "duration": 1.5"#;
    bench.file("s.json", bars(cases, more));
    bench.expect(0, &["run", "s.json"]);
    let found = table(&bench.text("figures/s/reductions.csv"));
    let value = numbers(&found, "value");
    assert_eq!(column(&found, "cases"), ["8"; 6]);
    for i in 0..3 {
        let (scaled, in_units) = (value[i].unwrap(), value[3 + i].unwrap());
        assert!(
            (in_units - 0.1 * scaled).abs() < 1e-15,
            "{scaled} {in_units}"
        );
    }
    assert!(bench.path("figures/s/m.png").is_file());
    // Of a structure: the metric is computed because it is reduced, and has blanks.
    let structure = r#"{"problem": "structure", "parameters": {"seed": [1, 2, 3], "k": [10, 20], "dt": 0.01, "duration": 3},
      "structure": {"masses": {"a": 1, "b": 2}, "springs": [{"between": ["ground", "a"], "k": "k"}, {"between": ["a", "b"], "k": 5}],
        "units": "t, kN, m, s", "ground": {"synthetic": {"seed": "seed"}}},
      "reductions": ["median peak(a - b) over seed"],
      "figures": [{"name": "m", "kind": "metric", "x": "k", "y": "median peak(a - b) over seed"}],
      "checks": [{"metric": "median peak(a - b) over seed", "min": 0}]}"#;
    bench.file("t.json", structure);
    bench.expect(0, &["run", "t.json"]);
    let results = table(&bench.text("figures/t/results.csv"));
    let peaks = numbers(&results, "peak(a - b)");
    let found = table(&bench.text("figures/t/reductions.csv"));
    for (k, value) in numbers(&found, "value").into_iter().enumerate() {
        // The cases are seed x k.
        let mut of = [0, 1, 2].map(|seed| peaks[2 * seed + k].unwrap());
        of.sort_by(f64::total_cmp);
        assert_eq!(value, Some(of[1]));
    }
    let done = bench.expect(0, &["check", "t.json"]);
    assert!(done.err.contains("2 checks, 0 not met"), "{}", done.err);
    bench.file(
        "t.json",
        structure.replace("[\"median peak(a - b)", "[\"median peak(a - c)"),
    );
    let done = bench.expect(2, &["run", "t.json"]);
    assert!(
        done.err.contains("reductions[0]: \"peak(a - c)\""),
        "{}",
        done.err
    );
}
