//! The `slipgap` program: reads the command line, runs the verb, ends with its exit code.

mod commands;
mod version;

use clap::{CommandFactory, Parser};
use commands::Verb;
use slipgap::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use version::VERSION;

/// Parameter studies of friction and impact models in time-history analysis.
#[derive(Parser)]
#[command(version = VERSION.as_str(), after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

const EXIT_CODES: &str = "Exit codes: 0 success; 1 internal error or I/O error; 2 mistake on the command line or in a study; 3 a case could not be solved; \
4 parts of a merge are missing; 5 a check is not met, a warning is denied, a verdict differs from the recorded one, results differ, or no case reaches the target; 130 interrupted.";

fn main() -> ExitCode {
    let verb = Cli::parse().verb;
    // A panic ends as any other error does: one message, exit code 1.
    let result = catch_unwind(AssertUnwindSafe(|| execute(verb))).unwrap_or_else(|_| {
        let what = "internal error of slipgap; please report it";
        Err(Error::Internal(what.into()))
    });
    ExitCode::from(result.unwrap_or_else(|error| {
        commands::terminal::report_error(&error);
        commands::exit_code(&error)
    }))
}

/// Runs the verb and returns its exit code.
fn execute(verb: Verb) -> Result<u8, Error> {
    commands::exit_on_interrupt()?;
    verb.execute(Cli::command)
}
