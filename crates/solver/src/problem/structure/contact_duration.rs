//! How long the nodes of an impact touch.

use crate::system::structure::{Contact, Structure};

/// Time for which the nodes of an impact touch as two free masses without other forces; `None` for friction, links and rigid impacts.
/// For a law with delta^1.5 it depends on the largest overlap, and is `None` without it.
pub fn time(structure: &Structure, contact: &Contact, overlap: Option<f64>) -> Option<f64> {
    // Between nodes of their own masses, as if other masses were not coupled to them.
    let nodes = contact.along.iter();
    let inverse: f64 = nodes
        .map(|(node, factor)| factor * factor / structure.nodes[*node].mass)
        .sum();
    if !inverse.is_finite() {
        return None;
    }
    let law = contact.law.law(0.0);
    law.properties().touching_time(inverse, overlap)
}
