//! Parts that nothing holds.

use crate::contact::ContactKind;
use crate::system::structure::Structure;

/// Whether a structure has a part that nothing holds, and that is not meant to move freely: without a load on it, it collides, or it
/// starts with a velocity.
pub fn has_idle_part(structure: &Structure) -> bool {
    let mut is_loaded = vec![false; structure.len()];
    let terms = structure.loads.iter().flat_map(|load| &load.pattern);
    let loads = terms.filter(|(_, factor)| *factor != 0.0);
    loads.for_each(|(node, _)| is_loaded[*node] = true);
    let contacts = structure.contacts.iter();
    let impacts = contacts.filter(|contact| contact.law.kind() == ContactKind::Impact);
    let mut is_meant: Vec<bool> = structure.velocity.iter().map(|v| *v != 0.0).collect();
    let nodes = impacts.flat_map(|contact| contact.along.iter().map(|(node, _)| *node));
    nodes.for_each(|node| is_meant[node] = true);
    let is_idle = |part: &Vec<usize>| {
        part.iter().any(|node| is_loaded[*node]) || !part.iter().any(|node| is_meant[*node])
    };
    structure.unheld_nodes().iter().any(is_idle)
}
