//! Histories and metrics compared with independent programs (tests/reference), which use 50 digits.

use crate::common;
use common::case;
use serde_json::Value as Json;
use slipgap::problem::{Metric, Solution, find};

fn data(file: &str) -> Json {
    let path = format!("{}/tests/data/{file}", env!("SLIPGAP_ROOT"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Largest difference of the thinned history, row by row.
fn history_difference(solution: &Solution, rows: &Json) -> f64 {
    let (c, e) = (&solution.computed, &solution.exact);
    let mut largest: f64 = 0.0;
    for row in rows.as_array().unwrap() {
        let row: Vec<f64> = row
            .as_array()
            .unwrap()
            .iter()
            .map(|x| x.as_f64().unwrap())
            .collect();
        let i = row[0] as usize;
        let ours = [
            c.time[i],
            c.displacement()[i],
            c.velocity()[i],
            c.force()[i],
            e.displacement()[i],
            e.velocity()[i],
        ];
        for (ours, theirs) in ours.iter().zip(&row[1..]) {
            largest = largest.max((ours - theirs).abs());
        }
    }
    largest
}

/// Solves every case of a file and compares; `tolerance` of the history from the case's data.
fn compare(file: &str, tolerance: impl Fn(&Json) -> f64) {
    let data = data(file);
    let problem = find(data["problem"].as_str().unwrap()).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert!(cases.len() > 30);
    let mut faults = Vec::new();
    for record in cases {
        let parameters = &record["parameters"];
        let case = case(&*problem, parameters);
        assert_eq!(
            case.steps(),
            record["steps"].as_u64().unwrap(),
            "{parameters}"
        );
        let row_if_known = |(row, metric): (usize, &Metric)| {
            record["metrics"]
                .get(&*metric.name)
                .is_some()
                .then_some(row)
        };
        let known: Vec<usize> = problem
            .metrics()
            .iter()
            .enumerate()
            .filter_map(row_if_known)
            .collect();
        let solution = problem.solve(&case, &known).unwrap();
        let tolerance = tolerance(record);
        let difference = history_difference(&solution, &record["history"]);
        if difference.is_nan() || difference > tolerance {
            faults.push(format!(
                "history {difference:e} > {tolerance:e}: {parameters}"
            ));
        }
        for (metric, ours) in problem.metrics().iter().zip(&solution.metrics) {
            let theirs = record["metrics"][&*metric.name].as_f64();
            // An arc cosine near 1 amplifies an error of 1e-16 to 1e-8.
            let tolerance = match &*metric.name {
                "sprague_geers_phase" | "sprague_geers_combined" => 2e-8,
                _ => tolerance,
            };
            let near = match (ours, theirs) {
                (Some(a), Some(b)) => (a - b).abs() <= tolerance,
                (None, None) => true,
                _ => false,
            };
            if !near {
                faults.push(format!(
                    "{} {ours:?}, not {theirs:?}: {parameters}",
                    metric.name
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn friction() {
    // Round-off of numbers of the size of x0, a random walk over the steps; S is a displacement over alpha.
    compare("friction.json", |record| {
        let number = |name: &str| record["parameters"][name].as_f64();
        let x0 = number("x0").unwrap().abs().max(1.0);
        let steps = record["steps"].as_f64().unwrap();
        let width = number("alpha").or(number("beta")).unwrap().min(1.0);
        4.0 * f64::EPSILON * x0 * steps.sqrt() / width
    });
}

#[test]
fn impact() {
    // The data contain the sensitivity of each history to r(0), which amplifies round-off.
    compare("impact.json", |record| {
        (1e-14 * record["sensitivity"].as_f64().unwrap()).max(1e-12)
    });
}

#[test]
fn profiles() {
    let data = data("impact.json");
    let problem = find("bar-impact").unwrap();
    let records = data["profiles"].as_array().unwrap();
    assert!(records.len() > 5);
    for record in records {
        let parameters = &record["parameters"];
        let case = case(&*problem, parameters);
        let snapshots = problem
            .as_textbook()
            .unwrap()
            .snapshots(&case, &[case.number("duration").unwrap()]);
        for (name, lines) in ["velocity", "stress"].iter().zip(&snapshots[0].profiles) {
            let computed = in_order(&lines.computed);
            // In the data the exact profile is at the centres of the elements.
            let centres = in_order(&snapshots[0].profiles[1].computed);
            let exact: Vec<f64> = centres
                .iter()
                .map(|&[x, _]| {
                    let part = usize::from(x > 0.0);
                    let line = &lines.exact[part];
                    let mut ends = line.chunks(2);
                    let inside = |pair: &&[[f64; 2]]| (pair[0][0] - x) * (pair[1][0] - x) <= 0.0;
                    ends.find(inside).unwrap()[0][1]
                })
                .collect();
            let computed: Vec<f64> = computed.iter().map(|point| point[1]).collect();
            let theirs = |key: String| -> Vec<f64> {
                let numbers = record[key.as_str()].as_array().unwrap();
                numbers.iter().map(|x| x.as_f64().unwrap()).collect()
            };
            for (ours, theirs, what) in [
                (computed, theirs(name.to_string()), "computed"),
                (exact, theirs(format!("{name}_exact")), "exact"),
            ] {
                assert_eq!(ours.len(), theirs.len(), "{what} {name}: {parameters}");
                for (a, b) in ours.iter().zip(&theirs) {
                    // Round-off of sums over up to 41 modes and a stiffness of up to 40 elements.
                    assert!((a - b).abs() < 1e-11, "{what} {name} {a} {b}: {parameters}");
                }
            }
        }
    }
}

/// Points of all parts from left to right; parts are given from the contact on.
fn in_order(parts: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = parts[0].iter().rev().copied().collect();
    points.extend(parts.iter().skip(1).flatten());
    points
}
