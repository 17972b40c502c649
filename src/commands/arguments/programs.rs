//! Whether a verb may start the programs of its studies: only where the command line says so.

use super::sources::Source;
use crate::batch::programs::allow;
use crate::error::Error;
use crate::study::Study;
use clap::Args;
use std::path::Path;

/// Whether the programs of studies may be started.
#[derive(Args, Clone, Copy)]
pub struct ProgramsArgs {
    /// Start the programs of studies with `programs`; without it, a study with programs is refused, since a study of another person could
    /// start anything
    #[arg(long)]
    pub allow_programs: bool,
}

impl ProgramsArgs {
    /// The studies, whose programs may be started from now on.
    ///
    /// # Errors
    /// A study has programs, and they are not allowed.
    pub fn allow(self, sources: Vec<Source>) -> Result<Vec<Source>, Error> {
        for source in &sources {
            self.allow_study(&source.file, &source.study)?;
        }
        Ok(sources)
    }

    /// The same of one study in a file.
    ///
    /// # Errors
    /// As of several.
    pub fn allow_study(self, file: &Path, study: &Study) -> Result<(), Error> {
        allow(file, study, self.allow_programs)
    }
}
