//! Several processes on one output folder.

use crate::scene::OUT;
use crate::{Bench, Done, Scene, differences, long};
use std::process::Stdio;

/// Number of processes at the same time.
const PROCESSES: usize = 4;

#[test]
fn together_on_one_folder() {
    same_study(2);
    reports_of_different_studies(2);
}

#[test]
#[ignore = "minutes; make torture"]
fn together_on_one_folder_for_long() {
    same_study(long(60));
    reports_of_different_studies(long(60));
}

/// Starts all commands at once and waits for them.
fn at_once(bench: &Bench, commands: &[Vec<&str>]) -> Vec<Done> {
    let start = |words: &Vec<&str>| {
        let mut command = bench.command();
        command
            .args(words)
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        command.spawn().unwrap()
    };
    let started: Vec<_> = commands.iter().map(start).collect();
    started
        .into_iter()
        .map(|child| child.wait_with_output().unwrap().into())
        .collect()
}

/// The same command several times. At least one succeeds. The others succeed too, or `run` reports that the store is in use.
/// The files are the same as after one command.
fn same_study(rounds: u64) {
    for scene in Scene::all() {
        for round in 0..rounds {
            let what = format!("{:?}, round {round}", scene.words);
            scene.reset();
            let ended = at_once(&scene.bench, &vec![scene.words.to_vec(); PROCESSES]);
            for done in &ended {
                // Reports and claims wait.
                let busy = scene.words[0] == "run"
                    && done.code == Some(1)
                    && done.err.contains("is in use by another run");
                assert!(done.code == Some(0) || busy, "{what}: {done:?}");
            }
            assert!(
                ended.iter().any(|done| done.code == Some(0)),
                "{what}: {ended:?}"
            );
            scene.complete(&what);
        }
    }
}

/// Pages about different studies in one file: all succeed, and the file is one of the pages.
fn reports_of_different_studies(rounds: u64) {
    let study = |alpha: usize| {
        format!(
            r#"{{ "problem": "friction-oscillator", "parameters": {{ "law": "displacement-control", "alpha": {alpha},
                "dT": "pi/8", "duration": "8*pi" }} }}"#
        )
    };
    let names: Vec<String> = (1..=PROCESSES).map(|k| format!("{k}.json")).collect();
    let written = || {
        let bench = Bench::new();
        names
            .iter()
            .enumerate()
            .for_each(|(k, name)| bench.file(name, study(k + 1)));
        bench
    };
    let alone: Vec<Bench> = names
        .iter()
        .map(|name| {
            let bench = written();
            assert_eq!(bench.run(&["report", name]).code, Some(0));
            bench
        })
        .collect();
    let page = "report.html";
    let pages: Vec<Vec<u8>> = alone
        .iter()
        .map(|bench| bench.tree(OUT)[page].clone())
        .collect();
    for round in 0..rounds {
        let bench = written();
        let commands: Vec<Vec<&str>> = names.iter().map(|name| vec!["report", name]).collect();
        for done in at_once(&bench, &commands) {
            assert_eq!(done.code, Some(0), "round {round}: {done:?}");
        }
        let mut tree = bench.tree(OUT);
        let found = tree.remove(page).unwrap();
        assert!(
            pages.contains(&found),
            "round {round}: the page is none of those written"
        );
        let mut stores = alone
            .iter()
            .flat_map(|bench| bench.tree(OUT))
            .collect::<crate::Tree>();
        stores.remove(page);
        assert_eq!(differences(&tree, &stores), "", "round {round}");
    }
}
