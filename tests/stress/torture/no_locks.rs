//! A file system without locks, as NFS or Lustre may be mounted: every call of `flock` fails.

use crate::{Bench, Done, differences, program};
use std::fs::{self, File};
use std::process::Command;
use std::time::{Duration, SystemTime};

/// Replaces the call of the C library.
const SHIM: &str = "
#include <errno.h>
int flock(int file, int operation) { (void)file; (void)operation; errno = NUMBER; return -1; }
";

/// ENOLCK, ENOSYS and EOPNOTSUPP of Linux.
const ERRORS: [&str; 3] = ["37", "38", "95"];

const STUDY: &str = r#"{ "problem": "friction-oscillator", "parameters": { "law": "velocity-control",
  "beta": {"range": [0.1, 1, 0.1]}, "dT": "pi/8", "duration": "8*pi", "x0": {"linspace": [1, 20, 4000]} },
  "when": "x0 > 19.99" }"#;

/// The program without locks, in a folder.
struct Without {
    bench: Bench,
    shim: String,
}

impl Without {
    /// `None` with a message if the machine cannot replace the call.
    fn new(number: &str) -> Option<Without> {
        let compiler = program("cc").filter(|_| cfg!(target_os = "linux"));
        let Some(compiler) = compiler else {
            eprintln!("no C compiler, or not Linux: a file system without locks was not tested");
            return None;
        };
        let bench = Bench::new();
        bench.file("shim.c", SHIM.replace("NUMBER", number));
        let mut command = Command::new(compiler);
        command.args(["-shared", "-fPIC", "-o", "shim.so", "shim.c"]);
        let built = command.current_dir(bench.path("")).output().unwrap();
        assert!(built.status.success(), "{built:?}");
        let shim = bench.path("shim.so").display().to_string();
        bench.file("s.json", STUDY);
        Some(Without { bench, shim })
    }

    #[track_caller]
    fn expect(&self, code: i32, words: &[&str]) -> Done {
        let mut command = self.bench.command();
        command.args(words).env("LD_PRELOAD", &self.shim);
        let done: Done = command.output().unwrap().into();
        assert_eq!(done.code, Some(code), "{words:?}: {done:?}");
        done
    }
}

#[test]
fn runs_shards_and_merges_without_locks() {
    let with = Bench::new();
    with.file("s.json", STUDY);
    assert_eq!(with.run(&["run", "s.json"]).code, Some(0));
    let wanted = with.tree("figures");
    for number in ERRORS {
        let Some(without) = Without::new(number) else {
            return;
        };
        without.expect(0, &["run", "s.json"]);
        without.expect(0, &["run", "s.json", "--out", "shards", "--shard", "2/2"]);
        without.expect(4, &["merge", "s.json", "--out", "shards"]);
        without.expect(0, &["run", "s.json", "--out", "shards", "--shard", "1/2"]);
        without.expect(0, &["merge", "s.json", "--out", "shards"]);
        for folder in ["figures", "shards"] {
            let differ = differences(&without.bench.tree(folder), &wanted);
            assert_eq!(differ, "", "{folder}, error {number}");
        }
    }
}

#[test]
fn without_locks_temporary_files_are_removed_after_a_day() {
    let Some(without) = Without::new(ERRORS[0]) else {
        return;
    };
    without.expect(0, &["run", "s.json"]);
    let [old, new] = ["old", "new"]
        .map(|age| format!("figures/s/store/.slipgap-0123456789{}.partial", &age[..2]));
    for (name, hours) in [(&old, 25), (&new, 23)] {
        without.bench.file(name, "rest");
        let file = File::options()
            .write(true)
            .open(without.bench.path(name))
            .unwrap();
        file.set_modified(SystemTime::now() - Duration::from_secs(hours * 3600))
            .unwrap();
    }
    without.expect(0, &["run", "s.json", "--shard", "1/1"]);
    assert!(without.bench.path(&old).exists() && without.bench.path(&new).exists());
    without.expect(0, &["merge", "s.json"]);
    assert!(!without.bench.path(&old).exists());
    // Another machine may be writing it.
    assert!(without.bench.path(&new).exists());
    // With locks nobody has locked it, and it is removed.
    assert_eq!(without.bench.run(&["merge", "s.json"]).code, Some(0));
    assert!(fs::symlink_metadata(without.bench.path(&new)).is_err());
}
