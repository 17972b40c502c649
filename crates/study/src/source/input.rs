//! The text of a study, from a file or standard input, and the settings of the command line.

use std::fs::File;
use std::io::{self, Read, Take, stdin};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};
use slipgap_problem::problem::structure::programs::Runner;
use std::sync::Arc;

use super::place::{self, Texts};
use super::setting::Setting;
use super::tree::{self, Node};
use crate::error::{Error, Fault};

/// Name of standard input in faults.
pub const STDIN: &str = "<stdin>";

/// Most bytes of a file: enough for lists of 10^6 values of several axes.
const LARGEST: u64 = 64 << 20;

/// The text of a study and the settings of the command line.
pub struct Input {
    /// The file as in the command.
    pub file: String,
    /// Its text.
    pub text: String,
    /// Where the records of the study are.
    pub folder: PathBuf,
    /// Parameters that the command line set.
    pub settings: Vec<Setting>,
    /// What may start the programs of the study, if anything may.
    pub programs: Option<Arc<dyn Runner>>,
}

impl Input {
    /// A text; `file` is its name in faults.
    pub fn new(file: &str, text: &str) -> Input {
        Input {
            file: file.to_owned(),
            text: text.to_owned(),
            folder: folder_of(Path::new(file)),
            settings: Vec::new(),
            programs: None,
        }
    }

    /// The text of a file of bounded size. Faults name the file as `file` does.
    ///
    /// # Errors
    /// The file cannot be read, is too large, or is not UTF-8.
    pub fn of_file(file: &Path) -> Result<Input, Error> {
        Ok(Input {
            file: file.display().to_string(),
            text: text_of(file)?,
            folder: folder_of(file),
            settings: Vec::new(),
            programs: None,
        })
    }

    /// The text on standard input, of the same bounded size.
    ///
    /// # Errors
    /// As of a file.
    pub fn of_stdin() -> Result<Input, Error> {
        let text = bounded(stdin().lock(), Path::new(STDIN))?;
        Ok(Input {
            file: STDIN.to_owned(),
            text,
            folder: PathBuf::new(),
            settings: Vec::new(),
            programs: None,
        })
    }

    /// The same with parameters set.
    pub fn with(self, settings: &[Setting]) -> Input {
        Input {
            settings: settings.to_vec(),
            ..self
        }
    }

    /// The same with what may start its programs.
    pub fn with_programs(self, programs: Option<Arc<dyn Runner>>) -> Input {
        Input { programs, ..self }
    }

    /// The text, without the settings.
    pub fn into_text(self) -> String {
        self.text
    }

    /// The hash of the text and, after a zero byte each, of the settings: a study has no zero byte.
    pub fn sha256(&self) -> String {
        let mut digest = Sha256::new();
        digest.update(&self.text);
        for setting in &self.settings {
            digest.update([0]);
            digest.update(setting.text());
        }
        hexadecimal(&digest.finalize())
    }
}

/// Bytes in hexadecimal digits.
pub(super) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The folder of a file.
fn folder_of(file: &Path) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).to_owned()
}

/// The text of a file of bounded size in UTF-8.
pub fn text_of(file: &Path) -> Result<String, Error> {
    let opened = open(file).map_err(Error::io("cannot read", file))?;
    bounded(opened, file)
}

/// A file. A regular one is read to the length that it has: beyond it, /proc/kmsg waits for the next message of the kernel.
/// Others, such as pipes, are read to their end.
pub fn open(file: &Path) -> io::Result<Take<File>> {
    let opened = File::open(file)?;
    let found = opened.metadata()?;
    let len = if found.is_file() {
        found.len()
    } else {
        u64::MAX
    };
    Ok(opened.take(len))
}

fn bounded(from: impl Read, file: &Path) -> Result<String, Error> {
    let mut bytes = Vec::new();
    from.take(LARGEST + 1)
        .read_to_end(&mut bytes)
        .map_err(Error::io("cannot read", file))?;
    if bytes.len() as u64 > LARGEST {
        let message = format!("larger than {} MiB, the limit for a study", LARGEST >> 20);
        return Err(refused(&file.display().to_string(), "", 0, message));
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let (good, bad) = error.as_bytes().split_at(at);
        let byte = bad.first().copied().unwrap_or_default();
        let message = format!("not UTF-8: byte 0x{byte:02x}; save the file as UTF-8");
        let good = String::from_utf8_lossy(good);
        refused(&file.display().to_string(), &good, good.len(), message)
    })
}

/// The tree of a text; `file` is its name in faults.
pub fn tree_of(file: &str, text: &str) -> Result<Node, Error> {
    tree::parse(text).map_err(|fault| refused(file, text, fault.at, fault.message))
}

/// The fault of a file that cannot be parsed.
fn refused(file: &str, text: &str, at: usize, message: String) -> Error {
    let (_, _, line, column) = Texts::new(file, text).at(at);
    Error::Faults(vec![Fault {
        file: file.to_owned(),
        line,
        column,
        path: String::new(),
        message,
        shown: place::shown(text, line, column),
    }])
}
