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
            .output()
            .unwrap();
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

/// A bar with so many elements.
fn bar(elements: u32, dt: &str, more: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": {dt}, "duration": 1}}, "structure": {{
            "bars": {{"b": {{"L": 1, "EA": 1, "mass": 1, "n": {elements}}}}},
            "springs": [{{"between": ["ground", "b.left"], "k": 1}}], "start": {{"b": {{"v": 1}}}}}}{more}}}"#
    )
}

#[test]
fn memory_is_counted_for_what_is_kept() {
    let bench = Bench::new();
    // 4e8 numbers of a whole history; the metric keeps 1e4.
    bench.file(
        "s.json",
        bar(19_999, "1e-4", r#", "metrics": ["last(b.left)"]"#),
    );
    bench.expect(0, &["check", "s.json"]);
    let why = "s.json: case 0: dt gives 1.000e4 steps of 40000 numbers in the whole history, at most 2.68e8 numbers fit in memory; \
               run it without --histories";
    for args in [
        &["run", "s.json", "--histories"][..],
        &["animate", "s.json"][..],
    ] {
        let err = bench.expect(2, args).err;
        let what = match args[0] {
            "run" => why,
            _ => {
                "case 0 cannot be solved: dt gives 1.000e4 steps of 40000 numbers in the whole history"
            }
        };
        assert!(err.contains(what), "{err}");
    }
    // Metrics of many nodes.
    let names: Vec<String> = (1..400).map(|i| format!("\"last(b.{i})\"")).collect();
    let metrics = format!(", \"metrics\": [{}]", names.join(", "));
    bench.file("s.json", bar(19_999, "1e-6", &metrics));
    let err = bench.expect(2, &["check", "s.json"]).err;
    let what = "dt: gives 1.000e6 steps of 399 numbers in the metrics and figures, at most 2.68e8 numbers fit in memory";
    assert!(err.contains(what), "{err}");
}

#[test]
fn so_many_contacts_that_no_memory_holds_their_matrices() {
    let bench = Bench::new();
    let contacts = r#""contacts": {"face": {"law": "impact", "pairs": "face.csv", "gap": 1, "k": 1}}, "start""#;
    bench.file("s.json", bar(3, "0.1", "").replace("\"start\"", contacts));
    let lines: Vec<String> = (0..20_000).map(|i| format!("c{i},b.left:1\n")).collect();
    bench.file("face.csv", format!("name,dof\n{}", lines.concat()));
    for verb in ["check", "run", "explain"] {
        let err = bench.expect(2, &[verb, "s.json"]).err;
        // 8 * 4.5 * 20000^2 bytes.
        let what = "structure.contacts.face: 20000 contacts, at most 7723 are allowed: the forces of all contacts of a step are found \
                    together, which needs about 14.4 GB";
        assert!(err.starts_with("s.json:") && err.contains(what), "{err}");
    }
}

/// Pairs of towers that meet, all alike; each pair moves as it does alone.
#[test]
fn many_pairs_of_bodies_take_the_room_of_their_pairs() {
    let bench = Bench::new();
    let study = |pairs: usize, more: &str| {
        let each = |of: fn(usize) -> String| (0..pairs).map(of).collect::<Vec<_>>().join(", ");
        let masses = each(|i| format!(r#""a{i}": 100, "b{i}": 80"#));
        let springs = each(|i| {
            format!(
                r#"{{"between": ["ground", "a{i}"], "k": 4000}}, {{"between": ["ground", "b{i}"], "k": 9000}}"#
            )
        });
        let contacts = each(|i| {
            format!(
                r#""c{i}": {{"law": "impact", "between": ["a{i}", "b{i}"], "gap": 0.02, "k": 1e5}}"#
            )
        });
        let last = pairs - 1;
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.005, "duration": 1.5}},
  "structure": {{"masses": {{{masses}}}, "springs": [{springs}], "contacts": {{{contacts}}},
  "ground": {{"sine": {{"amplitude": 3, "omega": 6}}}}{more}}}, "metrics": ["peak(a{last})", "peak(c{last}.S)"]}}"#
        )
    };
    let peaks = |pairs: usize| -> Vec<f64> {
        bench.file("s.json", study(pairs, ""));
        bench.expect(0, &["run", "s.json", "--out", &format!("of-{pairs}")]);
        let rows = bench.text(&format!("of-{pairs}/s/results.csv"));
        let cells = rows.lines().nth(1).unwrap().rsplit(',').take(2);
        cells.map(|cell| cell.parse().unwrap()).collect()
    };
    let (one, of_many) = (peaks(1), peaks(7_800));
    assert!(one.iter().all(|peak| *peak > 0.0));
    for (one, peak) in one.iter().zip(&of_many) {
        assert!((one / peak - 1.0).abs() < 1e-9, "{one} {peak}");
    }
    // What is found for all contacts at once has the limit.
    bench.file(
        "s.json",
        study(7_800, r#", "contacts_reference": "softened""#),
    );
    let err = bench.expect(2, &["check", "s.json"]).err;
    assert!(
        err.contains("7800 contacts, at most 7723 are allowed"),
        "{err}"
    );
}
