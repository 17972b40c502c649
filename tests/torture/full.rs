//! Disks with no room: a limit on the size of files, and a small disk where the system gives one.

use crate::scene::OUT;
use crate::{Done, Scene, Tree, program};
use std::fs;

/// Bytes that a disk in memory gives out at a time.
const PAGE: u64 = 4096;

#[test]
fn files_that_may_not_grow() {
    limited(&[Scene::run(), Scene::report()], 9);
}

#[test]
#[ignore = "minutes; make torture"]
fn files_that_may_not_grow_at_every_size() {
    for scene in Scene::all() {
        limited(&[scene], 1);
    }
}

/// No file may grow beyond so many KiB, which fails at the places where a full disk does.
fn limited(scenes: &[Scene], stride: usize) {
    let bash = program("bash").unwrap();
    for scene in scenes {
        let mut refused = 0;
        for limit in (0..).step_by(stride) {
            let what = format!("{:?} with files of {limit} KiB", scene.words);
            scene.reset();
            let line = format!("trap '' XFSZ; ulimit -f {limit}; exec \"$0\" \"$@\"");
            let mut command = scene.bench.command(&bash);
            command.args(["-c", &line]).arg(program("slipgap").unwrap());
            let done = Done::from(command.args(scene.words).output().unwrap());
            refused += usize::from(judged(scene, &done, &what));
            scene.repaired(&what);
            if done.code == Some(0) {
                break;
            }
        }
        assert!(refused > 0, "{:?}: no limit was too small", scene.words);
    }
}

/// Whether a run that had no room says so and leaves nothing but whole files; else it is complete.
fn judged(scene: &Scene, done: &Done, what: &str) -> bool {
    assert!(!done.err.contains("panicked"), "{what}: {done:?}");
    match done.code {
        Some(0) => scene.complete(what),
        Some(1) => {
            assert!(done.err.contains("slipgap: cannot "), "{what}: {done:?}");
            scene.whole(false, what);
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

/// A disk in memory with room for the former results and few pages more; then it grows, and the run is repeated.
fn full(scenes: &[Scene], stride: usize) {
    for scene in scenes {
        let used: u64 = scene
            .former
            .values()
            .map(|b| (b.len() as u64).div_ceil(PAGE))
            .sum();
        let mut refused = 0;
        for free in (0..).step_by(stride) {
            let what = format!("{:?} with {free} pages of disk left", scene.words);
            let Some((done, after, again, repaired)) = on_disk(scene, (used + free) * PAGE) else {
                eprintln!("no disk in memory to be had: not looked at");
                return;
            };
            scene.bench.put(OUT, &after);
            refused += usize::from(judged(scene, &done, &what));
            assert_eq!(again.code, Some(0), "{what}, with room: {again:?}");
            scene.bench.put(OUT, &repaired);
            scene.complete(&format!("{what}, with room"));
            if done.code == Some(0) {
                break;
            }
        }
        assert!(refused > 0, "{:?}: no disk was too small", scene.words);
    }
}

/// A run on a disk of so many bytes, and one more with room: how each ended and what it left. Nothing where the system
/// lets nobody mount.
fn on_disk(scene: &Scene, size: u64) -> Option<(Done, Tree, Done, Tree)> {
    let bench = &scene.bench;
    scene.reset();
    bench.put("former", &scene.former);
    bench.put("after", &Tree::new());
    bench.put("repaired", &Tree::new());
    for folder in ["after", "repaired"] {
        fs::create_dir(bench.path(folder)).unwrap();
    }
    // In a namespace of its own, with which the disk goes.
    let script = format!(
        "mount -t tmpfs -o size={size} tmpfs {OUT} || exit 99
         cp -a former/. {OUT} || exit 98
         PATH=/nonexistent \"$0\" \"$@\" 2> first; echo $? > first.code
         cp -a {OUT}/. after && mount -o remount,size=64m {OUT} || exit 97
         PATH=/nonexistent \"$0\" \"$@\" 2> second; echo $? > second.code
         cp -a {OUT}/. repaired"
    );
    let mut command = bench.command(program("unshare")?);
    command.env("PATH", std::env::var_os("PATH")?);
    command.args(["-r", "-m", "sh", "-c", &script]);
    let output = command
        .arg(program("slipgap")?)
        .args(scene.words)
        .output()
        .ok()?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!matches!(output.status.code(), Some(97 | 98)), "{said}");
        return None;
    }
    let done = |name: &str| Done {
        code: fs::read_to_string(bench.path(&format!("{name}.code")))
            .unwrap()
            .trim()
            .parse()
            .ok(),
        err: fs::read_to_string(bench.path(name)).unwrap(),
    };
    Some((
        done("first"),
        bench.tree("after"),
        done("second"),
        bench.tree("repaired"),
    ))
}
