//! What a person types without knowing the names: studies without their folder, a problem left out, a misspelt parameter.

use crate::{Bench, ONE, friction};

#[test]
fn a_study_is_found_by_its_name() {
    let bench = Bench::new();
    bench.file("studies/slide.json", friction(ONE, ""));
    for name in ["slide", "slide.json", "studies/slide", "studies/slide.json"] {
        let done = bench.expect(0, &["run", name]);
        assert_eq!(done.out, "figures/slide\n", "{name}");
        bench.expect(0, &["explain", name]);
        bench.expect(0, &["check", name]);
    }
    // A file here comes first.
    bench.file("slide.json", "{");
    bench.expect(2, &["run", "slide"]);
    let done = bench.expect(1, &["run", "glide"]);
    assert!(done.err.contains("cannot read glide"), "{}", done.err);
}

#[test]
fn a_study_is_found_by_its_name_in_any_folder_of_studies() {
    let bench = Bench::new();
    bench.file("studies/a/b/slide.json", friction(ONE, ""));
    let study_path = "studies/a/b/slide.json";
    for verb in ["run", "explain", "check", "list", "report", "status"] {
        for name in ["slide", "slide.json", "b/slide"] {
            bench.expect(0, &[verb, name]);
        }
    }
    let done = bench.expect(0, &["sbatch", "slide", "--shards", "2"]);
    assert!(done.out.contains(study_path), "{}", done.out);
    // Two files of one name: both are named, and a path says which is meant.
    bench.file("studies/c/slide.json", friction(ONE, ""));
    let done = bench.expect(2, &["run", "slide", "--out", "none"]);
    let said = format!(
        "slide: 2 files have this name: {study_path}, studies/c/slide.json; name one by its path"
    );
    assert!(done.err.contains(&said), "{}", done.err);
    assert!(!bench.path("none").exists());
    let done = bench.expect(0, &["run", "c/slide"]);
    assert_eq!(done.out, "figures/c/slide\n");
    bench.expect(0, &["run", study_path]);
}

#[test]
fn init_without_a_problem_names_all() {
    let done = Bench::new().expect(2, &["init", "first"]);
    for problem in ["friction-oscillator", "bar-impact", "structure"] {
        assert!(done.err.contains(problem), "{}", done.err);
    }
}

const STRUCTURE: &str = r#"{ "problem": "structure",
    "parameters": { "dt": 0.01, "duration": 1, "stiff": [1, 2, 1], "law": ["coulomb"] },
    "structure": { "units": "t, kN, m, s", "masses": { "x": 1 }, "ground": GROUND,
        "contacts": { "f": { "law": "coulomb", "between": ["ground", "x"], "limit": 1 } },
        "springs": [{ "between": ["ground", "x"], "k": "stiff" }] },
    "metrics": ["peak(x)", "ground.pga", "ground.y.pga"], "figures": [{ "name": "h", "kind": "history", "y": "ground.v" }] }"#;

#[test]
fn a_misspelt_setting_has_a_hint() {
    let bench = Bench::new();
    let study = STRUCTURE
        .replace("GROUND", r#"{ "y": { "synthetic": 1 } }"#)
        .replace(r#", "law": ["coulomb"]"#, "")
        .replace("ground.pga", "peak(x.v)")
        .replace("ground.v", "x");
    bench.file("s.json", study);
    let done = bench.expect(2, &["explain", "s.json", "--set", "stif=2"]);
    assert!(done.err.contains("did you mean \"stiff\"?"), "{}", done.err);
    let done = bench.expect(0, &["explain", "s.json"]);
    let note = "note: stiff has the value 1 twice: its cases repeat";
    assert!(done.out.contains(note), "{}", done.out);
}

#[test]
fn a_missing_record_is_the_only_fault() {
    let bench = Bench::new();
    let study = STRUCTURE
        .replace(
            "GROUND",
            r#"{ "x": { "record": "none.smc" }, "y": { "synthetic": 1 } }"#,
        )
        .replace(r#", "law": ["coulomb"]"#, "")
        .replace("ground.pga", "ground.x.pga")
        .replace("ground.v", "ground.x.v");
    bench.file("s.json", study);
    let done = bench.expect(2, &["run", "s.json"]);
    let faults = done.err.lines().filter(|line| line.starts_with("s.json:"));
    assert_eq!(faults.count(), 1, "{}", done.err);
    assert!(done.err.contains("none.smc"), "{}", done.err);
}

#[test]
fn pages_may_load_nothing() {
    let bench = Bench::new();
    bench.file("studies/s.json", friction(ONE, ""));
    bench.expect(0, &["run"]);
    bench.expect(0, &["report"]);
    let page = bench.text("figures/report.html");
    let policy = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';";
    assert!(page.contains(policy));
}
