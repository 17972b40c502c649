//! Results in an object store have the same bytes as in a folder. `make s3-test` installs a server and runs this.
#![cfg(unix)]

#[path = "../../common/bench.rs"]
mod bench;
mod errors;
mod server;
#[allow(dead_code)]
#[path = "../torture/tree.rs"]
mod tree;
mod verbs;

pub(crate) use bench::{Bench, Done};
use server::{Port, SERVER};
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};
use tree::{Tree, differences};

/// Twelve parts of some tenths of a second.
const LONG: &str = r#"{ "problem": "friction-oscillator", "parameters": {
    "law": "velocity-control", "beta": {"range": [0.1, 4.8, 0.1]}, "dT": "pi/125000", "duration": "8*pi",
    "x0": {"linspace": [1, 20, 4000]} }, "when": "x0 > 19.996",
  "figures": [{ "name": "f", "kind": "metric", "x": "beta", "y": "rms_error" }] }"#;

/// Few cases; the figure has this name, and there are so many values of alpha.
pub(crate) fn short(figure: &str, alphas: usize) -> String {
    format!(
        r#"{{ "problem": "friction-oscillator", "parameters": {{ "law": "displacement-control", "dT": "pi/10", "duration": "8*pi",
        "alpha": {{"linspace": [0.1, 5, {alphas}]}} }}, "figures": [{{ "name": "{figure}", "kind": "history" }}] }}"#
    )
}

/// Makes the bucket, and a folder to work in.
pub(crate) fn begin(bucket: &str) -> Bench {
    let bench = Bench::new();
    SERVER.client(&bench, &["make", bucket]);
    bench
}

/// All objects of a bucket, as a folder with them has them.
fn objects(bench: &Bench, bucket: &str) -> Tree {
    let _ = std::fs::remove_dir_all(bench.path("got"));
    SERVER.client(bench, &["get", bucket, "got"]);
    bench.tree("got")
}

/// What a folder has, except the lock of the store.
fn folder(bench: &Bench, name: &str) -> Tree {
    let mut tree = bench.tree(name);
    tree.retain(|name, _| !name.ends_with("store/.lock"));
    tree
}

