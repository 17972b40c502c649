//! The recipes of docs/clusters.md: the commands of the page run as they are there, and give the bytes of one plain run. `make recipes`
//! installs what PyPI has of the engines. An engine that is not there is named, and its recipe is not run.
#![cfg(unix)]

#[path = "../../common/bench.rs"]
mod bench;
#[allow(dead_code)]
#[path = "../torture/tree.rs"]
mod tree;

pub(crate) use bench::{Bench, Done};
use std::fs;
use std::path::Path;
use tree::{differences, program};

/// Cases in twelve chunks, for the sixteen shards of the page.
const STUDY: &str = r#"{ "problem": "friction-oscillator", "parameters": {
    "law": "velocity-control", "beta": {"range": [0.1, 4.8, 0.1]}, "dT": "pi/125", "duration": "8*pi",
    "x0": {"linspace": [1, 20, 4000]} }, "when": "x0 > 19.99",
  "figures": [{ "name": "f", "kind": "metric", "x": "beta", "y": "rms_error", "where": {"x0": 20} }] }"#;

const ROOT: &str = env!("SLIPGAP_ROOT");

/// The commands in the first block of a section of the page.
fn commands(section: &str) -> String {
    let page = fs::read_to_string(Path::new(ROOT).join("docs/clusters.md")).unwrap();
    let after = page
        .split_once(&format!("\n## {section}\n"))
        .unwrap_or_else(|| panic!("no section {section}"))
        .1;
    let block = after.split_once("```sh\n").unwrap().1;
    block.split_once("```").unwrap().0.to_owned()
}

/// Runs the commands of a section, if `test` succeeds, and compares the results.
fn run(section: &str, test: &[&str]) {
    let bench = Bench::new();
    let program_folder = Path::new(env!("CARGO_BIN_EXE_slipgap-tested"))
        .parent()
        .unwrap();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = [program_folder.to_owned()]
        .into_iter()
        .chain(std::env::split_paths(&path));
    let path = std::env::join_paths(folders).unwrap();
    let run = |name: &str, words: &[&str]| -> Option<Done> {
        let mut command = bench.command_of(program(name)?);
        // Settings and caches of the engines stay in the folder of the test, too.
        command.env("PATH", &path).env("HOME", bench.path("home"));
        Some(command.args(words).output().unwrap().into())
    };
    let there = run(test[0], &test[1..]);
    if there.is_none_or(|done| done.code != Some(0)) {
        eprintln!("no {section}, so its recipe was not run: {test:?} fails");
        return;
    }
    bench.file("study.json", STUDY);
    for entry in fs::read_dir(Path::new(ROOT).join("examples/clusters")).unwrap() {
        let file = entry.unwrap().path();
        let name = file.file_name().unwrap().to_str().unwrap();
        bench.file(
            &format!("examples/clusters/{name}"),
            fs::read(&file).unwrap(),
        );
    }
    let done = run("bash", &["-e", "-c", &commands(section)]).expect("bash");
    assert_eq!(done.code, Some(0), "{section}: {}\n{}", done.out, done.err);
    let whole = Bench::new();
    whole.file("study.json", STUDY);
    let plain = whole.run(&["run", "study.json", "--out", "DIR"]);
    assert_eq!(plain.code, Some(0), "{plain:?}");
    let differ = differences(&bench.tree("DIR"), &whole.tree("DIR"));
    assert_eq!(differ, "", "{section}");
    eprintln!("{section}: the same bytes");
}

#[test]
#[ignore = "starts other programs; make recipes"]
fn gnu_parallel() {
    run(
        "GNU parallel",
        &["parallel", "--will-cite", "--minversion", "20100101"],
    );
}

#[test]
#[ignore = "starts other programs; make recipes"]
fn snakemake() {
    run("Snakemake", &["snakemake", "--version"]);
}

#[test]
#[ignore = "starts other programs; make recipes"]
fn nextflow() {
    run("Nextflow", &["nextflow", "-version"]);
}

#[test]
#[ignore = "starts other programs; make recipes"]
fn dask() {
    run("Dask", &["python", "-c", "import dask.distributed"]);
}

#[test]
#[ignore = "starts other programs; make recipes"]
fn hyperqueue() {
    run("HyperQueue", &["python", "-c", "import hyperqueue"]);
}
