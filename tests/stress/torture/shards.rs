//! Shards of one study: killed, twice at once, in any order, over the parts of a former study. The merge gives the bytes of a run.

use crate::{Bench, Random, Tree, differences, long};
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Cases in nine chunks of 16 384 combinations, and a design: more parts than shards, with little work.
fn study(last: &str) -> String {
    format!(
        r#"{{ "problem": "friction-oscillator", "blocks": [
  {{ "parameters": {{ "law": "velocity-control", "beta": {{"range": [0.1, {last}, 0.1]}}, "dT": "pi/80", "duration": "8*pi",
      "x0": {{"linspace": [1, 20, 4000]}} }}, "when": "x0 > 19.99" }},
  {{ "parameters": {{ "law": "displacement-control", "alpha": {{"uniform": [0.1, 1]}}, "x0": {{"uniform": [8, 20]}},
      "dT": "pi/8", "duration": "8*pi" }}, "design": {{"kind": "saltelli", "n": 4, "seed": 1}} }}],
  "figures": [{{ "name": "f", "kind": "metric", "x": "beta", "y": "rms_error",
      "where": {{"law": "velocity-control", "x0": 20}} }}] }}"#
    )
}

const OUT: &str = "figures";

/// A folder with the study, and the results of an undisturbed run of it.
struct Whole {
    bench: Bench,
    wanted: Tree,
}

impl Whole {
    fn new() -> Whole {
        let bench = Bench::new();
        bench.file("s.json", study("3.2"));
        assert_eq!(bench.run(&["run", "s.json"]).code, Some(0));
        let wanted = bench.tree(OUT);
        let parts = wanted.keys().filter(|name| name.ends_with(".parquet"));
        assert!(parts.count() > 6, "{:?}", wanted.keys());
        Whole { bench, wanted }
    }

    /// Starts a shard.
    fn start(&self, index: u64, of: u64) -> Child {
        let mut command = self.bench.command();
        let shard = format!("{index}/{of}");
        command
            .args(["run", "s.json", "--jobs", "1", "--shard", &shard])
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        command.spawn().unwrap()
    }

    /// Asserts that every part that a shard of this study has saved is complete.
    fn complete_parts(&self, former: &Tree, what: &str) {
        for (name, bytes) in self.bench.tree(OUT) {
            if name.ends_with(".parquet") {
                let known = [&self.wanted, former].map(|tree| tree.get(&name) == Some(&bytes));
                assert!(known.contains(&true), "{what}: {name} is not complete");
            }
        }
    }

    /// Asserts that the merge gives the files of an undisturbed run.
    fn merged(&self, of: u64, what: &str) {
        let done = self
            .bench
            .run(&["merge", "s.json", "--shards", &of.to_string()]);
        assert_eq!(done.code, Some(0), "{what}: {done:?}");
        let differ = differences(&self.bench.tree(OUT), &self.wanted);
        assert_eq!(differ, "", "{what}");
    }
}

#[test]
fn shards_killed_and_twice_at_once() {
    killed(100);
}

#[test]
#[ignore = "minutes; make torture"]
fn shards_killed_and_twice_at_once_for_long() {
    killed(long(3000));
}

/// Rounds until so many processes were killed.
fn killed(kills: u64) {
    let whole = Whole::new();
    let former = {
        // The parts of an earlier version of the study: outdated ones, and one that is the same.
        let bench = Bench::new();
        bench.file("s.json", study("1.1").replace("pi/8\"", "pi/7\""));
        assert_eq!(bench.run(&["run", "s.json"]).code, Some(0));
        bench.tree(OUT)
    };
    let empty = Tree::new();
    let mut random = Random(1);
    let (mut killed, mut round) = (0, 0);
    while killed < kills {
        round += 1;
        let of = 1 + random.below(5);
        let what = format!("round {round}, {of} shards");
        let begun = if round % 3 == 0 { &former } else { &empty };
        whole.bench.put(OUT, begun);
        // The time of a kill depends on the machine. The assertions do not.
        let begin = Instant::now();
        let _ = whole.start(of, of).wait();
        let lasts = begin.elapsed().as_micros() as u64;
        for _ in 0..3 {
            for _ in 0..of {
                let index = 1 + random.below(of);
                let mut pair = [whole.start(index, of), whole.start(index, of)];
                for child in &mut pair {
                    sleep(Duration::from_micros(random.below(lasts)));
                    child.kill().unwrap();
                    killed += u64::from(child.wait().unwrap().code().is_none());
                }
            }
            whole.complete_parts(&former, &what);
        }
        // Every shard twice at once, two shards at a time, in another order each round.
        let shift = random.below(of);
        for at in (0..of).step_by(2) {
            let indices = (at..of.min(at + 2)).map(|i| 1 + (i + shift) % of);
            let pairs: Vec<Child> = indices
                .flat_map(|index| [whole.start(index, of), whole.start(index, of)])
                .collect();
            for mut child in pairs {
                assert_eq!(child.wait().unwrap().code(), Some(0), "{what}");
            }
        }
        whole.merged(of, &what);
    }
    eprintln!("{killed} shards killed in {round} rounds");
}

#[test]
fn many_shards_begin_at_once_in_a_new_folder() {
    let whole = Whole::new();
    for _ in 0..2 {
        whole.bench.put(OUT, &Tree::new());
        // More shards than parts.
        let mut shards: Vec<Child> = (1..=40).map(|index| whole.start(index, 40)).collect();
        for shard in &mut shards {
            assert_eq!(shard.wait().unwrap().code(), Some(0));
        }
        // Nothing but parts.
        let other = |name: &String| {
            !["s/", "s/store/"].contains(&name.as_str()) && !name.ends_with(".parquet")
        };
        assert_eq!(whole.bench.tree(OUT).keys().find(|name| other(name)), None);
        whole.merged(40, "40 shards at once");
    }
}
