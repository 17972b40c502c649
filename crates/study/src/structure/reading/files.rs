//! Files beside a study.

use super::given::Choices;
use super::reader::Reader;
use crate::source::faults::{Faults, quoted};
use crate::source::input::open;
use crate::source::tree::Node;
use crate::value::text;
use slipgap_problem::problem::interned;
use slipgap_problem::problem::numbers::parameter::{Kind, shortest};
use slipgap_problem::problem::structure::given::chosen::Chosen;
use slipgap_system::system::import::ImportFault;
use std::io::{self, Read};
use std::path::Path;

/// The content of a file that the text at a place names, of `largest` bytes at most. Its bytes belong to the identity of the structure.
pub(in crate::structure) fn read<T>(
    file: &str,
    (node, path): (&Node, &str),
    largest: u64,
    reader: &Reader,
    faults: &mut Faults,
    parse: impl FnOnce(&[u8]) -> Result<T, ImportFault>,
) -> Option<T> {
    let found = bytes(&reader.folder.join(file), largest);
    let bytes = match found {
        Ok(bytes) => bytes,
        Err(why) => {
            faults.add(node.at, path, format!("{}: {why}", quoted(file)));
            return None;
        }
    };
    match parse(&bytes) {
        Ok(content) => {
            reader.keep(file, &bytes);
            Some(content)
        }
        Err(why) => {
            faults.add(node.at, path, format!("{}: {why}", quoted(file)));
            None
        }
    }
}

/// The bytes of a file of bounded size, or why there are none.
pub(in crate::structure) fn bytes(path: &Path, largest: u64) -> Result<Vec<u8>, String> {
    if std::fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return Err("not a file".into());
    }
    let unread = |error: io::Error| format!("cannot read {}: {error}", path.display());
    let opened = open(path).map_err(unread)?;
    if opened.limit() > largest {
        return Err(format!("larger than {} MiB", largest >> 20));
    }
    let mut bytes = Vec::new();
    opened
        .take(largest)
        .read_to_end(&mut bytes)
        .map_err(unread)?;
    Ok(bytes)
}

impl Reader<'_> {
    /// Keeps the bytes of a file for the identity of the structure.
    pub fn keep(&self, file: &str, bytes: &[u8]) {
        self.records.borrow_mut().add(file, bytes);
    }
}

impl Reader<'_> {
    /// Keeps for the notes that a file has times from `first` on, before t = 0.
    pub fn begins(&self, file: &str, first: f64, what: &str) {
        let mut early = self.early.borrow_mut();
        if first < 0.0 && !early.iter().any(|(known, _)| known == file) {
            early.push((
                file.to_owned(),
                format!("begins at t = {}, {what}", shortest(first)),
            ));
        }
    }
}

/// Which files begin before t = 0, for `explain`, `run` and the page.
pub(in crate::structure) fn early_note(reader: &Reader) -> Option<String> {
    let early = reader.early.borrow();
    let (file, what) = early.first()?;
    let more = match early.len() {
        1 => String::new(),
        2 => "; so does 1 more file".to_owned(),
        count => format!("; so do {} more files", count - 1),
    };
    Some(format!("{} {what}{more}", quoted(file)))
}

impl Reader<'_> {
    /// The row of the parameter with this name and what it chooses from, if it chooses names.
    pub fn choices(&self, name: &str) -> Option<(usize, Choices)> {
        let row = self.table.iter().position(|p| p.name == name)?;
        match self.table[row].kind {
            Kind::Choice(choices) => Some((row, choices)),
            Kind::Number(_) | Kind::Whole { .. } => None,
        }
    }

    /// The file that a text names, or the parameter that chooses one; and all of the files.
    pub fn files(
        &self,
        node: &Node,
        path: &str,
        faults: &mut Faults,
    ) -> Option<(Chosen, Vec<&'static str>)> {
        let file = text(node, path, faults)?;
        Some(match self.choices(&file) {
            Some((row, files)) => {
                let files = files.iter().map(|file| file.0);
                (Chosen::Parameter(row), files.collect())
            }
            None => {
                let file = interned(&file);
                (Chosen::Name(file), vec![file])
            }
        })
    }
}
