//! Measurements of a structure: the key `measured`, whose files have columns of channels over time.

use super::files::bytes;
use super::keys::{COLUMN, MEASURED};
use super::named_metrics::hinted;
use super::reader::{Reader, open};
use crate::source::faults::{Faults, join, quoted};
use crate::source::hint::nearest;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::text;
use slipgap_solver::problem::interned;
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::channel::Channel;
use slipgap_solver::problem::structure::measured::{FEWEST, Measured, Test};
use slipgap_solver::problem::structure::names::Names;
use slipgap_solver::problem::structure::schema::Drawn;
use slipgap_solver::problem::structure::template::Chosen;
use slipgap_solver::problem::structure::unit_consistency::{dimension_of, examples};
use slipgap_solver::problem::structure::units::UnitNames;
use slipgap_solver::problem::unit::Dimension;
use slipgap_solver::system::measured_table::MeasuredTable;
use std::sync::Arc;

/// The key with its meaning.
pub(crate) const KEY: (&str, &str) = (
    "measured",
    "measured channels of a study of structures, with which its metrics compare, as in rms_error(deck.u, measured)",
);

/// Most bytes of a file.
const LARGEST: u64 = 64 << 20;

/// A column of a file.
pub(super) struct Column<'a> {
    name: String,
    /// Its unit in that of the study.
    factor: f64,
    place: (&'a Node, String),
}

