//! Supports with motions of their own: an acceleration, or one in each direction, with a delay.

use super::keys::{BASELINES, DISPLACEMENT, FUNCTION, GROUND, IMPOSED, SUPPORT, names};
use super::loads::{function, table};
use super::parts::Part;
use super::reader::Reader;
use crate::source::faults::{Faults, join};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::value::name;
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::template::{Course, Support};
use slipgap_solver::system::structure::{Baseline, Direction};

/// The directions x, y and z in which a support moves.
pub(super) fn directions(node: &Node) -> [bool; 3] {
    let Tree::Object(members) = &node.tree else {
        return [true, false, false];
    };
    let given = |direction: Direction| members.iter().any(|one| one.key == direction.name());
    match Direction::TRANSLATIONS.map(given) {
        [false, false, false] => [true, false, false],
        by_directions => by_directions,
    }
}

/// The motions of the supports, in the order of their numbers.
pub(super) fn supports(parts: &[Part], reader: &Reader, faults: &mut Faults) -> Vec<Support> {
    let all = parts.iter();
    all.flat_map(|part| support(part, reader, faults).unwrap_or_default())
        .collect()
}

/// `ground` together with `supports`.
pub(super) fn refuse_ground(object: &Object, faults: &mut Faults) {
    if let (Some(_), Some(supports)) = (object.get("ground"), object.get("supports")) {
        let message = "give ground or supports, not both: u is relative to the ground, but absolute with supports; \"ground\" is a node that does not move there";
        faults.add(supports.at, &object.path("supports"), message);
    }
}

fn support(
    (own_name, node, path): &Part,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<Support>> {
    let mut keys = names(FUNCTION);
    keys.extend(names(GROUND).into_iter().chain(names(SUPPORT)));
    let object = Object::open(node, path, &keys, faults)?;
    let delay = reader.optional(&object, "delay", Range::NotNegative, faults);
    let baseline = match object.get("baseline") {
        None => Baseline::None,
        Some(node) => {
            name(
                node,
                &object.path("baseline"),
                "baseline",
                &BASELINES,
                faults,
            )?;
            Baseline::Linear
        }
    };
    let support = |direction, course| Support {
        name: own_name.clone(),
        direction,
        course,
        delay: delay.clone(),
        baseline,
    };
    let given = directions(node);
    let members = object.members.iter();
    let plain = members.clone().find(|member| is_course(&member.key));
    let by_directions = members
        .clone()
        .any(|member| GROUND.iter().any(|key| key.0 == member.key));
    if !by_directions {
        let course = course(&object, node.at, path, reader, faults)?;
        return Some(vec![support(Direction::X, course)]);
    }
    if let Some(member) = plain {
        let message = "give a function of time, which is the motion in x, or x, y and z, not both";
        faults.add(member.at, &join(path, &member.key), message);
        return None;
    }
    let one = |(direction, given): (Direction, bool)| {
        let node = object.get(direction.name()).filter(|_| given)?;
        let path = object.path(direction.name());
        let mut keys = names(FUNCTION);
        keys.push(DISPLACEMENT.0);
        let object = Object::open(node, &path, &keys, faults)?;
        let course = course(&object, node.at, &path, reader, faults)?;
        Some(support(direction, course))
    };
    let all: Vec<Support> = (Direction::TRANSLATIONS.into_iter().zip(given))
        .filter_map(one)
        .collect();
    Some(all)
}

/// Whether a key says how a support moves.
fn is_course(key: &str) -> bool {
    key == DISPLACEMENT.0 || FUNCTION.iter().any(|own| own.0 == key)
}

/// The acceleration or the displacements of an object.
fn course(
    object: &Object,
    at: usize,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Course> {
    let Some(node) = object.get(DISPLACEMENT.0) else {
        return Some(Course::Acceleration(function(
            object, at, path, reader, faults,
        )?));
    };
    let mut others = object.members.iter();
    let other =
        others.find(|own| FUNCTION.iter().any(|key| key.0 == own.key) || own.key == "baseline");
    if let Some(other) = other {
        let message = format!("a support with displacements has no {}", other.key);
        faults.add(other.at, &join(path, &other.key), message);
        return None;
    }
    let path = object.path(DISPLACEMENT.0);
    let points = table(node, &path, IMPOSED, reader, faults)?;
    Some(Course::Displacement(points, (node.at, path)))
}
