//! `slipgap man`: the manual pages of the program and its verbs.

use crate::error::Error;
use clap::{Args, Command};
use std::fs;
use std::path::PathBuf;

/// The arguments of `slipgap man`.
#[derive(Args)]
pub struct ManArgs {
    /// The folder
    folder: PathBuf,
}

impl ManArgs {
    /// Writes the pages; returns the exit code.
    pub fn execute(self, program: Command) -> Result<u8, Error> {
        let folder = &self.folder;
        fs::create_dir_all(folder).map_err(Error::io("cannot make folder", folder))?;
        clap_mangen::generate_to(program, folder).map_err(Error::io("cannot write to", folder))?;
        Ok(0)
    }
}
