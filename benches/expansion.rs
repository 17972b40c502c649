//! How fast the cases of a study are made from their numbers: a million of them, none kept.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use slipgap::study::{Study, parse};

/// Cases that a run makes at a time.
const CHUNK: u64 = 16_384;

/// A thousand by a thousand, and what stands beside them.
fn study(parameters: &str, beside: &str) -> Study {
    let text = format!(
        r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "duration": "8*pi",
        "x0": {{"linspace": [1, 20, 1000]}}, "dT": {{"geomspace": [0.01, 0.5, 1000]}}, {parameters}}}{beside}}}"#
    );
    parse("bench.json", &text).expect("a study without faults")
}

fn expansion(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("expansion");
    group
        .sample_size(10)
        .throughput(Throughput::Elements(1_000_000));
    for (name, parameters, beside) in [
        ("grid", r#""beta": 0.1"#, ""),
        ("expression", r#""beta": "dT/2 + 0.01""#, ""),
        (
            "condition",
            r#""beta": 0.1"#,
            r#", "when": "dT < 0.45 or x0 > 2""#,
        ),
    ] {
        let study = study(parameters, beside);
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
