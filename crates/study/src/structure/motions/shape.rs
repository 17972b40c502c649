//! What is done to the function of a motion: `start`, `end`, `baseline`, `scale_to` and `delay`.

use super::table::table;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{
    ASCE_7, EN_1998, FUNCTION, Keys, SCALE_TO, SPECTRUM, TARGET_TABLE, names, range,
};
use crate::structure::reading::reader::{Reader, open};
use crate::value::name;
use slipgap_problem::problem::structure::given::amount::Amount;
use slipgap_problem::problem::structure::given::scale_to::{Goal, ScaleTo, TargetSpectrum};
use slipgap_problem::problem::structure::given::shape::Shape;
use slipgap_system::system::loads::Unit;
use slipgap_system::system::structure::Baseline;

/// What an object does to its function.
pub(in crate::structure) fn shape(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Box<Shape>> {
    let before = faults.count();
    let mut time = |key| reader.optional(object, key, range(FUNCTION, key), faults);
    let mut shape = Box::<Shape>::default();
    shape.start = time("start");
    shape.end = time("end");
    shape.delay = time("delay");
    shape.baseline = baseline(object, faults).unwrap_or_default();
    shape.scale_to = object
        .get("scale_to")
        .and_then(|node| scale_to(node, &object.path("scale_to"), reader, faults));
    (faults.count() == before).then_some(shape)
}

/// The baseline of an object.
pub(in crate::structure) fn baseline(object: &Object, faults: &mut Faults) -> Option<Baseline> {
    let node = object.get("baseline")?;
    let names = Baseline::ALL.map(Baseline::name);
    let place = name(node, &object.path("baseline"), "baseline", &names, faults)?;
    Some(Baseline::ALL[place])
}

fn scale_to(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<ScaleTo> {
    let object = open(node, path, SCALE_TO, faults)?;
    let goals = names(SCALE_TO)[..3].to_vec();
    let given: Vec<&str> = goals
        .iter()
        .copied()
        .filter(|key| object.get(key).is_some())
        .collect();
    let [goal] = given[..] else {
        object.fault(
            format!("must have exactly one of {}", goals.join(", ")),
            faults,
        );
        return None;
    };
    // Keys that only some goals have.
    let of_goal: &[&str] = match goal {
        "pga" => &[],
        "Sa" => &["T", "ratio"],
        _ => &["from", "to", "ratio"],
    };
    for key in ["T", "ratio", "from", "to"] {
        if let (Some(node), false) = (object.get(key), of_goal.contains(&key)) {
            faults.add(
                node.at,
                &object.path(key),
                format!("does not apply to {goal}"),
            );
        }
    }
    let unit = match object.get("unit") {
        None => 1.0,
        Some(node) => {
            let names = Unit::ALL.map(Unit::name);
            let place = name(node, &object.path("unit"), "unit", &names, faults)?;
            Unit::ALL[place].in_m_s2() / reader.metre
        }
    };
    let mut need = |key| reader.needed(&object, SCALE_TO, key, faults);
    let goal = match goal {
        "pga" => Goal::PeakAcceleration(need("pga")?),
        "Sa" => {
            let (value, period) = (need("Sa"), need("T"));
            Goal::Spectral {
                value: value?,
                period: period?,
                ratio: ratio(&object, reader, faults)?,
            }
        }
        _ => {
            let between = [need("from"), need("to")];
            let ratio = ratio(&object, reader, faults);
            let node = object.get("spectrum")?;
            let target = target(node, &object.path("spectrum"), reader, faults);
            let [from, to] = between;
            Goal::Spectrum {
                target: target?,
                between: [from?, to?],
                ratio: ratio?,
            }
        }
    };
    Some(ScaleTo { goal, unit })
}

/// The damping ratio, if there is one.
fn ratio(object: &Object, reader: &Reader, faults: &mut Faults) -> Option<Option<Amount>> {
    let before = faults.count();
    let ratio = reader.optional(object, "ratio", range(SCALE_TO, "ratio"), faults);
    (faults.count() == before).then_some(ratio)
}

/// A target spectrum: periods and ordinates, or the shape of a code.
fn target(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<TargetSpectrum> {
    let mut keys = names(SPECTRUM);
    keys.extend(names(TARGET_TABLE));
    let object = Object::open(node, path, &keys, faults)?;
    let code = names(SPECTRUM)
        .into_iter()
        .find(|key| object.get(key).is_some());
    let Some(code) = code else {
        let table = table(node, path, (TARGET_TABLE, ["T", "Sa"]), reader, faults);
        return table.map(TargetSpectrum::Table);
    };
    if object.members.len() > 1 {
        let message = "must have T and Sa, or one of EN 1998-1, ASCE 7";
        object.fault(message, faults);
        return None;
    }
    let (node, path) = (object.get(code)?, object.path(code));
    let all = |keys: Keys, faults: &mut Faults| {
        let object = open(node, &path, keys, faults)?;
        let values = keys
            .iter()
            .map(|key| reader.needed(&object, keys, key.0, faults));
        // All are read, so that every fault is reported.
        let values: Vec<Option<Amount>> = values.collect();
        values.into_iter().collect::<Option<Vec<Amount>>>()
    };
    if code == SPECTRUM[0].0 {
        let five = all(EN_1998, faults)?.try_into().ok()?;
        return Some(TargetSpectrum::En1998(Box::new(five)));
    }
    let three = all(ASCE_7, faults)?.try_into().ok()?;
    Some(TargetSpectrum::Asce7(Box::new(three)))
}
