//! The strength of a motion, or of the motions of a station together.

use super::set::set;
use super::target::target;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{AS_GROUND, GOALS, SCALE_TO, TOGETHER};
use crate::structure::reading::reader::{OfGround, Reader};
use slipgap_problem::problem::structure::given::scale_to::{Goal, ScaleTo};
use slipgap_system::system::loads::Unit;
use slipgap_system::system::loads::pair::Component;
use slipgap_system::system::loads::target::Fit;
use std::sync::Arc;

/// The strength of one motion: its own, or that of the ground.
pub(super) fn of_motion(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<OfGround> {
    if node.text() == Some(AS_GROUND) {
        let known = reader.of_ground.borrow().clone();
        if known.is_none() {
            let message = "the ground has no \"scale_to\" whose factor this motion could get";
            faults.add(node.at, path, message);
        }
        return known;
    }
    let object = Object::open(node, path, &SCALE_TO, faults)?;
    let before = faults.count();
    if let (Some(node), false) = (object.get("set"), path.starts_with("structure.ground")) {
        let message = "only the ground has a set; \"scale_to\": \"ground\" gives its factor";
        faults.add(node.at, &object.path("set"), message);
    }
    object.word("component", faults);
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
    let object = Object::open(node, path, &TOGETHER, faults)?;
    let before = faults.count();
    // With a factor, only the set has one.
    if object.get("factor").is_none() {
        object.need(
            "component",
            "geometric-mean, srss, rotd50 or rotd100",
            faults,
        );
    }
    let component = object.choice("component", &Component::ALL, faults);
    let scale_to = scale_to(&object, reader, faults)?;
    (faults.count() == before).then_some(ScaleTo {
        component,
        ..scale_to
    })
}

fn scale_to(object: &Object, reader: &Reader, faults: &mut Faults) -> Option<ScaleTo> {
    let goal = &*object.one_of(&GOALS, faults)?.key;
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
        Some(_) => object.choice("unit", &Unit::ALL, faults)?.in_m_s2() / reader.metre,
    };
    let mut need = |key| reader.needed(object, key, faults);
    let goal = match goal {
        "pga" => need("pga").map(Goal::PeakAcceleration),
        "factor" => need("factor").map(Goal::Factor),
        "Sa" => {
            let both = need("Sa").zip(need("T"));
            both.map(|(value, period)| Goal::Spectral { value, period })
        }
        _ => {
            let between = need("from").zip(need("to"));
            let (node, path) = object.given("spectrum", faults)?;
            let target = target(node, &path, reader, faults);
            let both = target.zip(between);
            both.map(|(target, (from, to))| Goal::Spectrum {
                target,
                between: [from, to],
            })
        }
    };
    let fit = object.choice("fit", &Fit::ALL, faults);
    if let (Some(node), None) = (object.get("factor"), object.get("set")) {
        let message = "needs a \"set\"; \"scale\" beside \"scale_to\" is a factor";
        faults.add(node.at, &object.path("factor"), message);
    }
    let ratio = reader.number(object, "ratio", faults);
    let goal = goal?;
    let set = match object.given("set", faults) {
        Some((node, path)) => Some(set(node, &path, &goal, reader, faults)?),
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
