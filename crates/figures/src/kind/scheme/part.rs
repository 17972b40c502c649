//! What kind of part it is, and what its kind decides.

use super::symbols::length;
use slipgap_problem::problem::structure::described::scheme::picture::Part;

/// Width and height of a node between laws in series.
pub const NODE: f64 = 4.0;
/// Space around nodes.
pub const AROUND_NODES: f64 = 14.0;
/// Space beside a name.
pub const BESIDE: f64 = 6.0;

/// Whether a part is drawn as nodes.
pub fn has_places(part: &Part) -> bool {
    part.model
        .as_ref()
        .is_some_and(|model| !model.nodes.is_empty())
}

/// Whether a part is a node between laws in series, as NAME.node1. Other parts have no dot in their names.
pub fn is_node(part: &Part) -> bool {
    let number = part.name.rsplit_once(".node").map(|(_, number)| number);
    part.elements.is_none()
        && part.model.is_none()
        && number.is_some_and(|number| number.parse::<u32>().is_ok())
}

/// The longest name at the edge of a block; 0 for other parts.
pub fn longest(part: &Part) -> f64 {
    let Some(model) = part.model.as_ref().filter(|_| !has_places(part)) else {
        return 0.0;
    };
    let names = model.interface.iter().map(|named| length(&named.name));
    names.fold(0.0, f64::max)
}

/// The least and largest coordinate of an axis.
pub fn extent(nodes: &[[f64; 3]], axis: usize) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    nodes.iter().fold(start, |[low, high], node| {
        [low.min(node[axis]), high.max(node[axis])]
    })
}
