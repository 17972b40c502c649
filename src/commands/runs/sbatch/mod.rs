//! `slipgap sbatch`: a script that submits the shards of a study to Slurm as an array, and the merge.
//!
//! The paths and numbers are variables at its beginning. The rest is the same for every study.

mod time;

use crate::batch::files::place::is_object;
use crate::commands::arguments::sources::{DASH, read};
use crate::commands::arguments::{ProgramsArgs, SettingsArgs, results_folder, whole};
use crate::commands::terminal::print;
use crate::error::Error;
use crate::run::found;
use crate::study::{MOST_CASES, unprintable};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;
use std::path::{Path, PathBuf, absolute};
use std::slice;
use time::TimeLimit;

const SUBMIT: &str = include_str!("submit.sh");
const ARRAY: &str = include_str!("array.sh");
const ARRAY_REQUEUED: &str = include_str!("array_requeued.sh");
const MERGE: &str = include_str!("merge.sh");

/// Seconds of the shortest task that can requeue itself: Slurm sends the signal 60 s before the end, or up to 60 s earlier, and
/// the task must have some time to compute.
const SHORTEST_REQUEUED: u64 = 180;

/// The arguments of `slipgap sbatch`.
#[derive(Args)]
pub struct SbatchArgs {
    /// Study file, or a folder with all sub-folders
    #[arg(value_name = "STUDY|FOLDER")]
    study: PathBuf,
    /// Number of shards, each a task of the array
    #[arg(long, value_name = "N", value_parser = whole::<u32>(1, u64::from(u32::MAX)))]
    shards: u32,
    /// Folder for the results, which all nodes must see
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    /// Time limit of a task and of the merge; if left out, that of the partition
    #[arg(long, value_name = "HH:MM:SS")]
    time: Option<TimeLimit>,
    /// Partition of the cluster; if left out, its default
    #[arg(long, value_name = "NAME", value_parser = NonEmptyStringValueParser::new())]
    partition: Option<String>,
    /// Let each task put itself into the queue again a minute before its time is over
    #[arg(long)]
    requeue: bool,
    /// Largest number of raw combinations in a study
    #[arg(long, value_name = "CASES", default_value_t = MOST_CASES, value_parser = whole::<u64>(0, u64::MAX))]
    limit: u64,
    #[command(flatten)]
    settings: SettingsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl SbatchArgs {
    /// Prints the script; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        sbatch(&self)
    }
}

/// Prints the script, after the studies were read; returns the exit code.
fn sbatch(args: &SbatchArgs) -> Result<u8, Error> {
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
    let read = read(slice::from_ref(&args.study), &args.settings.set, args.limit)?;
    args.programs.allow(read)?;
    print(&script(args)?)
}

/// The script.
fn script(args: &SbatchArgs) -> Result<String, Error> {
    let stem = args.study.file_stem().unwrap_or_default();
    let name = format!("slipgap-{}", stem.to_string_lossy());
    let program = std::env::current_exe().map_err(Error::io("cannot find", "slipgap"))?;
    let study = found(&args.study)?;
    let mut arguments = vec![full(&study)?, "--out".into(), full(&args.out)?];
    for setting in &args.settings.set {
        arguments.extend(["--set".into(), setting.text().to_owned()]);
    }
    if args.limit != MOST_CASES {
        arguments.extend(["--limit".into(), args.limit.to_string()]);
    }
    if args.programs.allow_programs {
        arguments.push("--allow-programs".into());
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
# The jobs begin here, so that the results of studies in the folder studies have the same names.
folder={}
slipgap={}
arguments=({})
shards={}
# Cores of a task.
cores=1
# Further options of sbatch, such as --account=NAME or --mem=4G.
options=({})
{SUBMIT}{array}{MERGE}",
        quoted(&name)?,
        quoted(&full(Path::new("."))?)?,
        quoted(&full(&program)?)?,
        words(&arguments)?,
        args.shards,
        words(&options)?,
    ))
}

/// A path from the root: the jobs may begin in another folder. An object store is the same from everywhere.
fn full(path: &Path) -> Result<String, Error> {
    let resolved = match is_object(path) {
        true => Ok(path.to_owned()),
        false => absolute(path),
    };
    let full = resolved.map_err(Error::io("cannot find", path))?;
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
            crate::study::printable(text)
        ))),
    }
}

#[cfg(test)]
mod tests;
