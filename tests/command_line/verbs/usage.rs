//! Verbs: list, schema, help, version, and mistakes on the command line.

use crate::{Bench, ONE, TWO, friction};
use std::path::Path;
use std::process::{Command, Stdio};

#[test]
fn help_and_version_go_to_stdout() {
    let bench = Bench::new();
    let help = bench.expect(0, &["--help"]);
    for word in ["run", "check", "list", "schema", "Exit codes", "130"] {
        assert!(help.out.contains(word), "{help:?}");
    }
    for verb in ["run", "check"] {
        assert!(bench.expect(0, &[verb, "--help"]).out.contains("--jobs"));
    }
    let printed = bench.expect(0, &["--version"]).out;
    let version = printed.strip_suffix('\n').unwrap();
    let number = concat!("slipgap ", env!("CARGO_PKG_VERSION"));
    match head() {
        Some(commit) => assert_eq!(version, format!("{number} ({})", &commit[..8])),
        None => assert_eq!(version, number),
    }
}

/// The commit by git itself, if this is a repository that keeps the log of its HEAD.
fn head() -> Option<String> {
    let root = Path::new(env!("SLIPGAP_ROOT"));
    let git = |words: &[&str]| {
        let mut command = Command::new("git");
        let call = command.arg("rev-parse").args(words).current_dir(root);
        let output = call.output().ok()?;
        let text = String::from_utf8(output.stdout).unwrap();
        output.status.success().then(|| text.trim().to_owned())
    };
    let log = root.join(git(&["--git-path", "logs/HEAD"])?);
    (root.join(".git").exists() && log.is_file()).then(|| git(&["HEAD"]).unwrap())
}

#[test]
fn mistakes_on_the_command_line_have_exit_code_2() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    for words in [
        &[][..],
        &["frobnicate"],
        &["run", "s.json", "--jobs", "0"],
        &["run", "s.json", "--jobs", "-1"],
        &["run", "s.json", "--jobs", "two"],
        &["run", "s.json", "--jobs"],
        &["run", "s.json", "--ot", "x"],
        &["check", "s.json", "--out", "x"],
        &["schema", "s.json"],
    ] {
        let done = bench.expect(2, words);
        assert!(done.out.is_empty() && !done.err.is_empty(), "{done:?}");
    }
    assert_eq!(bench.tree("."), ["s.json"]);
}

#[test]
fn list_shows_axes_cases_and_steps_without_running() {
    let bench = Bench::new();
    // A run would take hours.
    let long =
        r#""law": "velocity-control", "beta": [1, 2, 3], "dT": [1e-3, 1e-2], "duration": 2e4"#;
    bench.file(
        "studies/long.json",
        friction(long, r#", "title": "Very long""#),
    );
    bench.file("studies/two.json", friction(TWO, ""));
    let done = bench.expect(0, &["list"]);
    let rows: Vec<Vec<&str>> = done
        .out
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(
        rows[0],
        [
            "study", "problem", "cases", "steps", "axes", "figures", "title"
        ]
    );
    let long = [
        "long",
        "friction-oscillator",
        "6",
        "2000000..20000000",
        "beta(3)",
        "dT(2)",
        "Very",
        "long",
    ];
    assert_eq!(rows[1], long);
    assert_eq!(
        rows[2],
        ["two", "friction-oscillator", "2", "80", "alpha(2)"]
    );
    assert_eq!(bench.tree("."), ["studies/long.json", "studies/two.json"]);
}

#[test]
fn a_title_cannot_move_the_cursor() {
    let bench = Bench::new();
    bench.file(
        "s.json",
        friction(ONE, r#", "title": "one\ntwo\u001b[31m""#),
    );
    let done = bench.expect(2, &["list", "s.json"]);
    assert!(
        done.err
            .contains("title: must be a string of printable characters, got U+000A")
    );
    assert!(!done.err.contains('\u{1b}'), "{done:?}");
}

#[test]
fn the_schema_is_json_with_the_problems() {
    let text = Bench::new().expect(0, &["schema"]).out;
    let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
    let problems = &schema["properties"]["problem"]["enum"];
    assert_eq!(
        *problems,
        serde_json::json!(["friction-oscillator", "bar-impact", "structure"])
    );
}

/// The definition to which a part of the schema refers, or the part itself.
fn written_out<'a>(
    schema: &'a serde_json::Value,
    part: &'a serde_json::Value,
) -> &'a serde_json::Value {
    let annotated = &part["allOf"][0]["$ref"];
    let reference = part["$ref"].as_str().or(annotated.as_str());
    reference.map_or(part, |text| schema.pointer(&text[1..]).unwrap())
}

