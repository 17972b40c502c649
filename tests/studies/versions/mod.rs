//! The studies of earlier versions, as docs/versions.md promises: today's program runs them, or says what to change.
//!
//! `0.1.0/` has the studies and tables of commit 43c6b52b, the last before the changelog had anything beyond 0.1.0.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Columns that the changelog says have other numbers than in 0.1.0.
const CHANGED: [&str; 3] = ["contact_duration", "separations", "rdot_oscillation"];

/// Of the largest number of a column: another order of operations, over thousands of steps.
const ROUND_OFF: f64 = 1e-9;

fn frozen(folder: &str) -> PathBuf {
    let versions = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/studies/versions");
    versions.join("0.1.0").join(folder)
}

fn slipgap(words: &[&str], folder: &Path) -> Output {
    let program = env!("CARGO_BIN_EXE_slipgap");
    let mut command = Command::new(program);
    command.args(words).current_dir(folder).output().unwrap()
}

/// A table as columns: the name, and the cells.
fn columns(path: &Path) -> Vec<(String, Vec<String>)> {
    let mut table = csv::Reader::from_path(path).unwrap();
    let names: Vec<String> = table.headers().unwrap().iter().map(String::from).collect();
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    let cells = |at: usize| rows.iter().map(|row| row[at].to_owned()).collect();
    (0..)
        .zip(names)
        .map(|(at, name)| (name, cells(at)))
        .collect()
}

fn names(columns: &[(String, Vec<String>)]) -> Vec<&str> {
    columns.iter().map(|(name, _)| name.as_str()).collect()
}

fn numbers(cells: &[String]) -> Vec<Option<f64>> {
    cells.iter().map(|cell| cell.parse().ok()).collect()
}

#[test]
fn studies_of_0_1_0_run_and_have_their_columns_and_numbers() {
    let out = tempfile::tempdir().unwrap();
    let studies = frozen("studies");
    let folder = out.path().to_str().unwrap();
    let run = slipgap(&["run", ".", "--out", folder], &studies);
    let said = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{said}");
    // The checks in these studies are met, too.
    assert!(!said.contains("check-not-met"), "{said}");
    let mut compared = 0;
    for entry in fs::read_dir(frozen("tables")).unwrap() {
        let path = entry.unwrap().path();
        let study = path.file_stem().unwrap().to_str().unwrap();
        let then = columns(&path);
        let now = columns(&out.path().join(study).join("results.csv"));
        let kept: Vec<&str> = names(&now);
        let kept: Vec<&str> = kept
            .into_iter()
            .filter(|name| names(&then).contains(name))
            .collect();
        assert_eq!(kept, names(&then), "{study}");
        for (name, old) in &then {
            let new = &now.iter().find(|(other, _)| other == name).unwrap().1;
            assert_eq!(new.len(), old.len(), "{study}");
            if name == "contact_duration" {
                // What it was is another column.
                let steps = now.iter().find(|(name, _)| name == "contact_steps");
                assert_near(study, name, old, &steps.unwrap().1, &now);
            } else if !CHANGED.contains(&name.as_str()) {
                assert_near(study, name, old, new, &now);
            }
        }
        compared += 1;
    }
    assert_eq!(compared, fs::read_dir(&studies).unwrap().count());
    assert_eq!(compared, 15);
}

/// Texts are the same; numbers differ by round-off. Where the impact spring is so stiff (k_I = 1e5) that contact opens and closes
/// from step to step, round-off decides when, and the numbers are not compared.
#[track_caller]
fn assert_near(
    study: &str,
    name: &str,
    old: &[String],
    new: &[String],
    table: &[(String, Vec<String>)],
) {
    let stiff = table
        .iter()
        .find(|(name, _)| name == "k_I")
        .map(|column| &column.1);
    let is_stiff = |case: usize| stiff.is_some_and(|cells| cells[case] == "1e5");
    let largest = numbers(old)
        .into_iter()
        .flatten()
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    for (case, (a, b)) in old.iter().zip(new).enumerate() {
        match (a.parse::<f64>(), b.parse::<f64>()) {
            _ if is_stiff(case) => {}
            (Ok(x), Ok(y)) => assert!(
                (x - y).abs() <= ROUND_OFF * largest,
                "{study}, case {case}, {name}: {a} was {b}"
            ),
            _ => assert_eq!(a, b, "{study}, case {case}, {name}"),
        }
    }
}

/// What 0.1.0 accepted and is refused since, with what to change.
#[test]
fn what_is_refused_since_0_1_0_says_what_to_change() {
    let parameters = r#""law": "displacement-control", "alpha": [0.1, 1], "duration": 9"#;
    for (more, figure, words) in [
        (
            r#""dT": ["pi/10", "pi/20"], "x0": [11, 12]"#,
            r#""kind": "metric", "x": "dT", "y": "rms_error", "by": "alpha""#,
            "but x0 varies; choose one value in \"where\" or leave out \"by\"",
        ),
        (
            r#""dT": ["pi/10", "pi/20"]"#,
            r#""kind": "history", "by": "alpha""#,
            "but dT varies; choose one value in \"where\" or leave out \"by\"",
        ),
        (
            r#""dT": "pi/10""#,
            r#""kind": "map", "x": "alpha", "y": "dT", "z": "rms_error""#,
            "a map figure needs two values of dT",
        ),
    ] {
        let text = format!(
            r#"{{ "problem": "friction-oscillator", "parameters": {{ {parameters}, {more} }},
                "figures": [{{ "name": "a", {figure} }}] }}"#
        );
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("s.json"), text).unwrap();
        let list = slipgap(&["list", "s.json"], folder.path());
        let said = String::from_utf8_lossy(&list.stderr);
        assert_eq!(list.status.code(), Some(2), "{said}");
        assert!(
            said.starts_with("s.json:2:") && said.contains(words),
            "{said}"
        );
    }
}
