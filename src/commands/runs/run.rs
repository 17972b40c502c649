//! `slipgap run`: results, figures and, if wanted, histories of every study; of a folder the cheapest study first.

use super::shard;
use crate::batch::Shard;
use crate::batch::output::Folder;
use crate::batch::store::Store;
use crate::commands::arguments::sources::Source;
use crate::commands::arguments::{JobsArgs, OutputArgs, ProgramsArgs, StudiesArgs, results_folder};
use crate::commands::terminal::Terminal;
use crate::commands::{NOT_MET, UNSOLVED};
use crate::error::Error;
use crate::run::{OutputOptions, run_study};
use clap::Args;
use std::path::{Path, PathBuf};

/// The arguments of `slipgap run`.
#[derive(Args)]
pub struct RunArgs {
    #[command(flatten)]
    studies: StudiesArgs,
    /// Folder for the results; each study has its own folder in it
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    /// Also write the history of every case to histories/CASE.csv; all cases are computed again
    #[arg(long)]
    histories: bool,
    /// Stop at the first case that cannot be solved
    #[arg(long)]
    fail_fast: bool,
    #[command(flatten)]
    output: OutputArgs,
    /// Only compute the parts of shard I of N into the store in DIR: every N-th part, beginning with part I; `merge` writes the
    /// results
    #[arg(long, value_name = "I/N", conflicts_with_all = ["histories", "fail_fast", "deny_warnings", "format", "dpi", "black", "verbose"])]
    shard: Option<Shard>,
    #[command(flatten)]
    jobs: JobsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl RunArgs {
    /// Runs the studies; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let options = OutputOptions {
            histories: self.histories,
            fail_fast: self.fail_fast,
            ..self.output.options()
        };
        self.jobs.run(|| {
            let studies = self
                .programs
                .allow_in(self.studies.read_cheapest_first()?, self.studies.named())?;
            match self.shard {
                Some(shard) => shard::run(&studies, &self.out, shard),
                None => run(&studies, &self.out, &options, &self.output),
            }
        })
    }
}

/// Runs the studies into `out`; returns the exit code, that of a warning only if warnings are denied.
fn run(
    sources: &[Source],
    out: &Path,
    options: &OutputOptions,
    args: &OutputArgs,
) -> Result<u8, Error> {
    // All folders are opened first: a folder that cannot be written or is in use ends the command before any computing.
    for source in sources {
        let path = out.join(&source.name);
        Folder::of_study(&path)?;
        Store::open(&path)?;
    }
    let (mut solved, mut warned) = (true, false);
    let mut terminal = Terminal::new(sources);
    let mut run = |source: &Source| {
        let path = out.join(&source.name);
        let folder = Folder::of_study(&path)?;
        let written = run_study(source, folder, Store::open(&path)?, options, &mut terminal)?;
        args.print_files(&written)?;
        solved &= written.solved;
        warned |= written.has_warnings();
        Ok(())
    };
    let ended = sources.iter().try_for_each(&mut run);
    terminal.end();
    ended?;
    args.print_folder(sources, out)?;
    Ok(match (solved, args.deny_warnings && warned) {
        (false, _) => UNSOLVED,
        (true, true) => NOT_MET,
        (true, false) => 0,
    })
}
