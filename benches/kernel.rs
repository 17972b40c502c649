//! The sweep's own work: steps and default metrics of many cases side by side, against the add rate of this machine.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use slipgap::problem::Case;
use slipgap::study::{Study, parse};

/// Cases of one benchmark: whole groups of lanes.
const CASES: u64 = 4096;

fn study(parameters: &str) -> Study {
    let text = format!("{{{parameters}}}");
    parse("bench.json", &text).expect("a study without faults")
}

fn sweep(criterion: &mut Criterion) {
    slipgap::batch::keep_memory();
    let mut group = criterion.benchmark_group("sweep");
    group.sample_size(20);
    let oscillator = |law: &str, width: &str, steps: u64| {
        study(&format!(
            r#""problem": "friction-oscillator", "parameters": {{"law": "{law}", "x0": 12, "duration": "8*pi",
            "dT": "8*pi/{steps}", "{width}": {{"geomspace": [0.01, 10, {CASES}]}}}}"#
        ))
    };
    let bars = |n: u64| {
        study(&format!(
            r#""problem": "bar-impact", "parameters": {{"n": {n}, "dt": 0.005, "duration": 1.5,
            "gamma": {{"geomspace": [0.1, 10, {CASES}]}}}}"#
        ))
    };
    for (name, study, per_case) in [
        (
            "displacement-control 80",
            oscillator("displacement-control", "alpha", 80),
            80,
        ),
        (
            "velocity-control 80",
            oscillator("velocity-control", "beta", 80),
            80,
        ),
        (
            "displacement-control 2500",
            oscillator("displacement-control", "alpha", 2500),
            2500,
        ),
        ("bars 10", bars(10), 300 * 22),
        ("bars 40", bars(40), 300 * 82),
        ("bars 400", bars(400), 300 * 802),
    ] {
        let cases: Vec<Case> = study.cases().collect();
        let cases: Vec<&Case> = cases.iter().collect();
        group.throughput(Throughput::Elements(CASES * per_case));
        group.bench_function(BenchmarkId::new("metrics", name), |bencher| {
            bencher.iter(|| study.problem.sweep(&cases));
        });
    }
    group.finish();
}

criterion_group!(benches, sweep);
criterion_main!(benches);
