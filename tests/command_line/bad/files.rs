//! Friction studies and files with faults: all faults are reported at once with their places, and no file is written.

use crate::{Bench, Done, ONE, TWO, friction};

/// Runs a study with faults by every verb that reads it. Each sign ¶ in the text marks the place of a fault and is removed
/// first. Each fault must be reported there, in order, and begin with the expected text.
#[track_caller]
pub(crate) fn refused(marked: &str, expected: &[&str]) {
    let mut expected = expected.iter();
    let (mut text, mut lines) = (String::new(), Vec::new());
    for (i, part) in marked.split('¶').enumerate() {
        if i > 0 {
            let line = text.matches('\n').count() + 1;
            let column = text.rsplit('\n').next().unwrap().chars().count() + 1;
            lines.push(format!("{line}:{column}: {}", expected.next().unwrap()));
        }
        text.push_str(part);
    }
    assert!(
        expected.next().is_none(),
        "{marked}: more faults than marks"
    );
    refused_bytes(text.as_bytes(), &lines);
}

/// The same, with `LINE:COLUMN: ` before the expected text.
#[track_caller]
fn refused_bytes(text: &[u8], expected: &[String]) {
    let bench = Bench::new();
    bench.file("studies/s.json", text);
    for verb in ["run", "check", "list"] {
        let done = bench.expect(2, &[verb]);
        let shown = |line: &&str| line.starts_with("  | ");
        let lines: Vec<&str> = done.err.lines().filter(|line| !shown(line)).collect();
        assert_eq!(done.err.lines().filter(shown).count(), 2 * lines.len());
        let begins = |(line, start): (&&str, &String)| {
            line.strip_prefix("studies/s.json:")
                .is_some_and(|rest| rest.starts_with(start))
        };
        let fit = lines.len() == expected.len() && lines.iter().zip(expected).all(begins);
        assert!(fit, "{verb}: found {lines:#?}\nexpected {expected:#?}");
        assert_eq!(done.out, "");
    }
    assert_eq!(bench.tree("."), ["studies/s.json"]);
    assert!(!bench.path("figures").exists(), "nothing is written");
}

/// A friction study with this value of alpha.
#[track_caller]
fn alpha(value: &str, expected: &str) {
    let rest = r#""law": "displacement-control", "dT": 1, "duration": 9, "//": "α", "#;
    let mark = if value.contains('¶') { "" } else { "¶" };
    refused(
        &friction(&format!("{rest}\"alpha\": {mark}{value}"), ""),
        &[expected],
    );
}

#[test]
fn numbers() {
    alpha("-0.1", "parameters.alpha: must be > 0, got -0.1");
    alpha("0", "parameters.alpha: must be > 0");
    alpha(
        "1e999",
        "parameters.alpha: must be a finite number, got 1e999",
    );
    alpha("\"1/0\"", "parameters.alpha: \"1/0\": ");
    alpha("\"pi/\"", "parameters.alpha: \"pi/\": ");
    alpha("\"NaN\"", "parameters.alpha: \"NaN\": ");
    alpha("NaN", "not valid JSON");
    alpha("true", "parameters.alpha: must be a number");
    alpha("null", "parameters.alpha: must be a number");
    alpha(
        "[]",
        "parameters.alpha: must be a value or a non-empty list",
    );
    alpha("[¶[0.1]]", "parameters.alpha[0]: must be a number");
}

#[test]
fn names() {
    let beta = TWO.replace("[0.1, 1]", "1, \"beta\": ¶1");
    refused(
        &friction(&beta, ""),
        &[
            "parameters.beta: does not apply to law displacement-control, only to velocity-control, tanh, stribeck or stribeck-hyperbolic; allowed: law, alpha,",
        ],
    );
    refused(
        &friction(
            &TWO.replace("\"displacement-control", "¶\"displacement-controll"),
            "",
        ),
        &[
            "parameters.law: unknown law \"displacement-controll\", did you mean \"displacement-control\"?; allowed: ",
        ],
    );
    refused(
        &friction(TWO, "").replace("\"friction-oscillator", "¶\"friction-oscilator"),
        &[
            "problem: unknown problem \"friction-oscilator\", did you mean \"friction-oscillator\"?; allowed: ",
        ],
    );
    refused(
        &friction(&TWO.replace("duration\": ", "duratoin\": ¶"), "").replace(": { ", ": ¶{ "),
        &[
            "parameters.duration: missing",
            "parameters.duratoin: unknown key \"duratoin\", did you mean \"duration\"?; allowed: ",
        ],
    );
    refused(
        &friction(&format!("{ONE}, ¶\"dT\": 0.5"), ""),
        &["parameters.dT: key \"dT\" is given twice"],
    );
}

