//! `slipgap sbatch`: a script that submits the shards of a study to Slurm as an array, and the merge.
//!
//! The paths and numbers are variables at its beginning. The rest is the same for every study.

mod time;

pub use time::TimeLimit;

use super::sources::{DASH, read};
use super::terminal::print;
use slipgap::error::Error;
use slipgap::study::{MOST_CASES, Setting, unprintable};
use std::path::{Path, PathBuf, absolute};

const SUBMIT: &str = include_str!("submit.sh");
const ARRAY: &str = include_str!("array.sh");
const ARRAY_REQUEUED: &str = include_str!("array_requeued.sh");
const MERGE: &str = include_str!("merge.sh");

/// Seconds of the shortest task that can requeue itself: Slurm sends the signal 60 s before the end, or up to 60 s earlier, and
/// the task must have some time to compute.
const SHORTEST_REQUEUED: u64 = 180;

/// What the script submits.
pub struct SbatchArgs {
    /// The study file or folder.
    pub study: PathBuf,
    /// Folder of the results.
    pub out: PathBuf,
    /// Largest number of raw combinations.
    pub limit: u64,
    /// Number of shards.
    pub shards: u32,
    /// Time limit of a task and of the merge.
    pub time: Option<TimeLimit>,
    /// Partition of the cluster.
    pub partition: Option<String>,
    /// Whether a task requeues itself before its time is over.
    pub requeue: bool,
}

/// Prints the script, after the studies were read with these settings; returns the exit code.
pub fn sbatch(args: &SbatchArgs, settings: &[Setting]) -> Result<u8, Error> {
    if args.study == Path::new(DASH) {
        let what = "the tasks cannot read standard input; give a study file or a folder";
        return Err(Error::Usage(what.into()));
    }
    let short = args
        .time
        .as_ref()
        .filter(|time| time.seconds() < SHORTEST_REQUEUED);
    if let Some(time) = short.filter(|_| args.requeue) {
        return Err(Error::Usage(format!(
            "--time {time} is too short for --requeue; at least 00:03:00 is allowed"
        )));
    }
    // A mistake in a study is reported now, not by every task.
    read(std::slice::from_ref(&args.study), settings, args.limit)?;
    print(&script(args, settings)?)
}

/// The script, with `--set` for each setting.
fn script(args: &SbatchArgs, settings: &[Setting]) -> Result<String, Error> {
    let stem = args.study.file_stem().unwrap_or_default();
    let name = format!("slipgap-{}", stem.to_string_lossy());
    let program = std::env::current_exe().map_err(Error::io("cannot find", "slipgap"))?;
    let mut arguments = vec![full(&args.study)?, "--out".into(), full(&args.out)?];
    for setting in settings {
        arguments.extend(["--set".into(), setting.text().to_owned()]);
    }
    if args.limit != MOST_CASES {
        arguments.extend(["--limit".into(), args.limit.to_string()]);
    }
    let time = args.time.as_ref().map(|time| format!("--time={time}"));
    let partition = args
        .partition
        .as_ref()
        .map(|name| format!("--partition={name}"));
    let options: Vec<String> = time.into_iter().chain(partition).collect();
    let array = if args.requeue { ARRAY_REQUEUED } else { ARRAY };
    Ok(format!(
        "#!/bin/bash
# Submits the shards of a study to Slurm, and the merge of their results.
#   bash SCRIPT              submits all shards
#   SHARDS=3,17 bash SCRIPT  submits only these shards
set -euo pipefail

name={}
slipgap={}
arguments=({})
shards={}
# Cores of a task.
cores=1
# Further options of sbatch, such as --account=NAME or --mem=4G.
options=({})
{SUBMIT}{array}{MERGE}",
        quoted(&name)?,
        quoted(&full(&program)?)?,
        words(&arguments)?,
        args.shards,
        words(&options)?,
    ))
}

/// A path from the root: the jobs may begin in another folder.
fn full(path: &Path) -> Result<String, Error> {
    let full = absolute(path).map_err(Error::io("cannot find", path))?;
    let text = full.to_str().map(String::from);
    text.ok_or_else(|| Error::Usage(format!("{}: must be UTF-8 text", path.display())))
}

/// Words of bash with spaces between them.
fn words(texts: &[String]) -> Result<String, Error> {
    let words: Vec<String> = texts
        .iter()
        .map(|text| quoted(text))
        .collect::<Result<_, _>>()?;
    Ok(words.join(" "))
}

/// One word of bash, whatever it contains, if it can be printed.
fn quoted(text: &str) -> Result<String, Error> {
    match unprintable(text) {
        None => Ok(format!("'{}'", text.replace('\'', r"'\''"))),
        Some(c) => Err(Error::Usage(format!(
            "{}: cannot contain {c} in a script; rename it",
            slipgap::study::printable(text)
        ))),
    }
}

#[cfg(test)]
mod tests;
