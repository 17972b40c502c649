//! Groups of coupled nodes, which are moved apart where contacts or springs between them have no room.

use super::super::part::extent;
use slipgap_problem::problem::structure::described::scheme::model::Model;
use slipgap_problem::problem::structure::described::scheme::picture::{End, Link, Place};

/// Moves the groups that are beside or above one another so far apart that each link has its length. The shape of each group
/// stays. Groups that overlap by more than `beside` along an axis are not moved along it.
pub fn move_apart(
    model: &mut Model,
    links: &[Link],
    length: impl Fn(&Link) -> f64,
    beside: [f64; 2],
) {
    let groups = groups(model);
    let mut kinds: Vec<usize> = groups.clone();
    kinds.sort_unstable();
    kinds.dedup();
    let of = |group: usize| -> Vec<usize> {
        (0..groups.len())
            .filter(|node| groups[*node] == group)
            .collect()
    };
    // Groups that no link names move with those left of or above them.
    let members: Vec<Vec<usize>> = match kinds.len() <= MOST_GROUPS {
        true => kinds.iter().map(|group| of(*group)).collect(),
        false => return,
    };
    for axis in [0, 1] {
        let range = |model: &Model, group: usize| {
            let nodes: Vec<[f64; 3]> = members[group].iter().map(|i| model.nodes[*i]).collect();
            extent(&nodes, axis)
        };
        let mut order: Vec<usize> = (0..members.len()).collect();
        let starts: Vec<f64> = order.iter().map(|group| range(model, *group)[0]).collect();
        order.sort_by(|a, b| starts[*a].total_cmp(&starts[*b]));
        for cut in 1..order.len() {
            let (before, after) = order.split_at(cut);
            let mut by = 0.0_f64;
            for link in links {
                let Some([a, b]) = ends(model, link) else {
                    continue;
                };
                let group = |node: usize| kinds.binary_search(&groups[node]).unwrap_or(0);
                let (first, next) = match (group(a), group(b)) {
                    (i, j) if before.contains(&i) && j == after[0] => (a, b),
                    (i, j) if before.contains(&j) && i == after[0] => (b, a),
                    _ => continue,
                };
                let end = range(model, group(first))[1];
                if end - range(model, after[0])[0] <= beside[axis] {
                    let known = model.nodes[next][axis] - model.nodes[first][axis];
                    by = by.max(length(link) - known);
                }
            }
            for node in after.iter().flat_map(|group| &members[*group]) {
                model.nodes[*node][axis] += by;
            }
        }
    }
}

/// Of more groups none is moved.
const MOST_GROUPS: usize = 100;

/// The nodes of a link between two nodes.
fn ends(model: &Model, link: &Link) -> Option<[usize; 2]> {
    let node = |end: End| match end {
        End::Part(_, Place::Dof(dof)) => Some(model.interface[dof].node),
        End::Ground | End::Part(..) => None,
    };
    Some([node(link.between[0])?, node(link.between[1])?])
}

/// The group of each node, by its first node.
fn groups(model: &Model) -> Vec<usize> {
    let mut groups: Vec<usize> = (0..model.nodes.len()).collect();
    let root = |groups: &mut [usize], mut i: usize| {
        while groups[i] != i {
            groups[i] = groups[groups[i]];
            i = groups[i];
        }
        i
    };
    for [a, b] in &model.couplings {
        let (a, b) = (root(&mut groups, *a), root(&mut groups, *b));
        groups[a.max(b)] = a.min(b);
    }
    (0..groups.len()).map(|i| root(&mut groups, i)).collect()
}