#[test]
fn all_faults_of_all_files_at_once() {
    let bench = Bench::new();
    bench.file("studies/a.json", "{\n  \"problem\": 7 }");
    bench.file("studies/b.json", friction(ONE, ""));
    bench.file(
        "studies/c.json",
        friction(
            &TWO.replace("pi/10", "pi/"),
            ",\n \"cheks\": [],\n \"checks\": [{ \"metric\": \"rms_error\" }]",
        ),
    );
    let done = bench.expect(2, &["run"]);
    let caret = "  |   \"problem\": 7 }\n  |              ^\n";
    assert!(done.err.contains(caret), "{}", done.err);
    let places: Vec<String> = done
        .err
        .lines()
        .filter(|line| !line.starts_with("  | "))
        .map(|line| line.splitn(5, ':').take(4).collect::<Vec<_>>().join(":"))
        .collect();
    assert_eq!(
        places,
        [
            "studies/a.json:1:1: parameters",
            "studies/a.json:2:14: problem",
            "studies/c.json:1:109: parameters.dT",
            "studies/c.json:2:11: cheks",
            "studies/c.json:3:13: checks[0]",
        ],
        "{}",
        done.err
    );
    assert!(!bench.path("figures").exists());
}

#[test]
fn a_step_longer_than_the_run() {
    refused(
        &friction(&ONE.replace("0.5", "¶3.0000000001"), ""),
        &["parameters.dT: must be at most duration = 3, got 3.0000000001"],
    );
}

#[test]
fn files_that_are_not_studies() {
    refused("¶", &["the file is empty"]);
    refused("¶ \r\n", &["the file is empty"]);
    refused("¶[]", &["must be an object"]);
    refused("¶null", &["must be an object"]);
    refused("¶¶{}", &["problem: missing", "parameters: missing"]);
    refused(
        &format!("{}¶", &friction(TWO, "")[..100]),
        &["the file ends too early"],
    );
    refused(&format!("{}¶}}", friction(TWO, "")), &["not valid JSON"]);
    refused_bytes(b"{\n\"title\": \"\xe9\" }", &["2:11: not UTF-8".into()]);
    refused_bytes(b"\x00\x01\x02", &["1:1: not valid JSON".into()]);
    for (open, close) in [("[", "]"), ("{\"a\":", "}")] {
        let deep = open.repeat(100_000) + "1" + &close.repeat(100_000);
        refused_bytes(deep.as_bytes(), &["1:".into()]);
        refused_bytes(open.repeat(100_000).as_bytes(), &["1:".into()]);
    }
}

#[test]
fn missing_folders_and_files() {
    let bench = Bench::new();
    bench.file("empty/readme.txt", "");
    let done = bench.expect(2, &["run", "empty"]);
    assert_eq!(done.err, "slipgap: no studies (*.json) in folder empty\n");
    // Without an argument, the folder studies is meant.
    let done = bench.expect(2, &["check"]);
    let says = "slipgap: no folder studies here; name a study file or a folder, or write a first study by `slipgap init`\n";
    assert_eq!(done.err, says);
    for words in [&["run", "none.json"][..], &["list", "none"]] {
        let done = bench.run(words);
        assert_eq!(done.code, Some(1), "{done:?}");
        assert!(done.err.starts_with("slipgap: cannot read "), "{done:?}");
    }
    assert_eq!(bench.tree("."), ["empty/readme.txt"]);
}

#[test]
fn an_output_folder_that_cannot_be_written_is_reported_before_computing() {
    let bench = Bench::new();
    bench.file("studies/a.json", friction(ONE, ""));
    bench.file("studies/b.json", friction(ONE, ""));
    bench.file("file", "in the way");
    bench.file("out/b", "in the way");
    bench.file("results/a/results.csv/x", "a folder in the way");
    let cannot = |done: &Done| done.err.starts_with("slipgap: cannot ");
    let done = bench.expect(1, &["run", "--out", "file"]);
    assert!(cannot(&done) && done.out.is_empty(), "{done:?}");
    let done = bench.expect(1, &["run", "--out", "out"]);
    assert!(cannot(&done) && done.out.is_empty(), "{done:?}");
    assert!(!bench.path("out/a/results.csv").exists());
    // A folder with the name of a file is detected only when the file is written.
    let done = bench.expect(1, &["run", "--out", "results"]);
    assert!(done.err.contains("slipgap: cannot write "), "{done:?}");
}

