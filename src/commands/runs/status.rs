//! `slipgap status`: how far studies are that run here, on other machines or on a cluster.

use crate::batch::output::{differences, of_others};
use crate::batch::status::{MOST_SHARDS, Progress, State, StudyStatus, study_status};
use crate::commands::arguments::sources::Source;
use crate::commands::arguments::{JobsArgs, StudiesArgs, results_folder, whole};
use crate::commands::terminal::{duration, note, print, table};
use crate::error::Error;
use clap::Args;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Most processes with another clock that are named.
const MOST_NAMED: usize = 5;

/// The arguments of `slipgap status`.
#[derive(Args)]
pub struct StatusArgs {
    #[command(flatten)]
    studies: StudiesArgs,
    /// Folder of the results, in which the runs or shards have their stores
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    /// Number of shards; if left out, that of the shards that run
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1, MOST_SHARDS))]
    shards: Option<u64>,
    /// Print one object of JSON a line for each study
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    jobs: JobsArgs,
}

impl StatusArgs {
    /// Shows how far the studies are; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let studies = self.studies.read()?;
        self.jobs
            .run(|| status(&studies, &self.out, self.shards, self.json))
    }
}

/// Prints how far every study is; returns the exit code.
fn status(sources: &[Source], out: &Path, shards: Option<u64>, as_json: bool) -> Result<u8, Error> {
    let mut rows = vec![
        [
            "study", "shard", "state", "cases", "done", "failed", "rate", "left",
        ]
        .map(String::from)
        .to_vec(),
    ];
    let mut lines = String::new();
    for source in sources {
        let results = out.join(&source.name);
        let status = study_status(&source.study, &results, shards)?;
        if let Some((count, why)) = status.outdated {
            let parts = if count == 1 { "part" } else { "parts" };
            note(&source.line(&format!("{count} {parts} of another version: {why}")));
        }
        if let Some((count, path)) = &status.damaged {
            let parts = if *count == 1 { "part" } else { "parts" };
            let what = format!(
                "{count} {parts} damaged or unreadable, such as {}; run their shards again",
                path.display()
            );
            note(&source.line(&what));
        }
        for (shard, ahead) in status.ahead.iter().take(MOST_NAMED) {
            let process = shard.map_or("a run".into(), |shard| format!("shard {shard}"));
            let ahead = duration(ahead.as_secs_f64());
            let what = format!(
                "the last sign of {process} is {ahead} ahead of the clock of this machine; whether it runs is not known: set the clocks"
            );
            note(&source.line(&what));
        }
        let differences = differences(&results, &source.study);
        if !differences.is_empty() {
            note(&source.line(&of_others(&results, &differences)));
        }
        if as_json {
            let mut object = json_of(source, &status);
            object["results_of"] = differences.into();
            lines += &format!("{object}\n");
            continue;
        }
        let by_shard = status.shards.iter();
        let shards = by_shard.map(|(shard, progress)| row(source, shard.to_string(), progress));
        rows.extend(shards.chain([row(source, "all".into(), &status.all)]));
    }
    print(&if as_json { lines } else { table(&rows) })
}

fn row(source: &Source, shard: String, progress: &Progress) -> Vec<String> {
    let quiet = duration(progress.quiet.unwrap_or_default());
    let (state, unknown) = match progress.state() {
        State::Done => ("done".into(), "-"),
        State::Running if shard == "all" => (format!("{} running", progress.running), "?"),
        State::Running => ("running".into(), "?"),
        State::Stopped => (format!("not running for {quiet}"), "-"),
        State::NotBegun => ("not begun".into(), "-"),
    };
    let rate = progress.rate.map(|rate| match rate < 10.0 {
        true => format!("{rate:.2}/s"),
        false => format!("{rate:.0}/s"),
    });
    vec![
        source.name.clone(),
        shard,
        state,
        progress.cases.to_string(),
        progress.done.to_string(),
        progress.failed.to_string(),
        rate.unwrap_or(unknown.into()),
        progress.left.map_or(unknown.into(), duration),
    ]
}

fn json_of(source: &Source, status: &StudyStatus) -> Value {
    let mut object = json!({ "study": source.name });
    add(&mut object, &status.all);
    object["outdated_parts"] = status.outdated.map_or(0, |(count, _)| count).into();
    let shard = |(shard, progress): &(_, Progress)| {
        let mut object = json!({ "shard": format!("{shard}") });
        add(&mut object, progress);
        object
    };
    object["shards"] = status.shards.iter().map(shard).collect();
    object
}

fn add(object: &mut Value, progress: &Progress) {
    object["state"] = match progress.state() {
        State::Done => "done",
        State::Running => "running",
        State::Stopped => "not running",
        State::NotBegun => "not begun",
    }
    .into();
    object["cases"] = progress.cases.into();
    object["done"] = progress.done.into();
    object["failed"] = progress.failed.into();
    object["running"] = progress.running.into();
    object["cases_per_second"] = progress.rate.into();
    object["seconds_left"] = progress.left.into();
    object["seconds_since_last_sign"] = progress.quiet.into();
}
