//! The key `names`: what figures write instead of parameters, contacts, channels, records and programs.

use crate::source::faults::{Faults, join};
use crate::source::field::{Field, Kind, field};
use crate::source::object::Object;
use crate::source::tree::Member;
use crate::structure::programs;
use crate::structure::reading::reader::Reader;
use crate::value::text;
use slipgap_problem::problem::expression::printable;
use slipgap_problem::problem::structure::channels::channel::Channel;
use slipgap_problem::problem::structure::channels::channel_words::Shown;
use slipgap_problem::problem::structure::channels::names::Names;
use slipgap_problem::problem::structure::tables::schema::Named;
use std::path::Path;

/// The key of names for figures, with its meaning.
pub(crate) const SHOWN: Field = field("names", Kind::Shared("names"))
    .means("names in figures, of a structure: of a parameter or channel, with its unit, as in {\"gap\": [\"width of the gap\", \"m\"], \"g1.right - p2\": [\"seat displacement\"]}; of a contact, for its channels and metrics; of a record by its file; default: event, station and component of the header; of a program, in any problem");

/// What names are of.
enum Of {
    Parameter(usize),
    Contact,
    Channel(Channel),
    /// The file of a record, or a program.
    Value(String),
}

/// Reads the names that figures write.
pub(in crate::structure) fn shown(
    root: &Object,
    (parameters, names): (&mut [Named], &Names),
    reader: &Reader,
    faults: &mut Faults,
) -> Shown {
    let mut shown = Shown::default();
    let headings = reader
        .headings
        .borrow()
        .iter()
        .map(|(file, heading)| (file.clone(), printable(&heading.words())))
        .collect::<Vec<_>>();
    let mut values = record_names(&headings);
    let programs = programs::names(reader.root).into_iter();
    values.extend(programs.map(|name| (name.to_owned(), name.to_owned())));
    if let Some(node) = root.get(SHOWN.name) {
        let mut known: Vec<String> = parameters
            .iter()
            .map(|parameter| parameter.name.clone())
            .collect();
        known.extend(names.named_contacts().map(str::to_owned));
        known.extend(values.iter().map(|value| value.0.clone()));
        known.extend(names.channels());
        // Channels of all nodes, and sums, are too many for a list.
        if let Some(members) = node.object() {
            let keys = members.iter().map(|member| &member.key);
            known.extend(
                keys.filter(|key| of(key, (parameters, names), &values).is_some())
                    .cloned(),
            );
        }
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        let object = Object::of_keys(node, SHOWN.name, &known, faults);
        for own in object.iter().flat_map(|object| &object.members) {
            let Some(of) = of(&own.key, (parameters, names), &values) else {
                continue;
            };
            let Some(mut texts) = of.texts(own, faults) else {
                continue;
            };
            let unit = texts.get_mut(1).map(std::mem::take).unwrap_or_default();
            let name = texts.swap_remove(0);
            match of {
                Of::Parameter(row) => parameters[row].shown = Some([name, unit]),
                Of::Contact => shown.contacts.push((own.key.clone(), name)),
                Of::Channel(channel) => shown.channels.push((channel, [name, unit])),
                Of::Value(given) => {
                    let known = values.iter_mut().find(|known| known.0 == given);
                    known
                        .into_iter()
                        .for_each(|known| known.1.clone_from(&name));
                }
            }
        }
    }
    for named in parameters {
        let choices = named.choices.unwrap_or_default().iter();
        let given = choices.filter_map(|choice| values.iter().find(|value| value.0 == choice.0));
        named.shown_values = given.cloned().collect();
    }
    shown
}

impl Of {
    /// Most texts of its name: only what is a number has a unit.
    fn most_texts(&self) -> usize {
        match self {
            Of::Parameter(_) | Of::Channel(_) => 2,
            Of::Contact | Of::Value(_) => 1,
        }
    }

