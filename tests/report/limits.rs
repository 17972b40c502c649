//! Limits of the content of a page, and text that it must escape.

use super::browser::{chromium, probe};
use super::data::data;
use super::packed::unpacked;
use slipgap::batch::{self, Outcome, RunOptions, WarnedCases};
use slipgap::report::{self, Checks, Counts, Indices, Results, Section};
use slipgap::solve::Unsolvable;
use slipgap::study::{self, Study};
use slipgap::warnings::StudyWarnings;
use std::path::PathBuf;

const FRICTION: &str = r#"{ "problem": "friction-oscillator", "parameters": { "law": "velocity-control",
  "beta": { "linspace": [0.001, 0.4, 1500] }, "x0": 3, "dT": "pi/10", "duration": "2*pi" } }"#;

const BARS: &str = r#"{ "problem": "bar-impact", "metrics": ["max_overlap", "rms_error_r"],
  "parameters": { "gamma": 1, "n": [2, 3, 4], "dt": 0.25, "duration": 1, "L": 10, "E": 100, "V0": 0.1 } }"#;

fn outcomes(study: &Study) -> Vec<Outcome> {
    batch::all(study, None, &indicatif::ProgressBar::hidden()).unwrap()
}

/// The warnings of a study.
fn warnings(study: &Study) -> Vec<WarnedCases> {
    let mut warnings = StudyWarnings::new(study);
    let bar = indicatif::ProgressBar::hidden();
    batch::run(study, &bar, &RunOptions::METRICS, |part| {
        warnings.add(&part);
        Ok(())
    })
    .unwrap();
    warnings.list()
}

/// The page of one study with at most `most` bytes of results.
fn page(study: &Study, text: &str, outcomes: &[Outcome], most: usize) -> String {
    let mut results = Results::new(study, PathBuf::from("out/s/store"), most);
    let mut counts = Counts::new(study);
    counts.warnings = warnings(study);
    for (number, outcome) in (0..).zip(outcomes) {
        results.add(outcome);
        counts.add(study, number, outcome);
    }
    let section = Section {
        name: "s\u{1b}[31m",
        file: "s\u{7}.json".into(),
        text: text.into(),
        study,
        figures: Vec::new(),
        results,
        counts,
        indices: Indices::default(),
        quantiles: None,
        checks: Checks::default(),
        claims: Vec::new(),
    };
    let mut page = Vec::new();
    report::write(&mut page, &mut [section]).unwrap();
    String::from_utf8(page).unwrap()
}

const LIMIT: &str = "This page has only the first 1000 of 1500 cases, so it cannot filter or sort; all cases are in out/s/store";

#[test]
fn a_table_too_large_for_the_page_is_shortened_with_a_sentence() {
    let study = study::parse("s.json", FRICTION).unwrap();
    let outcomes = outcomes(&study);
    let mut results = Results::new(&study, PathBuf::new(), usize::MAX);
    outcomes.iter().for_each(|outcome| results.add(outcome));
    // The exact size in bytes, and one byte less.
    let whole = page(&study, FRICTION, &outcomes, results.bytes());
    assert!(data(&whole).head["limit"].is_null() && !whole.contains("has only the first"));
    let part = page(&study, FRICTION, &outcomes, results.bytes() - 1);
    let held = data(&part);
    assert_eq!(
        (&held.head["rows"], &held.head["cases"]),
        (&1000.into(), &1500.into())
    );
    assert_eq!(held.head["limit"], LIMIT);
    assert!(part.contains(&format!("<p>{LIMIT}.</p>")));
    for ((name, cells), (_, whole_cells)) in held.columns.iter().zip(data(&whole).columns) {
        assert!(cells.iter().eq(&whole_cells[..1000]), "{name}");
    }
    let Some(program) = chromium() else { return };
    let folder = tempfile::tempdir().unwrap();
    let script = r#"
        probe.begun = count();
        probe.filtered = [typed("beta>0.1"), root.querySelectorAll("tbody tr").length];
        probe.misspelt = typed("bta>0.1");
        type("");
        probe.again = [count(), root.querySelectorAll("tbody tr").length];
        sort("rms_error");
        probe.sorted = [count(), heads()[column("rms_error")].getAttribute("aria-sort"), values("case").slice(0, 3)];"#;
    let probe = probe(&program, folder.path(), &part, script);
    let begun = "1 to 100 of the first 1000 of 1500 cases";
    assert_eq!(probe["begun"], begun);
    assert_eq!(probe["filtered"], serde_json::json!([LIMIT, 0]));
    assert!(
        probe["misspelt"]
            .as_str()
            .unwrap()
            .starts_with("No column is called “bta”")
    );
    assert_eq!(probe["again"], serde_json::json!([begun, 100]));
    assert_eq!(
        probe["sorted"],
        serde_json::json!([LIMIT, "none", ["0", "1", "2"]])
    );
}

