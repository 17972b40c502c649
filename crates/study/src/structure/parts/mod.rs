//! Masses, bars, springs, damping and start of a structure.

pub(super) mod damping;
pub(super) mod springs;

use crate::source::faults::{Faults, join};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::contacts::plane;
use crate::structure::keys::{ACCELERATIONS, BAR, GRAVITY, MASS, START};
use crate::structure::reading::reader::{Part, Reader, take_name};
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::amount::Amount;
use slipgap_problem::problem::structure::parts::template::{Bar, Mass, Moved, Start, StaticLoad};
use slipgap_system::system::structure::Direction;
use std::collections::HashSet;

/// The masses, with one part for each direction of a mass that moves in several: NAME.x, NAME.y.
pub(in crate::structure) fn in_directions<'a>(
    parts: Vec<Part<'a>>,
    faults: &mut Faults,
) -> Vec<Part<'a>> {
    let mut expanded = Vec::new();
    for (name, node, path) in parts {
        let listed = node.get("direction").filter(|given| given.list().is_some());
        let Some(listed) = listed else {
            expanded.push((name, node, path));
            continue;
        };
        let list_path = format!("{path}.direction");
        for direction in plane::directions(listed, &list_path, faults)
            .into_iter()
            .flatten()
        {
            expanded.push((format!("{name}.{}", direction.name()), node, path.clone()));
        }
    }
    expanded
}

/// The lumped masses.
pub(in crate::structure) fn masses(
    parts: &[Part],
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<Mass> {
    let mass = |(name, node, path): &Part| {
        let (mass, direction) = match node.object() {
            Some(_) => {
                let object = Object::open(node, path, &MASS, faults)?;
                let mass = reader.number(&object, "mass", faults);
                let direction = match name.split_once('.') {
                    Some((_, direction)) => Direction::named(direction),
                    None => reader.direction(&object, faults),
                };
                (mass, direction)
            }
            None => {
                let mass = reader.amount(node, path, MASS.range("mass"), faults);
                (mass, Some(Direction::X))
            }
        };
        Some(Mass {
            name: name.clone(),
            mass: mass?,
            direction: direction?,
        })
    };
    parts.iter().filter_map(mass).collect()
}

/// The bars.
pub(in crate::structure) fn bars(parts: &[Part], reader: &Reader, faults: &mut Faults) -> Vec<Bar> {
    let mut bar = |(name, node, path): &Part| {
        let object = Object::open(node, path, &BAR, faults)?;
        let mut number = |key| reader.number(&object, key, faults);
        let (length, stiffness) = (number("L"), number("EA"));
        let (mass, elements) = (number("mass"), number("n"));
        let stiffness_damping = number("stiffness_damping");
        let direction = reader.direction(&object, faults);
        Some(Bar {
            name: name.clone(),
            length: length?,
            stiffness: stiffness?,
            mass: mass?,
            elements: elements?,
            stiffness_damping,
            direction: direction?,
        })
    };
    parts.iter().filter_map(&mut bar).collect()
}

/// Reports names of springs that are no names, or those of other parts.
pub(in crate::structure) fn check_spring_names(
    object: &Object,
    taken: &mut HashSet<String>,
    faults: &mut Faults,
) {
    let springs = object.get("springs").and_then(Node::list);
    for (i, spring) in springs.unwrap_or_default().iter().enumerate() {
        if let Some(node) = spring.get("name")
            && let Some(name) = node.text()
        {
            let path = format!("{}[{i}].name", object.path("springs"));
            take_name(name, "spring", (node.at, &path), taken, faults);
        }
    }
}

/// The static loads, by the names of what they act on, and gravity.
pub(in crate::structure) fn static_loads(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<StaticLoad> {
    let Some(node) = object.get("static") else {
        return Vec::new();
    };
    let path = object.path("static");
    let Some(members) = node.object() else {
        faults.must_be(
            node,
            &path,
            "an object with a force for each node, or gravity",
        );
        return Vec::new();
    };
    let mut loads = Vec::new();
    for member in members.iter().filter(|member| member.key != "//") {
        let path = join(&path, &member.key);
        if member.key == GRAVITY.name {
            loads.extend(gravity(&member.node, &path, reader, faults));
            continue;
        }
        let at = reader.moved(&member.key, member.at, &path, faults);
        let force = reader.amount(&member.node, &path, Range::Any, faults);
        loads.extend(
            at.zip(force)
                .map(|(at, force)| StaticLoad::Force(at, force)),
        );
    }
    loads
}

/// Gravity that acts from t = 0 on, without an equilibrium before.
pub(in crate::structure) fn falling(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<(Direction, Amount)> {
    let Some(node) = object.get(GRAVITY.name) else {
        return Vec::new();
    };
    let path = object.path(GRAVITY.name);
    if let Some(at_rest) = object
        .get("static")
        .and_then(|loads| loads.get(GRAVITY.name))
    {
        let message =
            "give it here or under \"static\", which makes the equilibrium at the start, not both";
        faults.add(
            at_rest.at,
            &join(&object.path("static"), GRAVITY.name),
            message,
        );
    }
    accelerations(node, &path, reader, faults)
}

/// The static loads of gravity.
fn gravity(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Vec<StaticLoad> {
    let each = accelerations(node, path, reader, faults).into_iter();
    each.map(|(direction, amount)| StaticLoad::Gravity(direction, amount))
        .collect()
}

/// The accelerations of gravity: one in y, or one for each key x, y and z.
fn accelerations(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<(Direction, Amount)> {
    if node.object().is_none() {
        let amount = reader.amount(node, path, Range::Any, faults);
        return amount
            .map(|amount| (Direction::Y, amount))
            .into_iter()
            .collect();
    }
    let Some(object) = Object::open(node, path, &ACCELERATIONS, faults) else {
        return Vec::new();
    };
    let one = |direction: Direction| {
        let amount = reader.number(&object, direction.name(), faults)?;
        Some((direction, amount))
    };
    Direction::TRANSLATIONS
        .into_iter()
        .filter_map(one)
        .collect()
}

/// The displacements and velocities at t = 0, by the names of nodes and bars.
pub(in crate::structure) fn start(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<Start> {
    let Some(node) = object.get("start") else {
        return Vec::new();
    };
    let path = object.path("start");
    let has_static = object.get("static").is_some();
    let Some(members) = node.object() else {
        faults.must_be(node, &path, "an object with a key for each node or bar");
        return Vec::new();
    };
    let members = members.iter().filter(|member| member.key != "//");
    let one = |member: &crate::source::tree::Member| {
        let path = join(&path, &member.key);
        let of = reader.moved(&member.key, member.at, &path, faults)?;
        if let Moved::Tied(_) = of {
            let message = "a tied dof starts as the dofs of which it is the sum; name these";
            faults.add(member.at, &path, message);
            return None;
        }
        let object = Object::open(&member.node, &path, &START, faults)?;
        if let (true, Some(node)) = (has_static, object.get("u")) {
            let message = "the static loads give the displacements at t = 0; a start may give v";
            faults.add(node.at, &object.path("u"), message);
        }
        Some(Start {
            of,
            u: reader.number(&object, "u", faults),
            v: reader.number(&object, "v", faults),
        })
    };
    members.filter_map(one).collect()
}
