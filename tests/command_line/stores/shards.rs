//! Shards, merges, and the script for Slurm: messages, exit codes and files.

use crate::{Bench, TWO, friction};
use std::fs;

/// Cases in four chunks of 16 384 combinations.
fn sweep(more: &str) -> String {
    let parameters = r#""law": "velocity-control", "beta": {"range": [0.1, 1.6, 0.1]}, "dT": "pi/8", "duration": "8*pi",
        "x0": {"linspace": [1, 20, 4000]}"#;
    friction(parameters, &format!(r#", "when": "x0 > 19.99"{more}"#))
}

fn parts(bench: &Bench, folder: &str) -> Vec<String> {
    let names = bench.everything(folder).into_iter();
    names.filter(|name| name.ends_with(".parquet")).collect()
}

#[test]
fn a_shard_keeps_its_parts_and_writes_nothing_else() {
    let bench = Bench::new();
    bench.file("s.json", sweep(""));
    let done = bench.expect(0, &["run", "s.json", "--shard", "2/3"]);
    assert_eq!(done.out, "");
    assert_eq!(done.err, "s, shard 2/3: 1 of 1 part computed\n");
    let store = bench.everything("figures");
    assert_eq!(store.len(), 1);
    assert!(
        store[0].starts_with("s/store/part-000000016384-"),
        "{store:?}"
    );
    let done = bench.expect(0, &["run", "s.json", "--shard", "1/3"]);
    assert_eq!(done.err, "s, shard 1/3: 2 of 2 parts computed\n");
    // A damaged part is computed again. The file has the name of its content.
    fs::write(bench.path("figures").join(&store[0]), "damaged").unwrap();
    let done = bench.expect(0, &["run", "s.json", "--shard", "2/3"]);
    assert_eq!(done.err, "s, shard 2/3: 1 of 1 part computed\n");
    assert_eq!(parts(&bench, "figures").len(), 3);
    let done = bench.expect(0, &["run", "s.json", "--shard", "2/3"]);
    assert_eq!(
        done.err,
        "s, shard 2/3: 0 of 1 part computed, 1 in the store already\n"
    );
    let done = bench.expect(0, &["run", "s.json", "--shard", "9/9"]);
    assert_eq!(done.err, "s, shard 9/9: 0 of 0 parts computed\n");
}

#[test]
fn a_merge_names_missing_parts_and_changes_nothing() {
    let bench = Bench::new();
    bench.file("s.json", sweep(""));
    bench.expect(0, &["run", "s.json", "--out", "whole"]);
    bench.expect(0, &["run", "s.json", "--shard", "1/3"]);
    let merge = ["merge", "s.json", "--shards", "3"];
    let done = bench.expect(4, &merge);
    assert_eq!(done.out, "");
    assert_eq!(
        done.err,
        "slipgap: s.json: 2 of 4 parts are missing (2 not there, 0 of another version); run shards 2,3 of 3 again\n"
    );
    let done = bench.expect(4, &["merge", "s.json"]);
    assert_eq!(
        done.err,
        "slipgap: s.json: 2 of 4 parts are missing (2 not there, 0 of another version); \
        with --shards N, this names the shards to run again\n"
    );
    assert!(bench.tree("figures").is_empty());
    bench.expect(0, &["run", "s.json", "--shard", "2/3"]);
    bench.expect(0, &["run", "s.json", "--shard", "3/3"]);
    let done = bench.expect(0, &merge);
    assert_eq!(done.out, "figures/s\n");
    let bytes = |folder: &str, name: &String| fs::read(bench.path(folder).join(name)).unwrap();
    assert_eq!(bench.everything("figures"), bench.everything("whole"));
    for name in bench.everything("figures") {
        assert_eq!(bytes("figures", &name), bytes("whole", &name), "{name}");
    }
    // A damaged part is named.
    let part = parts(&bench, "figures").pop().unwrap();
    fs::write(bench.path("figures").join(&part), "damaged").unwrap();
    let done = bench.expect(4, &merge);
    let what = format!(
        "1 of 4 parts are missing (0 not there, 1 damaged or unreadable, such as figures/{part}, 0 of another version); run shards 1 of 3 again\n"
    );
    assert!(done.err.ends_with(&what), "{done:?}");
    // Parts of another version of the study: the former results stay until all parts are there.
    bench.file("s.json", sweep("").replace("pi/8", "pi/9"));
    let former = bench.text("figures/s/results.csv");
    bench.expect(0, &["run", "s.json", "--shard", "1/3"]);
    let done = bench.expect(4, &merge);
    assert!(done.err.ends_with("2 of 4 parts are missing (0 not there, 2 of another version); run shards 2,3 of 3 again\n"), "{done:?}");
    assert_eq!(bench.text("figures/s/results.csv"), former);
    assert_eq!(parts(&bench, "figures").len(), 6);
    bench.expect(0, &["run", "s.json", "--shard", "2/3"]);
    bench.expect(0, &["run", "s.json", "--shard", "3/3"]);
    bench.expect(0, &merge);
    assert_ne!(bench.text("figures/s/results.csv"), former);
    assert_eq!(parts(&bench, "figures").len(), 4);
}

#[test]
fn cases_without_a_solution_are_rows_of_a_shard_and_end_a_merge_with_3() {
    let bench = Bench::new();
    // A step of 10^300 takes the velocity beyond the largest double.
    let parameters =
        r#""law": "displacement-control", "alpha": 1, "dT": [0.1, 1e300], "duration": "10*dT""#;
    bench.file("s.json", friction(parameters, ""));
    bench.file("other.json", friction(TWO, ""));
    bench.expect(3, &["run", "s.json", "--out", "whole"]);
    let done = bench.expect(0, &["run", "s.json", "--shard", "1/1"]);
    assert_eq!(
        done.err,
        "s, shard 1/1: 1 of 1 part computed; 1 case could not be solved\n"
    );
    let done = bench.expect(3, &["merge", "s.json"]);
    assert!(
        done.err.contains("s.json: case 1 could not be solved: "),
        "{done:?}"
    );
    assert_eq!(
        bench.text("figures/s/failures.csv"),
        bench.text("whole/s/failures.csv")
    );
    // Missing parts before cases without a solution. The complete study is merged.
    fs::remove_file(bench.path("figures/s/results.csv")).unwrap();
    bench.expect(4, &["merge", "s.json", "other.json"]);
    assert!(bench.path("figures/s/results.csv").exists());
    assert!(!bench.path("figures/other/results.csv").exists());
}

#[test]
fn settings_and_formats_are_those_of_a_run() {
    let bench = Bench::new();
    bench.file("s.json", sweep(""));
    let set = ["--set", "dT=pi/9"];
    bench.expect(
        0,
        &[
            &["run", "s.json", "--out", "whole", "--format", "parquet"][..],
            &set,
        ]
        .concat(),
    );
    for shard in ["1/2", "2/2"] {
        bench.expect(
            0,
            &[&["run", "s.json", "--shard", shard][..], &set].concat(),
        );
    }
    let done = bench.expect(4, &["merge", "s.json"]);
    assert!(
        done.err.contains("(0 not there, 4 of another version)"),
        "{done:?}"
    );
    bench.expect(
        0,
        &[&["merge", "s.json", "--format", "parquet"][..], &set].concat(),
    );
    assert_eq!(bench.everything("figures"), bench.everything("whole"));
    assert_eq!(
        bench.text("figures/s/manifest.json"),
        bench.text("whole/s/manifest.json")
    );
}

#[test]
fn mistakes_name_what_is_allowed() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, ""));
    for shard in ["0/4", "5/4", "1/0", "4", "a/b", "1.5/2", ""] {
        let done = bench.expect(2, &["run", "s.json", "--shard", shard]);
        assert!(
            done.err
                .contains("must be I/N with whole numbers 1 <= I <= N, as in 3/16"),
            "{done:?}"
        );
    }
    for other in [
        &["--histories"][..],
        &["--fail-fast"],
        &["--format", "csv"],
        &["--dpi", "100"],
    ] {
        let done = bench.expect(
            2,
            &[&["run", "s.json", "--shard", "1/2"][..], other].concat(),
        );
        assert!(done.err.contains("cannot be used with"), "{done:?}");
    }
    bench.expect(2, &["merge", "s.json", "--shards", "0"]);
    bench.expect(2, &["sbatch", "s.json"]);
    bench.expect(2, &["sbatch", "s.json", "--shards", "0"]);
    let done = bench.expect(2, &["sbatch", "s.json", "--shards", "2", "--time", "1h"]);
    assert!(
        done.err.contains("must be a time > 0 as Slurm reads it"),
        "{done:?}"
    );
    let done = bench.expect(
        2,
        &[
            "sbatch",
            "s.json",
            "--shards",
            "2",
            "--time",
            "2",
            "--requeue",
        ],
    );
    assert_eq!(
        done.err,
        "slipgap: --time 2 is too short for --requeue; at least 00:03:00 is allowed\n"
    );
    let done = bench.expect(2, &["sbatch", "-", "--shards", "2"]);
    assert_eq!(
        done.err,
        "slipgap: the tasks cannot read standard input; give a study file or a folder\n"
    );
    assert!(!bench.path("figures").exists());
    // A part that cannot be written.
    bench.file("figures", "a file");
    bench.expect(1, &["run", "s.json", "--shard", "1/2"]);
}

