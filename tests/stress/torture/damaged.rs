//! Stores that are damaged or manipulated between runs.

use crate::scene::OUT;
use crate::{Random, Scene, Tree, long};
use indicatif::ProgressBar;
use slipgap::batch::store::Store;
use slipgap::batch::{self, RunOptions};
use slipgap::study;
use std::panic::{AssertUnwindSafe, catch_unwind};
use twox_hash::XxHash3_128;

#[test]
fn damaged_stores() {
    damaged(10);
}

#[test]
#[ignore = "minutes; make torture"]
fn damaged_stores_for_long() {
    damaged(long(600));
}

fn damaged(rounds: u64) {
    let mut random = Random(2);
    let scenes = [Scene::run(), Scene::report()];
    for round in 0..rounds {
        let scene = &scenes[random.below(2) as usize];
        let mut tree = scene.wanted.clone();
        let mut done = String::new();
        for _ in 0..=random.below(3) {
            done += &damage(&mut tree, &scene.former, &mut random);
        }
        scene.bench.put(OUT, &tree);
        scene.repaired(&format!("{:?}, round {round}: {done}", scene.words));
    }
}

/// Damages a folder of results in one way; returns a description.
fn damage(tree: &mut Tree, former: &Tree, random: &mut Random) -> String {
    let parts = |tree: &Tree| -> Vec<String> {
        tree.keys()
            .filter(|name| name.ends_with(".parquet"))
            .cloned()
            .collect()
    };
    let parts_now = parts(tree);
    if parts_now.is_empty() {
        return "there is no part; ".into();
    }
    let one = parts_now[random.below(parts_now.len() as u64) as usize].clone();
    let two = parts_now[random.below(parts_now.len() as u64) as usize].clone();
    let bytes = tree[&one].clone();
    let at = random.below(bytes.len() as u64) as usize;
    let damage = match random.below(10) {
        0 => {
            flip(tree.get_mut(&one).unwrap(), random);
            "a bit of one is inverted"
        }
        1 => {
            tree.insert(one.clone(), bytes[..at].to_vec());
            "one is truncated"
        }
        2 => {
            tree.insert(one.clone(), [&bytes[..], &bytes[..at]].concat());
            "one is longer"
        }
        3 => {
            let other = tree.insert(two.clone(), bytes).unwrap();
            tree.insert(one.clone(), other);
            "two have each other's bytes"
        }
        4 => {
            tree.remove(&one);
            "one is removed"
        }
        5 => {
            // The number of another part, or of a part that the study does not have.
            let (_, number) = numbered(&two);
            let beyond = format!(
                "{:0width$}",
                1 + random.below(1 << 20),
                width = number.len()
            );
            let number = if random.below(2) == 0 {
                number
            } else {
                &beyond
            };
            let (folder, _) = numbered(&one);
            tree.insert(format!("{folder}{number}-{}.parquet", sum(&bytes)), bytes);
            "one has a copy under another number"
        }
        6 => {
            let others = parts(former);
            let other = others[random.below(others.len() as u64) as usize].clone();
            tree.insert(other.clone(), former[&other].clone());
            "one of a former study is added"
        }
        7 => {
            tree.insert(one.clone(), vec![0; bytes.len()]);
            "one contains zeros"
        }
        8 => {
            tree.remove(&one);
            let cut = bytes[..at].to_vec();
            tree.insert(forged(&one, &cut), cut);
            "one is truncated, with a valid checksum"
        }
        _ => {
            tree.retain(|name, _| !name.starts_with("s/store/"));
            "the store is removed"
        }
    };
    format!("{damage} ({one}); ")
}

/// Inverts one bit.
fn flip(bytes: &mut [u8], random: &mut Random) {
    let bit = random.below(8 * bytes.len() as u64);
    if let Some(byte) = bytes.get_mut(bit as usize / 8) {
        *byte ^= 1 << (bit % 8);
    }
}

/// The name of a part with the checksum of other bytes.
fn forged(name: &str, bytes: &[u8]) -> String {
    let (folder, number) = numbered(name);
    format!("{folder}{number}-{}.parquet", sum(bytes))
}

/// The checksum in the name of a part.
fn sum(bytes: &[u8]) -> String {
    format!("{:032x}", XxHash3_128::oneshot(bytes))
}

/// The name of a part up to its number, and the number.
fn numbered(name: &str) -> (&str, &str) {
    let (front, _) = name.rsplit_once('-').unwrap();
    front.split_at(front.rfind('-').unwrap() + 1)
}

#[test]
fn forged_parts() {
    forge(300);
}

#[test]
#[ignore = "minutes; make torture"]
fn forged_parts_for_long() {
    forge(long(40_000));
}

/// A damaged part with a valid checksum can have any content. A run uses it or computes its cases again, and does not panic.
/// The runs are in this process, because few of the damaged parts cause trouble.
fn forge(rounds: u64) {
    let mut random = Random(3);
    let scene = Scene::run();
    let study = study::read(&scene.bench.path("studies/s.json")).unwrap();
    let part = |name: &&String| name.starts_with("s/store/part-");
    let parts: Vec<&String> = scene.wanted.keys().filter(part).collect();
    let none = Tree::from([("s/store/".to_owned(), Vec::new())]);
    for round in 0..rounds {
        let mut store = none.clone();
        for name in &parts {
            let mut bytes = scene.wanted[*name].clone();
            for _ in 0..=random.below(3) {
                flip(&mut bytes, &mut random);
            }
            store.insert(forged(name, &bytes), bytes);
        }
        scene.bench.put(OUT, &store);
        let run = || {
            let store = Store::open(&scene.bench.path(OUT).join("s")).unwrap();
            let options = RunOptions {
                store: Some(&store),
                ..RunOptions::METRICS
            };
            batch::run(&study, &ProgressBar::hidden(), &options, |_| Ok(()))
        };
        let ended = catch_unwind(AssertUnwindSafe(run));
        assert!(
            matches!(ended, Ok(Ok(()))),
            "round {round}: {:?}: {ended:?}",
            store.keys()
        );
    }
}
