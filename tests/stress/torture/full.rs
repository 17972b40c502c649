//! Full disks: a limit on the size of files, and a small disk in memory if the system allows one.

use crate::scene::OUT;
use crate::{Done, Scene, Tree, program};
use std::fs;

/// Page size of a disk in memory, in bytes.
const PAGE: u64 = 4096;

#[test]
fn limited_file_sizes() {
    limited(&[Scene::run(), Scene::report()], 9);
}

#[test]
#[ignore = "minutes; make torture"]
fn limited_file_sizes_at_every_size() {
    for scene in Scene::all() {
        limited(&[scene], 1);
    }
}

/// Limits the size of files. Writing then fails in the same places as on a full disk.
fn limited(scenes: &[Scene], stride: usize) {
    let bash = program("bash").unwrap();
    for scene in scenes {
        let mut failures = 0;
        for limit in (0..).step_by(stride) {
            let what = format!("{:?} with files of {limit} KiB", scene.words);
            scene.reset();
            let line = format!("trap '' XFSZ; ulimit -f {limit}; exec \"$0\" \"$@\"");
            let mut command = scene.bench.command_of(&bash);
            command.args(["-c", &line]).arg(program("slipgap").unwrap());
            let done = Done::from(command.args(scene.words).output().unwrap());
            failures += usize::from(failed(scene, &done, &what));
            scene.repaired(&what);
            if done.code == Some(0) {
                break;
            }
        }
        assert!(failures > 0, "{:?}: no limit was too small", scene.words);
    }
}

/// Whether a run has failed. A failed run must report it and leave only complete files.
fn failed(scene: &Scene, done: &Done, what: &str) -> bool {
    assert!(!done.err.contains("panicked"), "{what}: {done:?}");
    match done.code {
        Some(0) => scene.complete(what),
        Some(1) => {
            assert!(done.err.contains("slipgap: cannot "), "{what}: {done:?}");
            scene.only_complete_files(false, what);
        }
        _ => panic!("{what}: {done:?}"),
    }
    done.code == Some(1)
}

#[test]
fn a_full_disk() {
    full(&[Scene::run()], 12);
}

#[test]
#[ignore = "minutes; make torture"]
fn a_disk_full_at_every_page() {
    full(&Scene::all(), 1);
}

/// Runs on a disk in memory with space for the former results and some pages, then again with more space.
fn full(scenes: &[Scene], stride: usize) {
    for scene in scenes {
        let used: u64 = scene
            .former
            .values()
            .map(|b| (b.len() as u64).div_ceil(PAGE))
            .sum();
        let mut failures = 0;
        for free in (0..).step_by(stride) {
            let what = format!("{:?} with {free} pages of disk left", scene.words);
            let Some((done, after, again, repaired)) = on_disk(scene, (used + free) * PAGE) else {
                eprintln!("a disk in memory is not allowed: not tested");
                return;
            };
            scene.bench.put(OUT, &after);
            failures += usize::from(failed(scene, &done, &what));
            assert_eq!(again.code, Some(0), "{what}, with room: {again:?}");
            scene.bench.put(OUT, &repaired);
            scene.complete(&format!("{what}, with room"));
            if done.code == Some(0) {
                break;
            }
        }
        assert!(failures > 0, "{:?}: no disk was too small", scene.words);
    }
}

/// A run on a disk of `size` bytes, and one with more space: how each ended, and its files. `None` if the system does not
/// allow mounting.
fn on_disk(scene: &Scene, size: u64) -> Option<(Done, Tree, Done, Tree)> {
    let bench = &scene.bench;
    scene.reset();
    bench.put("former", &scene.former);
    bench.put("after", &Tree::new());
    bench.put("repaired", &Tree::new());
    for folder in ["after", "repaired"] {
        fs::create_dir(bench.path(folder)).unwrap();
    }
    // The disk is in a new namespace and is removed with it.
    let script = format!(
        "mount -t tmpfs -o size={size} tmpfs {OUT} || exit 99
         cp -a former/. {OUT} || exit 98
         PATH=/nonexistent \"$0\" \"$@\" 2> first; echo $? > first.code
         cp -a {OUT}/. after && mount -o remount,size=64m {OUT} || exit 97
         PATH=/nonexistent \"$0\" \"$@\" 2> second; echo $? > second.code
         cp -a {OUT}/. repaired"
    );
    let mut command = bench.command_of(program("unshare")?);
    command.env("PATH", std::env::var_os("PATH")?);
    command.args(["-r", "-m", "sh", "-c", &script]);
    let output = command
        .arg(program("slipgap")?)
        .args(scene.words)
        .output()
        .ok()?;
    if !output.status.success() {
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(!matches!(output.status.code(), Some(97 | 98)), "{errors}");
        return None;
    }
    let done = |name: &str| Done {
        code: fs::read_to_string(bench.path(&format!("{name}.code")))
            .unwrap()
            .trim()
            .parse()
            .ok(),
        out: String::new(),
        err: fs::read_to_string(bench.path(name)).unwrap(),
    };
    Some((
        done("first"),
        bench.tree("after"),
        done("second"),
        bench.tree("repaired"),
    ))
}
