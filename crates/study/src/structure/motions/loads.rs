//! Functions of time: sines, tables, records, pulses and synthetic accelerations.

use super::records::record;
use super::shape::shape;
use super::table::table;
use crate::source::faults::{Faults, join};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{FUNCTION, FUNCTIONS, LOAD, PULSE, SINE, SYNTHETIC, TABLE};
use crate::structure::reading::reader::Reader;
use crate::value::text;
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
    let object = Object::open(node, path, &LOAD, faults)?;
    let at_node = object.given("at", faults);
    let at = at_node
        .and_then(|(node, path)| reader.moved(&text(node, &path, faults)?, node.at, &path, faults));
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
    let object = Object::open(node, path, &FUNCTION, faults)?;
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
    let member = object.one_of(&FUNCTIONS, faults)?;
    for (key, message) in OF_RECORDS {
        if let (Some(node), false) = (object.get(key), member.key == "record") {
            faults.add(node.at, &object.path(key), message);
        }
    }
    let inner = join(path, &member.key);
    let scale = reader.number(object, "scale", faults);
    let shape = shape(object, reader, faults);
    let kind = match member.key.as_str() {
        "sine" => sine(&member.node, &inner, reader, faults),
        "table" => {
            let [t, f] = table(&member.node, &inner, &TABLE, reader, faults)?;
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
    let object = Object::open(node, path, &SINE, faults)?;
    let ([amplitude, omega], phase) = sine_of(&object, reader, faults)?;
    Some(Kind::Sine {
        amplitude,
        omega,
        phase,
    })
}

/// Amplitude and circular frequency of a sine, and its phase.
pub(super) fn sine_of(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<([Amount; 2], Option<Amount>)> {
    let mut number = |key| reader.number(object, key, faults);
    let (amplitude, omega, phase) = (number("amplitude"), number("omega"), number("phase"));
    Some(([amplitude?, omega?], phase))
}

fn pulse(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Kind> {
    let forms = Object::open(node, path, &PULSE, faults)?;
    let member = forms.one_of(&PULSE.names(), faults)?;
    let form = forms.object(&member.key, faults)?;
    let fields = form.keys().fields();
    // Each number with a fault is reported.
    let read: Vec<Option<Amount>> = fields
        .map(|field| reader.number(&form, field.name, faults))
        .collect();
    let numbers: Option<Vec<Amount>> = read.into_iter().collect();
    let pulse = PULSES.iter().find(|pulse| pulse.name == member.key)?;
    Some(Kind::Pulse(pulse, numbers?))
}

/// A seed, plain or in an object with the frequency of the ground filter.
fn synthetic(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Kind> {
    if node.object().is_none() {
        let seed = reader.amount(node, path, SYNTHETIC.range("seed"), faults);
        return Some(Kind::Synthetic {
            seed: whole(seed?, faults)?,
            omega: None,
        });
    }
    let object = Object::open(node, path, &SYNTHETIC, faults)?;
    let before = faults.count();
    let amount = reader.number(&object, "seed", faults);
    let seed = amount.and_then(|seed| whole(seed, faults));
    let omega = reader.number(&object, "omega", faults);
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
