//! The time of a run without computing, from case numbers to files, and the time for writing the same columns without
//! encoding.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use indicatif::ProgressBar;
use parquet::basic::{Compression, Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use slipgap::batch::{self, PartResult, RunOptions, store::Store};
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::table::cases::Column;
use slipgap::study::{Study, parse};
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// Number of cases, each of one step.
const CASES: u64 = 65_536;

/// Bytes of a raw page.
const PAGE: usize = 1 << 16;

fn study() -> Study {
    let text = format!(
        r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "x0": 12, "duration": 1, "dT": 1,
        "beta": {{"geomspace": [0.01, 10, {CASES}]}}}}}}"#
    );
    parse("bench.json", &text).expect("a study without faults")
}

/// Runs the study; `take` receives its parts.
fn run(study: &Study, options: &RunOptions, mut take: impl FnMut(PartResult) + Send) {
    let bar = ProgressBar::hidden();
    batch::run(study, &bar, options, |part| {
        take(part);
        Ok(())
    })
    .expect("a run");
}

fn store(criterion: &mut Criterion) {
    let study = study();
    let folder = tempfile::tempdir().expect("a folder");
    let mut group = criterion.benchmark_group("store");
    group
        .sample_size(10)
        .throughput(Throughput::Elements(CASES));
    for (name, recompute) in [("written", true), ("found", false)] {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let store = Store::open(folder.path()).expect("a store");
                let options = RunOptions {
                    store: Some(&store),
                    recompute,
                    ..RunOptions::METRICS
                };
                let mut cases = 0;
                run(&study, &options, |part| cases += part.len());
                cases
            });
        });
    }
    group.bench_function("computed only", |bencher| {
        bencher.iter(|| {
            let mut cases = 0;
            run(&study, &RunOptions::METRICS, |part| cases += part.len());
            cases
        });
    });
    let mut chunks = Vec::new();
    run(&study, &RunOptions::METRICS, |part| {
        chunks.push(numbers(&study, &part));
    });
    group.bench_function("raw", |bencher| {
        bencher.iter(|| {
            for (i, columns) in chunks.iter().enumerate() {
                raw(columns, &folder.path().join(format!("{i}.parquet")));
            }
        });
    });
    group.finish();
}

/// All columns of a part as numbers: 0 for a name, NaN for no value.
fn numbers(study: &Study, part: &PartResult) -> Vec<Vec<f64>> {
    let case = (part.first..).take(part.len()).map(|number| number as f64);
    let mut columns: Vec<Vec<f64>> = vec![case.collect()];
    for column in part.cases.columns() {
        let of = |value: &Option<Value>| value.map_or(f64::NAN, |v| v.as_f64().unwrap_or(0.0));
        columns.push(match column {
            Column::Same(value) => vec![of(value); part.len()],
            Column::Each(cells) => (0..part.len()).map(|row| of(&cells.at(row))).collect(),
        });
    }
    for metric in &study.metrics {
        let values = part.metrics.column(*metric);
        columns.push(values.map(|x| x.unwrap_or(f64::NAN)).collect());
    }
    columns
}

/// Writes columns as one part, without dictionaries, compression and statistics.
fn raw(columns: &[Vec<f64>], path: &Path) {
    let field = |i: usize| {
        let built = Type::primitive_type_builder(&format!("column{i}"), Physical::DOUBLE)
            .with_repetition(Repetition::REQUIRED)
            .build();
        Arc::new(built.expect("a type"))
    };
    let fields = (0..columns.len()).map(field).collect();
    let schema = Type::group_type_builder("raw").with_fields(fields).build();
    let properties = WriterProperties::builder()
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::None)
        .set_compression(Compression::UNCOMPRESSED)
        .set_data_page_size_limit(PAGE)
        .build();
    let out = File::create(path).expect("a file");
    let schema = Arc::new(schema.expect("a schema"));
    let mut file = SerializedFileWriter::new(out, schema, properties.into()).expect("a writer");
    let mut rows = file.next_row_group().expect("rows");
    for column in columns {
        let mut writer = rows.next_column().expect("a column").expect("a column");
        let typed = writer.typed::<DoubleType>();
        typed.write_batch(column, None, None).expect("written");
        writer.close().expect("written");
    }
    rows.close().expect("written");
    file.close().expect("written");
}

criterion_group!(benches, store);
criterion_main!(benches);