#[test]
fn the_files_of_studies_are_listed() {
    let bench = Bench::new();
    let structure = r#"{"masses": {"a": 1}, "springs": [{"between": ["ground", "a"], "k": 40}], "ground": {"record": "motions/one.csv", "unit": "g"}}"#;
    let study = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}}, "structure": {structure}, "metrics": ["peak(a)"]}}"#
    );
    bench.file("deep/s.json", &study);
    bench.file("deep/t.json", &study);
    bench.file("deep/motions/one.csv", "t,a\n0,0\n0.5,1\n1,0\n2,0\n");
    let done = bench.expect(0, &["list", "--files", "deep"]);
    assert_eq!(done.out, "deep/s.json\ndeep/motions/one.csv\ndeep/t.json\n");
}

#[test]
fn a_path_of_objects_names_its_bucket() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    // The name of the study would be that of the bucket; the library panics at a blank.
    let forms = [
        "s3://",
        "s3:/",
        "s3:///s",
        "s3://a b/c",
        "s3://ab",
        "s3:bucket",
        "S3://bucket",
        "https://bucket/s",
    ];
    for out in forms {
        for verb in [
            &["run"][..],
            &["run", "--shard", "1/2"],
            &["merge"],
            &["status"],
            &["report"],
        ] {
            let done = bench.expect(2, &[verb, &["s.json", "--out", out]].concat());
            assert!(
                done.err
                    .contains("must be s3://BUCKET or s3://BUCKET/FOLDER"),
                "{done:?}"
            );
        }
    }
}

#[cfg(not(feature = "object-store"))]
#[test]
fn an_object_store_needs_a_program_built_with_it() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    let why = "this slipgap is built without object stores; `cargo install --path . --features object-store` in its sources builds it with them\n";
    for (verb, action) in [
        (&["run"][..], "write in folder s3://bucket/s"),
        (&["run", "--shard", "1/2"], "read s3://bucket/s/store"),
        (&["merge"], "write in folder s3://bucket/s"),
        (&["report"], "write in folder s3://bucket"),
    ] {
        let done = bench.expect(1, &[verb, &["s.json", "--out", "s3://bucket"]].concat());
        assert_eq!(done.err, format!("slipgap: cannot {action}: {why}"));
    }
    assert_eq!(bench.everything("."), ["s.json"]);
}

#[test]
fn figures_of_more_steps_than_fit_in_memory() {
    let long = ONE
        .replace("0.5", "5e-7")
        .replace("\"beta\": 1", "\"beta\": [1, 2, 3]");
    let figure = r#", "figures": [{ "name": "h", "kind": "history"WHERE }]"#;
    let text = friction(&long, &figure.replace("WHERE", ""));
    refused(
        &text.replace("[{ \"name", "[¶{ \"name"),
        &["figures[0].where: more than 10000000 steps to draw; narrow the cases with \"where\""],
    );
    let bench = Bench::new();
    let narrowed = figure.replace("WHERE", ", \"where\": { \"beta\": 1 }");
    bench.file("s.json", friction(&long, &narrowed));
    bench.expect(0, &["list", "s.json"]);
}

#[test]
fn a_name_outside_the_output_folder() {
    let bench = Bench::new();
    bench.file("...json", friction(ONE, ""));
    bench.file("..json", friction(ONE, ""));
    for name in ["...json", "..json"] {
        let done = bench.expect(2, &["run", name, "--out", "deep/out"]);
        assert!(
            done.err.contains("gives no valid name for a folder"),
            "{done:?}"
        );
    }
    assert_eq!(bench.tree("."), ["...json", "..json"]);
}

/// Whether a text has control characters of a terminal.
fn raw(text: &str) -> bool {
    text.chars().any(|c| c.is_control() && c != '\n')
}

#[test]
fn an_endless_file_is_an_error() {
    let bench = Bench::new();
    // 64 MiB of it are read.
    if cfg!(unix) {
        let done = bench.expect(2, &["list", "/dev/zero"]);
        assert_eq!(
            done.err.lines().next(),
            Some("/dev/zero:1:1: larger than 64 MiB, the limit for a study")
        );
    }
    let study = friction(ONE, "");
    bench.file(
        "s.json",
        study.clone() + &" ".repeat((64 << 20) - study.len()),
    );
    bench.expect(0, &["list", "s.json"]);
    bench.file(
        "s.json",
        study.clone() + &" ".repeat((64 << 20) - study.len() + 1),
    );
    bench.expect(2, &["list", "s.json"]);
}

