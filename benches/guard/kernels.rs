//! The instructions of sweeps without what is around them, and their speed beside cases one at a time.

use crate::count::{instructions, is_near};
use rayon::prelude::*;
use slipgap::problem::Case;
use slipgap::study::{Study, parse};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Sweeps, and the recorded number of instructions for each case (AVX2, the widest instructions of valgrind).
const SWEEPS: [(&str, &str, u64); 4] = [
    (
        "displacement-control",
        r#""problem": "friction-oscillator", "parameters": {"law": "displacement-control", "x0": 12, "dT": "pi/10",
            "duration": "8*pi", "alpha": {"geomspace": [0.01, 10, 1024]}}"#,
        1729,
    ),
    (
        "velocity-control",
        r#""problem": "friction-oscillator", "parameters": {"law": "velocity-control", "x0": 12, "dT": "pi/10",
            "duration": "8*pi", "beta": {"geomspace": [0.01, 10, 1024]}}"#,
        1729,
    ),
    (
        "bars",
        r#""problem": "bar-impact", "parameters": {"n": 10, "dt": 0.005, "duration": 1.5,
            "gamma": {"geomspace": [0.1, 10, 1024]}}"#,
        18304,
    ),
    (
        "unlike bars",
        r#""problem": "bar-impact", "parameters": {"n": 10, "dt": 0.005, "duration": 1.5, "right": {"A": 2, "n": 20},
            "gamma": {"geomspace": [0.1, 10, 1024]}}"#,
        34625,
    ),
];

/// Sweeps of other laws and methods, whose instructions are only counted.
const OTHERS: [(&str, &str, u64); 7] = [
    (
        "hht on displacement-control",
        r#""problem": "friction-oscillator", "parameters": {"law": "displacement-control", "method": "hht", "x0": 12,
            "dT": "pi/10", "duration": "8*pi", "alpha": {"geomspace": [0.1, 10, 1024]}}"#,
        2938,
    ),
    (
        "tanh",
        r#""problem": "friction-oscillator", "parameters": {"law": "tanh", "x0": 12, "dT": "pi/10", "duration": "8*pi",
            "beta": {"geomspace": [0.01, 10, 1024]}}"#,
        7785,
    ),
    (
        "lugre",
        r#""problem": "friction-oscillator", "parameters": {"law": "lugre", "x0": 12, "dT": "pi/10", "duration": "8*pi",
            "sigma0": {"geomspace": [0.1, 100, 1024]}}"#,
        9980,
    ),
    (
        "hht on bars",
        r#""problem": "bar-impact", "parameters": {"method": "hht", "n": 10, "dt": 0.005, "duration": 1.5,
            "gamma": {"geomspace": [0.1, 10, 1024]}}"#,
        29716,
    ),
    (
        "kelvin-voigt on bars",
        r#""problem": "bar-impact", "parameters": {"law": "kelvin-voigt", "restitution": 0.65, "n": 10, "dt": 0.005,
            "duration": 1.5, "gamma": {"geomspace": [0.1, 10, 1024]}}"#,
        35117,
    ),
    (
        "hunt-crossley on bars",
        r#""problem": "bar-impact", "parameters": {"law": "hunt-crossley", "restitution": 0.65, "n": 10, "dt": 0.005,
            "duration": 1.5, "gamma": {"geomspace": [0.1, 10, 1024]}}"#,
        46704,
    ),
    (
        "jankowski on bars",
        r#""problem": "bar-impact", "parameters": {"law": "jankowski", "restitution": 0.65, "n": 10, "dt": 0.005,
            "duration": 1.5, "gamma": {"geomspace": [0.1, 10, 1024]}}"#,
        61858,
    ),
];

/// Smallest quotient of the speeds of lanes and of single cases on AVX-512, much below the measured one.
const RATIO: f64 = 3.0;

fn study(text: &str) -> Study {
    parse("guard.json", &format!("{{{text}}}")).expect("a study without faults")
}

/// Runs a sweep so many times.
pub fn sweep(name: &str, times: u64) {
    let sweep = SWEEPS
        .iter()
        .chain(&OTHERS)
        .find(|sweep| sweep.0 == name)
        .expect("a sweep");
    let study = study(sweep.1);
    let (_, cases) = study.columns(0, study.raw_len());
    let rows: Vec<u32> = (0..cases.len() as u32).collect();
    for _ in 0..times {
        black_box(study.problem.sweep(&cases, &rows));
    }
}

/// Whether the instructions of all sweeps are near the recorded ones.
pub fn are_near() -> bool {
    let program = std::env::current_exe().expect("this program has a path");
    let kernels: Vec<(&str, &str, u64)> = SWEEPS.into_iter().chain(OTHERS).collect();
    let count = |(name, text, _): &(&str, &str, u64)| {
        // Both counts contain the work before the sweeps.
        let [one, two] = ["1", "2"].map(|times| instructions(&program, [name, times]));
        (two - one) as f64 / study(text).len() as f64
    };
    let counts: Vec<f64> = kernels.par_iter().map(count).collect();
    let near = kernels
        .iter()
        .zip(counts)
        .map(|((name, _, recorded), each)| is_near(name, each, *recorded));
    !near.collect::<Vec<_>>().contains(&false)
}

/// Whether lanes are faster than single cases by the ratio, if the processor has AVX-512.
pub fn ratios() -> bool {
    #[cfg(target_arch = "x86_64")]
    let wide = is_x86_feature_detected!("avx512f");
    #[cfg(not(target_arch = "x86_64"))]
    let wide = false;
    let mut good = true;
    for (name, text, _) in SWEEPS {
        let study = study(text);
        let cases: Vec<Case> = study.cases().collect();
        let (_, columns) = study.columns(0, study.raw_len());
        let rows: Vec<u32> = (0..columns.len() as u32).collect();
        // The best of several alternating measurements, because the speed of the machine varies.
        let (mut lanes, mut one) = (Duration::MAX, Duration::MAX);
        for _ in 0..7 {
            lanes = lanes.min(timed(|| {
                drop(black_box(study.problem.sweep(&columns, &rows)))
            }));
            one = one.min(timed(|| {
                for case in &cases {
                    drop(black_box(study.problem.solve(case, &[])));
                }
            }));
        }
        let ratio = one.as_secs_f64() / lanes.as_secs_f64();
        println!("{name}: side by side {ratio:.1} times as fast as one at a time");
        good &= !wide || ratio > RATIO;
    }
    good
}

fn timed(work: impl FnOnce()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}
