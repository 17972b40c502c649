//! Nodes of other programs in the plane of the picture. All matrices with places become one part, whose nodes are in points.

use super::super::part::{extent, has_places};
use super::super::symbols::{self, length};
use super::groups;
use slipgap_problem::problem::structure::described::scheme::model::Model;
use slipgap_problem::problem::structure::described::scheme::picture::{
    End, Link, Part, Place, Scheme,
};

/// Largest width and height of the nodes before groups are moved apart.
const LARGEST: [f64; 2] = [330.0, 230.0];
/// Groups that overlap by less than this part of the picture are beside one another.
const BESIDE: f64 = 0.05;

/// A scheme whose matrices with places are one part.
pub struct Placed {
    /// The other parts, then the one of all nodes, which has the place x, y of each node in points, y downwards.
    pub outer: Scheme,
    /// Links between nodes, or of nodes with the ground.
    pub inner: Vec<Link>,
    /// Forces on nodes.
    pub loads: Vec<usize>,
    /// Names of the matrices, each with its first node and the node after its last one.
    pub names: Vec<(String, [usize; 2])>,
    /// Which of X, Y, Z is horizontal and which vertical.
    pub axes: [usize; 2],
}

impl Placed {
    /// `None` if no matrices have places.
    pub fn of(scheme: &Scheme) -> Option<Placed> {
        let (with_nodes, others): (Vec<usize>, Vec<usize>) =
            (0..scheme.parts.len()).partition(|i| has_places(&scheme.parts[*i]));
        if with_nodes.is_empty() {
            return None;
        }
        let mut joined = Model::default();
        let mut names = Vec::new();
        let mut first_named = vec![0; scheme.parts.len()];
        for i in with_nodes {
            let Some(model) = &scheme.parts[i].model else {
                continue;
            };
            let first = joined.nodes.len();
            first_named[i] = joined.interface.len();
            joined.nodes.extend(&model.nodes);
            joined.names.extend(model.names.iter().cloned());
            joined.held.extend(&model.held);
            let moved = model.couplings.iter();
            joined
                .couplings
                .extend(moved.map(|pair| pair.map(|node| node + first)));
            for named in &model.interface {
                let mut named = named.clone();
                named.node += first;
                joined.interface.push(named);
            }
            names.push((scheme.parts[i].name.clone(), [first, joined.nodes.len()]));
        }
        let axes = axes(&joined.nodes);
        let merged = others.len();
        let end = |end: End| match end {
            End::Part(part, Place::Dof(dof)) if has_places(&scheme.parts[part]) => {
                End::Part(merged, Place::Dof(first_named[part] + dof))
            }
            End::Part(part, at) => {
                let before = others.iter().filter(|other| **other < part);
                End::Part(before.count(), at)
            }
            End::Ground => End::Ground,
        };
        let is_inner = |end: &End| matches!(*end, End::Part(part, _) if part == merged);
        let links = scheme.links.iter().map(|link| Link {
            between: link.between.map(end),
            ..link.clone()
        });
        let (inner, outer): (Vec<Link>, Vec<Link>) = links.partition(|link| {
            let mut ends = link.between.iter();
            ends.clone().any(is_inner) && ends.all(|end| *end == End::Ground || is_inner(end))
        });
        let (on_nodes, loads): (Vec<End>, Vec<End>) =
            scheme.loads.iter().copied().map(end).partition(is_inner);
        scale(&mut joined, axes);
        groups::move_apart(
            &mut joined,
            &inner,
            |link| symbols::along(link.kind).max(length(&link.name)) + 8.0,
            LARGEST.map(|length| BESIDE * length),
        );
        let mut parts: Vec<Part> = others.iter().map(|i| scheme.parts[*i].clone()).collect();
        parts.push(Part {
            name: String::new(),
            elements: None,
            model: Some(joined),
        });
        let dof = |end: End| match end {
            End::Part(_, Place::Dof(dof)) => Some(dof),
            End::Ground | End::Part(..) => None,
        };
        Some(Placed {
            outer: Scheme {
                parts,
                links: outer,
                loads,
                ground: scheme.ground.clone(),
            },
            inner,
            loads: on_nodes.into_iter().filter_map(dof).collect(),
            names,
            axes,
        })
    }
}

/// The two axes with the largest extents, in the order X, Y, Z.
fn axes(nodes: &[[f64; 3]]) -> [usize; 2] {
    let length = |axis: usize| {
        let [low, high] = extent(nodes, axis);
        high - low
    };
    let mut left_out = 2;
    for axis in [1, 0] {
        if length(axis) < length(left_out) {
            left_out = axis;
        }
    }
    match left_out {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}

/// Brings nodes into the plane, at one scale.
fn scale(model: &mut Model, axes: [usize; 2]) {
    let [[left, right], [low, high]] = axes.map(|axis| extent(&model.nodes, axis));
    let fits = |length: f64, largest: f64| match length > 0.0 {
        true => largest / length,
        false => f64::INFINITY,
    };
    let fitting = fits(right - left, LARGEST[0]).min(fits(high - low, LARGEST[1]));
    let scale = if fitting.is_finite() { fitting } else { 1.0 };
    for node in &mut model.nodes {
        let [x, y] = axes.map(|axis| node[axis]);
        *node = [scale * (x - left), scale * (high - y), 0.0];
    }
}
