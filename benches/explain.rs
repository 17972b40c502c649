//! The time that `explain` estimates for each shipped study over the time that its cases take, both of the processors.

use indicatif::ProgressBar;
use slipgap::batch::solve::cost::{measure, processor_time, sampling, total};
use slipgap::batch::{self, RunOptions};
use slipgap::problem::Case;
use slipgap::run::Source;
use slipgap::study_figures;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// As `explain` measures.
const MEASURING: Duration = slipgap::batch::solve::cost::MEASURING;

/// Studies below this time are not judged: their start takes as long.
const SHORT: f64 = 0.02;

fn main() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies");
    let entries = walkdir::WalkDir::new(folder).into_iter().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.into_path()).collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "json"));
    files.sort();
    println!("| Study | Estimated s | Needed s | Ratio |");
    println!("| --- | ---: | ---: | ---: |");
    let mut outside = Vec::new();
    for file in files {
        // A study read anew makes its signals anew.
        let read = || Source::read(&file, &[], u64::MAX).expect("a study without faults");
        let (estimated, needed) = (estimate(&read()), needed(&read()));
        let (Some(estimated), Some(needed)) = (estimated, needed) else {
            println!("The system does not tell the time of the processors.");
            return;
        };
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let ratio = estimated / needed;
        println!("| {name} | {estimated:.2} | {needed:.2} | {ratio:.2} |");
        if needed > SHORT && !(0.5..=2.0).contains(&ratio) {
            outside.push(format!("{name} {ratio:.2}"));
        }
    }
    println!("\nnot within a factor of 2: {}", outside.join(", "));
}

/// Seconds of one processor that `explain` estimates.
fn estimate(source: &Source) -> Option<f64> {
    let study = &source.study;
    let total = total(study);
    let case = study.case(0)?;
    let keep = |case: &Case| study_figures::show_history(study, case);
    let options = RunOptions {
        keep_history: study_figures::show_histories(study).then_some(&keep),
        ..RunOptions::METRICS
    };
    let measured = measure(study, total, &options, (&case, MEASURING, u64::MAX)).ok()?;
    let seconds = measured.seconds_for(total + sampling(study))?;
    Some(seconds * measured.threads as f64)
}

/// Seconds of one processor that all cases take.
fn needed(source: &Source) -> Option<f64> {
    let study = &source.study;
    let keep = |case: &Case| study_figures::show_history(study, case);
    let options = RunOptions {
        keep_history: study_figures::show_histories(study).then_some(&keep),
        ..RunOptions::METRICS
    };
    let before = processor_time()?;
    let bar = ProgressBar::hidden();
    batch::run(study, &bar, &options, |_| Ok(())).ok()?;
    Some(processor_time()? - before)
}
