//! The types of the columns of tables: all cells of a column are whole numbers, or all have a point or an exponent, so that programs
//! that take the type from the first rows read all others.

use crate::Bench;

/// A chain that impacts in some cases, with all tables that a run has.
const STUDY: &str = r#"{"problem": "structure",
    "parameters": {"v": {"linspace": [0, 3, 31]}, "k": {"geomspace": [1e-3, 1e3, 7]}, "f": {"range": [0, 0.3, 0.1]},
        "dt": 0.25, "duration": 2},
    "structure": {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": "k"}],
        "contacts": {"stop": {"law": "impact", "between": ["m", "ground"], "gap": 1, "k": 3}},
        "loads": [{"at": "m", "sine": {"amplitude": "f", "omega": 1}}], "start": {"m": {"v": "v"}}},
    "metrics": ["peak(m)", "peak(stop.S)", "impacts(stop)", "restitution(stop)"], "ensemble": ["v", "f"],
    "reductions": ["greatest peak(stop.S) over v", "median impacts(stop) over v, f"],
    "figures": [{"name": "p", "kind": "fragility", "x": "k", "y": "peak(m)", "limit": 1}]}"#;

/// What a cell is: a whole number, a real one, or text.
fn kind(cell: &str) -> char {
    let whole = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let bare = cell.strip_prefix('-').unwrap_or(cell);
    match cell.parse::<f64>() {
        _ if whole(bare) => 'w',
        Ok(_) if bare.contains(['.', 'e']) => 'r',
        Ok(_) | Err(_) => 't',
    }
}

/// The kinds of a column's cells, without empty ones, each once.
fn kinds(table: &str, column: &str) -> String {
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let index = rows
        .headers()
        .unwrap()
        .iter()
        .position(|header| header == column)
        .unwrap_or_else(|| panic!("{column}"));
    let cells = rows.records().map(|row| row.unwrap()[index].to_owned());
    let mut kinds: Vec<char> = cells
        .filter(|cell| !cell.is_empty())
        .map(|cell| kind(&cell))
        .collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds.into_iter().collect()
}

#[test]
fn every_column_of_every_table_has_one_type() {
    let bench = Bench::new();
    bench.file("s.json", STUDY);
    bench.expect(0, &["run", "s.json", "--histories"]);
    for (table, whole) in [
        ("results.csv", &["case"][..]),
        ("histories/0.csv", &[]),
        ("quantiles.csv", &["cases", "empty"]),
        ("two_samples.csv", &["n_1", "n_2"]),
        ("reductions.csv", &["cases", "empty"]),
        ("fragility.csv", &["cases", "empty", "exceeded"]),
    ] {
        let text = bench.text(&format!("figures/s/{table}"));
        let header = text.lines().next().unwrap();
        for column in csv::Reader::from_reader(text.as_bytes()).headers().unwrap() {
            let found = kinds(&text, column);
            let text = ["reduction", "figure", "metric", "parameter", "no_fit"];
            let wanted = match column {
                name if whole.contains(&name) => "w",
                name if text.contains(&name) => "t",
                _ => "r",
            };
            assert!(
                found == wanted || found.is_empty(),
                "{table}, {column} of {header}: {found}"
            );
        }
    }
}

#[test]
fn values_of_a_rule_are_its_decimals() {
    let bench = Bench::new();
    bench.file("s.json", STUDY);
    bench.expect(0, &["run", "s.json"]);
    let text = bench.text("figures/s/results.csv");
    let column = |index: usize| {
        let mut cells: Vec<String> = text
            .lines()
            .skip(1)
            .filter_map(move |line| line.split(',').nth(index))
            .map(str::to_owned)
            .collect();
        cells.sort_by(|a, b| a.parse::<f64>().unwrap().total_cmp(&b.parse().unwrap()));
        cells.dedup();
        cells
    };
    let tenths = |n: usize| {
        (0..=n)
            .map(|i| format!("{}.{}", i / 10, i % 10))
            .collect::<Vec<_>>()
    };
    let header: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let at = |name: &str| header.iter().position(|cell| *cell == name).unwrap();
    assert_eq!(column(at("v")), tenths(30));
    assert_eq!(column(at("f")), tenths(3));
    assert_eq!(
        column(at("k")),
        ["1e-3", "0.01", "0.1", "1.0", "10.0", "100.0", "1000.0"]
    );
}