#[test]
fn a_column_that_varies_after_the_shortened_rows_is_shown() {
    let wide = FRICTION
        .replace(r#""x0": 3"#, r#""x0": [3, 4]"#)
        .replace("0.4, 1500", "0.4, 1100");
    // x0 is the first axis: the rows on the page have one x0.
    let text = wide.replace(
        r#""beta": { "linspace": [0.001, 0.4, 1100] }, "x0": [3, 4]"#,
        r#""x0": [3, 4], "beta": { "linspace": [0.001, 0.4, 1100] }"#,
    );
    let study = study::parse("s.json", &text).unwrap();
    let held = data(&page(&study, &text, &outcomes(&study), 1000)).head;
    let columns = held["columns"].as_array().unwrap();
    let x0 = columns
        .iter()
        .find(|column| column["name"] == "x0")
        .unwrap();
    assert_eq!((&x0["width"], &x0["varies"]), (&0.into(), &true.into()));
}

#[test]
fn no_control_character_of_a_study_is_in_the_page() {
    let mut study = study::parse("s.json", FRICTION).unwrap();
    study.title =
        "bell\u{7} escape\u{1b}[2J next\u{85} none\u{fffe}\u{1ffff} nul\0 </script>".into();
    let text = format!("{FRICTION}\r\n\u{7f}\u{9b}\u{ffff}\t</pre>");
    let page = unpacked(&page(&study, &text, &outcomes(&study), usize::MAX));
    let forbidden =
        |c: char| (c.is_control() && c != '\n' && c != '\t') || u32::from(c) & 0xfffe == 0xfffe;
    assert_eq!(page.chars().find(|c| forbidden(*c)), None);
    assert!(
        page.contains("bell␇ escape␛[2J next\u{fffd} none\u{fffd}\u{fffd} nul␀ &lt;/script&gt;")
    );
    assert!(page.contains("\n␡\u{fffd}\u{fffd}\t&lt;/pre&gt;</pre>"));
    assert!(page.contains("s␇.json"));
}

#[test]
fn cases_without_contact_or_solution_are_counted() {
    let study = study::parse("s.json", BARS).unwrap();
    let mut touching = outcomes(&study);
    let whole = page(&study, BARS, &touching, usize::MAX);
    assert!(!whole.contains("have no contact") && !whole.contains("could not be solved"));
    // Bars with a gap of 2 c T_I/2 meet after 1 T_I, that is after the duration.
    let text = BARS.replace("\"n\": [2, 3, 4]", "\"n\": 2, \"gap\": [0, 2, 3]");
    let apart = study::parse("s.json", &text).unwrap();
    assert!(page(&apart, &text, &outcomes(&apart), usize::MAX).contains(
        "<p>2 of 3 cases have no contact before <code>duration</code>; their contact metrics are undefined or 0.</p>"
    ));
    touching[2].failure = Some(Unsolvable::Stored("S <grows>".into()));
    touching[2].metrics.fill(None);
    let failed = page(&study, BARS, &touching, usize::MAX);
    assert!(failed.contains("<p>1 of 3 cases could not be solved; case 2: S &lt;grows&gt;.</p>"));
}
