//! Runs killed at random times.

use crate::{Random, Scene, long};
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

#[test]
fn killed_at_random_times() {
    killed(2);
}

#[test]
#[ignore = "minutes; make torture"]
fn killed_at_random_times_for_long() {
    killed(long(150));
}

fn killed(rounds: u64) {
    let mut random = Random(1);
    for scene in Scene::all() {
        scene.reset();
        let begin = Instant::now();
        scene.repaired("undisturbed, over former results");
        // The time of the kill is random and depends on the machine. The assertions do not.
        let lasts = begin.elapsed().as_micros() as u64;
        for round in 0..rounds {
            scene.reset();
            // Killed one to four times, then undisturbed.
            for _ in 0..=random.below(4) {
                let mut command = scene.bench.command();
                command
                    .args(scene.words)
                    .stdout(Stdio::null())
                    .stderr(Stdio::null());
                let mut child = command.spawn().unwrap();
                sleep(Duration::from_micros(random.below(lasts)));
                child.kill().unwrap();
                child.wait().unwrap();
                scene.only_complete_files(true, &format!("{:?}, round {round}", scene.words));
            }
            scene.repaired(&format!("{:?}, killed, round {round}", scene.words));
        }
    }
}
