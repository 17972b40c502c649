//! Studies from standard input, and settings of the command line.

use crate::{Bench, Done, ONE, TWO, friction};
use sha2::{Digest, Sha256};
use std::io::Write;
use std::process::Stdio;

/// Runs the program with a text on standard input.
fn piped(bench: &Bench, words: &[&str], text: impl AsRef<[u8]>) -> Done {
    let mut command = bench.command();
    command
        .args(words)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // The program may stop reading before the end.
    let _ = stdin.write_all(text.as_ref());
    drop(stdin);
    child.wait_with_output().unwrap().into()
}

fn sha256(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn manifest(bench: &Bench, folder: &str) -> serde_json::Value {
    serde_json::from_str(&bench.text(&format!("{folder}/manifest.json"))).unwrap()
}

#[test]
fn a_study_from_standard_input_gives_the_same_as_its_file() {
    let bench = Bench::new();
    let check = r#", "checks": [{ "metric": "rms_error", "max": 1 }]"#;
    let text = friction(TWO, check);
    bench.file("s.json", &text);
    bench.expect(0, &["run", "s.json"]);
    let done = piped(&bench, &["run", "-"], &text);
    assert_eq!(done.code, Some(0), "{done:?}");
    let results = bench.text("figures/s/results.csv");
    assert_eq!(bench.text("figures/stdin/results.csv"), results);
    let (file, stdin) = (
        manifest(&bench, "figures/s"),
        manifest(&bench, "figures/stdin"),
    );
    assert_eq!(stdin["study_sha256"], file["study_sha256"]);
    assert_eq!(stdin["study"], "<stdin>");
    // Standard input has no commit.
    assert_eq!(stdin["git_commit"], serde_json::Value::Null);
    for (words, says) in [
        (&["check", "-"][..], "0 not met"),
        (&["list", "-"], "stdin"),
        (&["explain", "-", "1"], "stdin: case 1 of 2"),
        (&["report", "-"], "report.html"),
    ] {
        let done = piped(&bench, words, &text);
        assert_eq!(done.code, Some(0), "{words:?}: {done:?}");
        assert!((done.out + &done.err).contains(says), "{words:?}");
    }
    assert!(bench.text("figures/report.html").contains("&lt;stdin&gt;"));
}

#[test]
fn faults_of_standard_input_have_places() {
    let bench = Bench::new();
    for (text, says) in [
        (
            friction(&TWO.replace("0.1", "-0.1"), "").into_bytes(),
            "<stdin>:1:94: parameters.alpha[0]: must be > 0, got -0.1",
        ),
        (b"{\n\"a\"".to_vec(), "<stdin>:2:4: the file ends too early"),
        (b"{\xff".to_vec(), "<stdin>:1:2: not UTF-8: byte 0xff"),
        (
            vec![b' '; (64 << 20) + 1],
            "<stdin>:1:1: larger than 64 MiB",
        ),
    ] {
        let done = piped(&bench, &["run", "-"], &text);
        assert_eq!(done.code, Some(2), "{says}: {done:?}");
        assert!(done.err.starts_with(says), "{says}: {}", done.err);
    }
    assert_eq!(bench.tree("."), [""; 0]);
}

#[test]
fn a_setting_has_the_same_effect_as_a_value_in_the_file() {
    let bench = Bench::new();
    let blocks = |one: &str, two: &str| {
        format!(
            r#"{{ "problem": "friction-oscillator", "blocks": [{{ "parameters": {{ {one} }} }},
            {{ "parameters": {{ {two} }} }}] }}"#
        )
    };
    let bars = |more: &str| {
        crate::bars(
            &format!(r#""gamma": 1, "n": 2, "dt": 0.1, "duration": 1{more}"#),
            "",
        )
    };
    for (before, settings, after) in [
        (
            friction(TWO, ""),
            &["alpha=2"][..],
            friction(&TWO.replace("[0.1, 1]", "2"), ""),
        ),
        (
            friction(TWO, ""),
            &["alpha = [2, \"1/4\"] "],
            friction(&TWO.replace("[0.1, 1]", "[2, \"1/4\"]"), ""),
        ),
        (
            friction(TWO, ""),
            &["dT=pi/20"],
            friction(&TWO.replace("pi/10", "pi/20"), ""),
        ),
        (
            friction(TWO, ""),
            &["alpha={\"geomspace\": [1, 4, 3]}", "x0=6"],
            friction(&(TWO.replace("[0.1, 1]", "[1, 2, 4]") + r#", "x0": 6"#), ""),
        ),
        (
            friction(TWO, ""),
            &["initial_slip=pulled"],
            friction(&(TWO.to_owned() + r#", "initial_slip": "pulled""#), ""),
        ),
        // A parameter of one block is set there only. A parameter of no block is set in both.
        (
            blocks(TWO, ONE),
            &["beta=[2, 3]"],
            blocks(TWO, &ONE.replace(r#""beta": 1"#, r#""beta": [2, 3]"#)),
        ),
        (
            blocks(TWO, ONE),
            &["x0=[3, 6]"],
            blocks(
                &format!("{TWO}, \"x0\": [3, 6]"),
                &format!("{ONE}, \"x0\": [3, 6]"),
            ),
        ),
        (bars(""), &["right.L=20"], bars(r#", "right": { "L": 20 }"#)),
        (
            bars(r#", "right": { "L": 5, "n": 3 }"#),
            &["right.L=[10, 20]"],
            bars(r#", "right": { "L": [10, 20], "n": 3 }"#),
        ),
        (
            bars(r#", "right": { "L": 5 }"#),
            &["right=wall"],
            bars(r#", "right": "wall""#),
        ),
        (
            bars(""),
            &["dt=0.5/n", "n=[2, 4]"],
            bars("")
                .replace("0.1", "\"0.5/n\"")
                .replace("\"n\": 2", "\"n\": [2, 4]"),
        ),
    ] {
        bench.file("set.json", &before);
        bench.file("file.json", &after);
        let options = settings.iter().flat_map(|setting| ["--set", setting]);
        let words: Vec<&str> = ["run", "set.json"].into_iter().chain(options).collect();
        bench.expect(0, &words);
        bench.expect(0, &["run", "file.json"]);
        let results = bench.text("figures/file/results.csv");
        assert_eq!(
            bench.text("figures/set/results.csv"),
            results,
            "{settings:?}"
        );
    }
}

#[test]
fn the_manifest_has_the_settings() {
    let bench = Bench::new();
    let text = friction(TWO, "");
    bench.file("s.json", &text);
    bench.expect(0, &["run", "s.json"]);
    let plain = manifest(&bench, "figures/s");
    assert_eq!(plain["study_sha256"], sha256(text.as_bytes()));
    assert_eq!(plain.get("set"), None);
    bench.expect(0, &["run", "s.json", "--set", "alpha=2", "--set", "x0=6"]);
    let set = manifest(&bench, "figures/s");
    assert_eq!(
        set["study_sha256"],
        sha256((text + "\0alpha=2\0x0=6").as_bytes())
    );
    assert_eq!(set["set"], serde_json::json!(["alpha=2", "x0=6"]));
    bench.expect(0, &["report", "s.json", "--set", "x0=6"]);
    assert!(bench.text("figures/report.html").contains("s.json --set"));
}

#[test]
fn faults_of_settings_have_places() {
    let bench = Bench::new();
    let figure = r#",
  "figures": [{ "name": "a", "kind": "metric", "x": "alpha", "y": "rms_error", "where": { "alpha": 1 } }]"#;
    bench.file("s.json", friction(TWO, ""));
    bench.file("f.json", friction(TWO, figure));
    bench.file(
        "w.json",
        crate::bars(
            r#""gamma": 1, "n": 2, "dt": 0.1, "duration": 1, "right": "wall""#,
            "",
        ),
    );
    for (file, setting, says) in [
        (
            "s.json",
            "alpha=-0.1",
            &[
                "--set alpha=-0.1:1:7: parameters.alpha: must be > 0, got -0.1\n  | alpha=-0.1\n  |       ^\n",
            ][..],
        ),
        (
            "s.json",
            "alpha=[1, -2, \"x\"]",
            &[
                "--set alpha=[1, -2, \"x\"]:1:11: parameters.alpha[1]: must be > 0, got -2",
                ":1:15: parameters.alpha[2]: \"x\": unknown name",
            ],
        ),
        (
            "s.json",
            "alpha={\"linspace\": [1, 2]}",
            &[":1:20: parameters.alpha.linspace: must be [a, b, n]"],
        ),
        (
            "s.json",
            "alpha=[1, 2",
            &["--set alpha=[1, 2:1:12: the value ends too early"],
        ),
        (
            "s.json",
            "alpha=1 +",
            &["--set alpha=1 +:1:7: parameters.alpha: \"1 +\": expected a number"],
        ),
        (
            "s.json",
            "alpha=",
            &["--set alpha=:1:7: parameters.alpha: "],
        ),
        (
            "s.json",
            "alfa=1",
            &[
                "--set alfa=1:1:6: parameters.alfa: unknown key \"alfa\", did you mean \"alpha\"?; allowed: law",
            ],
        ),
        (
            "s.json",
            "beta=1",
            &["--set beta=1:1:6: parameters.beta: does not apply to law displacement-control"],
        ),
        ("s.json", "dT=1e9", &["--set dT=1e9:1:4: parameters.dT: "]),
        (
            "w.json",
            "right.L=2",
            &[
                "--set right.L=2:1:1: parameters.right: must be an object with the key \"L\", got \"wall\"",
            ],
        ),
        // A value in the file that becomes invalid is a fault of the file.
        (
            "f.json",
            "alpha=3",
            &["f.json:2:89: figures[0].where: no case has alpha = 1; the values are 3"],
        ),
    ] {
        let done = bench.expect(2, &["run", file, "--set", setting]);
        for says in says {
            assert!(done.err.contains(says), "{says}: {}", done.err);
        }
        assert!(!bench.path("figures").exists());
    }
    let done = bench.expect(2, &["list", "s.json", "--set", "x0=1", "--set", "x0=2"]);
    assert_eq!(
        done.err.lines().next(),
        Some("--set x0=2:1:1: \"x0\" is set twice")
    );
    // With several studies, the fault names the study for which the value is invalid.
    let done = bench.expect(2, &["list", "s.json", "w.json", "--set", "alpha=1"]);
    let first = done.err.lines().next().unwrap();
    assert!(
        first.starts_with("--set alpha=1:1:7: parameters.alpha: unknown key")
            && first.ends_with("(in w.json)"),
        "{first}"
    );
    for setting in ["alpha", "=1", "//=1", "a..b=1", "a b=1"] {
        let done = bench.expect(2, &["run", "s.json", "--set", setting]);
        assert!(done.err.contains("must be NAME=VALUE"), "{}", done.err);
    }
}

#[test]
fn every_verb_that_reads_a_study_has_settings() {
    let bench = Bench::new();
    bench.file(
        "s.json",
        friction(TWO, r#", "checks": [{ "metric": "rms_error", "max": 1 }]"#),
    );
    let list = bench.expect(0, &["list", "s.json", "--set", "x0=[3, 6, 12]"]);
    assert!(list.out.contains("x0(3)"), "{}", list.out);
    let explain = bench.expect(0, &["explain", "s.json", "--set", "x0=7.25"]);
    assert!(explain.out.contains("7.25"), "{}", explain.out);
    let check = bench.expect(0, &["check", "s.json", "--set", "x0=[3, 6, 12]"]);
    assert!(check.err.contains("6 checks, 0 not met"), "{}", check.err);
}

#[test]
fn a_setting_of_a_part_of_a_structure_says_what_is_set() {
    let bench = Bench::new();
    let study = r#"{ "problem": "structure", "parameters": { "p": 5, "dt": 0.01, "duration": 0.1 },
        "structure": { "masses": { "m": 1 }, "springs": [{ "between": ["ground", "m"], "k": "p" }] }, "metrics": ["peak(m)"] }"#;
    bench.file("s.json", study);
    for (name, key) in [("m", "k"), ("p", "k"), ("q", "k.x")] {
        let set = format!("{name}.{key}=3");
        let done = bench.expect(2, &["list", "s.json", "--set", &set]);
        let first = done.err.lines().next().unwrap();
        let expected = format!(
            "--set {set}:1:1: parameters.{name}.{key}: a parameter of a structure has no key \"{key}\"; --set changes parameters, as in \
             {name}=2,"
        );
        assert!(first.starts_with(&expected), "{first}");
        // One mistake, one message: with its line and a caret.
        assert_eq!(done.err.lines().count(), 3, "{}", done.err);
    }
    bench.expect(0, &["list", "s.json", "--set", "p=3"]);
}

#[test]
fn a_where_without_cases_names_the_setting_that_changed_them() {
    let bench = Bench::new();
    let figure = r#", "figures": [{ "name": "f", "kind": "history", "where": { "x0": 8 } }]"#;
    let parameters =
        r#""law": "velocity-control", "beta": 0.3, "dT": 0.5, "duration": 3, "x0": [8, 9]"#;
    bench.file("s.json", friction(parameters, figure));
    bench.expect(0, &["list", "s.json"]);
    let done = bench.expect(2, &["list", "s.json", "--set", "x0=10"]);
    let says = "figures[0].where: no case has x0 = 8; the values are 10, by --set x0\n";
    assert!(done.err.contains(says), "{done:?}");
    // Another setting is not the reason.
    bench.file("t.json", friction(parameters, &figure.replace('8', "7")));
    let done = bench.expect(2, &["list", "t.json", "--set", "beta=0.2"]);
    assert!(
        done.err
            .contains("no case has x0 = 7; the values are 8, 9\n"),
        "{done:?}"
    );
}

#[test]
fn a_record_replaces_synthetic_motions_of_the_studies_that_have_them() {
    let bench = Bench::new();
    let study = |seed: &str, ground: &str| {
        format!(
            r#"{{ "problem": "structure", "parameters": {{ "seed": {seed}, "omega": "10 + seed", "k": [5, 6], "dt": 0.01, "duration": 3 }},
            "structure": {{ "units": "t, kN, m, s", "masses": {{ "m": 1 }}, "springs": [{{ "between": ["ground", "m"], "k": "k" }}],
            "ground": {{ "synthetic": {ground}, "scale": 2 }} }}, "metrics": ["peak(m)", "ground.pga"] }}"#
        )
    };
    let by_seed = r#"{ "seed": "seed", "omega": "omega" }"#;
    bench.file("synthetic.json", study("[1, 2, 3]", by_seed));
    bench.file("drawn.json", study(r#""round(k)""#, by_seed));
    bench.file("a.csv", "0, 0\n1, 3\n2, 1\n3, 0\n");
    bench.file("b.csv", "0, 0\n1, -1\n2, 1\n3, 0\n");
    let set = ["--set", r#"record=["a.csv", "b.csv"]"#, "--set", "unit=g"];
    let with = |files: &[&'static str]| [&["run"], files, &set].concat();
    let done = bench.expect(0, &with(&["synthetic.json", "drawn.json"]));
    assert!(done.err.contains("drawn.json: left out: "), "{done:?}");
    assert!(bench.path("figures/synthetic").is_dir() && !bench.path("figures/drawn").exists());
    let results = bench.text("figures/synthetic/results.csv");
    let header: Vec<&str> = results.lines().next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|cell| *cell == name).unwrap();
    let (record, pga) = (column("record"), column("ground.pga"));
    let rows: Vec<Vec<&str>> = results
        .lines()
        .skip(1)
        .map(|row| row.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 4);
    assert!(rows.iter().any(|row| row[record] == "b.csv"));
    // 0.3 g of the synthetic motions, twice by the study.
    for row in &rows {
        assert!((row[pga].parse::<f64>().unwrap() / (0.6 * 9.80665) - 1.0).abs() < 1e-15);
    }
    // Alone it is an error as before.
    let done = bench.expect(2, &with(&["drawn.json"]));
    assert!(done.err.contains("\"record\" is not used"), "{done:?}");
}
