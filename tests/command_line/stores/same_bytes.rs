//! The same input gives the same bytes for any number of threads and on processors with narrower instructions.

use crate::{Bench, bars, friction};
use std::fs;
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
use std::process::Command;

#[test]
fn with_1_2_and_7_threads() {
    let bench = Bench::new();
    let many = r#""law": "displacement-control", "alpha": [0.1, 0.5, 1, 2, 5], "x0": [12, 12.5], "dT": "pi/20", "duration": "8*pi""#;
    let figures = r#", "figures": [
        { "name": "history", "kind": "history", "where": { "x0": 12.5 } },
        { "name": "law", "kind": "law" },
        { "name": "metric", "kind": "metric", "x": "alpha", "y": ["rms_error", "work_error"] },
        { "name": "map", "kind": "map", "x": "alpha", "y": "x0", "z": "rms_error" }]"#;
    bench.file("studies/friction.json", friction(many, figures));
    let history = r#", "figures": [{ "name": "r", "kind": "history", "panels": "k_I" }]"#;
    let impact = r#""k_I": [10, 100, 1e5], "n": [2, 10], "dt": 0.01, "duration": 1.5"#;
    bench.file("studies/bars.json", bars(impact, history));
    for jobs in ["1", "2", "7"] {
        bench.expect(0, &["run", "--histories", "--jobs", jobs, "--out", jobs]);
    }
    let files = bench.tree("1");
    for name in [
        "friction/map.png",
        "friction/history.svg",
        "friction/history.pdf",
        "bars/r.png",
        "bars/results.csv",
        "bars/histories/5.csv",
    ] {
        assert!(files.iter().any(|file| file == name), "{name} in {files:?}");
    }
    for jobs in ["2", "7"] {
        assert_eq!(files, bench.tree(jobs));
        for file in &files {
            let read = |jobs: &str| fs::read(bench.path(jobs).join(file)).unwrap();
            assert!(read("1") == read(jobs), "{file} with {jobs} threads");
        }
    }
}

/// QEMU has no AVX-512, and `qemu64` neither AVX2 nor AVX. `make platforms` compares more studies, and other processors.
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
#[test]
fn with_avx2_and_with_sse2_alone() {
    const QEMU: &str = "qemu-x86_64";
    let found = |folder: std::path::PathBuf| Some(folder.join(QEMU)).filter(|file| file.exists());
    let path = std::env::var_os("PATH").unwrap_or_default();
    let Some(qemu) = std::env::split_paths(&path).find_map(found) else {
        eprintln!("no {QEMU} is installed: other processors were not tried");
        return;
    };
    let bench = Bench::new();
    let studies = [
        "friction-fig6",
        "impact-fig4",
        "structures/structure-oblique-impact",
    ];
    let root = concat!(env!("SLIPGAP_ROOT"), "/studies");
    let studies = studies.map(|name| format!("{root}/{name}.json"));
    let run = |command: &mut Command, out: &str| {
        command.arg("run").args(&studies).args(["--out", out]);
        let done: crate::Done = command.output().unwrap().into();
        assert_eq!(done.code, Some(0), "{out}: {done:?}");
    };
    run(&mut bench.command(), "native");
    let files = bench.everything("native");
    assert!(files.iter().any(|file| file.ends_with(".parquet")));
    for processor in ["max", "qemu64"] {
        let mut command = bench.command_of(&qemu);
        let program = env!("CARGO_BIN_EXE_slipgap-tested");
        run(command.args(["-cpu", processor, program]), processor);
        assert_eq!(files, bench.everything(processor));
        for file in &files {
            let read = |out: &str| fs::read(bench.path(out).join(file)).unwrap();
            assert!(read("native") == read(processor), "{file}: {processor}");
        }
    }
}