/// Number of parts in a bucket.
fn parts(tree: &Tree) -> usize {
    tree.keys()
        .filter(|name| name.ends_with(".parquet"))
        .count()
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn a_run_writes_the_same_bytes_and_the_next_one_removes_what_is_outdated() {
    let bench = begin("plain");
    // All of these characters are in the keys as they are.
    let name = "a folder/100 % of ü~[x]+&=";
    let out = format!("s3://plain/{name}");
    bench.file("own/s/notes.txt", "mine");
    for folder in [format!("out/{name}"), format!("put/{name}")] {
        bench.file(&format!("{folder}/s/notes.txt"), "mine");
        bench.file(&format!("{folder}/s/histories/77.csv"), "mine");
    }
    SERVER.client(&bench, &["put", "plain", "put"]);
    let local = format!("out/{name}");
    let both = |study: String, more: &[&str]| {
        bench.file("s.json", study);
        let args = |out| [&["run", "s.json", "--out", out], more].concat();
        let done = SERVER.run(&bench, Port::Good, 0, &args(&out));
        assert_eq!(done.out, format!("{out}/s\n"));
        let wanted = bench.run(&args(&local));
        // The last line has the time.
        let cases = |done: &Done| done.err.split(" in ").next().map(String::from);
        assert_eq!(cases(&done), cases(&wanted));
        let found = objects(&bench, "plain");
        assert_eq!(differences(&found, &folder(&bench, "out")), "");
        found
    };
    let first = both(short("one", 5), &["--histories"]);
    assert!(first.contains_key(&format!("{name}/s/histories/4.csv")));
    // All cases are in the store; histories are not of this run any more.
    both(short("one", 5), &[]);
    let changed = both(short("two", 3), &[]);
    assert!(!changed.keys().any(|name| name.contains("one.png")));
    assert!(changed.contains_key(&format!("{name}/s/histories/77.csv")));
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn killed_shards_keep_their_parts_and_the_merge_writes_the_same_bytes() {
    let bench = begin("shards");
    bench.file("s.json", LONG);
    let out = ["--out", "s3://shards/x"];
    let args = |shard| {
        [
            &["run", "s.json", "--jobs", "1", "--shard", shard][..],
            &out,
        ]
        .concat()
    };
    let run = |shard, port, code| SERVER.run(&bench, port, code, &args(shard));
    let compare = || {
        let plain = bench.run(&["run", "s.json", "--out", "out/x"]);
        assert_eq!(plain.code, Some(0));
        let found = objects(&bench, "shards");
        assert_eq!(differences(&found, &folder(&bench, "out")), "");
    };
    let merge = [&["merge", "s.json", "--shards", "2"][..], &out].concat();
    // Both at once; the first is killed when a part of it is there.
    let mut command = SERVER.slipgap(&bench, Port::Good, &args("1/2"));
    let mut killed = command.stderr(Stdio::null()).spawn().unwrap();
    let begun = Instant::now();
    while parts(&objects(&bench, "shards")) == 0 {
        assert!(begun.elapsed() < Duration::from_secs(120));
        sleep(Duration::from_millis(50));
    }
    killed.kill().unwrap();
    killed.wait().unwrap();
    let kept = parts(&objects(&bench, "shards"));
    assert!((1..6).contains(&kept), "{kept} parts");
    let missing = SERVER.run(&bench, Port::Good, 4, &merge);
    assert!(
        missing.err.contains("run shards 1,2 of 2 again"),
        "{missing:?}"
    );
    assert_eq!(
        objects(&bench, "shards").len(),
        kept + 3,
        "only parts and their folders"
    );

    std::thread::scope(|scope| {
        let second = scope.spawn(|| run("2/2", Port::Failing, 0));
        let first = run("1/2", Port::Good, 0);
        let line = format!(
            "{} of 6 parts computed, {kept} in the store already",
            6 - kept
        );
        assert_eq!(first.err, format!("s, shard 1/2: {line}\n"));
        let line = second.join().unwrap().err;
        assert_eq!(line, "s, shard 2/2: 6 of 6 parts computed\n");
    });
    SERVER.run(&bench, Port::Good, 0, &merge);
    compare();

    // The study has changed: its parts replace the former ones, which the merge removes.
    bench.file("s.json", LONG.replace("pi/125000", "pi/100000"));
    run("1/2", Port::Good, 0);
    let outdated = SERVER.run(&bench, Port::Good, 4, &merge);
    assert!(
        outdated.err.contains("run shards 2 of 2 again"),
        "{outdated:?}"
    );
    run("2/2", Port::Good, 0);
    SERVER.run(&bench, Port::Good, 0, &merge);
    compare();
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn more_than_a_thousand_parts_are_listed() {
    let bench = begin("many");
    bench.file("s.json", short("f", 3));
    // A listing has 1000 names. These parts are of another study and behind a thousand of them, and are removed.
    for number in 0..1100 {
        let name = format!("part-{number:012}-{number:032x}.parquet");
        bench.file(&format!("put/s/store/{name}"), "damaged");
    }
    SERVER.client(&bench, &["put", "many", "put"]);
    assert_eq!(parts(&objects(&bench, "many")), 1100);
    SERVER.run(
        &bench,
        Port::Good,
        0,
        &["run", "s.json", "--out", "s3://many"],
    );
    bench.run(&["run", "s.json", "--out", "out"]);
    assert_eq!(
        differences(&objects(&bench, "many"), &folder(&bench, "out")),
        ""
    );
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn requests_that_fail_are_repeated_also_amid_a_large_table() {
    let bench = begin("failing");
    // 40 MB of results.csv, uploaded in pieces of 16 MiB.
    let study = r#"{ "problem": "friction-oscillator", "parameters": { "law": "displacement-control", "dT": 0.5, "duration": 3,
        "alpha": {"linspace": [0.1, 5, 700]}, "x0": {"linspace": [1, 20, 400]} } }"#;
    bench.file("s.json", study);
    let args = |out| ["run", "s.json", "--format", "csv", "--out", out];
    SERVER.run(&bench, Port::Failing, 0, &args("s3://failing"));
    assert_eq!(bench.run(&args("out")).code, Some(0));
    let wanted = folder(&bench, "out");
    assert!(wanted["s/results.csv"].len() > 33 << 20, "three pieces");
    assert_eq!(differences(&objects(&bench, "failing"), &wanted), "");
    assert_eq!(SERVER.client(&bench, &["unfinished", "failing"]), "");
}
