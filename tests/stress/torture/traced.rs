//! Runs that are killed at a system call, and calls that fail, by strace if it is installed and allowed.

use crate::{Bench, Done, Scene, program};
use std::fs;
use std::path::PathBuf;

/// Calls for files, in the form of strace. Some machines have only the newer form of a call.
const CALLS: [&str; 9] = [
    "/^open",
    "write",
    "/^rename",
    "/^unlink",
    "/^mkdir",
    "/^rmdir",
    "flock",
    "/^getdents",
    "close",
];

/// Those of them that are made to fail. The standard library ignores errors of `close` and panics if it fails for a
/// directory, which no disk causes.
const FAILING: [&str; 8] = [
    "/^open",
    "write",
    "/^rename",
    "/^unlink",
    "/^mkdir",
    "/^rmdir",
    "flock",
    "/^getdents",
];

/// The errors of the failing calls.
const ERRORS: [&str; 4] = ["ENOSPC", "EIO", "EACCES", "EROFS"];

#[test]
fn killed_at_some_system_calls() {
    each(&CALLS, &[Scene::run(), Scene::report()], 8, kill);
}

#[test]
#[ignore = "minutes; make torture"]
fn killed_at_every_system_call() {
    each(&CALLS, &Scene::all(), 1, kill);
}

#[test]
fn some_system_calls_fail() {
    each(
        &FAILING,
        &[Scene::run(), Scene::report()],
        8,
        |traced, call, n| fail(traced, call, n, ERRORS[n as usize % ERRORS.len()]),
    );
}

#[test]
#[ignore = "minutes; make torture"]
fn every_system_call_fails() {
    each(&FAILING, &Scene::all(), 1, |traced, call, n| {
        ERRORS.iter().all(|error| fail(traced, call, n, error))
    });
}

/// Disturbs every `stride`-th call of each kind, up to the last one.
fn each(
    calls: &[&str],
    scenes: &[Scene],
    stride: u64,
    disturb: impl Fn(&Traced, &str, u64) -> bool,
) {
    let Some(strace) = strace() else { return };
    let mut count = 0;
    for scene in scenes {
        let traced = Traced {
            strace: strace.clone(),
            scene,
        };
        for (number, call) in calls.iter().enumerate() {
            // The short form begins with a different call for each kind.
            let first = 1 + number as u64 % stride;
            let hits = (first..)
                .step_by(stride as usize)
                .take_while(|n| disturb(&traced, call, *n))
                .count();
            eprintln!("{:?}, {call}: {hits} calls disturbed", scene.words);
            count += hits;
        }
    }
    assert!(count > 10, "{count} runs were disturbed");
}

/// Kills a run at its n-th call of a kind; returns whether it has so many.
fn kill(traced: &Traced, call: &str, n: u64) -> bool {
    let scene = traced.scene;
    let what = format!("{:?} killed at {call} {n}", scene.words);
    scene.reset();
    let (done, met) = traced.run(&format!("{call}:signal=KILL:when={n}"));
    assert_eq!(done.code.is_none(), met, "{what}: {done:?}");
    if met {
        scene.only_complete_files(true, &what);
    }
    scene.repaired(&what);
    met
}

/// Makes the n-th call of a kind fail; returns whether there are so many.
fn fail(traced: &Traced, call: &str, n: u64, error: &str) -> bool {
    let scene = traced.scene;
    let what = format!("{:?} with {error} at {call} {n}", scene.words);
    scene.reset();
    let (done, met) = traced.run(&format!("{call}:error={error}:when={n}"));
    assert!(!done.err.contains("panicked"), "{what}: {done:?}");
    match done.code {
        // The result does not depend on the call.
        Some(0) => scene.complete(&what),
        // The loader of the system exits with 127.
        Some(1 | 127) => {
            // The first write of each thread fails, also that of the message.
            let mute = call == "write" && n == 1;
            assert!(mute || !done.err.is_empty(), "{what}: no message");
            // Files that cannot be removed remain.
            scene.only_complete_files(call.contains("unlink"), &what);
        }
        _ => panic!("{what}: {done:?}"),
    }
    scene.repaired(&what);
    met
}

/// A scene with its command run by strace.
struct Traced<'a> {
    strace: PathBuf,
    scene: &'a Scene,
}

impl Traced<'_> {
    /// Runs the command with an injection; returns how it ended, and whether the injection happened.
    fn run(&self, inject: &str) -> (Done, bool) {
        let bench = &self.scene.bench;
        let mut command = bench.command_of(&self.strace);
        command.args(["-f", "-o", "trace", "-e", &format!("inject={inject}")]);
        command
            .arg(program("slipgap").unwrap())
            .args(self.scene.words);
        let done = command.output().unwrap().into();
        let trace = fs::read_to_string(bench.path("trace")).unwrap();
        let met = trace.contains("(INJECTED)") || trace.contains("+++ killed by SIGKILL +++");
        (done, met)
    }
}

/// strace, if it is installed and allowed.
fn strace() -> Option<PathBuf> {
    let works = |path: &PathBuf| {
        let bench = Bench::new();
        let mut command = bench.command_of(path);
        command.args([
            "-f",
            "-o",
            "/dev/null",
            "-e",
            "inject=chdir:error=EIO:when=1",
        ]);
        let tried = program("true").map(|program| command.arg(program).output());
        tried.is_some_and(|tried| tried.is_ok_and(|output| output.status.success()))
    };
    let path = program("strace").filter(works);
    if path.is_none() {
        eprintln!("strace is not installed or not allowed: not tested");
    }
    path
}
