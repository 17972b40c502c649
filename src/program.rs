//! The program: reads the command line, runs the verb, gives its exit code.

use crate::commands::{self, Verb};
use crate::error::Error;
use clap::{Command, CommandFactory, FromArgMatches, Parser};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

/// Parameter studies of friction and impact models in time-history analysis.
#[derive(Parser)]
#[command(name = "slipgap", bin_name = "slipgap", after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

const EXIT_CODES: &str = "Exit codes: 0 success; 1 internal error or I/O error; 2 mistake on the command line or in a study; 3 a case could not be solved; \
4 parts of a merge are missing; 5 a check is not met, a warning is denied, a verdict differs from the recorded one, results differ, or no case reaches the target; 130 interrupted.";

/// Does what the command line of the process says, and returns the exit code. `version` is what `--version` prints.
pub fn main(version: &'static str) -> ExitCode {
    let program = || Cli::command().version(version);
    let mut matches = program().get_matches();
    let cli = Cli::from_arg_matches_mut(&mut matches);
    let verb = cli.unwrap_or_else(|fault| fault.exit()).verb;
    // A panic ends as any other error does: one message, exit code 1.
    let result = catch_unwind(AssertUnwindSafe(|| execute(verb, program))).unwrap_or_else(|_| {
        let what = "internal error of slipgap; please report it";
        Err(Error::Internal(what.into()))
    });
    ExitCode::from(result.unwrap_or_else(|error| {
        commands::terminal::report_error(&error);
        commands::exit_code(&error)
    }))
}

/// Runs the verb and returns its exit code.
fn execute(verb: Verb, program: impl FnOnce() -> Command) -> Result<u8, Error> {
    commands::exit_on_interrupt()?;
    verb.execute(program)
}
