//! Methods and structures in which a contact has no static limit.

use crate::methods::Method;
use crate::system::structure::Structure;

/// The first contact with two limits that a method or a structure cannot have: its index, and why.
pub fn static_ratio_fault(structure: &Structure, method: &Method) -> Option<(usize, String)> {
    let chains = structure.chains();
    let is_massless = |i: usize| {
        let massless = structure.massless();
        structure.column(i).any(|(node, _)| massless[node])
    };
    let mut contacts = structure.contacts.iter().enumerate();
    contacts.find_map(|(i, contact)| {
        if contact.law.static_ratio() == 1.0 {
            return None;
        }
        let has_static = matches!(method, Method::AverageAcceleration(_)) || method.has_impulses();
        let is_in_series = || chains.iter().any(|chain| chain.members().any(|m| m.contact == i));
        let why = match has_static {
            false => {
                "static_ratio above 1: the force of a contact that sticks alternates from step to step in this method, and would break it loose; allowed: average-acceleration or moreau-jean"
            }
            true if contact.law.row().is_some() && is_massless(i) => {
                "static_ratio above 1 in a plane is not known at a node without mass, where the way of the jump depends on the springs; give the node a mass"
            }
            true if is_in_series() => {
                "static_ratio above 1 is not known in series: the other contacts share the jump of the force; put a spring in their place, or give the node between them a mass"
            }
            true => return None,
        };
        Some((i, why.into()))
    })
}
