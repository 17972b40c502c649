//! The equilibrium of a structure under its static loads: K u + B S = p.
//!
//! The load is applied in parts where forces depend on the way; [`Equilibrium`] finds that of each.

use super::equilibrium::Equilibrium;
use crate::contact::ContactKind;
use crate::solve::Unsolvable;
use crate::system::structure::{Structure, StructureLaw};

/// The load is applied in so many parts where the forces of curved laws depend on the way: their memory is exact for lines only.
const PARTS: usize = 50;

/// Puts a structure with static loads in equilibrium with them, with its contacts. The velocities stay.
///
/// # Errors
/// Nothing holds a node, or the contacts have no forces.
pub fn settle(structure: &mut Structure) -> Result<(), Unsolvable> {
    if structure.preload.load.is_empty() {
        return Ok(());
    }
    let remembers = |law: ContactKind| law != ContactKind::Impact;
    let mut contacts = structure.contacts.iter();
    let parts =
        match contacts.any(|contact| contact.law.is_curved() && remembers(contact.law.kind())) {
            true => PARTS,
            false => 1,
        };
    let still = without_dampers(structure);
    let equilibrium = Equilibrium::of(still.as_ref().unwrap_or(structure), parts)?;
    equilibrium.refuse_loose()?;
    let Equilibrium {
        u, forces, curved, ..
    } = equilibrium;
    let laws = structure.contacts.iter().enumerate().map(|(i, contact)| {
        let loaded = contact.law.is_curved() && remembers(contact.law.kind());
        (loaded && at_rest(&contact.law).is_none()).then(|| curved.law(i))
    });
    structure.preload.laws = laws.collect();
    let contacts = 0..structure.contacts.len();
    structure.preload.planes = contacts.map(|i| curved.plane(i)).collect();
    structure.displacement = u;
    // A contact that presses without compliance is closed, not open or overlapping by the round-off of u.
    for (c, force) in forces.iter().enumerate() {
        let contact = &structure.contacts[c];
        let is_stop = contact.law.is_rigid() && contact.law.kind() == ContactKind::Impact;
        if is_stop && *force < 0.0 {
            structure.contacts[c].gap = -structure.relative(c, &structure.displacement);
        }
    }
    structure.preload.forces = forces.into_iter().map(Some).collect();
    Ok(())
}

/// The structure without the dampers of its contacts, if they have any: they have no static force, however slowly the equilibrium is
/// reached.
fn without_dampers(structure: &Structure) -> Option<Structure> {
    let mut contacts = structure.contacts.iter();
    contacts
        .any(|contact| at_rest(&contact.law).is_some())
        .then(|| {
            let mut still = structure.clone();
            for contact in &mut still.contacts {
                if let Some(law) = at_rest(&contact.law) {
                    contact.law = law;
                }
            }
            still
        })
}

/// The law without its damper; `None` if it has none.
fn at_rest(law: &StructureLaw) -> Option<StructureLaw> {
    let own_law = law.law(1.0);
    let still = own_law.without_damper().filter(|_| law.row().is_none())?;
    Some(StructureLaw::new(still, None))
}
