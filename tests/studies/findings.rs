//! Numbers of docs/findings.md, docs/findings-friction.md, docs/errata.md and the ledger, computed anew from the studies.
//!
//! The pages give two to four digits. Each tolerance here is half a unit of the last digit given, rounded up.

use crate::common;
use common::case;
use serde_json::json;
use slipgap::problem::{Problem, find};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::path::Path;
use std::process::Command;

/// The rows of a study's table, by column, wherever its folder of results is.
fn table(study: &Path) -> Vec<BTreeMap<String, f64>> {
    let out = tempfile::tempdir().unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
        .arg("run")
        .arg(study)
        .arg("--out")
        .arg(out.path())
        .output()
        .unwrap();
    assert!(run.status.success(), "{run:?}");
    let mut files = walkdir::WalkDir::new(out.path())
        .into_iter()
        .map(|entry| entry.unwrap().into_path());
    let results = files.find(|file| file.ends_with("results.csv")).unwrap();
    let text = std::fs::read_to_string(results).unwrap();
    let mut lines = text.lines();
    // The name of a metric with two arguments has a comma.
    let head = lines.next().unwrap().replace(", ", " ").replace('"', "");
    let columns: Vec<&str> = head.split(',').collect();
    let row = |line: &str| {
        let cells = columns.iter().zip(line.split(','));
        let numbers = cells.filter_map(|(c, x)| Some((c.to_string(), x.parse().ok()?)));
        numbers.collect()
    };
    lines.map(row).collect()
}

fn shipped(name: &str) -> Vec<BTreeMap<String, f64>> {
    let root = Path::new(env!("SLIPGAP_ROOT"));
    table(&root.join("studies").join(format!("{name}.json")))
}

fn written(text: &str) -> Vec<BTreeMap<String, f64>> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("study.json");
    std::fs::write(&file, text).unwrap();
    table(&file)
}

fn near(x: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (x - expected).abs() <= tolerance,
        "{what}: {x}, not {expected}"
    );
}

fn is(row: &BTreeMap<String, f64>, column: &str, x: f64) -> bool {
    row.get(column).is_some_and(|y| (x - y).abs() <= 1e-9 * x)
}

/// Root mean square of `rms_error` over the rows.
fn mean<'a>(rows: impl Iterator<Item = &'a BTreeMap<String, f64>>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for row in rows {
        sum += row["rms_error"] * row["rms_error"];
        count += 1.0;
    }
    (sum / count).sqrt()
}

#[test]
fn a_small_beta_is_good_for_every_release_and_beta_like_the_step_is_not() {
    let rows = shipped("friction/friction-releases");
    for (parts, small, like, least, alpha, worse) in [
        (10.0, 0.0178, 0.0295, 0.0175, 0.0239, 61.0),
        (20.0, 0.0056, 0.0240, 0.0056, 0.0139, 83.0),
        (40.0, 0.0020, 0.0176, 0.0020, 0.0073, 92.0),
        (80.0, 0.00087, 0.0113, 0.00087, 0.0038, 93.0),
    ] {
        let step = PI / parts;
        let of_step: Vec<_> = rows.iter().filter(|row| is(row, "dT", step)).collect();
        let of = |column: &str, width: f64| {
            let rows: Vec<_> = of_step
                .iter()
                .copied()
                .filter(|row| is(row, column, width))
                .collect();
            assert_eq!(rows.len(), 121, "{column} {width}");
            rows
        };
        let (narrow, wide) = (of("beta", 1e-4), of("beta", step));
        let digit = if parts > 50.0 { 0.5e-5 } else { 0.5e-4 };
        let base = mean(narrow.iter().copied());
        near(base, small, digit, "mean at 0.0001");
        near(
            mean(wide.iter().copied()),
            like,
            0.5e-4,
            "mean at beta = dT",
        );
        near(
            mean(of("alpha", 1e-4).into_iter()),
            alpha,
            0.5e-4,
            "mean at alpha = 0.0001",
        );
        let pairs = narrow.iter().zip(&wide);
        let count = pairs
            .filter(|(a, b)| b["rms_error"] > a["rms_error"])
            .count();
        near(count as f64 / 1.21, worse, 0.5, "share of releases");
        let widths: Vec<f64> = (0..41)
            .map(|i| 10_f64.powf(-4.0 + 0.1 * f64::from(i)))
            .collect();
        let means: Vec<f64> = widths
            .iter()
            .map(|b| mean(of("beta", *b).into_iter()))
            .collect();
        let best = means.iter().copied().fold(f64::INFINITY, f64::min);
        near(best, least, digit, "least mean");
        for (width, mean) in widths.iter().zip(&means) {
            assert!(
                *width > step * step / 4.0 || *mean <= 1.1 * best,
                "pi/{parts}: {width}"
            );
        }
    }
}

