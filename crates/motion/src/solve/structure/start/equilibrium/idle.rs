//! Bodies that nothing moves: without a load, free without their contacts, and not touched in the equilibrium of the others.
//!
//! Any place without a force would be one of theirs. They stay where they are.

use super::Equilibrium;
use super::weights::largest;
use crate::system::structure::Structure;

/// Force of K on a part that moves as a whole, over the largest entry of K, below which nothing holds it.
const FREE: f64 = 1e-9;

impl Equilibrium<'_> {
    /// Takes over the equilibrium in which idle bodies are fixed, if they have no forces in it.
    pub(super) fn leaves_idle(&mut self, parts: usize) -> bool {
        let is_idle = idle(self.structure);
        let mut fixed = self.structure.clone();
        let mut touching = Vec::new();
        for (c, own) in fixed.contacts.iter_mut().enumerate() {
            let all = own.along.len();
            own.along.retain(|(node, _)| !is_idle[*node]);
            if own.along.len() < all {
                touching.push(c);
            }
        }
        if touching.is_empty() {
            return false;
        }
        let Ok(found) = Equilibrium::of_others(&fixed, parts) else {
            return false;
        };
        if touching.iter().any(|c| found.forces[*c] != 0.0) {
            return false;
        }
        let memory = found.curved.memory();
        self.curved.recall(memory.into_iter());
        (self.u, self.forces) = (found.u, found.forces);
        true
    }
}

/// Whether each node is of a part with mass that has no load, and that K does not hold as a whole.
fn idle(structure: &Structure) -> Vec<bool> {
    let part = structure.parts();
    let largest_entry = structure.stiffness.largest();
    let is_idle = |own: usize| {
        let nodes = (0..part.len()).filter(|node| part[*node] == own);
        let is_of = |node: &usize| {
            structure.preload.load[*node] == 0.0 && structure.nodes[*node].mass > 0.0
        };
        if !nodes.clone().all(|node| is_of(&node)) {
            return false;
        }
        let mut moved = vec![0.0; part.len()];
        nodes.for_each(|node| moved[node] = 1.0);
        let mut force = vec![0.0; part.len()];
        structure.stiffness.add_product(&moved, &mut force);
        largest(&force) <= FREE * largest_entry
    };
    let mut found = vec![None; part.len()];
    let known = part
        .iter()
        .map(|own| *found[*own].get_or_insert_with(|| is_idle(*own)));
    known.collect()
}
