//! Files beside a study.

use super::given::Choices;
use super::reader::Reader;
use crate::source::faults::{Faults, quoted};
use crate::source::tree::Node;
use crate::value::text;
use slipgap_problem::problem::interned;
use slipgap_problem::problem::numbers::parameter::{Kind, shortest};
use slipgap_problem::problem::structure::given::chosen::Chosen;
use slipgap_system::system::import::ImportFault;

/// The content of a file that the text at a place names, of `largest` bytes at most. Its bytes belong to the identity of the structure.
pub(in crate::structure) fn read<T>(
    file: &str,
    (node, path): (&Node, &str),
    largest: u64,
    reader: &Reader,
    faults: &mut Faults,
    parse: impl FnOnce(&[u8]) -> Result<T, ImportFault>,
) -> Option<T> {
    let found = reader.folder.bytes(file, largest);
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
