//! Results in the units of a study: tables, checks and indices.

use crate::packed::unpacked;
use crate::{Bench, bars};
use std::fs;

const CASES: &str = r#""gamma": [0.5, 1, 2], "n": 10, "dt": 0.05, "duration": 2"#;

const UNITS: &str = r#", "units": {"length": "mm", "force": "kN", "time": "ms"}"#;

/// The store's files with their bytes.
fn store(bench: &Bench) -> Vec<(String, Vec<u8>)> {
    let names = bench.everything("figures/s/store").into_iter();
    let parts = names.filter(|name| name.starts_with("part-"));
    parts
        .map(|name| {
            let bytes = fs::read(bench.path("figures/s/store").join(&name));
            (name, bytes.unwrap())
        })
        .collect()
}

#[test]
fn units_need_no_computing_and_do_not_change_the_store() {
    let bench = Bench::new();
    bench.file("s.json", bars(CASES, ""));
    bench.expect(0, &["run", "s.json"]);
    let (plain, parts) = (bench.text("figures/s/results.csv"), store(&bench));
    assert!(!plain.contains("_in_") && !parts.is_empty());
    bench.expect(0, &["run", "s.json", "--out", "plain"]);
    bench.file("s.json", bars(CASES, UNITS));
    let done = bench.expect(0, &["run", "s.json"]);
    let first = done.err.lines().next();
    assert_eq!(first, Some("s: 3 of 3 cases from the store"), "{done:?}");
    assert_eq!(store(&bench), parts);
    let table = bench.text("figures/s/results.csv");
    assert!(table.contains(",peak_force,peak_force_in_kN,"), "{table}");
    // Columns in units are not compared.
    bench.expect(0, &["compare", "plain", "figures"]);
    bench.expect(0, &["compare", "figures", "plain"]);
    // Other names, then no units.
    bench.file("s.json", bars(CASES, &UNITS.replace("kN", "MN")));
    let done = bench.expect(0, &["run", "s.json"]);
    let first = done.err.lines().next();
    assert_eq!(first, Some("s: 3 of 3 cases from the store"), "{done:?}");
    assert!(
        bench
            .text("figures/s/results.csv")
            .contains(",peak_force_in_MN,")
    );
    bench.file("s.json", bars(CASES, ""));
    bench.expect(0, &["run", "s.json"]);
    assert_eq!(bench.text("figures/s/results.csv"), plain);
    assert_eq!(store(&bench), parts);
}

#[test]
fn checks_figures_and_histories_use_results_in_units() {
    let bench = Bench::new();
    // Bars of [I]: F0 = A V0 sqrt(E rho) = 0.1, T_I = 0.2; the scaled peak of one spring is between 1 and 2.
    let check = r#", "checks": [{"metric": "peak_force_in_kN", "where": {"gamma": 1}, "min": 0.1, "max": MAX}]"#;
    let figures = r#", "figures": [{"name": "m", "kind": "metric", "x": "gamma", "y": "peak_force_in_kN"},
        {"name": "h", "kind": "history", "in_units": true}]"#;
    let study = |max: &str| {
        bars(
            CASES,
            &format!("{UNITS}{figures}{check}").replace("MAX", max),
        )
    };
    bench.file("s.json", study("0.2"));
    let done = bench.expect(0, &["check", "s.json"]);
    assert!(done.out.contains("peak_force_in_kN"), "{}", done.out);
    bench.file("s.json", study("0.11"));
    bench.expect(5, &["check", "s.json"]);
    bench.expect(0, &["run", "s.json", "--histories"]);
    let history = bench.text("figures/s/histories/0.csv");
    assert!(history.starts_with("t,t_in_ms,r,r_in_mm,rdot,rdot_in_mm_per_ms,force,force_in_kN,"));
    assert!(bench.path("figures/s/h.png").is_file());
    // Also from the store.
    bench.expect(0, &["report", "s.json"]);
    let page = unpacked(&bench.text("figures/report.html"));
    assert!(page.contains("\"name\":\"peak_force_in_kN\""));
    let done = bench.expect(0, &["explain", "s.json"]);
    assert!(
        done.out.contains("peak_force, peak_force_in_kN,"),
        "{}",
        done.out
    );
}

#[test]
fn indices_of_a_force_in_units_depend_on_the_velocity() {
    // The scaled peak does not depend on V0, and little on gamma. The force is proportional to V0.
    let bench = Bench::new();
    let study = bars(
        r#""gamma": {"uniform": [0.5, 0.6]}, "V0": {"uniform": [1, 2]}, "n": 10, "dt": 0.05, "duration": 0.5"#,
        r#", "design": {"kind": "saltelli", "n": 64}, "units": {"length": "m", "force": "N", "time": "s"}"#,
    );
    bench.file("s.json", study);
    bench.expect(0, &["run", "s.json"]);
    let table = bench.text("figures/s/sobol.csv");
    let total = |metric: &str| -> f64 {
        let row = table
            .lines()
            .find(|row| row.starts_with(&format!("0,{metric},V0,")));
        row.unwrap().split(',').nth(6).unwrap().parse().unwrap()
    };
    assert!(total("peak_force").abs() < 1e-12);
    assert!(total("peak_force_in_N") > 0.9);
}
