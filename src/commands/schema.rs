//! `slipgap schema`: the schema of study files, or the page about them.

use super::terminal::print;
use clap::Args;
use slipgap::error::Error;
use slipgap::study;

/// The arguments of `slipgap schema`.
#[derive(Args)]
pub struct SchemaArgs {
    /// Print the page docs/study-files.md instead of the schema
    #[arg(long)]
    markdown: bool,
}

impl SchemaArgs {
    /// Prints the schema or the page; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        print(&match self.markdown {
            true => study::reference(),
            false => study::schema(),
        })
    }
}
