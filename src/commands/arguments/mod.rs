//! Arguments that several verbs share.

mod programs;
pub(super) mod sources;

pub use programs::{ProgramsArgs, note_left_out};

use super::terminal::print;
use crate::batch::files::place::for_results;
use crate::error::Error;
use crate::figures::style;
use crate::run::{OutputOptions, Written};
use crate::study::{MOST_CASES, Setting};
use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::{Args, ValueEnum};
use sources::Source;
use std::borrow::Cow;
use std::fmt;
use std::path::{Path, PathBuf};

/// The studies of a verb.
#[derive(Args)]
pub struct StudiesArgs {
    /// Study files, names of studies in the folder studies or one of its sub-folders, or folders with all sub-folders; `-` reads standard
    /// input, and its results go to the folder stdin
    #[arg(value_name = "STUDY|FOLDER", default_value = sources::STUDIES)]
    studies: Vec<PathBuf>,
    /// Largest number of raw combinations in a study
    #[arg(long, value_name = "CASES", default_value_t = MOST_CASES, value_parser = whole::<u64>(0, u64::MAX))]
    limit: u64,
    #[command(flatten)]
    settings: SettingsArgs,
}

impl StudiesArgs {
    /// The files and folders as they are named.
    pub fn named(&self) -> &[PathBuf] {
        &self.studies
    }

    /// Reads the studies.
    pub fn read(&self) -> Result<Vec<Source>, Error> {
        sources::read(&self.studies, &self.settings.set, self.limit)
    }

    /// Reads the studies, those of each folder in the order of their cost.
    pub fn read_cheapest_first(&self) -> Result<Vec<Source>, Error> {
        sources::read_cheapest_first(&self.studies, &self.settings.set, self.limit)
    }
}

/// Reads a folder of results, as by [`for_results`].
pub fn results_folder() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(for_results)
}

/// Parameters that the command line sets.
#[derive(Args)]
pub struct SettingsArgs {
    /// Set a parameter for this command: in every block that gives it, or in all blocks if none does; VALUE is JSON, a
    /// name or an expression, as in dT=pi/10 or 'alpha=[0.1, 1]'; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = Setting::new)]
    pub set: Vec<Setting>,
}

/// What a run or a merge writes and says.
#[derive(Args)]
pub struct OutputArgs {
    /// Exit with 5 if there is a warning
    #[arg(long)]
    pub deny_warnings: bool,
    /// Format of the results; by default the store, and results.csv for up to 10^5 cases
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Pixels an inch of the PNG files, and of images in SVG and PDF files, 72 to 1200
    #[arg(long, value_name = "N", default_value_t = style::DPI, value_parser = whole::<u32>(72, 1200))]
    dpi: u32,
    /// Draw all curves in black with dashes and markers, and bands hatched, as for print; shades of maps stay
    #[arg(long)]
    black: bool,
    /// Print the path of every file written, not only of the folder
    #[arg(long)]
    verbose: bool,
}

impl OutputArgs {
    /// What is written besides histories.
    pub fn options(&self) -> OutputOptions {
        OutputOptions {
            table: self.format.map(Format::has_table),
            dpi: self.dpi,
            black: self.black,
            ..OutputOptions::default()
        }
    }

    /// Prints the paths of the files of a study, if they are wanted.
    pub fn print_files(&self, written: &Written) -> Result<(), Error> {
        match self.verbose {
            true => print(&written.list()).map(drop),
            false => Ok(()),
        }
    }

    /// Prints the folder of all results, unless the paths of its files were printed.
    pub fn print_folder(&self, sources: &[Source], out: &Path) -> Result<(), Error> {
        let folder = match sources {
            [source] => out.join(&source.name),
            _ => out.to_owned(),
        };
        match self.verbose {
            true => Ok(()),
            false => print(&format!("{}\n", folder.display())).map(drop),
        }
    }
}

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

/// The number of threads of a verb.
#[derive(Args)]
pub struct JobsArgs {
    /// Number of threads, at most 1024; if left out, one for each core
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1024))]
    jobs: Option<u16>,
}

impl JobsArgs {
    /// Runs `work` on this number of threads.
    pub fn run(&self, work: impl FnOnce() -> Result<u8, Error> + Send) -> Result<u8, Error> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(self.jobs.map_or(0, usize::from))
            .build()
            .map_err(|e| Error::Internal(format!("cannot start threads: {e}")))?;
        pool.install(work)
    }
}

/// What an argument must be and is not.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Expected(pub Cow<'static, str>);

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "must be {}", self.0)
    }
}

impl std::error::Error for Expected {}

/// Reads a whole number from `least` to `most`.
pub fn whole<T: TryFrom<u64>>(
    least: u64,
    most: u64,
) -> impl Fn(&str) -> Result<T, Expected> + Clone + Send + Sync + 'static {
    move |text| {
        let parsed = text.parse::<u64>().ok();
        let number = parsed.filter(|n| (least..=most).contains(n));
        let expected = || match most {
            u64::MAX => format!("a whole number >= {least}"),
            _ => format!("a whole number from {least} to {most}"),
        };
        number
            .and_then(|n| T::try_from(n).ok())
            .ok_or_else(|| Expected(expected().into()))
    }
}
