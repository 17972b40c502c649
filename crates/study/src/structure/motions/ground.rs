//! The accelerations of the ground: one in x, or one for each key x, y and z, each with its strength or with one together.

use super::loads::known;
use super::members;
use super::scale_to::of_pair;
use super::set::give_component;
use crate::source::faults::{Faults, any_of};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{DIRECTIONS, GROUND, OF_GROUND};
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::structure::given::pair::Pair;
use slipgap_problem::problem::structure::given::scale_to::ScaleTo;
use slipgap_problem::problem::structure::given::shape::Scaled;
use slipgap_problem::problem::structure::given::strength::Strengths;
use slipgap_system::system::structure::Direction;
use std::collections::BTreeSet;
use std::sync::Arc;

/// A motion of the ground in its direction.
type Directed = (Direction, Scaled);

/// The accelerations of the ground.
pub(in crate::structure) fn ground(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<Directed> {
    let Some(node) = object.get("ground") else {
        return Vec::new();
    };
    let path = object.path("ground");
    // The parameters of the ground apart from those of the rest.
    let others = reader.used.take();
    let (mut ground, pair) = decoded(node, &path, reader, faults);
    let used = reader.used.take();
    reader.used.replace(others.union(&used).copied().collect());
    match pair {
        Some((scale_to, node)) => {
            let path = format!("{path}.{}", OF_GROUND.name);
            together(&mut ground, scale_to, &used, (node, &path), reader, faults);
        }
        None => alone(&mut ground, &used, (node, &path), reader, faults),
    }
    ground
}

/// The motions, and the strength that they get together with its place.
fn decoded<'a>(
    node: &'a Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> (Vec<Directed>, Option<(ScaleTo, &'a Node)>) {
    let members = node.object().unwrap_or_default().iter();
    let mut names = members.map(|member| member.key.to_lowercase());
    let by_directions = names.any(|name| DIRECTIONS.contains(&&*name));
    if !by_directions {
        return (
            vec![(Direction::X, known(node, path, reader, faults))],
            None,
        );
    }
    let Some(object) = Object::open(node, path, &GROUND, faults) else {
        return (Vec::new(), None);
    };
    let one = |direction: Direction| {
        let (node, path) = object.given(direction.name(), faults)?;
        Some((direction, known(node, &path, reader, faults)))
    };
    let ground = Vec::from_iter(Direction::TRANSLATIONS.into_iter().filter_map(one));
    let given = object.given(OF_GROUND.name, faults);
    let pair = given.and_then(|(node, path)| Some((of_pair(node, &path, reader, faults)?, node)));
    (ground, pair)
}

/// Gives all motions the strength of x and y together.
fn together(
    ground: &mut [Directed],
    mut scale_to: ScaleTo,
    used: &BTreeSet<usize>,
    (node, path): (&Node, &str),
    reader: &Reader,
    faults: &mut Faults,
) {
    let scaled = ground
        .iter()
        .filter(|motion| motion.1.shape.scale_to.is_some());
    let names: Vec<&str> = scaled.map(|pair| pair.0.name()).collect();
    if !names.is_empty() {
        let message = format!(
            "give it for the ground or for its directions, not both: {} has one",
            any_of(&names)
        );
        faults.add(node.at, path, message);
        return;
    }
    let motion = |direction| ground.iter().find(|pair| pair.0 == direction);
    let (Some((_, x)), Some((_, y))) = (motion(Direction::X), motion(Direction::Y)) else {
        let message = "needs a motion in x and one in y; give it under the direction of one motion";
        faults.add(node.at, path, message);
        return;
    };
    if let Some(set) = &mut scale_to.set {
        give_component(set, scale_to.component, (node, path), faults);
        match members::of_set(&[x, y], used, reader) {
            Ok(members) => set.members = members,
            Err(why) => faults.add(node.at, path, why),
        }
    }
    let pair: Arc<dyn Strengths> = Arc::new(Pair::new([x.clone(), y.clone()]));
    let scale_to = Arc::new(scale_to);
    for (_, motion) in ground {
        motion.shape.scale_to = Some(scale_to.clone());
        motion.shape.pair = Some(pair.clone());
    }
    reader.of_ground.replace(Some((scale_to, Some(pair))));
}

/// Gives the set of a motion with a strength of its own its motions.
fn alone(
    ground: &mut [Directed],
    used: &BTreeSet<usize>,
    (node, path): (&Node, &str),
    reader: &Reader,
    faults: &mut Faults,
) {
    for (_, motion) in ground.iter_mut() {
        let Some(scale_to) = motion.shape.scale_to.clone() else {
            continue;
        };
        if let Some(set) = &scale_to.set {
            let why = match set.component {
                Some(_) => Err("a set of motions in one direction has no component; its rule must be one for single components".to_owned()),
                None => members::of_set(&[motion], used, reader),
            };
            match why {
                Ok(members) => {
                    let mut changed = (*scale_to).clone();
                    if let Some(set) = &mut changed.set {
                        set.members = members;
                    }
                    motion.shape.scale_to = Some(Arc::new(changed));
                }
                Err(why) => faults.add(node.at, path, why),
            }
        }
    }
    // Of one motion, others may get the factor, too.
    if let [(_, motion)] = ground
        && let Some(scale_to) = &motion.shape.scale_to
    {
        let strengths: Arc<dyn Strengths> = Arc::new(motion.clone());
        let scaling = (scale_to.clone(), Some(strengths));
        reader.of_ground.replace(Some(scaling));
    }
}
