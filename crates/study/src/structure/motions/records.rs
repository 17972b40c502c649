//! Recorded accelerations: the files next to the study, read once.

use crate::source::faults::{Faults, quoted};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{FUNCTION, range};
use crate::structure::reading::reader::Reader;
use crate::value::{name, number};
use slipgap_problem::problem::numbers::parameter::{Range, shortest};
use slipgap_problem::problem::structure::given::loads::Kind;
use slipgap_system::system::loads::record::{Heading, Mean, Reading};
use slipgap_system::system::loads::{self, SignalFault, Unit};
use slipgap_system::system::structure::Signal;
use std::sync::Arc;

/// Most bytes of a record.
const LARGEST: u64 = 64 << 20;

/// The record at a node, or the parameter that chooses one.
pub(in crate::structure) fn record(
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
    let reading = reading(function, faults)?;
    let (chosen, files) = reader.files(node, path, faults)?;
    let before = faults.count();
    let mut records = Vec::new();
    for file in files {
        match read(file, (unit, reading), function, reader) {
            Ok(signal) => records.push((file, signal)),
            Err((key, why)) => {
                let wrong = key.and_then(|key| Some((function.get(key)?.at, function.path(key))));
                let (at, path) = wrong.unwrap_or_else(|| (node.at, path.to_owned()));
                faults.add(at, &path, format!("{}: {why}", quoted(file)));
            }
        }
    }
    (faults.count() == before).then_some(Kind::Record {
        name: chosen,
        records,
    })
}

/// What the function says about its file besides the unit.
fn reading(function: &Object, faults: &mut Faults) -> Option<Reading> {
    let before = faults.count();
    let mean = function.get("mean").and_then(|node| {
        let names = Mean::ALL.map(Mean::name);
        let place = name(node, &function.path("mean"), "mean", &names, faults)?;
        Some(Mean::ALL[place])
    });
    let mut whole = |key: &str| {
        let node = function.get(key)?;
        let path = function.path(key);
        let x = number(node, &path, Range::Positive, faults)?;
        if x.fract() == 0.0 && x <= 1e6 {
            return Some(x as usize);
        }
        let message = format!(
            "must be a whole number from 1 to 1000000, got {}",
            shortest(x)
        );
        faults.add(node.at, &path, message);
        None
    };
    let (column, component) = (whole("column"), whole("component"));
    let dt = function.get("dt");
    let dt = dt.and_then(|node| number(node, &function.path("dt"), range(FUNCTION, "dt"), faults));
    (faults.count() == before).then_some(Reading {
        mean,
        column,
        dt,
        component,
    })
}

/// Why a file gives no signal, and the key of the function that contradicts it; without one, the file itself is at fault.
type Fault = (Option<&'static str>, String);

/// The signal of a file, in the study's units.
fn read(
    file: &str,
    (unit, reading): (Option<Unit>, Reading),
    function: &Object,
    reader: &Reader,
) -> Result<Arc<Signal>, Fault> {
    let bytes = reader
        .folder
        .bytes(file, LARGEST)
        .map_err(|why| (None, why))?;
    let record = loads::record::parse(file, &bytes, reading);
    let record = record.map_err(|fault| {
        let why = format!("line {}: {}", fault.line, fault.cause);
        (fault.cause.key(), why)
    })?;
    let signal = loads::signal(&record, unit, 1.0 / reader.metre).map_err(|why| match why {
        SignalFault::TwoUnits { .. } => (Some("unit"), why.to_string()),
        SignalFault::NoUnit | SignalFault::NotFinite => (None, why.to_string()),
    })?;
    if let (None, Some(removed), Some(unit)) = (reading.mean, record.removed_mean, record.unit) {
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
    let removed = reader.removed_means.borrow();
    let removed = removed.first().map(|(file, mean)| {
        let more = match removed.len() {
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