#[test]
fn the_error_of_r_falls_to_the_end_of_the_range_of_gamma() {
    let rows = written(
        r#"{ "problem": "bar-impact", "parameters": { "n": [2, 4, 10, 40, 112], "gamma": [0.25, 1, 2, 7, 8], "dt": 0.0005, "duration": 1.5 } }"#,
    );
    let value = |n: f64, gamma: f64, column: &str| {
        let found = rows
            .iter()
            .find(|row| is(row, "n", n) && is(row, "gamma", gamma));
        found.unwrap()[column]
    };
    for (n, gamma, expected) in [
        (10.0, 1.0, 0.082),
        (10.0, 2.0, 0.053),
        (10.0, 7.0, 0.047),
        (10.0, 8.0, 0.032),
        (40.0, 1.0, 0.026),
        (40.0, 2.0, 0.018),
        (40.0, 8.0, 0.010),
    ] {
        near(value(n, gamma, "rms_error_r"), expected, 0.6e-3, "r");
    }
    for (n, expected) in [
        (2.0, 0.60),
        (4.0, 0.40),
        (10.0, 0.39),
        (40.0, 0.36),
        (112.0, 0.34),
    ] {
        near(value(n, 1.0, "rms_error_rdot"), expected, 0.6e-2, "rdot");
    }
    for (n, gamma, expected) in [(10.0, 1.0, 0.39), (40.0, 1.0, 0.39), (40.0, 0.25, 0.07)] {
        near(
            value(n, gamma, "rdot_oscillation"),
            expected,
            0.6e-2,
            "oscillation",
        );
    }
}

#[test]
fn a_step_that_is_not_iterated_makes_energy_on_the_way() {
    let root = Path::new(env!("SLIPGAP_ROOT"));
    let rows = table(&root.join("studies/claims/impact-once.json"));
    let rows_of = |dt: f64| {
        let rows = rows
            .iter()
            .filter(move |row| is(row, "dt", dt) && is(row, "duration", 6.0));
        rows.collect::<Vec<_>>()
    };
    let half = rows_of(0.5)
        .into_iter()
        .find(|row| row["gap"] == 0.0)
        .unwrap();
    near(
        1.0 + half["energy_drift_max"],
        46.7,
        0.05,
        "greatest energy",
    );
    near(1.0 + half["energy_drift_final"], 17.0, 0.5, "last energy");
    let fine = rows_of(0.05);
    let most = |column: &str| {
        fine.iter()
            .map(|row| row[column])
            .fold(f64::NEG_INFINITY, f64::max)
    };
    near(most("energy_drift_max"), 0.33, 0.005, "gain on the way");
    for row in &fine {
        assert!(
            (-0.115..=-0.065).contains(&row["energy_drift_final"]),
            "{row:?}"
        );
    }
    let converged = written(
        r#"{ "problem": "bar-impact", "parameters": { "k_I": 100, "n": 10, "dt": 0.05, "duration": 6 } }"#,
    );
    near(
        most("max_overlap") / converged[0]["max_overlap"],
        1.68,
        0.005,
        "overlap",
    );
}

/// Squares of the velocity's error at the nodes further than 0.25 L from a front at |x| = `front`: all, and their count;
/// those of the two contact nodes.
fn away(problem: &dyn Problem, gamma: f64, n: u32, t: f64, front: f64) -> (f64, f64, f64) {
    let case = case(
        problem,
        &json!({ "gamma": gamma, "n": n, "dt": 0.002, "duration": 1.0 }),
    );
    let snapshots = problem.as_textbook().unwrap().snapshots(&case, &[t]);
    let (mut sum, mut count, mut contact) = (0.0, 0.0, 0.0);
    for (bar, points) in [1.0, -1.0]
        .into_iter()
        .zip(&snapshots[0].profiles[0].computed)
    {
        for [x, v] in points {
            let x = x.abs();
            if (x - front).abs() <= 0.25 + 1e-12 {
                continue;
            }
            // 1 ahead of the front, 0 behind it; -1 behind it on its way back.
            let ahead = if t <= 0.5 { bar } else { -bar };
            let error = v - if x > front { ahead } else { 0.0 };
            sum += error * error;
            count += 1.0;
            if x < 1e-12 {
                contact += error * error;
            }
        }
    }
    (sum, count, contact)
}

#[test]
fn away_from_fronts_the_difference_is_that_of_the_contact_nodes() {
    let problem = find("bar-impact").unwrap();
    for n in [10, 40] {
        for (t, front) in [(0.25, 0.5), (0.5, 1.0), (0.75, 0.5)] {
            let (sum, count, contact) = away(&*problem, 1.0, n, t, front);
            let share = contact / sum;
            assert!((0.615..0.955).contains(&share), "n = {n}, t = {t}: {share}");
            let rest = ((sum - contact) / (count - 2.0)).sqrt();
            assert!((0.035..0.175).contains(&rest), "n = {n}, t = {t}: {rest}");
        }
    }
    // A front at 9 is outside the bar, so nothing is left out, not even at the free end where the front stands.
    for (t, front, expected) in [(0.49, 0.98, 0.020), (0.5, 9.0, 0.183), (0.51, 0.98, 0.018)] {
        let (sum, count, _) = away(&*problem, 0.25, 40, t, front);
        near((sum / count).sqrt(), expected, 0.5e-3, "velocity");
    }
}

#[test]
fn a_disturbance_grows_a_thousand_times_more_in_the_force_than_in_r() {
    let problem = find("bar-impact").unwrap();
    let solve = |gap: f64| {
        let case = json!({ "k_I": 1e5, "n": 10, "dt": 0.001, "duration": 0.37, "gap": gap });
        problem
            .solve(&self::case(&*problem, &case), &[])
            .unwrap()
            .computed
    };
    let (calm, disturbed) = (solve(0.0), solve(1e-13));
    let most = |a: &[f64], b: &[f64]| {
        let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        differences.fold(0.0, f64::max) / 1e-13
    };
    // The size of a growth: its digits depend on round-off.
    let force = most(calm.force(), disturbed.force());
    let r = most(calm.displacement(), disturbed.displacement());
    assert!((0.5e9..2e9).contains(&force), "{force}");
    assert!((3.5e5..14e5).contains(&r), "{r}");
}