#[test]
fn the_schema_allows_one_value_or_a_list_in_where() {
    let text = Bench::new().expect(0, &["schema"]).out;
    let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
    for problem in ["friction-oscillator", "bar-impact"] {
        let filter = &schema["definitions"][format!("{problem}.where")];
        let properties = filter["properties"].as_object().unwrap();
        assert!(properties.len() > 3, "{filter}");
        for (name, value) in properties.iter().filter(|(name, _)| *name != "//") {
            let value = written_out(&schema, value);
            let [one, list] = &value["anyOf"].as_array().unwrap()[..] else {
                panic!("{name}: {value}")
            };
            let list = written_out(&schema, list);
            assert_eq!(list["type"], "array", "{name}");
            assert_eq!(list["items"], *one, "{name}");
        }
    }
}

/// The verbs that the help lists.
fn verbs(bench: &Bench) -> Vec<String> {
    let help = bench.expect(0, &["--help"]).out;
    let from_commands = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let lines = from_commands.take_while(|line| !line.is_empty());
    let words = lines.filter_map(|line| line.split_whitespace().next());
    words.map(String::from).collect()
}

#[test]
fn shells_complete_every_verb_and_each_has_a_manual_page() {
    let bench = Bench::new();
    let verbs = verbs(&bench);
    assert!(verbs.len() > 10, "{verbs:?}");
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = bench.expect(0, &["completions", shell]).out;
        for word in verbs
            .iter()
            .map(String::as_str)
            .chain(["black", "markdown"])
        {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    bench.expect(2, &["completions", "dos"]);
    bench.expect(0, &["man", "share/man1"]);
    let pages = bench.tree("share/man1");
    for verb in verbs.iter().filter(|verb| *verb != "help") {
        assert!(pages.contains(&format!("slipgap-{verb}.1")), "{verb}");
    }
    assert!(pages.contains(&"slipgap.1".to_owned()), "{pages:?}");
    let page = bench.text("share/man1/slipgap-run.1");
    assert!(page.starts_with(".ie") && page.contains(".TH"), "{page}");
    assert!(page.contains("\\-\\-histories"), "{page}");
    bench.file("file", "");
    let done = bench.expect(1, &["man", "file"]);
    assert!(done.err.contains("cannot make folder file"), "{done:?}");
}

#[test]
fn a_closed_pipe_is_not_an_error() {
    let bench = Bench::new();
    let figure = r#", "figures": [{ "name": "history", "kind": "history" }]"#;
    bench.file("studies/a.json", friction(TWO, figure));
    for words in [
        &["schema"][..],
        &["list"],
        &["run"],
        &["check"],
        &["--help"],
    ] {
        let mut command = bench.command();
        command
            .args(words)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        drop(child.stdout.take());
        let done: crate::Done = child.wait_with_output().unwrap().into();
        assert_eq!(done.code, Some(0), "{words:?}: {done:?}");
        assert!(!done.err.contains("panicked"), "{words:?}: {done:?}");
    }
    let written = [
        "history.pdf",
        "history.png",
        "history.svg",
        "manifest.json",
        "results.csv",
    ];
    assert_eq!(bench.tree("figures/a"), written);
}

#[test]
fn another_limit_of_the_number_of_cases() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, ""));
    let done = bench.expect(2, &["list", "s.json", "--limit", "1"]);
    assert!(
        done.err.contains("2 cases; allowed: at most 1"),
        "{}",
        done.err
    );
    bench.expect(0, &["list", "s.json", "--limit", "2"]);
    // More than 10^9 combinations need the option. They are counted without being made.
    let axis = |name: &str| format!(r#""{name}": {{"linspace": [1, 2, 40000]}}"#);
    let many = format!(
        r#""law": "velocity-control", {}, {}, "dT": 0.1, "duration": 9"#,
        axis("beta"),
        axis("x0")
    );
    bench.file("s.json", friction(&many, ""));
    let done = bench.expect(2, &["list", "s.json"]);
    assert!(
        done.err
            .contains("1600000000 cases; allowed: at most 1000000000"),
        "{}",
        done.err
    );
    let done = bench.expect(0, &["explain", "s.json", "1599999999"]);
    assert!(
        done.out.contains("case 1599999999 of 1600000000"),
        "{}",
        done.out
    );
}

