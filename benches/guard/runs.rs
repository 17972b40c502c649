//! The instructions of whole runs, from the study file to the store and to results.csv.

use crate::count::{instructions, is_near};
use rayon::prelude::*;
use std::fs;
use std::path::Path;

/// A run of the program.
struct Run {
    name: &'static str,
    /// The keys of a study; `CASES` is the number of values along the second axis.
    study: &'static str,
    /// Numbers of cases of two runs. What the program does once is in both.
    cases: [u64; 2],
    /// The format of the results.
    format: &'static str,
    /// Recorded number of instructions for each case (AVX2, the widest instructions of valgrind).
    recorded: u64,
}

/// Number of values along the first axis.
const AXIS: u64 = 16;

const OSCILLATORS: &str = r#""problem": "friction-oscillator", "parameters": {"law": "displacement-control",
    "x0": {"linspace": [8, 20, 16]}, "dT": "pi/10", "duration": "8*pi", "alpha": {"geomspace": [0.01, 10, CASES]}}"#;

const RUNS: [Run; 5] = [
    Run {
        name: "run of oscillators",
        study: OSCILLATORS,
        cases: [16_384, 49_152],
        format: "parquet",
        recorded: 1677,
    },
    Run {
        name: "run of oscillators with results.csv",
        study: OSCILLATORS,
        cases: [4096, 8192],
        format: "csv",
        recorded: 16_961,
    },
    Run {
        name: "run of bars, n = 10",
        study: r#""problem": "bar-impact", "parameters": {"n": 10, "dt": 0.005, "duration": 1.5,
            "gap": {"linspace": [0, 0.1, 16]}, "gamma": {"geomspace": [0.1, 10, CASES]}}"#,
        cases: [1024, 3072],
        format: "parquet",
        recorded: 29_138,
    },
    Run {
        name: "run of bars, n = 40",
        study: r#""problem": "bar-impact", "parameters": {"n": 40, "dt": 0.005, "duration": 1.5,
            "gap": {"linspace": [0, 0.1, 16]}, "gamma": {"geomspace": [0.1, 10, CASES]}}"#,
        cases: [512, 1536],
        format: "parquet",
        recorded: 53_548,
    },
    Run {
        name: "run of structures",
        study: r#""problem": "structure", "parameters": {"gap": {"linspace": [0.01, 0.03, 16]},
            "scale": {"geomspace": [0.5, 2, CASES]}, "dt": 0.01, "duration": 2},
            "structure": {"masses": {"a|b": 1},
                "springs": [{"between": ["ground", "a"], "mass": 1, "period": 0.5, "ratio": 0.05},
                    {"between": ["ground", "b"], "mass": 1, "period": 0.9, "ratio": 0.05}],
                "contacts": {"gap": {"law": "impact", "between": ["a", "b"], "gap": "gap", "k": 1e4}},
                "ground": {"synthetic": {"seed": 1}, "scale": "scale"}},
            "metrics": ["peak(a)", "peak(b)", "peak(gap.S)", "impacts(gap)"]"#,
        cases: [256, 768],
        format: "parquet",
        recorded: 142_099,
    },
];

/// Whether the instructions of all runs are near the recorded ones.
pub fn are_near() -> bool {
    let count = |run: &Run| {
        let [few, many] = run.cases.map(|cases| run.instructions(cases));
        let [first, second] = run.cases;
        (many - few) as f64 / (second - first) as f64
    };
    let counts: Vec<f64> = RUNS.par_iter().map(count).collect();
    let near = RUNS
        .iter()
        .zip(counts)
        .map(|(run, each)| is_near(run.name, each, run.recorded));
    !near.collect::<Vec<_>>().contains(&false)
}

impl Run {
    /// Number of instructions of a run with so many cases on one thread.
    fn instructions(&self, cases: u64) -> i64 {
        let folder = tempfile::tempdir().expect("a folder for the results");
        let file = folder.path().join("sweep.json");
        let study = self.study.replace("CASES", &(cases / AXIS).to_string());
        fs::write(&file, format!("{{{study}}}")).expect("a file for the study");
        let args = ["run", "--jobs", "1", "--format", self.format, "--out"]
            .map(Path::new)
            .into_iter()
            .chain([folder.path(), &file]);
        // The release build of the program stands beside this one.
        let guard = std::env::current_exe().expect("this program has a path");
        let program = guard.with_file_name("slipgap");
        instructions(&program, args)
    }
}
