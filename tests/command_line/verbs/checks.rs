//! Checks that are met, checks that are not, and cases that cannot be solved.

use crate::{Bench, TWO, friction, shipped};
use std::fs;

#[test]
fn a_check_writes_no_files() {
    let bench = Bench::new();
    let done = bench.expect(0, &["check", &format!("{}/friction-fig5.json", shipped())]);
    assert!(done.out.starts_with("study"), "{}", done.out);
    assert!(done.err.contains("checks, 0 not met"), "{}", done.err);
    assert_eq!(bench.tree("."), [""; 0]);
}

#[test]
fn a_stricter_limit_is_not_met() {
    let bench = Bench::new();
    let fig5 = fs::read_to_string(format!("{}/friction-fig5.json", shipped())).unwrap();
    let tight = fig5.replace("\"max\": 0.02455", "\"max\": 0.02445");
    assert_ne!(fig5, tight);
    bench.file("tight.json", tight);
    let done = bench.expect(5, &["check", "tight.json"]);
    let lines: Vec<&str> = done
        .out
        .lines()
        .filter(|l| l.ends_with("NOT MET"))
        .collect();
    let words: Vec<&str> = lines[0].split_whitespace().collect();
    assert_eq!(lines.len(), 1, "{}", done.out);
    assert_eq!(words[..3], ["tight", "0", "rms_error"]);
    assert!(words[3].starts_with("0.02445") && words[3] > "0.02445");
    assert_eq!(words[4..7], ["0.02445", "..", "0.02445"]);
}

#[test]
fn a_metric_without_a_value_does_not_meet_its_check() {
    let bench = Bench::new();
    // The run ends before the exact solution is at rest.
    let short = TWO.replace("8*pi", "2*pi");
    let check = r#", "checks": [{ "metric": "rest_error", "max": 1e9 }]"#;
    bench.file("s.json", friction(&short, check));
    let done = bench.expect(5, &["check", "s.json"]);
    assert_eq!(done.out.matches("undefined").count(), 2, "{}", done.out);
    assert!(done.err.contains("2 checks, 2 not met"), "{}", done.err);
    bench.expect(0, &["run", "s.json"]);
}

#[test]
fn a_list_in_where_checks_every_case_with_one_of_its_values() {
    let bench = Bench::new();
    let three = TWO.replace("[0.1, 1]", "[0.1, 1, 5]");
    // An error is >= 0, so that no check is met.
    let check = |values: &str| {
        let check =
            format!(r#"{{ "metric": "rms_error", "where": {{ "alpha": {values} }}, "max": -1 }}"#);
        bench.file(
            "s.json",
            friction(&three, &format!(r#", "checks": [{check}]"#)),
        );
        let done = bench.expect(5, &["check", "s.json"]);
        let rows = done.out.lines().filter(|line| line.ends_with("NOT MET"));
        let case = |line: &str| line.split_whitespace().nth(1).map(str::to_owned);
        rows.filter_map(case).collect::<Vec<_>>()
    };
    assert_eq!(check("[5, 0.1]"), ["0", "2"]);
    assert_eq!(check("[1, 1, \"1\"]"), ["1"]);
    assert_eq!(check("5"), ["2"]);
}

/// A step of 10^300 takes the velocity beyond the largest double.
const WILD: &str =
    r#""law": "displacement-control", "alpha": 1, "dT": [0.1, 1e300], "duration": [10, 1e300]"#;

#[test]
fn a_case_without_a_solution_keeps_its_row() {
    let bench = Bench::new();
    let wild = WILD
        .replace("[0.1, 1e300]", "1e300")
        .replace("[10, 1e300]", "1e300");
    let tame = WILD
        .replace("[0.1, 1e300]", "0.1")
        .replace("[10, 1e300]", "10");
    let blocks = [&tame, &wild, &tame].map(|p| format!("{{ \"parameters\": {{ {p} }} }}"));
    let more = r#""figures": [{ "name": "history", "kind": "history" }, { "name": "law", "kind": "law" },
        { "name": "metric", "kind": "metric", "x": "dT", "y": "rms_error", "x_scale": "log" }],
        "checks": [{ "metric": "rms_error", "max": 1 }]"#;
    bench.file(
        "s.json",
        format!(
            "{{ \"problem\": \"friction-oscillator\", \"blocks\": [{}], {more} }}",
            blocks.join(", ")
        ),
    );
    let done = bench.expect(3, &["run", "s.json", "--histories"]);
    assert!(
        done.err.contains("s.json: case 1 could not be solved: "),
        "{}",
        done.err
    );
    let text = bench.text("figures/s/results.csv");
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!(rows.len(), 4);
    assert_eq!(
        rows[2],
        "1,displacement-control,1.0,,1e300,1e300,12.0,unloaded,,,,,,,,,"
    );
    assert_eq!(rows[1][1..], rows[3][1..]);
    assert!(!rows[1].ends_with(','));
    let written = bench.tree("figures/s").join(" ");
    assert_eq!(
        written,
        "failures.csv histories/0.csv histories/2.csv history.pdf history.png history.svg law.pdf law.png law.svg manifest.json metric.pdf metric.png metric.svg results.csv"
    );
    let done = bench.expect(3, &["check", "s.json"]);
    assert!(done.err.contains("3 checks, 1 not met"), "{}", done.err);
}
