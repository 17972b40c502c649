//! The same input gives the same bytes for any number of threads.

use crate::{Bench, bars, friction};
use std::fs;

#[test]
fn with_1_2_and_7_threads() {
    let bench = Bench::new();
    let many = r#""law": "displacement-control", "alpha": [0.1, 0.5, 1, 2, 5], "x0": [12, 12.5], "dT": "pi/20", "duration": "8*pi""#;
    let figures = r#", "figures": [
        { "name": "history", "kind": "history", "where": { "x0": 12.5 } },
        { "name": "law", "kind": "law" },
        { "name": "metric", "kind": "metric", "x": "alpha", "y": ["rms_error", "work_error"] },
        { "name": "map", "kind": "map", "x": "alpha", "y": "x0", "z": "rms_error" }]"#;
    bench.file("studies/friction.json", friction(many, figures));
    let history = r#", "figures": [{ "name": "r", "kind": "history", "panels": "k_I" }]"#;
    let impact = r#""k_I": [10, 100, 1e5], "n": [2, 10], "dt": 0.01, "duration": 1.5"#;
    bench.file("studies/bars.json", bars(impact, history));
    for jobs in ["1", "2", "7"] {
        bench.expect(0, &["run", "--histories", "--jobs", jobs, "--out", jobs]);
    }
    let files = bench.tree("1");
    for name in [
        "friction/map.png",
        "friction/history.svg",
        "friction/history.pdf",
        "bars/r.png",
        "bars/results.csv",
        "bars/histories/5.csv",
    ] {
        assert!(files.iter().any(|file| file == name), "{name} in {files:?}");
    }
    for jobs in ["2", "7"] {
        assert_eq!(files, bench.tree(jobs));
        for file in &files {
            let read = |jobs: &str| fs::read(bench.path(jobs).join(file)).unwrap();
            assert!(read("1") == read(jobs), "{file} with {jobs} threads");
        }
    }
}
