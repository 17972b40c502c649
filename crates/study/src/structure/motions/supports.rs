//! Supports with motions of their own: an acceleration, or one in each direction, with a delay.

use super::loads::function;
use super::shape::baseline;
use super::table::table;
use crate::source::faults::{Faults, join, quoted};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::structure::keys::{
    BETWEEN, DISPLACEMENT, FUNCTION, FUNCTIONS, GROUND, IMPOSED, IMPOSED_BY_FILE, IMPOSED_SINE,
    SINE, SUPPORT, VELOCITY, names, range,
};
use crate::structure::measured::{column, test};
use crate::structure::reading::given::member;
use crate::structure::reading::reader::Part;
use crate::structure::reading::reader::{Reader, open};
use crate::value::name;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::structure::channels::measured_channels::Test;
use slipgap_problem::problem::structure::given::amount::Amount;
use slipgap_problem::problem::structure::given::supports::{Course, Line, Points, Support};
use slipgap_system::system::structure::{Baseline, Direction};
use std::sync::Arc;

/// The directions x, y and z in which a support moves.
pub(in crate::structure) fn directions(node: &Node) -> [bool; 3] {
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
pub(in crate::structure) fn supports(
    parts: &[Part],
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<Support> {
    let supports = parts.iter();
    supports
        .flat_map(|part| support(part, reader, faults).unwrap_or_default())
        .collect()
}

/// `ground` together with `supports`.
pub(in crate::structure) fn refuse_ground(object: &Object, faults: &mut Faults) {
    if let (Some(_), Some(supports)) = (object.get("ground"), object.get("supports")) {
        let message = "give ground or supports, not both: u is relative to the ground, but absolute with supports; \"ground\" is a node that does not move there";
        faults.add(supports.at, &object.path("supports"), message);
    }
}

/// A delay or a baseline of a support and of one of its directions, too.
fn refuse_twice(support: &Object, direction: &Node, path: &str, faults: &mut Faults) {
    let Tree::Object(members) = &direction.tree else {
        return;
    };
    let twice = members.iter().filter(|member| {
        SUPPORT.iter().any(|key| key.0 == member.key) && support.get(&member.key).is_some()
    });
    for member in twice {
        let message = "give it for the support or for its directions, not both";
        faults.add(member.at, &join(path, &member.key), message);
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
    let given = directions(node);
    let members = object.members.iter();
    let plain = members
        .clone()
        .filter(|member| {
            [DISPLACEMENT.0, VELOCITY.0].contains(&&*member.key)
                || !SUPPORT.iter().any(|key| key.0 == member.key)
        })
        .find(|member| is_course(&member.key));
    let by_directions = members
        .clone()
        .any(|member| GROUND.iter().any(|key| key.0 == member.key));
    // The delay and the baseline of a function are those of the support, whose displacement follows from them. Its strength is that
    // without the baseline; to remove it once more changes nothing.
    let support = |direction, (mut course, velocity): (Course, Option<Amount>), delay| {
        let (delay, baseline) = match &mut course {
            Course::Acceleration(acceleration) => {
                let shape = &mut acceleration.shape;
                let baseline = shape.baseline;
                if shape.scale_to.is_none() {
                    shape.baseline = Baseline::None;
                }
                (shape.delay.take(), baseline)
            }
            Course::Displacement(..) | Course::Uniform => (delay, Baseline::None),
        };
        Support {
            name: own_name.clone(),
            direction,
            course,
            delay,
            velocity,
            baseline,
        }
    };
    if !by_directions {
        let course = course(&object, node.at, path, reader, faults)?;
        let delay = match &course.0 {
            Course::Displacement(..) | Course::Uniform => {
                reader.optional(&object, "delay", range(SUPPORT, "delay"), faults)
            }
            Course::Acceleration(_) => None,
        };
        return Some(vec![support(Direction::X, course, delay)]);
    }
    if let Some(member) = plain {
        let message = "give a function of time, which is the motion in x, or x, y and z, not both";
        faults.add(member.at, &join(path, &member.key), message);
        return None;
    }
    let delay = reader.optional(&object, "delay", range(SUPPORT, "delay"), faults);
    let baseline = baseline(&object, faults).unwrap_or_default();
    let one = |(direction, given): (Direction, bool)| {
        let node = object.get(direction.name()).filter(|_| given)?;
        let path = object.path(direction.name());
        refuse_twice(&object, node, &path, faults);
        let mut keys = names(FUNCTION);
        keys.extend([DISPLACEMENT.0, VELOCITY.0]);
        let object = Object::open(node, &path, &keys, faults)?;
        let mut course = course(&object, node.at, &path, reader, faults)?;
        if let (Some(_), Some(delay)) = (&course.1, &delay) {
            faults.add(delay.at, &delay.path, MOVING);
        }
        if let Course::Acceleration(acceleration) = &mut course.0 {
            let shape = &mut acceleration.shape;
            shape.delay = shape.delay.take().or_else(|| delay.clone());
            if shape.baseline == Baseline::None {
                shape.baseline = baseline;
            }
        }
        Some(support(direction, course, delay.clone()))
    };
    let supports: Vec<Support> = (Direction::TRANSLATIONS.into_iter().zip(given))
        .filter_map(one)
        .collect();
    Some(supports)
}

/// Whether a key says how a support moves.
fn is_course(key: &str) -> bool {
    [DISPLACEMENT.0, VELOCITY.0].contains(&key) || FUNCTION.iter().any(|row| row.0 == key)
}

/// Why a support with a velocity at t = 0 has no delay.
const MOVING: &str = "a support that has a velocity at t = 0 has no delay";

/// The acceleration or the displacements of an object, and its velocity at t = 0.
fn course(
    object: &Object,
    at: usize,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<(Course, Option<Amount>)> {
    let velocity = reader.optional(object, VELOCITY.0, Range::Any, faults);
    if let (Some(_), Some(delay)) = (&velocity, object.get("delay")) {
        faults.add(delay.at, &object.path("delay"), MOVING);
    }
    let Some(node) = object.get(DISPLACEMENT.0) else {
        let mut kinds = FUNCTION[..FUNCTIONS].iter();
        if velocity.is_some() && kinds.all(|kind| object.get(kind.0).is_none()) {
            return Some((Course::Uniform, velocity));
        }
        let acceleration = function(object, at, path, reader, faults)?;
        return Some((Course::Acceleration(Box::new(acceleration)), velocity));
    };
    if let Some(velocity) = &velocity {
        let message = "a support with displacements has the velocity of these";
        faults.add(velocity.at, &velocity.path, message);
    }
    let mut others = object.members.iter().filter(|member| member.key != "delay");
    let other = others.find(|member| FUNCTION.iter().any(|key| key.0 == member.key));
    if let Some(other) = other {
        let message = format!("a support with displacements has no {}", other.key);
        faults.add(other.at, &join(path, &other.key), message);
        return None;
    }
    let path = object.path(DISPLACEMENT.0);
    let has = |keys: &[(&str, &str)]| keys.iter().any(|key| member(node, key.0).is_some());
    let points = if has(IMPOSED_SINE) {
        sine(node, &path, reader, faults)?
    } else if has(&IMPOSED_BY_FILE[..3]) {
        file(node, &path, reader, faults)?
    } else {
        let [t, u] = table(node, &path, (IMPOSED, ["t", "u"]), reader, faults)?;
        Points::List([t, u], line(node, &path, faults)?)
    };
    Some((Course::Displacement(points, (node.at, path)), None))
}

/// The line between points.
fn line(node: &Node, path: &str, faults: &mut Faults) -> Option<Line> {
    let Some(line) = member(node, BETWEEN.0) else {
        return Some(Line::default());
    };
    let names = Line::ALL.map(Line::name);
    let index = name(line, &join(path, BETWEEN.0), "line", &names, faults)?;
    Some(Line::ALL[index])
}

/// A displacement that is a sine.
fn sine(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Points> {
    let object = open(node, path, IMPOSED_SINE, faults)?;
    let (key, meaning) = IMPOSED_SINE[0];
    let object = open(
        object.need(key, meaning, faults)?,
        &object.path(key),
        SINE,
        faults,
    )?;
    let mut need = |key| reader.needed(&object, SINE, key, faults);
    let (amplitude, omega) = (need("amplitude"), need("omega"));
    let phase = reader.optional(&object, "phase", Range::Any, faults);
    Some(Points::Sine([amplitude?, omega?], phase))
}

/// The displacements of a file.
fn file(node: &Node, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Points> {
    let (file_node, file_path) = (node, path);
    let object = open(node, path, IMPOSED_BY_FILE, faults)?;
    let mut need = |index: usize| {
        let (key, meaning) = IMPOSED_BY_FILE[index];
        Some((object.need(key, meaning, faults)?, object.path(key)))
    };
    let (file, time, u) = (need(0), need(1), need(2));
    let ((node, path), time, u) = (file?, time?, u?);
    let mut column = |(node, path), dimension| column(node, path, dimension, &reader.units, faults);
    let (time, u) = (column(time, Dimension::Time), column(u, Dimension::Length));
    let (time, u) = (time?, u?);
    let (chosen, files) = reader.files(node, &path, faults)?;
    let mut points = Vec::with_capacity(files.len());
    for file in files {
        let (test, bytes) = test(file, (node, &path), (&time, &[&u]), reader, faults)?;
        reader.keep(file, &bytes);
        let Test { time, values } = test;
        let u = values.into_iter().next()?;
        if u.len() < 2 {
            let message = format!(
                "{}: the file has {}; the displacements of a support need at least 2 rows",
                quoted(file),
                match u.len() {
                    0 => "no row of numbers",
                    _ => "1 row of numbers",
                }
            );
            faults.add(node.at, &path, message);
            return None;
        }
        // The support is at rest at its first point.
        let first = *u.first()?;
        let u = u.iter().map(|x| x - first).collect();
        points.push((file, Arc::new([time, u])));
    }
    Some(Points::File(
        chosen,
        points,
        line(file_node, file_path, faults)?,
    ))
}
