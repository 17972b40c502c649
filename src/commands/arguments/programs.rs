//! Whether a verb may start the programs of its studies: only where the command line says so.

use super::sources::Source;
use crate::batch::programs::allow;
use crate::commands::terminal::note;
use crate::error::Error;
use crate::run::found;
use crate::study::Study;
use clap::Args;
use std::path::{Path, PathBuf};

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

    /// The same, but studies of folders whose programs are not allowed are left out with a note, if others are left.
    ///
    /// # Errors
    /// A study that is `named`, and no folder of it, has programs that are not allowed, or all have.
    pub fn allow_in(self, sources: Vec<Source>, named: &[PathBuf]) -> Result<Vec<Source>, Error> {
        let folders = named.iter().filter_map(|path| found(path).ok());
        let folders: Vec<PathBuf> = folders.filter(|path| path.is_dir()).collect();
        let may_leave = |source: &Source| {
            let in_folder = folders.iter().any(|folder| source.file.starts_with(folder));
            in_folder && !self.allow_programs && source.study.programs().is_some()
        };
        let (without, kept): (Vec<Source>, Vec<Source>) = sources.into_iter().partition(may_leave);
        if kept.is_empty() {
            return self.allow(without);
        }
        note_left_out(without.iter().map(|source| (&*source.file, &source.study)));
        self.allow(kept)
    }

    /// The same of one study in a file.
    ///
    /// # Errors
    /// As of several.
    pub fn allow_study(self, file: &Path, study: &Study) -> Result<(), Error> {
        allow(file, study, self.allow_programs)
    }
}

/// Says which studies are left out, and the commands that they would start.
pub fn note_left_out<'a>(studies: impl Iterator<Item = (&'a Path, &'a Study)>) {
    let (mut files, mut commands) = (Vec::new(), Vec::new());
    for (file, study) in studies {
        let list = study.programs().map_or(&[][..], |programs| &programs.list);
        commands.extend(list.iter().map(|program| program.shown_command()));
        files.push(file.display().to_string());
    }
    commands.sort();
    commands.dedup();
    if !files.is_empty() {
        note(&format!(
            "{}: left out: programs would be started ({}); allowed with --allow-programs, if you trust them",
            files.join(", "),
            commands.join("; ")
        ));
    }
}
