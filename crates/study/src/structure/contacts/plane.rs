//! Contacts in a plane: two directions, each with its nodes.

use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::reading::reader::Reader;
use crate::value::text;
use slipgap_problem::problem::structure::given::node::{GROUND, NodeRef};
use slipgap_problem::problem::structure::parts::along::Term;
use slipgap_system::system::structure::{Direction, PlaneRow};

/// The rows of a contact in a plane: NAME.1 and NAME.2.
const ROWS: [(PlaneRow, &str); 2] = [(PlaneRow::First, "1"), (PlaneRow::Second, "2")];

/// Nodes I and J of both directions, with their places in the study.
pub(in crate::structure) type Pairs = [[(String, (usize, String)); 2]; 2];

/// Whether a contact is in a plane.
pub(super) fn is_given(object: &Object) -> bool {
    ["plane", "directions"]
        .into_iter()
        .any(|key| object.get(key).is_some())
}

/// The names and nodes of both directions.
pub(super) fn places(
    name: &str,
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<(String, Vec<Term>, PlaneRow)>> {
    for key in ["gap", "along", "pairs"] {
        if let Some(node) = object.get(key) {
            let message = format!("a contact in a plane has no {key}");
            faults.add(node.at, &object.path(key), message);
            return None;
        }
    }
    let pairs = match (object.get("plane"), object.get("between")) {
        (Some(_), Some(node)) => {
            let message = "give plane, or between and directions, not both";
            faults.add(node.at, &object.path("between"), message);
            return None;
        }
        (Some(node), None) => of_plane(node, object, faults)?,
        (None, _) => of_directions(object, faults)?,
    };
    let mut rows = Vec::new();
    let mut moves = false;
    for (pair, (row, number)) in pairs.into_iter().zip(ROWS) {
        let [i, j] = pair;
        let first = reader.side(&i.0, i.1, -1.0, faults);
        let second = reader.side(&j.0, j.1, 1.0, faults);
        let ((first, mut terms), (second, others)) = (first?, second?);
        moves |= first != second;
        // Nodes that are one move nothing: the direction is held.
        let of_ground = |term: &Term| term.node.node == NodeRef::Ground;
        terms.extend(others);
        if first == second && !terms.iter().all(of_ground) {
            terms.clear();
        }
        rows.push((format!("{name}.{number}"), terms, row));
    }
    if !moves {
        object.fault("a contact needs two different nodes in a direction", faults);
        return None;
    }
    Some(rows)
}

/// A list of two items.
fn two<'a>(node: &'a Node, path: &str, what: &str, faults: &mut Faults) -> Option<&'a [Node; 2]> {
    let items = node.list().and_then(|items| items.try_into().ok());
    if items.is_none() {
        faults.must_be(node, path, what);
    }
    items
}

fn of_plane(node: &Node, object: &Object, faults: &mut Faults) -> Option<Pairs> {
    if let Some(node) = object.get("directions") {
        let path = object.path("directions");
        // The names of the directions; the nodes say where they are.
        directions(node, &path, faults)?;
    }
    let path = object.path("plane");
    let wanted = "two pairs of nodes, those of the first direction and those of the second";
    let [first, second] = two(node, &path, wanted, faults)?;
    let mut pair = |node: &Node, index: usize| {
        let path = format!("{path}[{index}]");
        let [i, j] = two(node, &path, "a list of two nodes", faults)?;
        let mut side = |node: &Node, index: usize| {
            let path = format!("{path}[{index}]");
            Some((text(node, &path, faults)?, (node.at, path)))
        };
        Some([side(i, 0)?, side(j, 1)?])
    };
    Some([pair(first, 0)?, pair(second, 1)?])
}

fn of_directions(object: &Object, faults: &mut Faults) -> Option<Pairs> {
    let node = object.need("directions", "two of x, y and z", faults)?;
    let directions = directions(node, &object.path("directions"), faults)?;
    in_directions(object, directions, faults)
}

/// The nodes of `between` in both directions.
pub(in crate::structure) fn in_directions(
    object: &Object,
    directions: [Direction; 2],
    faults: &mut Faults,
) -> Option<Pairs> {
    let wanted = "two nodes with both directions; or plane, two pairs of nodes";
    let node = object.need("between", wanted, faults)?;
    let path = object.path("between");
    let ends = two(node, &path, "a list of two nodes", faults)?;
    let mut names = Vec::new();
    for (index, node) in ends.iter().enumerate() {
        let path = format!("{path}[{index}]");
        names.push((text(node, &path, faults)?, (node.at, path)));
    }
    let [i, j] = <[_; 2]>::try_from(names).ok()?;
    let pair = |direction: Direction| {
        [&i, &j].map(|(name, origin)| {
            let full = match name == GROUND {
                true => name.clone(),
                false => format!("{name}.{}", direction.name()),
            };
            (full, origin.clone())
        })
    };
    Some(directions.map(pair))
}

/// Two different directions.
pub(in crate::structure) fn directions(
    node: &Node,
    path: &str,
    faults: &mut Faults,
) -> Option<[Direction; 2]> {
    let wanted = "a list of two of x, y and z";
    let mut found = Vec::new();
    for (index, node) in two(node, path, wanted, faults)?.iter().enumerate() {
        let names = Direction::TRANSLATIONS.map(Direction::name);
        let path = format!("{path}[{index}]");
        let axis = crate::value::name(node, &path, "direction", &names, faults)?;
        found.push(Direction::TRANSLATIONS[axis]);
    }
    match found[..] {
        [first, second] if first != second => Some([first, second]),
        _ => {
            faults.add(node.at, path, "the two directions must differ");
            None
        }
    }
}
