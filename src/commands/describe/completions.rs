//! `slipgap completions`: what a shell needs to complete verbs and options.

use crate::commands::terminal::print;
use crate::error::Error;
use clap::{Args, Command};
use clap_complete::{Shell, generate};

/// The arguments of `slipgap completions`.
#[derive(Args)]
pub struct CompletionsArgs {
    /// The shell
    shell: Shell,
}

impl CompletionsArgs {
    /// Prints the script of the shell; returns the exit code.
    pub fn execute(self, mut program: Command) -> Result<u8, Error> {
        let name = program.get_name().to_owned();
        let mut script = Vec::new();
        generate(self.shell, &mut program, name, &mut script);
        print(&String::from_utf8_lossy(&script))
    }
}
