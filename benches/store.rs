//! A chunk of cases from its numbers to its file: what a run does beside computing.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use indicatif::ProgressBar;
use slipgap::batch::{self, Wishes, store::Store};
use slipgap::study::parse;

/// Cases of so few steps that hardly anything is computed.
const CASES: u64 = 65_536;

fn store(criterion: &mut Criterion) {
    let text = format!(
        r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "x0": 12, "duration": 1, "dT": 1,
        "beta": {{"geomspace": [0.01, 10, {CASES}]}}}}}}"#
    );
    let study = parse("bench.json", &text).expect("a study without faults");
    let folder = tempfile::tempdir().expect("a folder");
    let mut group = criterion.benchmark_group("store");
    group
        .sample_size(10)
        .throughput(Throughput::Elements(CASES));
    for (name, anew) in [("written", true), ("found", false)] {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let store = Store::open(folder.path()).expect("a store");
                let wishes = Wishes {
                    store: Some(&store),
                    anew,
                    ..Wishes::METRICS
                };
                let mut cases = 0;
                batch::run(&study, &ProgressBar::hidden(), &wishes, |done| {
                    cases += done.len();
                    Ok(())
                })
                .expect("a run");
                cases
            });
        });
    }
    group.finish();
}

criterion_group!(benches, store);
criterion_main!(benches);
