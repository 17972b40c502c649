//! The same bytes for any number of threads, on the shipped studies.

use crate::{Bench, differences};
use std::fs;
use std::path::Path;

/// Studies that take a second or more. Studies with many small cases test the same.
const SLOW: [&str; 3] = ["impact-map-gamma-n", "impact-sobol", "impact-budget"];

#[test]
fn one_and_two_threads() {
    threads(&["2"], &|name| {
        ["friction-map-beta", "friction-fig5", "impact-fig4"].contains(&name)
    });
}

#[test]
#[ignore = "minutes; make torture"]
fn from_1_to_16_threads() {
    let counts: Vec<String> = (2..=16).map(|jobs: u32| jobs.to_string()).collect();
    let jobs: Vec<&str> = counts.iter().map(String::as_str).collect();
    threads(&jobs, &|name| !SLOW.contains(&name));
    threads(&["16"], &|name| SLOW.contains(&name));
}

/// Compares runs of shipped studies with one thread and with each of these numbers of threads.
fn threads(jobs: &[&str], wanted: &dyn Fn(&str) -> bool) {
    let bench = Bench::new();
    let mut count = 0;
    // The two textbook problems, whose studies need no other file.
    for folder in ["", "friction", "impact"] {
        let folder = Path::new(env!("SLIPGAP_ROOT")).join("studies").join(folder);
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap();
            if !path.is_file() || !wanted(name) {
                continue;
            }
            bench.file(&format!("studies/{name}.json"), fs::read(&path).unwrap());
            count += 1;
        }
    }
    assert!(count > 2, "{count} studies");
    let run = |jobs: &str| {
        let done = bench.run(&["run", "--out", jobs, "--jobs", jobs]);
        assert_eq!(done.code, Some(0), "{done:?}");
        bench.tree(jobs)
    };
    let one = run("1");
    for jobs in jobs {
        assert_eq!(differences(&run(jobs), &one), "", "{jobs} threads");
    }
}
