//! `slipgap calibrate`: the values of free parameters with which a study comes nearest to what was measured.

use super::UNSOLVED;
use super::arguments::sources;
use super::arguments::{JobsArgs, ProgramsArgs, SettingsArgs, results_folder, whole};
use super::terminal::{input_note, print, progress, table};
use crate::batch::output::Folder;
use crate::calibrate::{calibrate, check_folder, text, write};
use crate::error::Error;
use crate::figures::style;
use crate::recommend::Stop;
use crate::run::Source;
use crate::study::MOST_CASES;
use clap::Args;
use std::path::PathBuf;
use std::time::Instant;

/// The arguments of `slipgap calibrate`.
#[derive(Args)]
pub struct CalibrateArgs {
    /// Study file with the key `calibrate`; `-` is standard input
    study: PathBuf,
    /// Folder for tables, figures and the studies with the best values; the study has its own folder in it
    #[arg(long, value_name = "DIR", default_value = "figures", value_parser = results_folder())]
    out: PathBuf,
    #[command(flatten)]
    settings: SettingsArgs,
    /// Pixels an inch of the PNG files, 72 to 1200
    #[arg(long, value_name = "N", default_value_t = style::DPI, value_parser = whole::<u32>(72, 1200))]
    dpi: u32,
    #[command(flatten)]
    jobs: JobsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl CalibrateArgs {
    /// Searches; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        if self.study.is_dir() {
            let what = format!("{} is a folder; name one study", self.study.display());
            return Err(Error::Usage(what));
        }
        let sources = self.programs.allow(sources::read(
            std::slice::from_ref(&self.study),
            &self.settings.set,
            MOST_CASES,
        )?)?;
        let source = sources.first();
        source.map_or(Ok(0), |source| self.jobs.run(|| self.run(source)))
    }

    /// Calibrates a study, writes its files and prints what was found; returns the exit code.
    fn run(&self, source: &Source) -> Result<u8, Error> {
        let path = self.out.join(&source.name);
        // A folder that cannot be written ends the command before any computing.
        check_folder(&path)?;
        Folder::open(&path)?;
        for message in source
            .study
            .problem
            .as_structure()
            .map_or(&[][..], |structure| structure.notes())
        {
            input_note(&source.line(message));
        }
        let (bar, start) = (progress::counter(&source.name), Instant::now());
        let found = calibrate(source, &bar, &Stop::default())?;
        let seconds = start.elapsed().as_secs_f64();
        let cases = format!("{} cases in {seconds:.1} s", found.solved());
        progress::finish(&bar, &source.name, &cases);
        let written = write(&found, source, &path, self.dpi)?;
        let mut out = text(&found, &table);
        out += "\n";
        for path in written {
            out += &format!("{}\n", path.display());
        }
        print(&out)?;
        Ok(match found.best() {
            Some(_) => 0,
            None => UNSOLVED,
        })
    }
}
