//! `init` and `explain`.

use crate::Bench;

#[test]
fn a_study_of_init_runs_and_meets_its_checks() {
    let bench = Bench::new();
    for problem in ["friction-oscillator", "bar-impact", "structure"] {
        let name = format!("mine/{problem}");
        let done = bench.expect(0, &["init", &name, "--problem", problem]);
        assert!(
            done.out.starts_with(&format!("studies/{name}.json\n")),
            "{}",
            done.out
        );
        let file = format!("studies/{name}.json");
        let text = bench.text(&file);
        assert!(text.contains("\"//\"") && text.contains("\"../../schema/study.json\""));
        bench.expect(0, &["check", &file]);
        let done = bench.expect(0, &["run", &file, "--deny-warnings"]);
        assert!(!done.err.contains("warning"), "{}", done.err);
        assert!(bench.path("schema/study.json").is_file());
        // An existing file is not replaced.
        let done = bench.expect(2, &["init", &name, "--problem", problem]);
        assert!(done.err.contains("exists already"), "{}", done.err);
        assert_eq!(bench.text(&file), text);
    }
    assert!(
        bench
            .expect(2, &["init", "x", "--problem", "bars"])
            .err
            .contains("bar-impact")
    );
    for name in ["../x", "/x", "", "a//b", ".x", "-x", "a b"] {
        let done = bench.expect(2, &["init", "--problem", "bar-impact", "--", name]);
        assert!(done.err.contains("must be letters"), "{name}: {}", done.err);
    }
}

#[test]
fn explain_shows_the_origin_of_each_value() {
    let bench = Bench::new();
    let study = r#"{"problem": "bar-impact", "parameters": {"gamma": [0.5, 1], "n": {"uniform": [2, 9]}, "dt": "0.1/n",
        "duration": 1.5, "gap": 0.2}, "design": {"kind": "sobol", "n": 4},
        "figures": [{"name": "one", "kind": "history", "where": {"gamma": 1}, "by": "n"}]}"#;
    bench.file("s.json", study);
    let output = bench.expect(0, &["explain", "s.json", "5"]).out;
    let row = |name: &str| -> Vec<&str> {
        let mut lines = output
            .lines()
            .map(|line| line.split_whitespace().collect::<Vec<_>>());
        lines.find(|words| words.first() == Some(&name)).unwrap()
    };
    assert_eq!(row("gamma")[..6], ["gamma", "1", "1", "axis", "of", "2"]);
    assert_eq!(row("n")[3], "design");
    assert_eq!(row("dt")[3], "\"0.1/n\"");
    assert_eq!(row("gap")[1..6], ["0.2", "c", "T_I/2", "study", "distance"]);
    assert_eq!(row("E")[3], "default");
    assert_eq!(row("k_I")[3], "follows");
    let n: f64 = row("n")[1].parse().unwrap();
    let steps = (1.5 / (0.1 / n) * (1.0 + 1e-12)).floor();
    assert!(output.contains(&format!(
        "steps: {steps}; steps x modes: {} of",
        steps * 2.0 * (n + 1.0)
    )));
    assert!(output.contains("figures: one\n"), "{output}");
    assert!(
        bench
            .expect(2, &["explain", "."])
            .err
            .contains(". is a folder; name one study")
    );
    let done = bench.expect(2, &["explain", "s.json", "8"]);
    assert!(
        done.err.contains("case 8: s has cases 0 to 7"),
        "{}",
        done.err
    );
}

#[cfg(unix)]
#[test]
fn init_writes_through_no_link() {
    use std::os::unix::fs::symlink;
    let bench = Bench::new();
    bench.file("studies/other.json", "mine");
    let init = ["init", "x", "--problem", "bar-impact"];
    // It leads to a file that is not there, so that it does not exist itself.
    symlink(bench.path("mine"), bench.path("studies/x.json")).unwrap();
    let done = bench.expect(1, &init);
    assert!(
        done.err.contains("studies/x.json: there is a link"),
        "{done:?}"
    );
    std::fs::remove_file(bench.path("studies/x.json")).unwrap();
    std::fs::create_dir(bench.path("schema")).unwrap();
    symlink(bench.path("mine"), bench.path("schema/study.json")).unwrap();
    let done = bench.expect(1, &init);
    assert!(
        done.err.contains("schema/study.json: there is a link"),
        "{done:?}"
    );
    assert!(!bench.path("mine").exists());
}
