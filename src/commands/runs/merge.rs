//! `slipgap merge`: tables, figures and manifest of studies whose cases shards have computed.

use crate::batch::output::Folder;
use crate::batch::store::{STORE, Store};
use crate::commands::arguments::sources::Source;
use crate::commands::arguments::{
    JobsArgs, OutputArgs, ProgramsArgs, StudiesArgs, results_folder, whole,
};
use crate::commands::terminal::{Terminal, report_error};
use crate::commands::{NOT_MET, PARTS_MISSING, UNSOLVED};
use crate::error::Error;
use crate::run::merge_study;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};

/// The arguments of `slipgap merge`.
#[derive(Args)]
pub struct MergeArgs {
    #[command(flatten)]
    studies: StudiesArgs,
    /// Folder of the results, in which the shards have their stores
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    /// Number of shards; if parts are missing, the message then names the shards to run again
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1, u64::MAX))]
    shards: Option<u64>,
    #[command(flatten)]
    output: OutputArgs,
    #[command(flatten)]
    jobs: JobsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl MergeArgs {
    /// Merges the studies; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let studies = self
            .programs
            .allow_in(self.studies.read()?, self.studies.named())?;
        self.jobs
            .run(|| merge(&studies, &self.out, self.shards, &self.output))
    }
}

/// Merges every study into its folder in `out`; returns the exit code, that of a warning only if warnings are denied. `shards` is the number of shards, if it is known. Of a
/// study with missing parts nothing is written; the others are merged.
fn merge(
    sources: &[Source],
    out: &Path,
    shards: Option<u64>,
    args: &OutputArgs,
) -> Result<u8, Error> {
    let (mut unsolved, mut warned, mut missing) = (None, None, None);
    let (options, mut terminal) = (args.options(), Terminal::new(sources));
    let mut merge = |source: &Source| {
        let path = out.join(&source.name);
        let made = not_there(&path.join(STORE));
        let (folder, store) = (Folder::of_study(&path)?, Store::open(&path)?);
        match merge_study(source, folder, store, shards, &options, &mut terminal) {
            Ok(written) => {
                args.print_files(&written)?;
                if !written.solved {
                    unsolved = Some(UNSOLVED);
                }
                if args.deny_warnings && written.has_warnings() {
                    warned = Some(NOT_MET);
                }
            }
            Err(error @ Error::PartsMissing(_)) => {
                // Folders that are not empty remain.
                made.iter().for_each(|folder| drop(fs::remove_dir(folder)));
                report_error(&error);
                terminal.skip(source);
                missing = Some(PARTS_MISSING);
            }
            Err(other) => return Err(other),
        }
        Ok(())
    };
    let ended = sources.iter().try_for_each(&mut merge);
    terminal.end();
    ended?;
    if missing.is_none() {
        args.print_folder(sources, out)?;
    }
    Ok(missing.or(unsolved).or(warned).unwrap_or(0))
}

/// The folders that are made to make this one, itself first.
fn not_there(folder: &Path) -> Vec<PathBuf> {
    let folders = folder.ancestors();
    let absent = folders.take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists());
    absent.map(Path::to_owned).collect()
}
