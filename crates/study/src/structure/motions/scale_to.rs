//! The strength of a motion, or of the motions of a station together.

use super::set::{component, set};
use super::target::target;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::structure::keys::{AS_GROUND, GOALS, SCALE_TO, names, range};
use crate::structure::reading::reader::{OfGround, Reader, open};
use crate::value::name;
use slipgap_problem::problem::structure::given::scale_to::{Goal, ScaleTo};
use slipgap_system::system::loads::Unit;
use slipgap_system::system::loads::target::Fit;
use std::sync::Arc;

/// The component of a motion that has a factor of its own.
const EACH: &str = "each";

/// The strength of one motion: its own, or that of the ground.
pub(super) fn of_motion(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<OfGround> {
    if let Tree::Text(text) = &node.tree
        && text == AS_GROUND
    {
        let known = reader.of_ground.borrow().clone();
        if known.is_none() {
            let message = "the ground has no \"scale_to\" whose factor this motion could get";
            faults.add(node.at, path, message);
        }
        return known;
    }
    let object = open(node, path, SCALE_TO, faults)?;
    let before = faults.count();
    if let (Some(node), false) = (object.get("set"), path.starts_with("structure.ground")) {
        let message = "only the ground has a set; \"scale_to\": \"ground\" gives its factor";
        faults.add(node.at, &object.path("set"), message);
    }
    if let Some(node) = object.get("component") {
        name(
            node,
            &object.path("component"),
            "component",
            &[EACH],
            faults,
        );
    }
    let scale_to = scale_to(&object, reader, faults)?;
    (faults.count() == before).then(|| (Arc::new(scale_to), None))
}

/// The strength of both horizontal motions together.
pub(super) fn of_pair(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<ScaleTo> {
    let object = open(node, path, SCALE_TO, faults)?;
    let before = faults.count();
    // With a factor, only the set has one.
    let given = match object.get("factor") {
        Some(_) => object.get("component"),
        None => object.need(
            "component",
            "geometric-mean, srss, rotd50 or rotd100",
            faults,
        ),
    };
    let component = given.and_then(|node| component(node, &object.path("component"), faults));
    let scale_to = scale_to(&object, reader, faults)?;
    (faults.count() == before).then_some(ScaleTo {
        component,
        ..scale_to
    })
}

fn scale_to(object: &Object, reader: &Reader, faults: &mut Faults) -> Option<ScaleTo> {
    let goals = names(&SCALE_TO[..GOALS]);
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
        "Sa" => &["T", "ratio"],
        "spectrum" => &["from", "to", "ratio", "fit"],
        _ => &[],
    };
    let set_has = |key: &str| key == "ratio" && object.get("set").is_some();
    for key in ["T", "ratio", "from", "to", "fit"] {
        if let (Some(node), false) = (object.get(key), of_goal.contains(&key) || set_has(key)) {
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
            let index = name(node, &object.path("unit"), "unit", &names, faults)?;
            Unit::ALL[index].in_m_s2() / reader.metre
        }
    };
    let mut need = |key| reader.needed(object, SCALE_TO, key, faults);
    let goal = match goal {
        "pga" => need("pga").map(Goal::PeakAcceleration),
        "factor" => need("factor").map(Goal::Factor),
        "Sa" => {
            let both = need("Sa").zip(need("T"));
            both.map(|(value, period)| Goal::Spectral { value, period })
        }
        _ => {
            let between = need("from").zip(need("to"));
            let node = object.get("spectrum")?;
            let target = target(node, &object.path("spectrum"), reader, faults);
            let both = target.zip(between);
            both.map(|(target, (from, to))| Goal::Spectrum {
                target,
                between: [from, to],
            })
        }
    };
    let fit = object.get("fit").and_then(|node| {
        let names = Fit::ALL.map(Fit::name);
        let index = name(node, &object.path("fit"), "fit", &names, faults)?;
        Some(Fit::ALL[index])
    });
    if let (Some(node), None) = (object.get("factor"), object.get("set")) {
        let message = "needs a \"set\"; \"scale\" beside \"scale_to\" is a factor";
        faults.add(node.at, &object.path("factor"), message);
    }
    let ratio = reader.optional(object, "ratio", range(SCALE_TO, "ratio"), faults);
    let goal = goal?;
    let set = match object.get("set") {
        Some(node) => Some(set(node, &object.path("set"), &goal, reader, faults)?),
        None => None,
    };
    Some(ScaleTo {
        goal,
        unit,
        ratio,
        fit: fit.unwrap_or_default(),
        component: None,
        set: set.map(Box::new),
    })
}
