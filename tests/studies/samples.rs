//! Distributions against tests: the study of a sliding block, whose tests another program computed.

use serde_json::Value as Json;
use slipgap::statistics::kolmogorov_smirnov::test;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Runs the shipped study; gives results.csv and tests.csv as cells.
fn run(jobs: &str) -> [Vec<Vec<String>>; 2] {
    let root = Path::new(env!("SLIPGAP_ROOT"));
    let out = tempfile::tempdir().unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
        .args([
            "run",
            "studies/calibrate/sliding-tests.json",
            "--jobs",
            jobs,
            "--out",
        ])
        .arg(out.path())
        .current_dir(root)
        .output()
        .unwrap();
    assert!(run.status.success(), "{run:?}");
    ["results.csv", "tests.csv"].map(|name| {
        let text =
            fs::read_to_string(out.path().join("calibrate/sliding-tests").join(name)).unwrap();
        let row = |line: &str| line.split(',').map(String::from).collect();
        text.lines().map(row).collect()
    })
}

fn place(table: &[Vec<String>], name: &str) -> usize {
    table[0].iter().position(|cell| cell == name).unwrap()
}

/// The values of a metric in the cases of a slider, rising.
fn cases(results: &[Vec<String>], slider: &str, metric: &str) -> Vec<f64> {
    let (slider_column, column) = (place(results, "slider"), place(results, metric));
    let rows = results[1..]
        .iter()
        .filter(|row| row[slider_column] == slider);
    let mut values: Vec<f64> = rows.map(|row| row[column].parse().unwrap()).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The largest distance of two distribution functions, by counts at each value.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let part = |values: &[f64], x: f64| {
        values.iter().filter(|y| **y <= x).count() as f64 / values.len() as f64
    };
    let gaps = a.iter().chain(b).map(|x| (part(a, *x) - part(b, *x)).abs());
    gaps.fold(0.0, f64::max)
}

const METRICS: [(&str, &str); 2] = [("peak(block.u)", "peak"), ("rms(block.u)", "rms")];

#[test]
fn the_right_law_is_accepted_in_95_of_100_sets_and_wrong_ones_are_refused() {
    let [results, tests] = run("2");
    // The peaks of the files as they are written, in mm.
    let folder = Path::new(env!("SLIPGAP_ROOT")).join("studies/calibrate/measured/sliding");
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    let reduced = |reduce: &dyn Fn(Vec<f64>) -> f64| -> Vec<f64> {
        let of = |file: &std::path::PathBuf| {
            let text = fs::read_to_string(file).unwrap();
            let rows = text
                .lines()
                .skip(2)
                .map(|line| line.split_once(',').unwrap().1);
            reduce(rows.map(|u| u.parse::<f64>().unwrap() * 1e-3).collect())
        };
        files.iter().map(of).collect()
    };
    let peak = reduced(&|u| u.iter().fold(0.0, |most: f64, x| most.max(x.abs())));
    let rms = reduced(&|u| (u.iter().map(|x| x * x).sum::<f64>() / u.len() as f64).sqrt());
    assert_eq!(tests.len(), 1 + 2 * 3);
    for row in &tests[1..] {
        let cell = |name: &str| &row[place(&tests, name)];
        let number = |name: &str| cell(name).parse::<f64>().unwrap();
        let slider = cell("slider");
        let sample = if row[0].starts_with("peak") {
            &peak
        } else {
            &rms
        };
        let cases = cases(&results, slider, &row[0]);
        assert_eq!([cell("tests"), cell("cases")], ["20", "256"]);
        // Parts of 1/20 and 1/256: their difference is rounded a few times.
        assert!(
            (number("D") - distance(sample, &cases)).abs() < 1e-14,
            "{row:?}"
        );
        assert!(number("D_low") <= number("D") && number("D") <= number("D_high"));
        assert!(number("median_tests_low") <= number("median_tests"));
        assert!(number("q16_cases") < number("median_cases"));
        let verdict = if slider == "friction" {
            "accepted"
        } else {
            "refused"
        };
        assert_eq!(cell("verdict"), verdict, "{row:?}");
        assert_eq!(number("p") < 0.05, verdict == "refused");
    }
    // The same cells on another number of threads, the bootstrap's too.
    assert_eq!(run("1")[1], tests);

    // 100 sets of 30 tests of the same program.
    let text = fs::read_to_string(Path::new(env!("SLIPGAP_ROOT")).join("tests/data/sliding.json"));
    let data: Json = serde_json::from_str(&text.unwrap()).unwrap();
    let accepted = |slider: &str, metric: (&str, &str)| {
        let cases = cases(&results, slider, metric.0);
        let sets = data[metric.1].as_array().unwrap().iter().map(|set| {
            let numbers = set.as_array().unwrap().iter().map(Json::as_f64);
            let mut values: Vec<f64> = numbers.map(Option::unwrap).collect();
            values.sort_by(f64::total_cmp);
            values
        });
        sets.filter(|set| test(set, &cases).unwrap().p >= 0.05)
            .count()
    };
    for metric in METRICS {
        // Of 100 sets that are accepted with a probability of 95 %, fewer than 89 are with one of 0.4 % (binomial).
        let right = accepted("friction", metric);
        assert!(right >= 89, "{metric:?}: {right}");
        for wrong in ["half", "dashpot"] {
            let count = accepted(wrong, metric);
            assert!(
                count <= 5,
                "{wrong} {metric:?}: {count} of 100 are accepted"
            );
        }
    }
}
