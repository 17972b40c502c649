//! Runs that end early, and files that obstruct them: the next run continues, and no incomplete file remains.

use crate::{Bench, ONE, friction};
use std::fs;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Cases whose histories take many seconds.
const LONG: &str =
    r#""law": "velocity-control", "beta": {"linspace": [1, 2, 1000]}, "dT": 0.01, "duration": 100"#;

/// Starts a run and waits until it has written a file.
fn started(bench: &Bench, words: &[&str], file: impl Fn(&str) -> bool) -> Child {
    let mut command = bench.command();
    command
        .args(words)
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    let there = |bench: &Bench| {
        bench.path("figures/s").exists()
            && bench.everything("figures/s").iter().any(|name| file(name))
    };
    while !there(bench) {
        assert!(
            child.try_wait().unwrap().is_none(),
            "it ended before it wrote"
        );
        sleep(Duration::from_millis(5));
    }
    child
}

fn partial(bench: &Bench) -> Vec<String> {
    let mut names = bench.everything("figures");
    names.retain(|name| name.ends_with(".partial"));
    names
}

#[test]
fn the_next_run_removes_histories_of_a_killed_run_and_no_files_of_the_user() {
    let bench = Bench::new();
    bench.file("s.json", friction(LONG, ""));
    for name in ["mine.csv", "7.csv.txt", "0999.csv", "999.csv"] {
        bench.file(&format!("figures/s/histories/{name}"), "mine");
    }
    let mut child = started(
        &bench,
        &["run", "s.json", "--histories", "--jobs", "1"],
        |name| name == "histories/3.csv",
    );
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!partial(&bench).is_empty(), "results.csv was growing");
    bench.file("s.json", friction(ONE, ""));
    bench.expect(0, &["run", "s.json"]);
    assert_eq!(
        bench.tree("figures/s"),
        [
            "histories/0999.csv",
            "histories/7.csv.txt",
            "histories/999.csv",
            "histories/mine.csv",
            "manifest.json",
            "results.csv"
        ]
    );
    let manifest = bench.text("figures/s/manifest.json");
    assert!(!manifest.contains("unfinished"), "{manifest}");
}

#[test]
fn an_interrupted_run_keeps_its_parts_and_no_temporary_file() {
    // From coarse to fine: 3 steps of 4002 modes, then 1.5 million.
    let study = |steps: &str| {
        format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": 1, "n": 2000, "dt": [{steps}], "duration": 1.5}}}}"#
        )
    };
    let bench = Bench::new();
    bench.file("s.json", study("0.5, 1e-6"));
    let mut child = started(&bench, &["run", "s.json"], |name| {
        name.ends_with(".parquet")
    });
    assert!(!partial(&bench).is_empty(), "results.csv is growing");
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status();
    assert!(sent.unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(partial(&bench), [""; 0]);
    bench.file("s.json", study("0.5"));
    let done = bench.expect(0, &["run", "s.json"]);
    let first = done.err.lines().next();
    assert_eq!(first, Some("s: 1 of 1 cases from the store"), "{done:?}");
}

#[test]
fn an_unreadable_manifest_is_reported_before_computing() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    bench.expect(0, &["run", "s.json"]);
    let whole = bench.text("figures/s/manifest.json");
    for unread in [
        "",
        "{",
        "[]",
        "{}",
        r#"{"files": 1}"#,
        r#"{"files": [1]}"#,
        &whole[..whole.len() / 2],
    ] {
        bench.file("figures/s/manifest.json", unread);
        let done = bench.expect(1, &["run", "s.json"]);
        assert!(
            done.err.starts_with(
                "slipgap: cannot read figures/s/manifest.json: it does not list the files"
            ),
            "{}",
            done.err
        );
    }
    fs::remove_file(bench.path("figures/s/manifest.json")).unwrap();
    bench.expect(0, &["run", "s.json"]);
    assert_eq!(bench.text("figures/s/manifest.json"), whole);
}

