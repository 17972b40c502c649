//! `slipgap run`: results, figures and, if wanted, histories of every study.

use super::sources::Source;
use super::terminal::{Terminal, print};
use super::{NOT_MET, UNSOLVED};
use clap::ValueEnum;
use slipgap::batch::output::Folder;
use slipgap::batch::store::Store;
use slipgap::error::Error;
use slipgap::run::{OutputOptions, run_study};
use std::path::Path;

/// The files of a run in addition to figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// results.csv for any number of cases, and the store
    Csv,
    /// Only the store, a folder of Parquet files
    Parquet,
}

impl Format {
    /// Whether results.csv is written.
    pub fn has_table(self) -> bool {
        self == Format::Csv
    }
}

/// Runs the studies into `out`; returns the exit code, that of a warning only if warnings are denied.
pub fn run(
    sources: &[Source],
    out: &Path,
    output: &OutputOptions,
    deny_warnings: bool,
) -> Result<u8, Error> {
    // All folders are opened first: a folder that cannot be written or is in use ends the command before any computing.
    for source in sources {
        let path = out.join(&source.name);
        Folder::of_study(&path)?;
        Store::open(&path)?;
    }
    let (mut solved, mut warned) = (true, false);
    for source in sources {
        let path = out.join(&source.name);
        let folder = Folder::of_study(&path)?;
        let written = run_study(source, folder, Store::open(&path)?, output, &mut Terminal)?;
        print(&written.list())?;
        solved &= written.solved;
        warned |= !written.warnings.is_empty();
    }
    Ok(match (solved, deny_warnings && warned) {
        (false, _) => UNSOLVED,
        (true, true) => NOT_MET,
        (true, false) => 0,
    })
}
