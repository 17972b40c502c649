//! Studies of so many combinations that their parts are in sub-folders.

use crate::{Bench, friction};
use std::process::Command;

/// 10^8 combinations, of which 20 000 at both ends are cases.
fn large() -> String {
    let parameters = r#""law": "velocity-control", "dT": 0.5, "duration": 3,
        "beta": {"linspace": [1, 2, 10000]}, "x0": {"linspace": [1, 2, 10000]}"#;
    friction(parameters, r#", "when": "abs(beta - 1.5) > 0.49999""#)
}

#[test]
fn shards_and_readers_find_the_parts_in_sub_folders() {
    let bench = Bench::new();
    bench.file("s.json", large());
    bench.expect(0, &["run", "s.json"]);
    let store = bench.everything("figures/s/store");
    let parts: Vec<&str> = { store.iter() }
        .filter(|name| name.ends_with(".parquet"))
        .filter_map(|name| name.split('-').next())
        .collect();
    // Combinations 0 to 9999 and 99 990 000 to 99 999 999. A folder has 1024 chunks of 32 768.
    assert_eq!(parts, ["000000/part", "000002/part"], "{store:?}");
    for shard in ["2/2", "1/2"] {
        bench.expect(0, &["run", "s.json", "--out", "shards", "--shard", shard]);
    }
    bench.expect(0, &["merge", "s.json", "--out", "shards"]);
    assert_eq!(bench.everything("shards/s/store"), store);
    bench.expect(0, &["compare", "figures/s", "shards/s"]);
    let csv = bench.text("figures/s/results.csv");
    assert_eq!(bench.text("shards/s/results.csv"), csv);
    assert_eq!(csv.lines().count(), 20_001);
    // All from the store.
    let again = bench.expect(0, &["run", "s.json"]).err;
    assert!(
        again.contains("20000 of 20000 cases from the store"),
        "{again}"
    );
    let python = std::env::var("SLIPGAP_PYTHON").unwrap_or("python3".into());
    for (tool, program) in [
        ("pandas", "len(pandas.read_parquet(store))"),
        (
            "pyarrow.dataset",
            "pyarrow.dataset.dataset(store).count_rows()",
        ),
        ("polars", "len(polars.read_parquet(store))"),
        (
            "duckdb",
            "duckdb.sql(f\"select count(*) from '{store}/**/*.parquet'\").fetchall()[0][0]",
        ),
    ] {
        let there = Command::new(&python)
            .args(["-c", &format!("import {tool}")])
            .output();
        if !there.is_ok_and(|output| output.status.success()) {
            eprintln!("{tool}: not installed for {python}, not looked at");
            continue;
        }
        let program =
            format!("import {tool}\nstore = 'figures/s/store'\nassert {program} == 20000");
        let output = Command::new(&python)
            .args(["-c", &program])
            .current_dir(bench.path(""))
            .output();
        let output = output.unwrap();
        assert!(
            output.status.success(),
            "{tool}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
}

#[test]
fn combinations_that_are_not_tested_are_counted_as_at_most() {
    let bench = Bench::new();
    let parameters = r#""law": "velocity-control", "dT": 0.5, "duration": 3,
        "beta": {"linspace": [1, 2, 100000]}, "x0": {"linspace": [1, 2, 10000]}"#;
    bench.file("s.json", friction(parameters, r#", "when": "beta*x0 < 2""#));
    assert!(
        bench
            .expect(0, &["list", "s.json"])
            .out
            .contains("at most 1000000000")
    );
    // beta = 1 and x0 = 1; beta = 2 and x0 = 2.
    let first = bench.expect(0, &["explain", "s.json", "0"]).out;
    assert!(first.contains("case 0 of at most 1000000000"), "{first}");
    let last = bench.expect(2, &["explain", "s.json", "999999999"]).err;
    assert!(
        last.contains("case 999999999: this combination does not meet the condition"),
        "{last}"
    );
}
