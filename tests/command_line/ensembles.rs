//! Ensembles: from the study file to the tables.

use crate::Bench;

const STUDY: &str = r#"{"problem": "friction-oscillator", "parameters": {"law": "displacement-control", "alpha": [0.1, 1],
    "x0": {"linspace": [8, 12, 9]}, "dT": "pi/10", "duration": "8*pi"}, "ensemble": "x0",
    "figures": [{"name": "d", "kind": "distribution", "y": "rms_error"}]}"#;

/// The rows of a table as cells.
fn rows(table: &str) -> Vec<Vec<&str>> {
    let lines = table.lines();
    lines.map(|line| line.split(',').collect()).collect()
}

#[test]
fn the_tables_of_an_ensemble_are_those_of_its_cases() {
    let bench = Bench::new();
    bench.file("s.json", STUDY);
    bench.expect(0, &["run", "s.json"]);
    let quantiles = bench.text("figures/s/quantiles.csv");
    let two_samples = bench.text("figures/s/two_samples.csv");
    let results = bench.text("figures/s/results.csv");
    let results = rows(&results);
    let at = |name: &str| results[0].iter().position(|cell| *cell == name).unwrap();
    let (alpha, error) = (at("alpha"), at("rms_error"));
    for row in rows(&quantiles).iter().filter(|row| row[0] == "rms_error") {
        let own = results.iter().filter(|result| result[alpha] == row[1]);
        let mut values: Vec<f64> = own.map(|result| result[error].parse().unwrap()).collect();
        values.sort_by(f64::total_cmp);
        assert_eq!(row[2..4], ["9", "0"]);
        let number = |place: usize| row[place].parse::<f64>().unwrap();
        // Of nine values the 5th is the median, the 3rd a quarter, the 2nd and 8th the ends of its interval.
        let found = [
            number(4),
            number(7),
            number(8),
            number(12),
            number(15),
            number(16),
        ];
        assert_eq!(
            found,
            [
                values[0], values[2], values[4], values[8], values[1], values[7]
            ]
        );
    }
    assert!(
        rows(&two_samples)[1..]
            .iter()
            .all(|row| row[1..4] == ["alpha", "0.1", "1"])
    );
    let manifest = bench.text("figures/s/manifest.json");
    assert!(manifest.contains("quantiles.csv") && manifest.contains("two_samples.csv"));
    // The same bytes from the store, on one thread, and without results.csv.
    for options in [&["--jobs", "1"][..], &["--format", "parquet"]] {
        bench.expect(0, &[&["run", "s.json"], options].concat());
        assert_eq!(bench.text("figures/s/quantiles.csv"), quantiles);
        assert_eq!(bench.text("figures/s/two_samples.csv"), two_samples);
    }
}

#[test]
fn outdated_tables_are_removed() {
    let bench = Bench::new();
    bench.file("s.json", STUDY);
    bench.expect(0, &["run", "s.json"]);
    let exists = |name: &str| bench.path(&format!("figures/s/{name}")).is_file();
    assert!(exists("quantiles.csv") && exists("two_samples.csv"));
    // One ensemble alone has nothing to compare with.
    let one = STUDY.replace("\"ensemble\": \"x0\"", "\"ensemble\": [\"x0\", \"alpha\"]");
    bench.file("s.json", &one);
    bench.expect(0, &["run", "s.json"]);
    assert!(exists("quantiles.csv") && !exists("two_samples.csv"));
    let none = STUDY
        .replace("\"ensemble\": \"x0\",", "")
        .replace("distribution\"", "metric\", \"x\": \"x0\"");
    bench.file("s.json", &none);
    bench.expect(0, &["run", "s.json"]);
    assert!(!exists("quantiles.csv") && exists("d.png"));
}
