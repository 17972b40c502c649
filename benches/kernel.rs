//! The speed of the solver: steps and default metrics of many cases in lanes and one at a time. `slipgap-guard rates` measures
//! the rate of additions, which is the limit of both.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use slipgap::problem::Case;
use slipgap::study::{Study, parse};
use std::hint::black_box;

fn study(parameters: &str) -> Study {
    let text = format!("{{{parameters}}}");
    parse("bench.json", &text).expect("a study without faults")
}

/// Oscillators released at x0 = 12, with `steps` steps up to 8 pi.
fn oscillators(law: &str, width: &str, steps: u64, cases: u64) -> Study {
    study(&format!(
        r#""problem": "friction-oscillator", "parameters": {{"law": "{law}", "x0": 12, "duration": "8*pi",
        "dT": "8*pi/{steps}", "{width}": {{"geomspace": [0.01, 10, {cases}]}}}}"#
    ))
}

/// Like bars of n elements, 300 steps.
fn bars(n: u64, cases: u64) -> Study {
    study(&format!(
        r#""problem": "bar-impact", "parameters": {{"n": {n}, "dt": 0.005, "duration": 1.5,
        "gamma": {{"geomspace": [0.1, 10, {cases}]}}}}"#
    ))
}

/// Steps of a case, or steps times modes of both bars.
fn work(study: &Study) -> u64 {
    study
        .cases()
        .map(|case| study.problem.work(&case, &[]).steps)
        .sum()
}

fn sweep(criterion: &mut Criterion) {
    slipgap::batch::keep_memory();
    let mut group = criterion.benchmark_group("sweep");
    group.sample_size(20);
    let of = |law: &str, steps| match law {
        "displacement-control" => oscillators(law, "alpha", steps, 4096),
        _ => oscillators(law, "beta", steps, 4096),
    };
    for (name, study) in [
        ("displacement-control 80", of("displacement-control", 80)),
        (
            "displacement-control 2500",
            of("displacement-control", 2500),
        ),
        ("velocity-control 80", of("velocity-control", 80)),
        ("velocity-control 2500", of("velocity-control", 2500)),
        ("bars 10", bars(10, 4096)),
        ("bars 40", bars(40, 4096)),
        ("bars 100", bars(100, 512)),
        ("bars 1000", bars(1000, 64)),
        ("bars 10000", bars(10_000, 16)),
    ] {
        let (_, cases) = study.columns(0, study.raw_len());
        let rows: Vec<u32> = (0..cases.len() as u32).collect();
        group.throughput(Throughput::Elements(work(&study)));
        group.bench_function(BenchmarkId::new("metrics", name), |bencher| {
            bencher.iter(|| study.problem.sweep(&cases, &rows));
        });
    }
    group.finish();
}

/// One case at a time, each with its history.
fn case(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("case");
    group.sample_size(20);
    for (name, study) in [
        (
            "displacement-control 80",
            oscillators("displacement-control", "alpha", 80, 64),
        ),
        (
            "velocity-control 80",
            oscillators("velocity-control", "beta", 80, 64),
        ),
        ("bars 10", bars(10, 64)),
        ("bars 40", bars(40, 64)),
    ] {
        let cases: Vec<Case> = study.cases().collect();
        group.throughput(Throughput::Elements(work(&study)));
        group.bench_function(BenchmarkId::new("alone", name), |bencher| {
            bencher.iter(|| {
                for case in &cases {
                    drop(black_box(study.problem.solve(case, &[])));
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, sweep, case);
criterion_main!(benches);
