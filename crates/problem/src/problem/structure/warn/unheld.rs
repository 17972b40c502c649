//! Parts that nothing holds.

use crate::contact::ContactKind;
use crate::system::structure::Structure;

/// Whether a structure has a part that nothing holds, and that is not meant to move freely: without loads, it collides, or it
/// starts with a velocity.
pub fn has_idle_part(structure: &Structure) -> bool {
    let mut parts = structure.unheld_nodes().into_iter();
    if !structure.loads.is_empty() || !structure.supports.is_empty() {
        return parts.next().is_some();
    }
    let impacts = structure.contacts.iter();
    let impacts = impacts.filter(|contact| contact.law.kind() == ContactKind::Impact);
    let mut is_meant: Vec<bool> = structure.velocity.iter().map(|v| *v != 0.0).collect();
    let nodes = impacts.flat_map(|contact| contact.along.iter().map(|(node, _)| *node));
    nodes.for_each(|node| is_meant[node] = true);
    parts.any(|part| !part.iter().any(|node| is_meant[*node]))
}
