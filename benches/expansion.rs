//! The time for making a million cases of a study from their numbers.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use slipgap::study::{Study, parse};

/// Number of cases that a run makes at a time.
const CHUNK: u64 = 16_384;

/// A grid of 1000 x 1000 cases, with further parameters and keys.
fn study(parameters: &str, keys: &str) -> Study {
    let text = format!(
        r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "duration": "8*pi",
        "x0": {{"linspace": [1, 20, 1000]}}, "dT": {{"geomspace": [0.01, 0.5, 1000]}}, {parameters}}}{keys}}}"#
    );
    parse("bench.json", &text).expect("a study without faults")
}

fn expansion(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("expansion");
    group
        .sample_size(10)
        .throughput(Throughput::Elements(1_000_000));
    for (name, parameters, keys) in [
        ("grid", r#""beta": 0.1"#, ""),
        ("expression", r#""beta": "dT/2 + 0.01""#, ""),
        (
            "condition",
            r#""beta": 0.1"#,
            r#", "when": "dT < 0.45 or x0 > 2""#,
        ),
    ] {
        let study = study(parameters, keys);
        group.bench_function(BenchmarkId::new("cases", name), |bencher| {
            bencher.iter(|| {
                let starts = (0..study.raw_len()).step_by(CHUNK as usize);
                starts
                    .map(|from| study.columns(from, from + CHUNK).1.len())
                    .sum::<usize>()
            });
        });
    }
    group.bench_function("reading", |bencher| {
        bencher.iter(|| study(r#""beta": 0.1"#, "").raw_len());
    });
    group.finish();
}

criterion_group!(benches, expansion);
criterion_main!(benches);