    /// The texts of its name.
    fn texts(&self, member: &Member, faults: &mut Faults) -> Option<Vec<String>> {
        let path = join(SHOWN.name, &member.key);
        let counts = 1..=self.most_texts();
        let list = member.node.list();
        let Some(items) = list.filter(|items| counts.contains(&items.len())) else {
            faults.must_be(&member.node, &path, self.form());
            return None;
        };
        let numbered = items.iter().enumerate();
        let read = numbered.map(|(i, item)| text(item, &format!("{path}[{i}]"), faults));
        read.collect()
    }

    fn form(&self) -> &'static str {
        match self {
            Of::Parameter(_) | Of::Channel(_) => {
                "a list of a name and a unit, as in [\"gap\", \"m\"]"
            }
            Of::Contact | Of::Value(_) => "a list of a name, as in [\"gap at the pier\"]",
        }
    }
}

/// The names that figures write for programs, in a study without a structure.
pub(crate) fn of_programs(
    root: &Object,
    programs: &[&str],
    faults: &mut Faults,
) -> Vec<(String, String)> {
    let node = root.get(SHOWN.name).filter(|_| !programs.is_empty());
    let object = node.and_then(|node| Object::of_keys(node, SHOWN.name, programs, faults));
    let members = object.iter().flat_map(|object| &object.members);
    let named = members.filter_map(|member| {
        let texts = Of::Value(member.key.clone()).texts(member, faults)?;
        Some((member.key.clone(), texts.into_iter().next()?))
    });
    named.collect()
}

/// What a key names: a parameter before a part of the structure with the same name.
fn of(
    key: &str,
    (parameters, names): (&[Named], &Names),
    values: &[(String, String)],
) -> Option<Of> {
    if let Some(row) = parameters
        .iter()
        .position(|parameter| parameter.name == *key)
    {
        return Some(Of::Parameter(row));
    }
    if names.named_contacts().any(|contact| contact == key) {
        return Some(Of::Contact);
    }
    let mut named = values
        .iter()
        .map(|value| &value.0)
        .filter(|value| *value == key || name(value) == key);
    match (named.next(), named.next()) {
        (Some(value), None) => Some(Of::Value(value.clone())),
        _ => Channel::parse(key, names).ok().map(Of::Channel),
    }
}

/// The name of a file without its folders.
fn name(file: &str) -> &str {
    file.rsplit(['/', '\\']).next().unwrap_or(file)
}

/// The name of a file without folders and ending.
fn stem(file: &str) -> String {
    let stem = Path::new(name(file)).file_stem();
    stem.map_or_else(
        || file.to_owned(),
        |stem| stem.to_string_lossy().into_owned(),
    )
}

/// The records by what their headers name, each once; by the stem of its file one without a heading, and behind it one whose
/// heading another has.
fn record_names(headings: &[(String, String)]) -> Vec<(String, String)> {
    let name = |(file, words): &(String, String)| {
        let shared = headings
            .iter()
            .any(|other| other.0 != *file && other.1 == *words);
        let words = match (words.is_empty(), shared) {
            (true, _) => stem(file),
            (false, true) => format!("{words} ({})", stem(file)),
            (false, false) => words.clone(),
        };
        (file.clone(), words)
    };
    headings.iter().map(name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_named_by_its_heading_or_its_file() {
        let owned = |(file, words): (&str, &str)| (file.to_owned(), words.to_owned());
        let headings = [
            ("a/one.AT2", "Event, Hill, 90°"),
            ("b/two.AT2", "Event, Hill, 0°"),
            ("b/three.AT2", "Event, Hill, 0°"),
            ("b/table.1.csv", ""),
        ];
        let pairs = record_names(&headings.map(owned));
        let names: Vec<&str> = pairs.iter().map(|pair| pair.1.as_str()).collect();
        assert_eq!(
            names,
            [
                "Event, Hill, 90°",
                "Event, Hill, 0° (two)",
                "Event, Hill, 0° (three)",
                "table.1"
            ]
        );
    }
}
