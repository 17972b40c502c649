//! How long the nodes of an impact touch.

use crate::system::structure::{Contact, Structure};

/// Time for which the nodes of an impact touch as two free masses without other forces; `None` for friction, links and rigid impacts.
/// For a law with delta^1.5 it depends on the largest overlap, and is `None` without it.
pub fn time(structure: &Structure, contact: &Contact, overlap: Option<f64>) -> Option<f64> {
    let nodes = contact.between.iter().flatten();
    let inverse: f64 = nodes.map(|node| 1.0 / structure.nodes[*node].mass).sum();
    let law = contact.law.law(0.0);
    law.properties().touching_time(inverse, overlap)
}
