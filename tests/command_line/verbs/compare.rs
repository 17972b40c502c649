//! Comparison of two folders of results.

use crate::{Bench, TWO, friction};

#[test]
fn the_largest_difference_is_first_and_the_exit_code_is_5() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, ""));
    bench.file("deep/t.json", friction(TWO, ""));
    bench.expect(0, &["run", "s.json", "--out", "a"]);
    bench.expect(0, &["run", "deep/t.json", "--out", "a/deep"]);
    // The same cases in reverse order.
    let turned = TWO.replace("[0.1, 1]", "[1, 0.1]");
    bench.file("s.json", friction(&turned, ""));
    bench.expect(0, &["run", "s.json", "--out", "b"]);
    bench.expect(0, &["run", "deep/t.json", "--out", "b/deep"]);
    assert_eq!(
        bench.expect(0, &["compare", "a", "b"]).err,
        "2 studies equal, 0 different\n"
    );
    // Without results.csv, from the store.
    std::fs::remove_file(bench.path("b/s/results.csv")).unwrap();
    bench.expect(0, &["compare", "a/s", "b/s"]);
    // A finer step changes every metric of one case, and none of the other.
    let finer = turned.replace("\"pi/10\"", "[\"pi/10\", \"pi/20\"]");
    bench.file("s.json", friction(&finer, ""));
    bench.expect(0, &["run", "s.json", "--out", "b"]);
    let done = bench.expect(5, &["compare", "a", "b"]);
    assert!(done.err.contains("s: 2 cases only in b"), "{}", done.err);
    assert_eq!(done.out, "");
    let text = bench.text("a/s/results.csv");
    let (rms, max) = (cell(&text, 1, "rms_error"), cell(&text, 2, "max_error"));
    let nearly = (max.parse::<f64>().unwrap() * (1.0 + 1e-10)).to_string();
    let changed = text.replace(&rms, "0.5").replace(&max, &nearly);
    bench.file("a/s/results.csv", changed);
    let done = bench.expect(5, &["compare", "a/s", "b/s"]);
    let rows: Vec<Vec<&str>> = done
        .out
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(rows[1][..2], [".", "rms_error"]);
    assert_eq!(rows[1][rows[1].len() - 3..], ["0", "0.5", rms.as_str()]);
    assert_eq!(rows[2][..2], [".", "max_error"]);
    let done = bench.expect(5, &["compare", "a/s", "b/s", "--tolerance", "1e-9"]);
    assert!(done.out.contains("rms_error") && !done.out.contains("max_error"));
    bench.expect(2, &["compare", "a/s", "b/s", "--tolerance", "-1"]);
    bench.expect(2, &["compare", "a", "deep"]);
    bench.expect(1, &["compare", "a", "nothing"]);
}

#[test]
fn the_manifest_names_the_problem_and_the_columns_do_without_one() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, ""));
    bench.expect(0, &["run", "s.json", "--out", "a"]);
    bench.expect(0, &["run", "s.json", "--out", "b"]);
    // A table of an earlier version without a column: every case has the default of x0.
    let text = bench.text("b/s/results.csv");
    let x0 = text.split(',').position(|name| name == "x0").unwrap();
    let mut without = String::new();
    for line in text.lines() {
        let mut cells: Vec<&str> = line.split(',').collect();
        cells.remove(x0);
        without += &(cells.join(",") + "\n");
    }
    bench.file("b/s/results.csv", &without);
    let equal = "1 studies equal, 0 different\n";
    assert_eq!(bench.expect(0, &["compare", "a", "b"]).err, equal);
    // Without a manifest the columns decide, and one of them is missing.
    std::fs::remove_file(bench.path("b/s/manifest.json")).unwrap();
    let done = bench.expect(5, &["compare", "a", "b"]);
    assert!(done.err.contains("different problems"), "{}", done.err);
    bench.file("b/s/results.csv", &text);
    assert_eq!(bench.expect(0, &["compare", "a", "b"]).err, equal);
    // The manifest decides, not the columns.
    let manifest = bench.text("a/s/manifest.json");
    let other = manifest.replace("friction-oscillator", "bar-impact");
    bench.file("b/s/manifest.json", other);
    let done = bench.expect(5, &["compare", "a", "b"]);
    assert!(done.err.contains("different problems"), "{}", done.err);
}

/// A cell of results.csv.
fn cell(text: &str, row: usize, column: &str) -> String {
    let mut lines = text.lines().map(|line| line.split(','));
    let column_index = lines
        .next()
        .unwrap()
        .position(|name| name == column)
        .unwrap();
    lines
        .nth(row - 1)
        .unwrap()
        .nth(column_index)
        .unwrap()
        .to_owned()
}
