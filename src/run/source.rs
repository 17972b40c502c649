//! A study and where it comes from.

use crate::study::Study;
use std::path::PathBuf;

/// A study and its origin.
#[derive(Debug)]
pub struct Source {
    /// The file as in the command, or the name of standard input.
    pub file: PathBuf,
    /// Its folder in the output folder, as in `claims/friction`.
    pub name: String,
    /// The text of the file.
    pub text: String,
    /// The study.
    pub study: Study,
}

impl Source {
    /// The file and the settings of the command line.
    pub fn origin(&self) -> String {
        let mut origin = self.file.display().to_string();
        for setting in &self.study.settings {
            origin += &format!(" --set '{}'", setting.text());
        }
        origin
    }

    /// A line about the study that begins with its file.
    pub fn line(&self, what: &str) -> String {
        format!("{}: {what}", self.file.display())
    }
}
