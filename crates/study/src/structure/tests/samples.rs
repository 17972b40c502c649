//! Tests that are compared as a sample with an ensemble.

use crate::{Input, Study};
use std::path::{Path, PathBuf};

/// A folder with three tests of 12 rows: u is `size` times 0, -1, .., -10, 5 mm at uneven times.
fn folder(name: &str) -> PathBuf {
    let name = format!("slipgap-samples-{name}-{}", std::process::id());
    let folder = std::env::temp_dir().join(name);
    std::fs::create_dir_all(&folder).unwrap();
    for (name, size) in [("run-b.csv", 3.0), ("run-a.csv", 1.0), ("run-c.csv", 2.0)] {
        let row = |i: u32| {
            let u = if i < 11 { -f64::from(i) } else { 5.0 };
            format!("{},{}\n", f64::from(i * i) * 0.01, size * u)
        };
        let rows: String = (0..12).map(row).collect();
        std::fs::write(folder.join(name), format!("t,u\n{rows}")).unwrap();
    }
    folder
}

fn read(folder: &Path, measured: &str, rest: &str) -> Result<Study, String> {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1, "v": [1, 2, 3]}},
            "structure": {{"units": "t, kN, m, s", "masses": {{"deck": 1}}, "start": {{"deck": {{"v": "v"}}}}}},
            "measured": {{"time": "t", "columns": {{"deck.u": {{"column": "u", "unit": "mm"}}}}, {measured}}}, {rest}}}"#
    );
    let file = folder.join("s.json").display().to_string();
    let study = Input::new(&file, &text).study(1000);
    study.map_err(|error| error.to_string())
}

const ENSEMBLE: &str = r#""ensemble": "v", "metrics": ["peak(deck)", "last(deck.u)", "min(deck)", "max(deck)", "rms(deck)", "time_of_peak(deck)", "peak(deck.v)"]"#;

#[test]
fn each_test_gives_the_reductions_of_its_values() {
    let folder = folder("values");
    let files = r#""file": {"files": "run-*.csv"}, "compare": "distribution""#;
    let study = read(&folder, files, ENSEMBLE).unwrap();
    // The tests are no axis.
    assert_eq!(study.len(), 3);
    let squares: f64 = (1..=10).map(|i| f64::from(i * i)).sum::<f64>() + 25.0;
    let rms = (squares / 12.0).sqrt();
    let expected = [10.0, 5.0, -10.0, 5.0, rms];
    for (row, value) in expected.into_iter().enumerate() {
        let found = study.in_tests(row).unwrap();
        let mut values: Vec<f64> = [1.0, 2.0, 3.0].map(|size| size * value * 1e-3).to_vec();
        values.sort_by(f64::total_cmp);
        for (a, b) in found.iter().zip(&values) {
            // A few roundings.
            assert!((a - b).abs() < 1e-15, "{row}: {found:?} {values:?}");
        }
    }
    // The first time of the largest absolute value, by the times of the file.
    assert_eq!(study.in_tests(5), Some(vec![1.0; 3]));
    assert_eq!(study.in_tests(6), None);
    // A list of files has the values of these files, and none changes the keys of stores.
    let files = r#""file": ["run-a.csv", "run-c.csv"], "compare": "distribution""#;
    let two = read(&folder, files, ENSEMBLE).unwrap();
    assert_eq!(two.in_tests(0), Some(vec![0.01, 0.02]));
    assert_eq!(
        two.problem.as_structure().unwrap().identity(),
        study.problem.as_structure().unwrap().identity()
    );
    let lines = two
        .problem
        .as_structure()
        .unwrap()
        .description(&two.case(0).unwrap())
        .unwrap();
    assert!(
        lines.contains("of 2 tests, compared with each ensemble"),
        "{lines}"
    );
}

#[test]
fn a_window_is_of_the_times_of_a_test() {
    let folder = folder("windows");
    let files = r#""file": {"files": "run-*.csv"}, "compare": "distribution""#;
    let metrics = r#""ensemble": "v", "metrics": ["peak(deck, from=0.1, to=0.7)", "mean(deck, from=0.36, to=0.64)",
        "time_of_peak(deck, to=0.5)", "peak(deck, from=0.1*v)"]"#;
    let study = read(&folder, files, metrics).unwrap();
    // Of -4 at 0.16 to -8 at 0.64, and of -6, -7 and -8 at 0.36, 0.49 and 0.64.
    let mean = (0.13 * 6.5 + 0.15 * 7.5) / 0.28;
    for (row, values) in [
        (0, [1.0, 2.0, 3.0].map(|size| 8e-3 * size)),
        (1, [3.0, 2.0, 1.0].map(|size| -1e-3 * mean * size)),
        (2, [0.49; 3]),
    ] {
        let found = study.in_tests(row).unwrap();
        for (a, b) in found.iter().zip(values) {
            // A few roundings.
            assert!((a - b).abs() < 1e-15, "{row}: {found:?} {values:?}");
        }
    }
    // Tests have no parameters.
    assert_eq!(study.in_tests(3), None);
}

#[test]
fn faults_say_what_is_allowed() {
    let folder = folder("faults");
    let files = r#""file": ["run-a.csv", "run-b.csv"]"#;
    let way = r#""compare": "distribution""#;
    let metrics = r#""metrics": ["peak(deck)"]"#;
    for (measured, rest, part) in [
        (
            format!(r#"{files}, "compare": "distributions""#),
            ENSEMBLE.to_owned(),
            "did you mean \"distribution\"?",
        ),
        (
            format!("{files}, {way}"),
            metrics.to_owned(),
            "measured.compare: \"distribution\" needs the key \"ensemble\"",
        ),
        (
            format!(r#"{files}, {way}, "delay": 0.1"#),
            ENSEMBLE.to_owned(),
            "measured.delay: of histories that are compared point by point; leave it out",
        ),
        (
            format!(r#""file": "run-a.csv", {way}"#),
            ENSEMBLE.to_owned(),
            "measured.file: must be a list of at least 2 files, or",
        ),
        (
            format!(r#""file": ["run-a.csv", "run-d.csv"], {way}"#),
            ENSEMBLE.to_owned(),
            "measured.file[1]: \"run-d.csv\"",
        ),
        (
            format!("{files}, {way}"),
            r#""ensemble": "v", "metrics": ["peak(deck.v)"]"#.to_owned(),
            "measured: no metric of the study is of a measured channel and one of peak, last, min, max, rms, mean, residual, time_of_peak",
        ),
        (
            format!("{files}, {way}"),
            r#""ensemble": "v", "metrics": ["peak(deck)", "rms_error(deck, measured)"]"#.to_owned(),
            "\"rms_error(deck, measured)\" compares point by point, \"measured\" as a distribution",
        ),
        (
            format!("{files}, {way}"),
            r#""ensemble": "v", "metrics": ["peak(deck, from=0.66, to=0.8)"]"#.to_owned(),
            "\"peak(deck, from=0.66, to=0.8)\": a test has no time in this window",
        ),
        (
            files.to_owned(),
            ENSEMBLE.to_owned(),
            "measured.file: must be",
        ),
    ] {
        let fault = read(&folder, &measured, &rest).map(|_| ()).unwrap_err();
        assert!(fault.contains(part), "{fault}\n{part}");
        assert!(fault.contains("s.json:"), "{fault}");
    }
}