#[cfg(unix)]
#[test]
fn control_characters_in_file_names_are_escaped() {
    let bench = Bench::new();
    for (name, escaped, character) in [
        ("a\u{1b}[31mb.json", "a\\u{1b}[31mb.json", "U+001B"),
        ("a\nb.json", "a\\nb.json", "U+000A"),
        ("a\u{202e}b.json", "a\\u{202e}b.json", "U+202E"),
    ] {
        bench.file(&format!("f/{name}"), friction(ONE, ""));
        for asked in ["f", &format!("f/{name}")] {
            for verb in ["list", "run", "check"] {
                let done = bench.expect(2, &[verb, asked]);
                let what = format!(
                    "slipgap: f/{escaped}: the name of a study cannot contain {character}; rename it\n"
                );
                assert_eq!(done.err, what);
            }
        }
        std::fs::remove_file(bench.path(&format!("f/{name}"))).unwrap();
    }
    // Names in other messages.
    for words in [
        &["list", "no\u{1b}[2Jthing"][..],
        &["compare", "no\u{9b}2J", "there\u{7}"],
        &["run", "f\u{1b}c"],
    ] {
        let done = bench.run(words);
        assert!(!raw(&done.err) && !raw(&done.out), "{done:?}");
        assert_ne!(done.code, Some(0));
    }
}

#[test]
fn long_titles_and_names_are_not_shortened() {
    let bench = Bench::new();
    let title = "x".repeat(70_000);
    let when = format!("\"1{}\"", " + 0".repeat(20_000));
    bench.file(
        "s.json",
        friction(
            &ONE.replace(
                "\"beta\": 1",
                &format!("\"beta\": {}", when.replace("1 + 0", "1 + 0*dT")),
            ),
            &format!(", \"title\": \"{title}\""),
        ),
    );
    let done = bench.expect(0, &["list", "s.json"]);
    assert!(done.out.contains(&title));
    let done = bench.expect(0, &["explain", "s.json"]);
    assert!(done.out.contains(" + 0 + 0"));
}

#[test]
fn too_many_threads_are_an_error() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    for (jobs, code) in [("0", 2), ("1025", 2), ("65535", 2), ("3", 0)] {
        bench.expect(code, &["run", "s.json", "--jobs", jobs]);
    }
}

#[test]
fn a_million_million_combinations_are_explained() {
    let bench = Bench::new();
    let many = r#""law": "velocity-control", "beta": {"linspace": [1, 2, 1000000]}, "x0": {"linspace": [1, 2, 1000000]},
        "dT": 0.1, "duration": 9"#;
    // The condition depends only on beta: of 10^6 values those from the 500 000th on, counted from 0, are cases.
    let when = ", \"when\": \"beta > 1.5\"";
    bench.file(
        "s.json",
        format!("{{\"problem\": \"friction-oscillator\", \"parameters\": {{{many}}}{when}}}"),
    );
    let done = bench.expect(0, &["explain", "s.json", "499999999999"]);
    assert!(
        done.out.contains("case 499999999999 of 500000000000"),
        "{done:?}"
    );
    bench.expect(2, &["explain", "s.json", "500000000000"]);
    // The number of points of a figure cannot be determined.
    let figure = r#", "figures": [{"name": "f", "kind": "metric", "x": "beta", "y": "rms_error"}]"#;
    bench.file("s.json", friction(many, figure));
    let done = bench.expect(2, &["explain", "s.json"]);
    assert!(
        done.err.contains(
            "figures[0].where: chooses among 1000000000000 combinations; allowed: at most 10000000"
        ),
        "{done:?}"
    );
}

/// The exit code of a command within ten seconds; `None` if it does not end.
#[cfg(target_os = "linux")]
fn ends(bench: &Bench, args: &[&str]) -> Option<i32> {
    let mut command = bench.command();
    let null = std::process::Stdio::null;
    command.args(args).stdout(null()).stderr(null());
    let mut child = command.spawn().unwrap();
    for _ in 0..1000 {
        if let Some(status) = child.try_wait().unwrap() {
            return status.code();
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    None
}

/// /proc/kmsg has no end: a reader waits for the next message. It is readable by root only; others get an error at once.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_never_ends_is_not_waited_for() {
    let bench = Bench::new();
    let record = r#"{ "problem": "structure", "parameters": { "dt": 0.01, "duration": 1 },
        "structure": { "units": "t, kN, m, s", "masses": { "m": 1 }, "springs": [{ "between": ["ground", "m"], "k": 1 }],
            "ground": { "record": "/proc/kmsg", "unit": "g" } }, "metrics": ["peak(m)"] }"#;
    bench.file("s.json", record);
    assert_eq!(ends(&bench, &["list", "s.json"]), Some(2));
    for args in [
        &["list", "/proc/kmsg"][..],
        &["run", "/proc/kmsg"],
        &["claims", "/proc/kmsg"],
    ] {
        assert!(matches!(ends(&bench, args), Some(1 | 2)), "{args:?}");
    }
}
