//! Functions of time: sines, tables, records, pulses and synthetic accelerations.

use super::records::record;
use super::shape::shape;
use super::table::table;
use crate::source::faults::{Faults, join};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::structure::keys::{
    FUNCTION, FUNCTIONS, LOAD_AT, SINE, SYNTHETIC, TABLE, names, of_pulse, range,
};
use crate::structure::reading::reader::{Reader, open};
use crate::value::text;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::amount::{self, Amount};
use slipgap_problem::problem::structure::given::source::{Kind, LARGEST_SEED, Source};
use slipgap_problem::problem::structure::{given::shape::Scaled, parts::template::Load};
use slipgap_system::system::loads::pulse::PULSES;

/// A force on a node.
pub(in crate::structure) fn load(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Load> {
    let mut keys = vec![LOAD_AT.0];
    keys.extend(names(FUNCTION));
    let object = Object::open(node, path, &keys, faults)?;
    let at_node = object.need(LOAD_AT.0, LOAD_AT.1, faults);
    let at = at_node.and_then(|node| {
        let path = object.path("at");
        reader.moved(&text(node, &path, faults)?, node.at, &path, faults)
    });
    if let Some(node) = object.get("scale_to") {
        let message = "only an acceleration is scaled to a strength";
        faults.add(node.at, &object.path("scale_to"), message);
    }
    let force = function(&object, node.at, path, reader, faults);
    Some(Load {
        at: at?,
        force: force?,
    })
}

/// A function of time with its scale.
pub(in crate::structure) fn scaled(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Scaled> {
    let object = open(node, path, FUNCTION, faults)?;
    function(&object, node.at, path, reader, faults)
}

/// The same; nothing moves in place of a function with a fault, so that only the fault itself has a message.
pub(super) fn known(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Scaled {
    let none = || Scaled {
        source: Source::new(
            Kind::Table {
                t: Vec::new(),
                f: Vec::new(),
            },
            (node.at, path.to_owned()),
        ),
        scale: None,
        shape: Box::default(),
    };
    scaled(node, path, reader, faults).unwrap_or_else(none)
}

/// Keys that only a record has, and the message for another function with one.
const OF_RECORDS: [(&str, &str); 5] = [
    (
        "unit",
        "only a record has a unit; other functions are in the units of the study",
    ),
    ("mean", "only the mean of a record is removed or kept"),
    ("column", "only a record has columns"),
    ("dt", "only a record has a time step"),
    ("component", "only a record has components"),
];

/// The function of an object, whose other keys belong to something else.
pub(in crate::structure) fn function(
    object: &Object,
    at: usize,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Scaled> {
    let kinds = &FUNCTION[..FUNCTIONS];
    let members = object.members.iter();
    let given: Vec<_> = members
        .filter(|member| kinds.iter().any(|kind| kind.0 == member.key))
        .collect();
    let [member] = given[..] else {
        let names: Vec<&str> = kinds.iter().map(|kind| kind.0).collect();
        object.fault(
            format!("must have exactly one of {}", names.join(", ")),
            faults,
        );
        return None;
    };
    for (key, message) in OF_RECORDS {
        if let (Some(node), false) = (object.get(key), member.key == "record") {
            faults.add(node.at, &object.path(key), message);
        }
    }
    let inner = join(path, &member.key);
    let scale = reader.optional(object, "scale", Range::Any, faults);
    let shape = shape(object, reader, faults);
    let kind = match member.key.as_str() {
        "sine" => sine(&member.node, &inner, reader, faults),
        "table" => {
            let [t, f] = table(&member.node, &inner, (TABLE, ["t", "f"]), reader, faults)?;
            Some(Kind::Table { t, f })
        }
        "record" => record(&member.node, &inner, object, reader, faults),
        "pulse" => pulse(&member.node, &inner, reader, faults),
        _ => synthetic(&member.node, &inner, reader, faults),
    };
    Some(Scaled {
        source: Source::new(kind?, (at, path.to_owned())),
        scale,
        shape: shape?,
    })
}

fn sine(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Kind> {
    let object = open(node, path, SINE, faults)?;
    let mut need = |key| reader.needed(&object, SINE, key, faults);
    let (amplitude, omega) = (need("amplitude"), need("omega"));
    Some(Kind::Sine {
        amplitude: amplitude?,
        omega: omega?,
        phase: reader.optional(&object, "phase", Range::Any, faults),
    })
}

fn pulse(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Kind> {
    let forms = PULSES.map(|pulse| pulse.name);
    let object = Object::open(node, path, &forms, faults)?;
    let [member] = object.members[..] else {
        object.fault(
            format!("must have exactly one of {}", forms.join(", ")),
            faults,
        );
        return None;
    };
    let pulse = PULSES.iter().find(|pulse| pulse.name == member.key)?;
    let keys = pulse.numbers;
    let object = open(&member.node, &object.path(&member.key), keys, faults)?;
    let given = keys.iter().map(|(key, meaning)| {
        let node = object.need(key, meaning, faults)?;
        reader.amount(node, &object.path(key), of_pulse(key), faults)
    });
    // Each number with a fault is reported.
    let read: Vec<Option<Amount>> = given.collect();
    let numbers: Option<Vec<Amount>> = read.into_iter().collect();
    Some(Kind::Pulse(pulse, numbers?))
}

/// A seed, plain or in an object with the frequency of the ground filter.
fn synthetic(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Kind> {
    let Tree::Object(_) = &node.tree else {
        let seed = reader.amount(node, path, range(SYNTHETIC, "seed"), faults);
        return Some(Kind::Synthetic {
            seed: whole(seed?, faults)?,
            omega: None,
        });
    };
    let object = open(node, path, SYNTHETIC, faults)?;
    let before = faults.count();
    let amount = reader.needed(&object, SYNTHETIC, "seed", faults);
    let seed = amount.and_then(|seed| whole(seed, faults));
    let omega = reader.optional(&object, "omega", range(SYNTHETIC, "omega"), faults);
    let complete = faults.count() == before;
    Some(Kind::Synthetic { seed: seed?, omega }).filter(|_| complete)
}

/// A seed; a plain number is reported here if it is not whole, so that all faults are reported together.
fn whole(seed: Amount, faults: &mut Faults) -> Option<Amount> {
    if let amount::Source::Number(x) = seed.source
        && let Err(violation) = seed.as_whole(x, 0, LARGEST_SEED)
    {
        faults.add(seed.at, &seed.path, violation.message);
        return None;
    }
    Some(seed)
}