#[cfg(unix)]
#[test]
fn files_of_the_user_remain_and_links_are_not_followed() {
    use std::os::unix::fs::symlink;
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    bench.file("mine", "mine");
    let files = [
        ".slipgap-probe",
        "results.csv.partial",
        "manifest.json.partial",
        "store/results.csv.partial",
    ];
    for name in files {
        bench.file(&format!("figures/s/{name}"), "mine");
    }
    for name in ["results.csv", "failures.csv.partial"] {
        symlink(bench.path("mine"), bench.path(&format!("figures/s/{name}"))).unwrap();
    }
    // A link is neither followed nor replaced.
    let done = bench.expect(1, &["run", "s.json"]);
    assert!(
        done.err.contains("figures/s/results.csv: there is a link"),
        "{done:?}"
    );
    assert_eq!(bench.text("mine"), "mine");
    fs::remove_file(bench.path("figures/s/results.csv")).unwrap();
    bench.expect(0, &["run", "s.json"]);
    assert_eq!(bench.text("mine"), "mine");
    for name in files {
        assert_eq!(bench.text(&format!("figures/s/{name}")), "mine");
    }
    assert!(bench.text("figures/s/results.csv").starts_with("case,"));
    // A link instead of the lock would open another file.
    let lock = bench.path("figures/s/store/.lock");
    fs::remove_file(&lock).unwrap();
    symlink(bench.path("mine"), &lock).unwrap();
    let done = bench.expect(1, &["run", "s.json"]);
    assert_eq!(
        done.err,
        "slipgap: cannot lock figures/s/store/.lock: it is not a file; remove it\n"
    );
    assert_eq!(bench.text("mine"), "mine");
}

#[cfg(unix)]
#[test]
fn a_pipe_in_place_of_a_result_does_not_stop_a_run() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    bench.expect(0, &["run", "s.json"]);
    let everything = bench.everything("figures/s");
    let entry = everything.iter().find(|name| name.ends_with(".parquet"));
    let part = entry.unwrap().rsplit('/').next().unwrap();
    for name in ["manifest.json", &format!("store/{part}")] {
        let path = bench.path(&format!("figures/s/{name}"));
        fs::remove_file(&path).unwrap();
        let made = Command::new("mkfifo").arg(&path).status().unwrap();
        assert!(made.success());
        let mut command = bench.command();
        command.args(["run", "s.json"]).stderr(Stdio::null());
        let mut child = command.stdout(Stdio::null()).spawn().unwrap();
        // A run takes a fraction of a second; a reader of the pipe waits for ever.
        let mut waits = 0..3000;
        while child.try_wait().unwrap().is_none() && waits.next().is_some() {
            sleep(Duration::from_millis(20));
        }
        let ended = child.try_wait().unwrap();
        child.kill().unwrap();
        assert_eq!(ended.and_then(|ended| ended.code()), Some(1), "{name}");
        fs::remove_file(&path).unwrap();
    }
}

#[cfg(unix)]
#[test]
fn more_studies_than_open_files_allowed() {
    let bench = Bench::new();
    for study in 0..60 {
        bench.file(&format!("studies/{study}.json"), friction(ONE, ""));
    }
    let run = format!(
        "ulimit -n 40; exec {} run --jobs 1",
        env!("CARGO_BIN_EXE_slipgap-tested")
    );
    let done = Command::new("bash")
        .args(["-c", &run])
        .current_dir(bench.path(""))
        .output()
        .unwrap();
    assert!(done.status.success(), "{done:?}");
    assert_eq!(bench.tree("figures").len(), 2 * 60);
}

#[test]
fn all_unsolved_cases_are_in_the_table_and_the_first_are_reported() {
    let bench = Bench::new();
    // With steps of 10^300 and more the velocity exceeds the largest double.
    let parameters = r#""law": "displacement-control", "alpha": 1, "dT": {"linspace": [1e300, 2e300, 25]}, "duration": "10*dT""#;
    bench.file("s.json", friction(parameters, ""));
    let done = bench.expect(3, &["run", "s.json"]);
    let named = done
        .err
        .lines()
        .filter(|line| line.contains("could not be solved: "));
    assert_eq!(named.count(), 20);
    assert!(
        done.err
            .ends_with("s.json: 5 more cases could not be solved\n"),
        "{}",
        done.err
    );
    let table = bench.text("figures/s/failures.csv");
    let numbers: Vec<&str> = table
        .lines()
        .skip(1)
        .filter_map(|row| row.split(',').next())
        .collect();
    let expected: Vec<String> = (0..25).map(|case| case.to_string()).collect();
    assert_eq!(numbers, expected);
    let checked = bench.expect(3, &["check", "s.json"]);
    assert!(
        checked
            .err
            .contains("s.json: 5 more cases could not be solved\n"),
        "{}",
        checked.err
    );
}
