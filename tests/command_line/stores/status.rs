//! How far shards and runs are, compared with the parts that are on disk.

use crate::{Bench, ONE, friction};
use parquet::file::reader::{FileReader, SerializedFileReader};
use serde_json::Value as Json;
use std::fs::{self, File};
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

/// Cases in 2.5 chunks for each beta of ten; a part takes some tenths of a second in the build of the tests.
fn slow(last: &str) -> String {
    let parameters = format!(
        r#""law": "velocity-control", "beta": {{"range": [0.1, {last}, 0.1]}}, "dT": "pi/10000", "duration": "8*pi",
        "x0": {{"linspace": [1, 20, 4000]}}"#
    );
    friction(&parameters, r#", "when": "x0 > 19.9""#)
}

/// The status of the study, from the one line of JSON.
#[track_caller]
fn status(bench: &Bench, more: &[&str]) -> Json {
    let words = [&["status", "s.json", "--json"][..], more].concat();
    let done = bench.expect(0, &words);
    assert_eq!(done.out.lines().count(), 1, "{done:?}");
    serde_json::from_str(&done.out).unwrap()
}

/// The numbers of cases of the parts on disk, by their starts.
fn rows_on_disk(bench: &Bench) -> Vec<(u64, u64)> {
    let names = bench.everything("figures").into_iter();
    let parts = names.filter(|name| name.ends_with(".parquet"));
    let rows = |name: String| {
        let start = name.split('-').nth(1).unwrap().parse().unwrap();
        let file = File::open(bench.path("figures").join(&name)).unwrap();
        let metadata = SerializedFileReader::new(file).unwrap();
        (start, metadata.metadata().file_metadata().num_rows() as u64)
    };
    parts.map(rows).collect()
}

fn start(bench: &Bench, more: &[&str]) -> Child {
    let mut command = bench.command();
    command
        .args(["run", "s.json", "--jobs", "1"])
        .args(more)
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    command.spawn().unwrap()
}

/// Waits until a file of the store is there.
#[track_caller]
fn wait_for(bench: &Bench, file: &str) {
    let begin = Instant::now();
    while !bench.path("figures/s/store").join(file).exists() {
        assert!(begin.elapsed().as_secs() < 60, "no {file}");
        sleep(Duration::from_millis(20));
    }
}

#[test]
fn cases_done_are_those_of_the_parts_on_disk() {
    let bench = Bench::new();
    bench.file("s.json", slow("4.8").replace("pi/10000", "pi/10"));
    let before = status(&bench, &["--shards", "3"]);
    assert_eq!(before["state"], "not begun");
    assert_eq!(
        (&before["done"], &before["running"]),
        (&0.into(), &0.into())
    );
    assert!(before["seconds_since_last_sign"].is_null(), "{before}");
    // Nothing is written.
    assert_eq!(bench.everything("."), ["s.json"]);
    bench.expect(0, &["run", "s.json", "--shard", "2/3"]);
    let disk = rows_on_disk(&bench);
    // Twelve chunks: a shard has four of them.
    assert_eq!(disk.len(), 4);
    let rows: u64 = disk.iter().map(|part| part.1).sum();
    let found = status(&bench, &["--shards", "3"]);
    assert_eq!(
        (&found["state"], &found["done"]),
        (&"not running".into(), &rows.into())
    );
    let shards = found["shards"].as_array().unwrap();
    let states: Vec<&str> = shards
        .iter()
        .map(|s| s["state"].as_str().unwrap())
        .collect();
    assert_eq!(states, ["not begun", "done", "not begun"]);
    assert_eq!(shards[1]["shard"], "2/3");
    assert_eq!(
        (&shards[1]["cases"], &shards[1]["done"]),
        (&rows.into(), &rows.into())
    );
    let sum = |key: &str| -> u64 { shards.iter().map(|s| s[key].as_u64().unwrap()).sum() };
    assert_eq!(
        (found["cases"].as_u64(), found["done"].as_u64()),
        (Some(sum("cases")), Some(sum("done")))
    );
    // A part that is half written: its end, with the key, is not there.
    let part = bench.everything("figures").pop().unwrap();
    let path = bench.path("figures").join(&part);
    let bytes = fs::read(&path).unwrap();
    fs::write(&path, &bytes[..bytes.len() / 2]).unwrap();
    let half = status(&bench, &["--shards", "3"]);
    assert_eq!(half["done"], rows - disk[3].1);
    fs::write(&path, bytes).unwrap();
    // The whole table, in which the time of the last part is not always the same.
    let text = bench.expect(0, &["status", "s.json", "--shards", "3"]).out;
    let lines: Vec<&str> = text.lines().collect();
    let words = |line: usize| lines[line].split_whitespace().collect::<Vec<_>>();
    assert_eq!(
        words(0),
        [
            "study", "shard", "state", "cases", "done", "failed", "rate", "left"
        ]
    );
    let rows = rows.to_string();
    assert_eq!(words(2), ["s", "2/3", "done", &rows, &rows, "0", "-", "-"]);
    assert_eq!(words(1)[..4], ["s", "1/3", "not", "begun"]);
    assert_eq!(words(4)[..5], ["s", "all", "not", "running", "for"]);
    // Another version of the study has no part of this one.
    bench.file("s.json", slow("4.8").replace("pi/10000", "pi/9"));
    let done = bench.expect(0, &["status", "s.json", "--json"]);
    assert_eq!(
        done.err,
        "s.json: 4 parts of another version: different parameters\n"
    );
    assert!(
        done.out.contains(r#""done":0,"#) && done.out.contains(r#""outdated_parts":4"#),
        "{done:?}"
    );
}

#[test]
fn a_shard_runs_until_it_is_killed_and_again_until_it_is_done() {
    let bench = Bench::new();
    bench.file("s.json", slow("4.8"));
    let mut child = start(&bench, &["--shard", "1/2"]);
    wait_for(&bench, ".running-1-of-2");
    let begin = Instant::now();
    let found = loop {
        let before: u64 = rows_on_disk(&bench).iter().map(|part| part.1).sum();
        let found = status(&bench, &[]);
        let after: u64 = rows_on_disk(&bench).iter().map(|part| part.1).sum();
        let done = found["done"].as_u64().unwrap();
        assert!((before..=after).contains(&done), "{before} {found} {after}");
        if done > 0 && !found["cases_per_second"].is_null() {
            break found;
        }
        assert!(begin.elapsed().as_secs() < 60, "{found}");
        sleep(Duration::from_millis(100));
    };
    assert_eq!(
        (&found["state"], &found["running"]),
        (&"running".into(), &1.into())
    );
    let [first, second] = &found["shards"].as_array().unwrap()[..] else {
        panic!("two shards: {found}");
    };
    // The number of shards is in the sign.
    assert_eq!(
        (&first["state"], &second["state"]),
        (&"running".into(), &"not begun".into())
    );
    // All cases have the same number of steps, so that the time left is that of the cases left.
    let number = |object: &Json, key: &str| object[key].as_f64().unwrap();
    let cases = number(first, "cases") - number(first, "done");
    let seconds = cases / number(first, "cases_per_second");
    assert!(
        (number(first, "seconds_left") / seconds - 1.0).abs() < 1e-9,
        "{found}"
    );
    assert!(number(first, "seconds_left") < number(&found, "seconds_left"));
    assert!(second["cases_per_second"].is_null() && second["seconds_left"].is_null());

    child.kill().unwrap();
    child.wait().unwrap();
    // The sign remains, and gets old, as the parts do.
    assert!(bench.path("figures/s/store/.running-1-of-2").exists());
    for name in bench.everything("figures") {
        let file = File::options()
            .write(true)
            .open(bench.path("figures").join(name));
        let time = SystemTime::now() - Duration::from_secs(200);
        file.unwrap().set_modified(time).unwrap();
    }
    let found = status(&bench, &[]);
    assert_eq!(
        (&found["state"], &found["running"]),
        (&"not running".into(), &0.into())
    );
    let quiet = number(&found["shards"][0], "seconds_since_last_sign");
    assert!((200.0..230.0).contains(&quiet), "{found}");
    assert!(found["cases_per_second"].is_null() && found["seconds_left"].is_null());
    let text = bench.expect(0, &["status", "s.json"]).out;
    assert!(text.contains("not running for 3 min"), "{text}");
    // A clock of another machine that is an hour ahead, and a sign that is half written: it is named, and no other age changes.
    fs::write(bench.path("figures/s/store/.running-2-of-2"), "{\"sec").unwrap();
    let sign_ahead = |seconds: u64| {
        let file = File::options()
            .write(true)
            .open(bench.path("figures/s/store/.running-2-of-2"));
        let time = SystemTime::now() + Duration::from_secs(seconds);
        file.unwrap().set_modified(time).unwrap();
    };
    sign_ahead(3600);
    let done = bench.expect(0, &["status", "s.json", "--json"]);
    let named = "the last sign of shard 2/2 is 60 min ahead of the clock of this machine";
    assert!(done.err.contains(named), "{done:?}");
    let found: Json = serde_json::from_str(&done.out).unwrap();
    assert_eq!(
        (&found["shards"][0]["state"], &found["shards"][1]["state"]),
        (&"not running".into(), &"not begun".into())
    );
    let quiet = number(&found, "seconds_since_last_sign");
    assert!((200.0..260.0).contains(&quiet), "{found}");
    // Clocks may differ by 20 s.
    sign_ahead(20);
    let found = status(&bench, &[]);
    assert_eq!(
        (&found["shards"][0]["state"], &found["shards"][1]["state"]),
        (&"not running".into(), &"running".into())
    );
    assert!(found["cases_per_second"].is_null());

    for shard in ["1/2", "2/2"] {
        bench.expect(0, &["run", "s.json", "--shard", shard]);
    }
    let found = status(&bench, &["--shards", "2"]);
    assert_eq!(
        (&found["state"], &found["done"]),
        (&"done".into(), &found["cases"])
    );
    // A sign that a killed process left is removed by the merge.
    fs::write(bench.path("figures/s/store/.running-7-of-99999"), "").unwrap();
    let shown = bench.expect(0, &["status", "s.json"]).out;
    assert!(shown.lines().count() < 20, "{shown}");
    bench.expect(0, &["merge", "s.json"]);
    let left = bench.everything("figures").into_iter();
    assert_eq!(left.filter(|name| name.contains("running")).count(), 0);
}

#[test]
fn a_whole_run_is_one_process() {
    let bench = Bench::new();
    bench.file("s.json", slow("9.6"));
    let mut child = start(&bench, &[]);
    wait_for(&bench, ".running");
    let found = status(&bench, &[]);
    assert_eq!(
        (&found["state"], &found["running"]),
        (&"running".into(), &1.into())
    );
    assert_eq!(found["shards"].as_array().map(Vec::len), Some(0));
    let text = bench.expect(0, &["status", "s.json"]).out;
    assert!(
        text.lines().count() == 2 && text.contains("1 running"),
        "{text}"
    );
    // Ctrl-C removes the sign.
    if cfg!(unix) {
        let id = child.id().to_string();
        let sent = std::process::Command::new("kill")
            .args(["-INT", &id])
            .status();
        assert!(sent.unwrap().success());
        assert_eq!(child.wait().unwrap().code(), Some(130));
        let left = bench.everything("figures").into_iter();
        assert_eq!(left.filter(|name| name.contains("running")).count(), 0);
    } else {
        child.kill().unwrap();
        child.wait().unwrap();
    }
}

#[test]
fn cases_without_a_solution_are_done_and_failed() {
    let bench = Bench::new();
    // A step of 10^300 takes the velocity beyond the largest double.
    let parameters = r#""law": "displacement-control", "alpha": 1, "dT": [0.1, 1e300, 2e300], "duration": "10*dT""#;
    bench.file("s.json", friction(parameters, ""));
    bench.file("t.json", friction(ONE, ""));
    bench.expect(3, &["run", "s.json"]);
    let failures = bench.text("figures/s/failures.csv").lines().count() as u64 - 1;
    let found = status(&bench, &[]);
    assert_eq!(
        (&found["done"], &found["failed"]),
        (&3.into(), &failures.into())
    );
    assert_eq!(failures, 2);
    // A line for each study.
    let done = bench.expect(0, &["status", "s.json", "t.json", "--json"]);
    assert_eq!(done.out.lines().count(), 2);
}

#[test]
fn mistakes_have_the_usual_messages() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    bench.file(
        "bad.json",
        friction(ONE, "").replace("\"beta\"", "\"betta\""),
    );
    for shards in ["0", "x", "100001"] {
        let done = bench.expect(2, &["status", "s.json", "--shards", shards]);
        assert!(
            done.err.contains("must be a whole number from 1 to 100000"),
            "{done:?}"
        );
    }
    let done = bench.expect(2, &["status", "bad.json"]);
    assert!(done.err.starts_with("bad.json:1:"), "{done:?}");
    bench.expect(1, &["status", "none.json"]);
    // A store that is a file.
    bench.file("figures/s/store", "");
    let done = bench.expect(1, &["status", "s.json"]);
    assert!(done.err.contains("cannot read"), "{done:?}");
}
