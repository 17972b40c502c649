//! The script of `slipgap sbatch` on a cluster of real Slurm daemons. `make slurm-test` runs it.
#![cfg(unix)]

mod cluster;
mod long;

#[path = "../../common/bench.rs"]
mod bench;
#[allow(dead_code)]
#[path = "../torture/tree.rs"]
mod tree;

pub(crate) use bench::{Bench, Done};
use cluster::{Cluster, wait};
use std::fs;
use std::path::PathBuf;
use tree::differences;

/// Cases of 10^6 steps in twelve chunks, two in each of six shards. A chunk takes some tenths of a second.
const STUDY: &str = r#"{ "problem": "friction-oscillator", "parameters": {
    "law": "velocity-control", "beta": {"range": [0.1, 4.8, 0.1]}, "dT": "pi/125000", "duration": "8*pi",
    "x0": {"linspace": [1, 20, 4000]} }, "when": "x0 > 19.996",
  "figures": [{ "name": "f", "kind": "metric", "x": "beta", "y": "rms_error" }] }"#;

/// A submission of the script.
struct Submission<'a> {
    cluster: &'a Cluster,
    array: String,
    merge: String,
}

impl Submission<'_> {
    /// The process that the shard's task has stopped, once it has.
    fn stopped(&self, marks: &Bench, shard: u32) -> String {
        let path = marks.path(&format!("shard-{shard}.pid"));
        let pid = wait(|| fs::read_to_string(&path).ok(), || self.cluster.logs());
        pid.trim().to_owned()
    }

    fn task(&self, shard: u32) -> String {
        format!("{}_{shard}", self.array)
    }

    /// Waits until the merge has ended; returns its exit code and what it wrote.
    fn merged(&self, work: &Bench) -> (String, String) {
        let ended = || {
            let shown = self.cluster.show(&self.merge);
            let state = field(&shown, "JobState");
            let ended = ["COMPLETED", "FAILED", "CANCELLED", "TIMEOUT"].contains(&&*state);
            ended.then(|| field(&shown, "ExitCode"))
        };
        let code = wait(ended, || self.cluster.logs());
        let log = work.path(&format!("slurm-{}.out", self.merge));
        (code, fs::read_to_string(log).unwrap_or_default())
    }
}

/// A value in the output of `scontrol show job`.
fn field(shown: &str, key: &str) -> String {
    let mut words = shown.split_whitespace();
    let value = words.find_map(|word| word.strip_prefix(key)?.strip_prefix('='));
    value.unwrap_or_default().to_owned()
}

/// Makes a script, submits it, and returns the numbers of its jobs.
fn submit<'a>(
    cluster: &'a Cluster,
    work: &Bench,
    marks: &Bench,
    shards: Option<&str>,
) -> Submission<'a> {
    let program = env!("CARGO_BIN_EXE_slipgap-tested");
    let wrapper = concat!(env!("SLIPGAP_ROOT"), "/tests/stress/slurm/shard.sh");
    let made = work.run(&[
        "sbatch",
        "s.json",
        "--shards",
        "6",
        "--out",
        "a folder",
        "--requeue",
        "--time",
        "00:30:00",
    ]);
    assert_eq!(made.code, Some(0), "{made:?}");
    let script = made.out.replace(
        &format!("slipgap='{program}'"),
        &format!("slipgap='{wrapper}'"),
    );
    assert_ne!(script, made.out);
    let marks = marks.path("").display().to_string();
    let variables = [("SLIPGAP", program), ("MARKS", &marks)];
    submitted(cluster, work, &script, &variables, shards)
}

