//! Stores that were damaged or tampered with between runs.

use crate::scene::OUT;
use crate::{Random, Scene, Tree, long};
use indicatif::ProgressBar;
use slipgap::batch::store::Store;
use slipgap::batch::{self, Wishes};
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
        let mut told = String::new();
        for _ in 0..=random.below(3) {
            told += &damage(&mut tree, &scene.former, &mut random);
        }
        scene.bench.put(OUT, &tree);
        scene.repaired(&format!("{:?}, round {round}: {told}", scene.words));
    }
}

/// Damages a folder of results in one way; which.
fn damage(tree: &mut Tree, former: &Tree, random: &mut Random) -> String {
    let parts = |tree: &Tree| -> Vec<String> {
        tree.keys()
            .filter(|name| name.ends_with(".parquet"))
            .cloned()
            .collect()
    };
    let mine = parts(tree);
    if mine.is_empty() {
        return "no part is left; ".into();
    }
    let one = mine[random.below(mine.len() as u64) as usize].clone();
    let two = mine[random.below(mine.len() as u64) as usize].clone();
    let bytes = tree[&one].clone();
    let place = random.below(bytes.len() as u64) as usize;
    let did = match random.below(10) {
        0 => {
            flip(tree.get_mut(&one).unwrap(), random);
            "a bit of one is turned"
        }
        1 => {
            tree.insert(one.clone(), bytes[..place].to_vec());
            "one is cut short"
        }
        2 => {
            tree.insert(one.clone(), [&bytes[..], &bytes[..place]].concat());
            "one goes on"
        }
        3 => {
            let other = tree.insert(two.clone(), bytes).unwrap();
            tree.insert(one.clone(), other);
            "two have each other's bytes"
        }
        4 => {
            tree.remove(&one);
            "one is gone"
        }
        5 => {
            // Of two parts, or of a part that the study does not have.
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
            "one is there under another number, too"
        }
        6 => {
            let others = parts(former);
            let other = others[random.below(others.len() as u64) as usize].clone();
            tree.insert(other.clone(), former[&other].clone());
            "one of a former study has come back"
        }
        7 => {
            tree.insert(one.clone(), vec![0; bytes.len()]);
            "one holds zeros"
        }
        8 => {
            tree.remove(&one);
            let cut = bytes[..place].to_vec();
            tree.insert(forged(&one, &cut), cut);
            "one is cut short, with the sum of what is left"
        }
        _ => {
            tree.retain(|name, _| !name.starts_with("s/store/"));
            "the store is gone"
        }
    };
    format!("{did} ({one}); ")
}

/// Turns one bit.
fn flip(bytes: &mut [u8], random: &mut Random) {
    let bit = random.below(8 * bytes.len() as u64);
    if let Some(byte) = bytes.get_mut(bit as usize / 8) {
        *byte ^= 1 << (bit % 8);
    }
}

/// The name of a part with the sum of other bytes.
fn forged(name: &str, bytes: &[u8]) -> String {
    let (folder, number) = numbered(name);
    format!("{folder}{number}-{}.parquet", sum(bytes))
}

/// The sum in the name of a part.
fn sum(bytes: &[u8]) -> String {
    format!("{:032x}", XxHash3_128::oneshot(bytes))
}

/// What stands before the number of a part in its name, and the number.
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

/// A part whose name has the sum of its damaged bytes is read, and what it holds is anybody's guess; a run takes it or
/// computes its cases anew, and does not panic. In this process, since few of the damaged ones are hard to read.
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
            let wishes = Wishes {
                store: Some(&store),
                ..Wishes::METRICS
            };
            batch::run(&study, &ProgressBar::hidden(), &wishes, |_| Ok(()))
        };
        let ended = catch_unwind(AssertUnwindSafe(run));
        assert!(
            matches!(ended, Ok(Ok(()))),
            "round {round}: {:?}: {ended:?}",
            store.keys()
        );
    }
}
