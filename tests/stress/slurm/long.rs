//! A hundred shards of 10^7 cases on the virtual nodes, of which many are killed: nothing is lost. `make slurm-long` runs it; it takes
//! ten minutes on two cores, and 2 GB of disk.

use crate::cluster::Cluster;
use crate::{Bench, Done, field, started, submitted};
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// 10^7 cases of 200 steps.
const STUDY: &str = r#"{ "problem": "friction-oscillator", "parameters": {
    "law": "velocity-control", "beta": {"linspace": [0.1, 10, 1000]}, "dT": "pi/25", "duration": "8*pi",
    "x0": {"linspace": [1, 20, 10000]} } }"#;

const CASES: u64 = 10_000_000;

const SHARDS: u32 = 100;

/// Rounds of kills; after them the shards run undisturbed.
const ROUNDS: usize = 4;

/// Time between two kills.
const BETWEEN: Duration = Duration::from_millis(1500);

/// Of Knuth's linear congruential generator.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % most
    }
}

/// The shards that run now: the process, and the number of the shard.
fn running(study: &Path) -> Vec<(String, u32)> {
    let study = study.display().to_string();
    let mut found = Vec::new();
    for entry in fs::read_dir("/proc").unwrap().flatten() {
        let line = fs::read_to_string(entry.path().join("cmdline")).unwrap_or_default();
        let words: Vec<&str> = line.split('\0').collect();
        if !words[0].ends_with("slipgap") || !words.contains(&&*study) {
            continue;
        }
        let at = words.iter().position(|word| *word == "--shard");
        let shard = at.and_then(|at| words.get(at + 1)?.split_once('/'));
        if let Some((index, _)) = shard {
            let pid = entry.file_name().to_string_lossy().into_owned();
            found.push((pid, index.parse().unwrap()));
        }
    }
    found
}

/// Runs the program.
fn run(work: &Bench, words: &[&str]) -> Done {
    let done: Done = work.command().args(words).output().unwrap().into();
    assert_eq!(done.code, Some(0), "{done:?}");
    done
}

fn status(work: &Bench) -> Json {
    let done = run(
        work,
        &[
            "status", "s.json", "--out", "out", "--shards", "100", "--json",
        ],
    );
    serde_json::from_str(&done.out).unwrap()
}

/// The files of a folder with their sizes.
fn files(root: &Path) -> BTreeMap<String, u64> {
    let entries = walkdir::WalkDir::new(root).into_iter().map(Result::unwrap);
    let files = entries.filter(|entry| entry.file_type().is_file());
    let named = files.map(|entry| {
        let name = entry
            .path()
            .strip_prefix(root)
            .unwrap()
            .display()
            .to_string();
        (name, entry.metadata().unwrap().len())
    });
    named.collect()
}

fn ended(cluster: &Cluster, job: &str) -> Option<String> {
    let shown = cluster.show(job);
    let state = field(&shown, "JobState");
    let ended = ["COMPLETED", "FAILED", "CANCELLED", "TIMEOUT"].contains(&&*state);
    ended.then(|| field(&shown, "ExitCode"))
}

#[test]
#[ignore = "ten minutes; make slurm-long"]
fn ten_million_cases_in_a_hundred_shards_with_kills() {
    let base = Bench::new();
    let Some(cluster) = started(&base) else {
        return;
    };
    let work = Bench::new();
    work.file("s.json", STUDY);
    let begin = Instant::now();
    run(&work, &["run", "s.json", "--out", "whole"]);
    eprintln!("one plain run: {:.0} s", begin.elapsed().as_secs_f64());

    let (mut kills, mut requeues, mut last, mut round) = (0, 0, 0, 0);
    let mut random = Random(1);
    let mut again: Option<String> = None;
    let begin = Instant::now();
    let merged = loop {
        round += 1;
        let made = run(
            &work,
            &[
                "sbatch",
                "s.json",
                "--shards",
                "100",
                "--out",
                "out",
                "--requeue",
                "--time",
                "02:00:00",
            ],
        );
        let submission = submitted(&cluster, &work, &made.out, &[], again.as_deref());
        let merge = submission.merge.clone();
        let mut turn = 0;
        let code = loop {
            if let Some(code) = ended(&cluster, &merge) {
                break code;
            }
            sleep(BETWEEN);
            if round > ROUNDS {
                continue;
            }
            turn += 1;
            let shards = running(&work.path("s.json"));
            if shards.is_empty() {
                continue;
            }
            let (pid, shard) = &shards[random.below(shards.len())];
            if turn % 5 == 0 {
                cluster.out("scontrol", &["requeue", &submission.task(*shard)]);
                requeues += 1;
            } else if cluster.out("bash", &["-c", &format!("kill -KILL {pid} && echo done")])
                == "done\n"
            {
                kills += 1;
            }
            // What is done stays done.
            if turn % 4 == 0 {
                let found = status(&work);
                let done = found["done"].as_u64().unwrap();
                assert!(
                    (last..=CASES).contains(&done) && found["cases"] == CASES,
                    "{last} {found}"
                );
                last = done;
            }
        };
        let log = fs::read_to_string(work.path(&format!("slurm-{merge}.out"))).unwrap_or_default();
        eprintln!(
            "round {round}: {kills} kills, {requeues} requeued, {last} cases; merge {code}: {}",
            log.trim()
        );
        if code == "0:0" {
            break merge;
        }
        assert_eq!(code, "4:0", "{log}\n{}", cluster.logs());
        let shards = log.rsplit_once("run shards ").unwrap().1;
        again = Some(shards.split_once(" of ").unwrap().0.to_owned());
        assert!(round < 20, "the rounds do not end");
    };
    let wall = begin.elapsed().as_secs_f64();
    let shown = cluster.show(&merged);
    let found = status(&work);
    assert_eq!(
        (&found["state"], &found["done"], &found["failed"]),
        (&"done".into(), &CASES.into(), &0.into())
    );
    let (in_shards, whole) = (files(&work.path("out")), files(&work.path("whole")));
    assert_eq!(in_shards, whole);
    for name in in_shards.keys() {
        let same = fs::read(work.path("out").join(name)).unwrap()
            == fs::read(work.path("whole").join(name)).unwrap();
        assert!(same, "other bytes: {name}");
    }
    let bytes: u64 = in_shards.values().sum();
    let lost = CASES - found["done"].as_u64().unwrap();
    eprintln!(
        "{SHARDS} shards, {CASES} cases: {round} submissions, {kills} kills, {requeues} requeued, {wall:.0} s; {lost} cases lost; {} files, {bytes} bytes, all the same; merge from {} to {}",
        in_shards.len(),
        field(&shown, "StartTime"),
        field(&shown, "EndTime"),
    );
}