#[test]
fn numbers_that_are_none_are_named_with_what_is_allowed() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    for (words, says) in [
        (
            &["explain", "s.json", "abc"][..],
            "'abc' for '[CASE]': must be a whole number >= 0",
        ),
        (
            &["run", "s.json", "--dpi", "300.5"],
            "'300.5' for '--dpi <N>': must be a whole number from 72 to 1200",
        ),
        (
            &["run", "s.json", "--dpi", "71"],
            "'71' for '--dpi <N>': must be a whole number from 72 to 1200",
        ),
        (
            &["run", "s.json", "--jobs", "1025"],
            "must be a whole number from 1 to 1024",
        ),
        (
            &["list", "s.json", "--limit", "1e6"],
            "'1e6' for '--limit <CASES>': must be a whole number >= 0",
        ),
        (
            &["merge", "s.json", "--shards", "0"],
            "must be a whole number >= 1",
        ),
    ] {
        let done = bench.expect(2, words);
        assert!(done.err.contains(says), "{done:?}");
    }
    bench.expect(0, &["run", "s.json", "--dpi", "72", "--jobs", "1"]);
}

#[test]
fn a_run_draws_in_the_colours_of_okabe_and_ito_unless_black_is_asked_for() {
    let bench = Bench::new();
    let study = |name: &str, key: &str| {
        let text = format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2], "n": 4, "dt": 0.02, "duration": 1.5}},
              "figures": [{{"name": "f", "kind": "history", "y": "r"{key}}}]}}"#
        );
        bench.file(name, &text);
    };
    study("s.json", "");
    study("black.json", r#", "colour": false"#);
    study("blue.json", r#", "colour": true"#);
    let blue = |words: &[&str], name: &str| {
        bench.expect(0, &[&["run"], words].concat());
        bench
            .text(&format!("figures/{name}/f.svg"))
            .contains("#0072b2")
    };
    assert!(blue(&["s.json"], "s"));
    assert!(!blue(&["s.json", "--black"], "s"));
    assert!(!blue(&["black.json"], "black"));
    assert!(blue(&["blue.json"], "blue"));
    assert!(!blue(&["blue.json", "--black"], "blue"));
}

#[test]
fn without_a_folder_of_studies_the_message_says_what_to_do() {
    let bench = Bench::new();
    for verb in ["run", "check", "list", "report"] {
        let done = bench.expect(2, &[verb]);
        assert_eq!(
            done.err,
            "slipgap: no folder studies here; name a study file or a folder, or write a first study by `slipgap init`\n"
        );
    }
    bench.expect(0, &["init", "first", "--problem", "bar-impact"]);
    bench.expect(0, &["list"]);
}

#[test]
fn one_check_is_one_check_and_histories_are_a_reason_to_run_again() {
    let bench = Bench::new();
    let check = r#", "checks": [{ "metric": "rms_error", "max": 1 }]"#;
    bench.file("s.json", friction(ONE, check));
    let done = bench.expect(0, &["check", "s.json"]);
    assert!(done.err.ends_with("1 check, 0 not met\n"), "{done:?}");
    let histories = ["run", "s.json", "--histories"];
    let first = bench.expect(0, &histories);
    assert_eq!(first.err, "s: 1 case run\n");
    let again = bench.expect(0, &histories);
    assert_eq!(
        again.err,
        "s: 1 case run, also those of the store, for their histories\n"
    );
}
