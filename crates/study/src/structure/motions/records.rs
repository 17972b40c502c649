//! Recorded accelerations: the files next to the study, read once.

use super::members::combinations;
use super::record_keys::{Fault, RecordKeys};
use crate::source::faults::{Faults, quoted};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::numbers::parameter::{Value, shortest};
use slipgap_problem::problem::structure::given::chosen::Chosen;
use slipgap_problem::problem::structure::given::source::Kind;
use slipgap_system::system::loads::record::{Heading, Reading};
use slipgap_system::system::loads::{self, SignalFault, Unit};
use slipgap_system::system::structure::Signal;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Most bytes of a record.
const LARGEST: u64 = 64 << 20;

/// The record at a node, or the parameters that choose its file and how it is read.
pub(in crate::structure) fn record(
    node: &Node,
    path: &str,
    function: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Kind> {
    let keys = RecordKeys::of(function, reader, faults)?;
    let (chosen, files) = reader.files(node, path, faults)?;
    let of_file = match chosen {
        Chosen::Parameter(row) => Some(row),
        Chosen::Name(_) => None,
    };
    let sorted: BTreeSet<usize> = of_file.into_iter().chain(keys.rows()).collect();
    let rows: Vec<usize> = sorted.into_iter().collect();
    let choices = match (keys.rows().is_empty(), of_file) {
        (true, None) => vec![Vec::new()],
        (true, Some(row)) => files
            .iter()
            .map(|file| vec![(row, Value::Name(file))])
            .collect(),
        (false, _) => match combinations(&rows, reader) {
            Ok(choices) => choices,
            Err(why) => {
                faults.add(node.at, path, why);
                return None;
            }
        },
    };
    let before = faults.count();
    let mut records = Vec::new();
    for values in choices {
        let given = |row: usize| {
            values
                .iter()
                .find(|value| value.0 == row)
                .map(|value| value.1)
        };
        let file = match chosen {
            Chosen::Parameter(row) => given(row).map_or("", Value::name),
            Chosen::Name(file) => file,
        };
        let signal = keys.with(&values);
        match signal.and_then(|with| read(file, with, keys.has_mean(), function, reader)) {
            Ok(signal) => records.push((values.into_iter().map(|value| value.1).collect(), signal)),
            Err((key, why)) => {
                let wrong = key.and_then(|key| Some((function.get(key)?.at, function.path(key))));
                let (at, path) = wrong.unwrap_or_else(|| (node.at, path.to_owned()));
                let others = values.iter().filter(|value| Some(value.0) != of_file);
                let texts = others.map(|(row, x)| format!(", {} = {x}", reader.table[*row].name));
                let with: String = texts.collect();
                faults.add(at, &path, format!("{}{with}: {why}", quoted(file)));
            }
        }
    }
    (faults.count() == before).then_some(Kind::Record {
        name: chosen,
        rows,
        records,
    })
}

/// The signal of a file, in the study's units.
fn read(
    file: &str,
    (unit, reading): (Option<Unit>, Reading),
    has_mean: bool,
    function: &Object,
    reader: &Reader,
) -> Result<Arc<Signal>, Fault> {
    let bytes = reader
        .folder
        .bytes(file, LARGEST)
        .map_err(|why| (None, why))?;
    let record = loads::record::parse(file, &bytes, reading).map_err(|fault| {
        let why = format!("line {}: {}", fault.line, fault.cause);
        (fault.cause.key(), why)
    })?;
    let signal = loads::signal(&record, unit, 1.0 / reader.metre).map_err(|why| match why {
        SignalFault::TwoUnits { .. } => (Some("unit"), why.to_string()),
        SignalFault::NoUnit | SignalFault::NotFinite => (None, why.to_string()),
    })?;
    if let (false, Some(removed), Some(unit)) = (has_mean, record.removed_mean, record.unit) {
        let removed = format!("{} {unit}", shortest(four_digits(removed)));
        let mut means = reader.removed_means.borrow_mut();
        if !means.iter().any(|(known, _)| known == file) {
            means.push((file.to_owned(), removed));
        }
    }
    if let Some(doubt) = record.doubts.first() {
        let mut doubts = reader.doubts.borrow_mut();
        if !doubts.iter().any(|(known, _)| known == file) {
            doubts.push((file.to_owned(), doubt.to_string()));
        }
    }
    if let (None, Some(first)) = (function.get("start"), record.times.first()) {
        let what = format!(
            "and what is before t = 0 is not used: add {} to its times to use all, \"start\": 0 ends this note",
            shortest(-first)
        );
        reader.begins(file, *first, &what);
    }
    let heading = Heading::of(&bytes, &reading);
    let mut headings = reader.headings.borrow_mut();
    match headings.iter_mut().find(|known| known.0 == file) {
        // Several components of a file.
        Some((_, known)) if known.component != heading.component => known.component.clear(),
        Some(_) => {}
        None => headings.push((file.to_owned(), heading)),
    }
    drop(headings);
    reader.keep(file, &bytes);
    Ok(signal)
}

/// A number with four digits.
fn four_digits(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}

/// What was done to the records, and what their headers say otherwise, for `explain`, `run` and the page.
pub(in crate::structure) fn notes(reader: &Reader) -> Vec<String> {
    let means = reader.removed_means.borrow();
    let removed = means.first().map(|(file, mean)| {
        let more = match means.len() {
            1 => String::new(),
            2 => " and that of 1 more record".to_owned(),
            count => format!(" and those of {} more records", count - 1),
        };
        format!(
            "the mean of {}, {mean},{more} is removed, as for every K-NET file; \"mean\": \"kept\" keeps it, \"mean\": \"removed\" ends \
             this note",
            quoted(file)
        )
    });
    let doubts = reader.doubts.borrow();
    let doubt = doubts.first().map(|(file, doubt)| {
        let more = match doubts.len() {
            1 => String::new(),
            2 => "; 1 more record has such a contradiction".to_owned(),
            count => format!("; {} more records have such contradictions", count - 1),
        };
        format!("{}: {doubt}{more}", quoted(file))
    });
    removed.into_iter().chain(doubt).collect()
}
