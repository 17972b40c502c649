//! Measurements of a structure: the key `measured`, whose files have columns of channels over time.

mod column;
mod metrics;
mod sample;
mod table;

pub(super) use column::{Column, column};
pub(super) use metrics::report_not_measured;
pub(super) use table::test;

use super::keys::{COMPARE, KEY, MEASURED};
use crate::source::faults::{Faults, join, quoted};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::structure::named::named_metrics::hinted;
use crate::structure::reading::reader::{Reader, open};
use crate::value::name;
use slipgap_problem::problem::numbers::parameter::{Range, shortest};
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::structure::channels::channel::Channel;
use slipgap_problem::problem::structure::channels::measured_channels::{FEWEST, Measured, Test};
use slipgap_problem::problem::structure::channels::names::Names;
use slipgap_problem::problem::structure::channels::sample::Sample;
use slipgap_problem::problem::structure::tables::schema::Drawn;
use std::sync::Arc;

/// What was measured.
pub(super) enum Given {
    /// Histories that are compared point by point.
    Histories(Measured),
    /// Tests that are compared as a sample.
    Sample(Sample),
}

/// What was measured, with the channels of histories added to those that are drawn; `None` without the key, or with a fault.
pub(super) fn decode(
    root: &Object,
    (names, units): (&Names, &str),
    reader: &Reader,
    drawn: &mut Vec<Drawn>,
    faults: &mut Faults,
) -> Option<Given> {
    let node = root.get(KEY.0)?;
    let object = open(node, KEY.0, MEASURED, faults)?;
    let need = |key: &str, faults: &mut Faults| {
        let meaning = MEASURED.iter().find(|row| row.0 == key)?.1;
        Some((object.need(key, meaning, faults)?, object.path(key)))
    };
    let before = faults.count();
    let file = need("file", faults);
    let time = need("time", faults);
    let columns = need("columns", faults);
    let time = time.and_then(|(node, path)| column(node, path, Dimension::Time, units, faults));
    let columns = columns.and_then(|(node, path)| channels(node, &path, (names, units), faults));
    let way = match object.get("compare") {
        Some(node) => name(node, &object.path("compare"), "way", &COMPARE, faults),
        None => Some(0),
    };
    if way? == 1 {
        let columns = (time?, columns?);
        let sample = sample::sample((root, &object), file?, columns, reader, faults)?;
        return (faults.count() == before).then_some(Given::Sample(sample));
    }
    let delay = reader.optional(&object, "delay", Range::Any, faults);
    let (node, path) = file?;
    let (chosen, files) = reader.files(node, &path, faults)?;
    let (time, columns) = (time?, columns?);
    if faults.count() > before {
        return None;
    }
    let of_channels: Vec<&Column> = columns.iter().map(|column| &column.1).collect();
    let tests = files.into_iter().filter_map(|file| {
        let origin = (node, &*path);
        let (test, bytes) = long_test(file, origin, (&time, &of_channels), reader, faults)?;
        reader.keep(file, &bytes);
        if let (None, Some(first)) = (&delay, test.time.first()) {
            let what = format!(
                "and its points before t = 0 are not compared: \"delay\": {} makes its first point t = 0, \"delay\": 0 ends this note",
                shortest(*first)
            );
            reader.begins(file, *first, &what);
        }
        Some((file, Arc::new(test)))
    });
    let tests = tests.collect();
    let channels = columns.into_iter().map(|(channel, column)| {
        let origin = (column.place.0.at, column.place.1);
        let number = number(&channel, origin, drawn);
        (channel, number)
    });
    let measured = Measured {
        file: chosen,
        tests,
        channels: channels.collect(),
        delay,
        delays: [0.0; 2],
        place: (node.at, path),
    };
    (faults.count() == before).then_some(Given::Histories(measured))
}

/// The content of a file with enough rows, and its bytes.
fn long_test(
    file: &str,
    (node, path): (&Node, &str),
    columns: (&Column, &[&Column]),
    reader: &Reader,
    faults: &mut Faults,
) -> Option<(Test, Vec<u8>)> {
    let found = test(file, (node, path), columns, reader, faults)?;
    let rows = found.0.time.len();
    if rows < FEWEST {
        let name = quoted(file);
        let message = format!("{name}: {rows} rows of numbers; allowed: at least {FEWEST}");
        faults.add(node.at, path, message);
    }
    Some(found)
}

/// The number of a channel among those that histories draw, to which it is added if it is not there.
fn number(channel: &Channel, origin: (usize, String), drawn: &mut Vec<Drawn>) -> usize {
    let same = |known: &Drawn| !known.error && known.channel.terms == channel.terms;
    drawn.iter().position(same).unwrap_or_else(|| {
        drawn.push(Drawn {
            name: channel.name.clone(),
            channel: channel.clone(),
            error: false,
            place: origin,
        });
        drawn.len() - 1
    })
}

/// The channels with their columns.
fn channels<'a>(
    node: &'a Node,
    path: &str,
    (names, units): (&Names, &str),
    faults: &mut Faults,
) -> Option<Vec<(Channel, Column<'a>)>> {
    let members = match &node.tree {
        Tree::Object(members) => members.iter().filter(|member| member.key != "//"),
        Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
            faults.must_be(node, path, "an object with a column for each channel");
            return None;
        }
    };
    let before = faults.count();
    let mut found: Vec<(Channel, Column)> = Vec::new();
    for member in members {
        let path = join(path, &member.key);
        let channel = match Channel::parse(&member.key, names) {
            Ok(channel) => channel,
            Err(why) => {
                let message = format!("{}: {}", quoted(&member.key), hinted(&why, names));
                faults.add(member.at, &path, message);
                continue;
            }
        };
        if let Some((same, _)) = found.iter().find(|known| known.0.terms == channel.terms) {
            let message = format!("{} is given twice, as {}", quoted(&member.key), same.name);
            faults.add(member.at, &path, message);
            continue;
        }
        let column = column(&member.node, path, channel.dimension(), units, faults);
        found.extend(column.map(|column| (channel, column)));
    }
    if found.is_empty() && faults.count() == before {
        faults.must_be(node, path, "an object with a column for each channel");
    }
    (faults.count() == before).then_some(found)
}