/// Submits a script, with these variables and only these shards, and returns the numbers of its jobs.
fn submitted<'a>(
    cluster: &'a Cluster,
    work: &Bench,
    script: &str,
    variables: &[(&str, &str)],
    shards: Option<&str>,
) -> Submission<'a> {
    work.file("submit.sh", script);
    let mut command = cluster.command("bash");
    command
        .arg("submit.sh")
        .current_dir(work.path(""))
        .envs(variables.iter().copied());
    if let Some(shards) = shards {
        command.env("SHARDS", shards);
    }
    let done: Done = command.output().unwrap().into();
    assert_eq!(done.code, Some(0), "{done:?}");
    // "array 1: shards 1-6 of 6; then job 7: merge"
    let numbers: Vec<&str> = done
        .out
        .split(|c: char| !c.is_ascii_digit())
        .filter(|word| !word.is_empty())
        .collect();
    Submission {
        cluster,
        array: numbers[0].to_owned(),
        merge: numbers[numbers.len() - 1].to_owned(),
    }
}

/// The daemons in a folder; `None`, and a word why, without Slurm.
fn started(base: &Bench) -> Option<Cluster> {
    let cluster = Cluster::start(&base.path("cluster"));
    let said = |why: &_| eprintln!("no Slurm, so shards were not tested on it: {why}");
    cluster.inspect_err(said).ok()
}

#[test]
#[ignore = "starts the daemons of Slurm; make slurm-test"]
fn killed_requeued_preempted_and_cancelled_tasks_then_the_merge() {
    let base = Bench::new();
    let Some(cluster) = started(&base) else {
        return;
    };
    let (work, marks, whole) = (Bench::new(), Bench::new(), Bench::new());
    for bench in [&work, &whole] {
        bench.file("s.json", STUDY);
    }
    assert_eq!(
        whole.run(&["run", "s.json", "--out", "a folder"]).code,
        Some(0)
    );

    let first = submit(&cluster, &work, &marks, None);
    // Shard 2: its program is killed, as by a lack of memory.
    cluster.run(
        "bash",
        &["-c", &format!("kill -KILL {}", first.stopped(&marks, 2))],
    );
    // Shard 3: requeued by hand, as after the failure of a node.
    first.stopped(&marks, 3);
    cluster.run("scontrol", &["requeue", &first.task(3)]);
    // Shard 4: preempted by an urgent job on its node.
    first.stopped(&marks, 4);
    let node = field(&cluster.show(&first.task(4)), "NodeList");
    cluster.run(
        "sbatch",
        &[
            "--partition=urgent",
            "--nodelist",
            &node,
            "--output=/dev/null",
            "--wrap=true",
        ],
    );
    // Shard 5: cancelled.
    first.stopped(&marks, 5);
    cluster.run("scancel", &[&first.task(5)]);
    // Shard 6: its time is nearly over, and it requeues itself.
    first.stopped(&marks, 6);
    cluster.run("scancel", &["--signal=USR1", "--batch", &first.task(6)]);

    let (code, log) = first.merged(&work);
    let message = "s.json: 4 of 12 parts are missing (4 not there, 0 of another version); run shards 2,5 of 6 again\n";
    assert!(
        code == "4:0" && log.ends_with(message),
        "{code} {log}\n{}",
        cluster.logs()
    );
    for (shard, restarts) in [(1, "0"), (2, "0"), (3, "1"), (4, "1"), (5, "0"), (6, "1")] {
        let shown = cluster.show(&first.task(shard));
        assert_eq!(
            field(&shown, "Restarts"),
            restarts,
            "shard {shard}: {shown}"
        );
    }

    let second = submit(&cluster, &work, &marks, Some("2,5"));
    let (code, log) = second.merged(&work);
    assert_eq!(code, "0:0", "{log}\n{}", cluster.logs());
    let tree = |bench: &Bench| bench.tree("a folder");
    assert_eq!(differences(&tree(&work), &tree(&whole)), "");
    let logs: PathBuf = work.path(&format!("slurm-{}_2.out", second.array));
    let log = fs::read_to_string(logs).unwrap();
    assert_eq!(log, "s, shard 2/6: 2 of 2 parts computed\n");
}
