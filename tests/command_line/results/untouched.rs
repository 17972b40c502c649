//! Cases without contact: counted on stderr and in the manifest, with empty contact metrics.

use crate::Bench;
use serde_json::Value as Json;

/// Gaps from 0 to 2. With a duration of 0.5, gaps of 1 and more do not close.
fn study(gaps: usize) -> String {
    format!(
        r#"{{"problem": "bar-impact", "parameters": {{"gamma": 1, "n": 1, "dt": 0.25, "duration": 0.5,
            "gap": {{"linspace": [0, 2, {gaps}]}}}}}}"#
    )
}

#[test]
fn runs_count_cases_without_contact() {
    let bench = Bench::new();
    bench.file("s.json", study(5));
    let note = "s.json: 3 of 5 cases have no contact before `duration`; their contact metrics are undefined";
    // The second time the cases come from the store.
    for _ in 0..2 {
        let done = bench.expect(0, &["run", "s.json"]);
        assert!(done.err.contains(note), "{done:?}");
        let manifest: Json = serde_json::from_str(&bench.text("figures/s/manifest.json")).unwrap();
        assert_eq!(manifest["cases_without_contact"], 3);
    }
    let table = bench.text("figures/s/results.csv");
    let mut rows = table.lines().map(|row| row.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let contact = [
        "contact_duration",
        "contact_steps",
        "separations",
        "max_overlap",
        "rdot_oscillation",
        "peak_force",
        "impulse_error",
        "restitution",
    ];
    let column = |name: &str| header.iter().position(|h| *h == name).unwrap();
    for (case, row) in rows.enumerate() {
        let empty = contact.map(|name| row[column(name)].is_empty());
        match case {
            0 | 1 => assert!(!empty[3] && !empty[5] && !empty[7], "{row:?}"),
            _ => assert_eq!(empty, [true; 8], "{row:?}"),
        }
        assert!(!row[column("rms_error_r")].is_empty());
    }
}

#[test]
fn cases_are_counted_also_without_tables_and_figures() {
    let bench = Bench::new();
    bench.file("many.json", study(20_401));
    bench.file("all.json", study(2).replace("[0, 2, 2]", "[0.1, 0.2, 2]"));
    let done = bench.expect(0, &["run", "many.json", "all.json", "--format", "parquet"]);
    // Said once for both studies, which are named with their cases.
    let mut notes = done.err.lines().filter(|line| {
        line.starts_with("note: no-contact: 10201 of 20401 cases in 1 of 2 studies")
    });
    assert!(
        notes.any(|line| line.ends_with(": many (10201)")),
        "{done:?}"
    );
    for (name, count) in [("many", 10_201), ("all", 0)] {
        let text = bench.text(&format!("figures/{name}/manifest.json"));
        let manifest: Json = serde_json::from_str(&text).unwrap();
        assert_eq!(manifest["cases_without_contact"], count);
    }
}
