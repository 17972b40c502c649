//! Recorded accelerations: the files next to the study, read once.

use super::reader::Reader;
use crate::problem::interned;
use crate::problem::structure::loads::Kind;
use crate::problem::structure::template::Chosen;
use crate::study::source::faults::{Faults, quoted};
use crate::study::source::input::open;
use crate::study::source::object::Object;
use crate::study::source::tree::Node;
use crate::study::value::{name, text};
use crate::system::loads::{self, Unit};
use crate::system::structure::Signal;
use std::io::{self, Read};
use std::sync::Arc;

/// Most bytes of a record.
const LARGEST: u64 = 64 << 20;

/// The record at a node, or the parameter that chooses one.
pub(super) fn record(
    node: &Node,
    path: &str,
    function: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Kind> {
    let unit = match function.get("unit") {
        None => None,
        Some(node) => {
            let names = Unit::ALL.map(Unit::name);
            Some(Unit::ALL[name(node, &function.path("unit"), "unit", &names, faults)?])
        }
    };
    let file = text(node, path, faults)?;
    let (chosen, files) = match reader.choices(&file) {
        Some((row, files)) => (
            Chosen::Parameter(row),
            files.iter().map(|file| file.0).collect(),
        ),
        None => {
            let file = interned(&file);
            (Chosen::Name(file), vec![file])
        }
    };
    let before = faults.count();
    let mut records = Vec::new();
    for file in files {
        match read(file, unit, reader) {
            Ok(signal) => records.push((file, signal)),
            Err(why) => faults.add(node.at, path, format!("{}: {why}", quoted(file))),
        }
    }
    (faults.count() == before).then_some(Kind::Record {
        name: chosen,
        records,
    })
}

/// The signal of a file, in the study's units.
fn read(file: &str, unit: Option<Unit>, reader: &Reader) -> Result<Arc<Signal>, String> {
    let path = reader.folder.join(file);
    if std::fs::metadata(&path).is_ok_and(|found| !found.is_file()) {
        return Err("not a file".into());
    }
    let unread = |error: io::Error| format!("cannot read {}: {error}", path.display());
    let opened = open(&path).map_err(unread)?;
    if opened.limit() > LARGEST {
        return Err(format!("larger than {} MiB", LARGEST >> 20));
    }
    let mut bytes = Vec::new();
    opened
        .take(LARGEST)
        .read_to_end(&mut bytes)
        .map_err(unread)?;
    let record = loads::record::parse(file, &bytes);
    let record = record.map_err(|fault| format!("line {}: {}", fault.line, fault.message))?;
    let signal = loads::signal(&record, unit, 1.0 / reader.metre).map_err(|why| why.to_string())?;
    let mut all = reader.records.borrow_mut();
    if !all.iter().any(|(known, _)| known == file) {
        all.push((file.to_owned(), bytes));
    }
    Ok(signal)
}
