//! `slipgap animate`: one page that shows cases of a study in motion.

use super::arguments::sources::{self, Source};
use super::arguments::{ProgramsArgs, SettingsArgs, whole};
use super::terminal::{note, print};
use crate::animate::{Shown, animate};
use crate::batch::output::Folder;
use crate::error::Error;
use clap::Args;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Folder of the results of studies.
const FIGURES: &str = "figures";

/// Name of the page in the folder of its study.
const PAGE: &str = "animation.html";

/// The arguments of `slipgap animate`.
#[derive(Args)]
pub struct AnimateArgs {
    /// Study file; `-` is standard input
    study: PathBuf,
    /// Number of the case, from 0; if left out, the first case that a history figure shows, or else the first case
    #[arg(value_parser = whole::<u64>(0, u64::MAX))]
    case: Option<u64>,
    /// Number of a second case, shown beside the first one
    #[arg(value_name = "CASE2", value_parser = whole::<u64>(0, u64::MAX), conflicts_with = "exact")]
    second: Option<u64>,
    /// Show the exact motion of the case beside the computed one
    #[arg(long)]
    exact: bool,
    /// The file to write; if left out, figures/STUDY/animation.html
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    settings: SettingsArgs,
    #[command(flatten)]
    programs: ProgramsArgs,
}

impl AnimateArgs {
    /// Writes the page; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        if self.study.is_dir() {
            let what = format!("{} is a folder; name one study", self.study.display());
            return Err(Error::Usage(what));
        }
        let read = sources::read(&[self.study], &self.settings.set, u64::MAX)?;
        let sources = self.programs.allow(read)?;
        let Some(source) = sources.first() else {
            return Ok(0);
        };
        let shown = Shown {
            cases: self.case.into_iter().chain(self.second).collect(),
            exact: self.exact,
        };
        let page = animate(&source.study, &source.name, &shown)?;
        let path = write(source, self.out.as_deref(), &page)?;
        note(&format!(
            "{}: {} kB",
            path.display(),
            page.len().div_ceil(1000)
        ));
        print(&format!("{}\n", path.display()))
    }
}

/// Writes the page; returns its path.
fn write(source: &Source, out: Option<&Path>, page: &str) -> Result<PathBuf, Error> {
    let usual = Path::new(FIGURES).join(&source.name).join(PAGE);
    let path = out.unwrap_or(&usual);
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
        let what = format!("{} names no file to write", path.display());
        return Err(Error::Usage(what));
    };
    if path.is_dir() {
        let what = format!("{} is a folder; name a file to write", path.display());
        return Err(Error::Usage(what));
    }
    let parent = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = Folder::open(parent.unwrap_or(Path::new(".")))?;
    folder.write_unlisted(name, |file| file.write_all(page.as_bytes()))?;
    Ok(path.to_owned())
}
