//! The verbs of the command line, one file or folder each, with their arguments.

mod animate;
mod arguments;
mod calibrate;
mod claims;
mod compare;
mod describe;
mod explain;
mod init;
mod list;
mod recommend;
mod report;
mod request;
mod runs;
pub mod terminal;

use crate::batch::files::atomic::stop_writing;
use crate::error::Error;
use clap::{Command, Subcommand};
use describe::completions::CompletionsArgs;
use describe::man::ManArgs;
use describe::schema::SchemaArgs;
use runs::check::CheckArgs;
use runs::merge::MergeArgs;
use runs::run::RunArgs;
use runs::sbatch::SbatchArgs;
use runs::status::StatusArgs;
use terminal::note;

/// Exit code if a case could not be solved.
pub const UNSOLVED: u8 = 3;
/// Exit code if a check is not met.
pub const NOT_MET: u8 = 5;
/// Exit code if parts of a merge are missing.
pub const PARTS_MISSING: u8 = 4;
/// Exit code after Ctrl-C.
const INTERRUPTED: u8 = 130;

/// The exit code of a command that failed: 2 for usage and studies, 1 for what has no code of its own.
pub fn exit_code(error: &Error) -> u8 {
    match error {
        Error::Faults(_) | Error::Usage(_) => 2,
        Error::Unsolved(_) => UNSOLVED,
        Error::PartsMissing(_) => PARTS_MISSING,
        Error::Interrupted => INTERRUPTED,
        Error::Io { .. } | Error::Busy(_) | Error::Internal(_) => 1,
    }
}

/// What the program does.
#[derive(Subcommand)]
pub enum Verb {
    /// Write a small study with remarks to studies/NAME.json, as a start
    Init(init::InitArgs),
    /// Run studies; write results.csv and figures to one folder for each study
    Run(RunArgs),
    /// Write the results of studies whose cases `run --shard` has computed; compute none
    Merge(MergeArgs),
    /// Print a script that submits the shards of a study to Slurm as an array, and then the merge
    Sbatch(SbatchArgs),
    /// Show how far studies are that run here or on other machines: cases done and failed, rate and time left of each shard
    Status(StatusArgs),
    /// Run studies and test their checks; write no files
    Check(CheckArgs),
    /// Show studies with their axes, cases and steps; compute nothing
    List(list::ListArgs),
    /// Show one case of a study: parameters, steps, cost and estimated time
    Explain(explain::ExplainArgs),
    /// Compare two folders of results and show the differences of each metric, the largest first
    Compare(compare::CompareArgs),
    /// Write one page about studies, with figures, checks, claims, and tables to sort and filter; the page needs no other file
    Report(report::ReportArgs),
    /// Write one page that shows a case in motion, or two cases side by side; the page needs no other file
    Animate(animate::AnimateArgs),
    /// Test the statements of the papers and of the literature by studies, print the verdicts and write claims.md
    Claims(claims::ClaimsArgs),
    /// Find the cheapest parameters that reach a target; show the errors and the alternatives
    Recommend(recommend::RecommendArgs),
    /// Find the values of free parameters with which a study comes nearest to what was measured
    Calibrate(calibrate::CalibrateArgs),
    /// Print the JSON schema of study files
    Schema(SchemaArgs),
    /// Print a script with which a shell completes verbs and options
    Completions(CompletionsArgs),
    /// Write the manual pages slipgap.1, slipgap-run.1 and so on to a folder
    Man(ManArgs),
}

impl Verb {
    /// Does it and returns the exit code. Some verbs describe the whole `program`.
    pub fn execute(self, program: impl FnOnce() -> Command) -> Result<u8, Error> {
        match self {
            Verb::Init(args) => args.execute(),
            Verb::Run(args) => args.execute(),
            Verb::Merge(args) => args.execute(),
            Verb::Sbatch(args) => args.execute(),
            Verb::Status(args) => args.execute(),
            Verb::Check(args) => args.execute(),
            Verb::List(args) => args.execute(),
            Verb::Explain(args) => args.execute(),
            Verb::Compare(args) => args.execute(),
            Verb::Report(args) => args.execute(),
            Verb::Animate(args) => args.execute(),
            Verb::Claims(args) => args.execute(),
            Verb::Recommend(args) => args.execute(),
            Verb::Calibrate(args) => args.execute(),
            Verb::Schema(args) => args.execute(),
            Verb::Completions(args) => args.execute(program()),
            Verb::Man(args) => args.execute(program()),
        }
    }
}

/// Makes Ctrl-C end the program at once, without incomplete files.
pub fn exit_on_interrupt() -> Result<(), Error> {
    ctrlc::set_handler(|| {
        let _guard = stop_writing();
        note("slipgap: interrupted; all files are complete; a run keeps its finished parts, and the same command continues it");
        std::process::exit(INTERRUPTED.into());
    })
    .map_err(|e| Error::Internal(format!("cannot listen for Ctrl-C: {e}")))
}
