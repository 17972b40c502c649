//! `slipgap schema`: the schema of study files, or a page about them.

use crate::commands::terminal::print;
use crate::error::Error;
use crate::study;
use clap::Args;
use clap::builder::PossibleValuesParser;

/// The arguments of `slipgap schema`.
#[derive(Args)]
pub struct SchemaArgs {
    /// Print the page docs/study-files.md instead of the schema, or docs/study-files-PROBLEM.md
    #[arg(long, value_name = "PROBLEM", num_args = 0..=1, value_parser = PossibleValuesParser::new(study::problem_pages()))]
    #[expect(
        clippy::option_option,
        reason = "clap's type of an option whose value may be left out"
    )]
    markdown: Option<Option<String>>,
}

impl SchemaArgs {
    /// Prints the schema or a page; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let page = match self.markdown {
            None => Some(study::schema()),
            Some(None) => Some(study::reference()),
            Some(Some(problem)) => study::problem_reference(&problem),
        };
        print(&page.unwrap_or_default())
    }
}