#[test]
fn the_script_for_slurm_has_full_paths_and_the_settings() {
    let bench = Bench::new();
    bench.file("it's/s.json", friction(TWO, ""));
    let words = [
        "sbatch",
        "it's/s.json",
        "--shards",
        "16",
        "--partition",
        "long",
        "--set",
        "alpha=[0.1, 1]",
    ];
    let done = bench.expect(0, &words);
    assert_eq!(done.err, "");
    let folder = bench.path("").canonicalize().unwrap().display().to_string();
    let arguments = format!(
        "arguments=('{folder}/it'\\''s/s.json' '--out' '{folder}/figures' '--set' 'alpha=[0.1, 1]')"
    );
    assert!(done.out.contains(&arguments), "{}\n{arguments}", done.out);
    assert!(
        done.out.contains("\nshards=16\n") && done.out.contains("\noptions=('--partition=long')\n"),
        "{}",
        done.out
    );
    assert!(
        done.out.contains("--dependency=\"afterany:$array\"") && !done.out.contains("--signal")
    );
}

#[test]
fn a_merge_without_parts_leaves_no_files_and_no_folders_of_its_own() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, ""));
    bench.expect(4, &["merge", "s.json", "--out", "deep/out"]);
    assert!(!bench.path("deep").exists());
    // Folders that were there stay, without the lock.
    fs::create_dir_all(bench.path("mine/s/store")).unwrap();
    bench.expect(4, &["merge", "s.json", "--out", "mine"]);
    assert!(bench.path("mine/s/store").is_dir());
    assert!(bench.everything("mine").is_empty());
    // A store with parts of another study keeps its lock.
    bench.expect(0, &["run", "s.json"]);
    let before = bench.everything("figures");
    bench.file("s.json", friction(TWO, "").replace("pi/10", "pi/20"));
    bench.expect(4, &["merge", "s.json"]);
    assert_eq!(bench.everything("figures"), before);
}