/// What was measured, with the channels added to those that histories draw; `None` without the key, or with a fault.
pub(super) fn decode(
    root: &Object,
    (names, units): (&Names, &str),
    reader: &Reader,
    drawn: &mut Vec<Drawn>,
    faults: &mut Faults,
) -> Option<Measured> {
    let node = root.get(KEY.0)?;
    let object = open(node, KEY.0, MEASURED, faults)?;
    let need = |key: &str, faults: &mut Faults| {
        let meaning = MEASURED.iter().find(|own| own.0 == key)?.1;
        Some((object.need(key, meaning, faults)?, object.path(key)))
    };
    let before = faults.count();
    let file = need("file", faults);
    let time = need("time", faults);
    let columns = need("columns", faults);
    let time = time.and_then(|(node, path)| column(node, path, Dimension::Time, units, faults));
    let columns = columns.and_then(|(node, path)| channels(node, &path, (names, units), faults));
    let delay = reader.optional(&object, "delay", Range::Any, faults);
    let (node, path) = file?;
    let (chosen, files) = chosen(node, &path, reader, faults)?;
    let (time, columns) = (time?, columns?);
    if faults.count() > before {
        return None;
    }
    let of_channels: Vec<&Column> = columns.iter().map(|own| &own.1).collect();
    let tests = files.into_iter().filter_map(|file| {
        let test = test(file, (node, &path), (&time, &of_channels), reader, faults)?;
        let rows = test.time.len();
        if rows < FEWEST {
            let name = quoted(file);
            let message = format!("{name}: {rows} rows of numbers; allowed: at least {FEWEST}");
            faults.add(node.at, &path, message);
        }
        Some((file, Arc::new(test)))
    });
    let tests = tests.collect();
    let channels = columns.into_iter().map(|(channel, own)| {
        let place = (own.place.0.at, own.place.1);
        let number = number(&channel, place, drawn);
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
    (faults.count() == before).then_some(measured)
}

/// The number of a channel among those that histories draw, to which it is added if it is not there.
fn number(channel: &Channel, place: (usize, String), drawn: &mut Vec<Drawn>) -> usize {
    let same = |own: &Drawn| !own.error && own.channel.terms == channel.terms;
    drawn.iter().position(same).unwrap_or_else(|| {
        drawn.push(Drawn {
            name: channel.name.clone(),
            channel: channel.clone(),
            error: false,
            place,
        });
        drawn.len() - 1
    })
}

/// The file, or the parameter that chooses one, and all of the files.
pub(super) fn chosen(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<(Chosen, Vec<&'static str>)> {
    let file = text(node, path, faults)?;
    Some(match reader.choices(&file) {
        Some((row, files)) => (
            Chosen::Parameter(row),
            files.iter().map(|file| file.0).collect(),
        ),
        None => {
            let file = interned(&file);
            (Chosen::Name(file), vec![file])
        }
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
        _ => {
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
        if let Some((same, _)) = found.iter().find(|own| own.0.terms == channel.terms) {
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

/// A column of a quantity of this dimension: its name, or an object with its unit.
pub(super) fn column<'a>(
    node: &'a Node,
    path: String,
    dimension: Dimension,
    units: &str,
    faults: &mut Faults,
) -> Option<Column<'a>> {
    let Tree::Object(_) = &node.tree else {
        if !matches!(node.tree, Tree::Text(_)) {
            let wanted = "the name of a column, or an object with column and unit";
            faults.must_be(node, &path, wanted);
            return None;
        }
        return Some(Column {
            name: text(node, &path, faults)?,
            factor: 1.0,
            place: (node, path),
        });
    };
    let object = open(node, &path, COLUMN, faults)?;
    let (key, meaning) = COLUMN[0];
    let own = object.need(key, meaning, faults)?;
    let place = (own, object.path(key));
    let name = text(own, &place.1, faults)?;
    let factor = match object.get("unit") {
        Some(node) => factor(node, &object.path("unit"), dimension, units, faults)?,
        None => 1.0,
    };
    Some(Column {
        name,
        factor,
        place,
    })
}

/// A unit in that of the study.
fn factor(
    node: &Node,
    path: &str,
    dimension: Dimension,
    units: &str,
    faults: &mut Faults,
) -> Option<f64> {
    let unit = text(node, path, faults)?;
    let shown = quoted(&unit);
    let what = dimension.in_words();
    let message = match dimension_of(&unit) {
        Some(own) if own == dimension => match UnitNames::of(units) {
            Some(study) => match study.factor(&unit, dimension) {
                Some(factor) => return Some(factor),
                None => format!(
                    "the study's unit of {what}, {}, is not known; leave out the unit, with the column in that of the study",
                    quoted(&study.of_dimension(dimension))
                ),
            },
            None => "needs \"units\" in \"structure\", as in \"t, kN, m, s\"".to_owned(),
        },
        Some(own) => format!(
            "must be a unit of {what}, got {shown}, one of {}; allowed: {}",
            own.in_words(),
            examples(dimension)
        ),
        None => format!(
            "unknown unit {shown} of {what}; allowed: {}",
            examples(dimension)
        ),
    };
    faults.add(node.at, path, message);
    None
}

/// The content of a file, in the units of the study.
pub(super) fn test(
    file: &str,
    (node, path): (&Node, &str),
    (time, columns): (&Column, &[&Column]),
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Test> {
    let refuse = |why: String, (node, path): (&Node, &str), faults: &mut Faults| {
        faults.add(node.at, path, format!("{}: {why}", quoted(file)));
    };
    let place = (node, path);
    let bytes = match bytes(&reader.folder.join(file), LARGEST) {
        Ok(bytes) => bytes,
        Err(why) => {
            refuse(why, place, faults);
            return None;
        }
    };
    let table = match MeasuredTable::read(file, &bytes) {
        Ok(table) => table,
        Err(why) => {
            refuse(format!("line {}: {}", why.line, why.cause), place, faults);
            return None;
        }
    };
    let mut numbers = |column: &Column, rise: bool| {
        let found = match rise {
            true => table.times(&column.name),
            false => table.column(&column.name),
        };
        let own = (column.place.0, column.place.1.as_str());
        match found {
            Ok(numbers) => {
                let numbers: Vec<f64> = numbers.iter().map(|x| x * column.factor).collect();
                if numbers.iter().all(|x| x.is_finite()) {
                    return Some(numbers);
                }
                let name = quoted(&column.name);
                refuse(
                    format!("column {name} is too large in the units of the study"),
                    own,
                    faults,
                );
            }
            Err(why) => {
                // The study has the name of a column that is not there, the file has the other faults.
                let known: Vec<&str> = table.names().iter().map(String::as_str).collect();
                let is_known = known.contains(&column.name.as_str());
                let hint = match nearest(&column.name, &known).filter(|_| !is_known) {
                    Some(near) => format!(", did you mean {}?", quoted(near)),
                    None => String::new(),
                };
                let place = if is_known { place } else { own };
                refuse(
                    format!("line {}: {}{hint}", why.line, why.cause),
                    place,
                    faults,
                );
            }
        }
        None
    };
    let time = numbers(time, true);
    let values: Vec<Option<Vec<f64>>> = columns.iter().map(|own| numbers(own, false)).collect();
    let (time, values) = (time?, values.into_iter().collect::<Option<Vec<_>>>()?);
    reader.keep(file, bytes);
    Some(Test { time, values })
}
