//! Errors: faults of study files with their places, and errors of commands.

use std::fmt;
use std::path::PathBuf;

/// A fault of a study file: its place, what is wrong, and what is allowed.
///
/// Displayed as `FILE:LINE:COLUMN: PATH: MESSAGE`; line and column count from 1, in characters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The study file as in the command.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1, in characters.
    pub column: usize,
    /// The key, as in `parameters.alpha[2]`; empty for faults of syntax.
    pub path: String,
    /// What is wrong and what is allowed.
    pub message: String,
    /// The line, or the part of it near the place, with a caret below; empty after many faults.
    pub shown: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}: ", self.file, self.line, self.column)?;
        if !self.path.is_empty() {
            write!(f, "{}: ", self.path)?;
        }
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}

/// Why a command failed.
#[derive(Debug)]
pub enum Error {
    /// All faults of study files, in file order.
    Faults(Vec<Fault>),
    /// A mistake on the command line.
    Usage(String),
    /// A file or folder that could not be read or written.
    Io {
        /// The operation, as in `cannot write`.
        doing: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// The error of the operating system.
        source: std::io::Error,
    },
    /// A case that could not be solved, if the run ends at the first one.
    Unsolved(String),
    /// Parts that a merge needs and the store does not have.
    PartsMissing(String),
    /// A folder of results that another run uses.
    Busy(PathBuf),
    /// The caller stopped the run.
    Interrupted,
    /// An error of this program.
    Internal(String),
}

impl Error {
    /// Makes an error of the operating system for `path`.
    pub fn io(
        doing: &'static str,
        path: impl Into<PathBuf>,
    ) -> impl FnOnce(std::io::Error) -> Error {
        let path = path.into();
        move |source| Error::Io {
            doing,
            path,
            source,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Faults(faults) => {
                for (i, fault) in faults.iter().enumerate() {
                    if i > 0 {
                        writeln!(f)?;
                    }
                    write!(f, "{fault}")?;
                }
                Ok(())
            }
            Error::Usage(message)
            | Error::Unsolved(message)
            | Error::PartsMissing(message)
            | Error::Internal(message) => f.write_str(message),
            Error::Interrupted => f.write_str("interrupted"),
            Error::Busy(path) => write!(
                f,
                "{} is in use by another run; wait for it, or give another folder with --out",
                path.display()
            ),
            Error::Io {
                doing,
                path,
                source,
            } => write!(f, "{doing} {}: {source}", path.display()),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Error::Io { source, .. } => Some(source),
            Error::Faults(_)
            | Error::Usage(_)
            | Error::Unsolved(_)
            | Error::PartsMissing(_)
            | Error::Busy(_)
            | Error::Interrupted
            | Error::Internal(_) => None,
        }
    }
}
