//! The files that a study reads: their hashes in the manifest, and which verbs say that results are of others.

use crate::Bench;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

const STUDY: &str = r#"{"problem": "structure", "parameters": {"record": ["a.csv", "b.csv"], "dt": 0.1, "duration": 1},
    "structure": {"units": "t, kN, m, s", "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 40}],
        "ground": {"record": "record", "unit": "m/s2"}}, "metrics": ["peak(m)"]}"#;

fn record(factor: f64) -> String {
    let row = |i: u32| format!("{},{}\n", f64::from(i) / 10.0, factor * f64::from(i % 3));
    format!("t,a\n{}", (0..=10).map(row).collect::<String>())
}

fn manifest(bench: &Bench, folder: &str) -> Value {
    serde_json::from_str(&bench.text(&format!("{folder}/s/manifest.json"))).unwrap()
}

#[test]
fn every_verb_says_that_results_are_of_other_files() {
    let bench = Bench::new();
    bench.file("s.json", STUDY);
    for (name, factor) in [("a.csv", 1.0), ("b.csv", 2.0)] {
        bench.file(name, record(factor));
    }
    for out in ["one", "figures"] {
        bench.expect(0, &["run", "s.json", "--out", out]);
    }
    let before = manifest(&bench, "one");
    let input = |name: &str| {
        let text = bench.text(name);
        let digits: String = Sha256::digest(text.as_bytes())
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        json!({"name": name, "size": text.len(), "sha256": digits})
    };
    assert_eq!(before["inputs"], json!([input("a.csv"), input("b.csv")]));
    let status = |expected: &str| {
        let done = bench.expect(0, &["status", "s.json", "--json"]);
        assert!(done.err.contains(expected), "{}", done.err);
        let found: Value = serde_json::from_str(&done.out).unwrap();
        found["results_of"].as_array().unwrap().len()
    };
    assert_eq!(status(""), 0);
    bench.file("b.csv", record(3.0));
    assert_eq!(
        status("the results in figures/s are of another b.csv (sha256 "),
        1
    );
    let done = bench.expect(0, &["check", "s.json"]);
    assert!(done.err.contains("are of another b.csv"), "{}", done.err);
    // A report has the cases of the files as they are, in its tables and in results.csv.
    let done = bench.expect(0, &["report", "s.json"]);
    assert!(done.err.contains("another b.csv"), "{}", done.err);
    bench.expect(0, &["run", "s.json", "--out", "two"]);
    let tables = ["figures", "two"].map(|out| bench.text(&format!("{out}/s/results.csv")));
    assert_eq!(tables[0], tables[1]);
    assert_eq!(status(""), 0);
    let after = manifest(&bench, "two");
    assert_eq!(after["study_sha256"], before["study_sha256"]);
    assert_eq!(after["inputs"], json!([input("a.csv"), input("b.csv")]));
    let done = bench.expect(5, &["compare", "one", "two"]);
    assert!(
        done.err.contains("s: b.csv differs (sha256 "),
        "{}",
        done.err
    );
    assert!(!done.err.contains("a.csv"), "{}", done.err);
    // Results of another version of the program, and of one that wrote no hashes.
    for (key, value, part) in [
        (
            "program_version",
            json!("0.1.0"),
            "version 0.1.0 of the program",
        ),
        (
            "inputs",
            Value::Null,
            "files of which manifest.json has no hashes",
        ),
    ] {
        let mut old = manifest(&bench, "figures");
        match value.is_null() {
            true => drop(old.as_object_mut().unwrap().remove(key)),
            false => old[key] = value,
        }
        bench.file("figures/s/manifest.json", old.to_string());
        assert_eq!(status(part), 1);
        let done = bench.expect(0, &["report", "s.json"]);
        assert!(done.err.contains(part), "{}", done.err);
        assert_eq!(status(""), 0);
    }
}
