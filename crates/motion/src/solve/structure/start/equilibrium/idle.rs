//! Bodies that nothing moves: without a load, free without their contacts, and not touched in the equilibrium of the others.
//!
//! Any place without a force would be one of theirs. They stay where they are.

use super::Equilibrium;
use crate::system::structure::Structure;

/// Force of K on a part that moves as a whole, over the largest entry of K, below which nothing holds it.
const FREE: f64 = 1e-9;

impl Equilibrium<'_> {
    /// Takes over the equilibrium in which idle bodies are fixed, if they have no forces in it.
    pub(super) fn leaves_idle(&mut self, parts: usize) -> bool {
        let is_idle = idle(self.structure);
        let touches = |c: &usize| {
            let mut nodes = self.structure.column(*c);
            nodes.any(|(node, _)| is_idle[node])
        };
        let touching: Vec<usize> = (0..self.structure.contacts.len()).filter(touches).collect();
        if touching.is_empty() {
            return false;
        }
        let mut fixed = self.structure.clone();
        for c in &touching {
            fixed.contacts[*c].along.retain(|(node, _)| !is_idle[*node]);
        }
        let found = Equilibrium::with(&fixed, 0).and_then(|equilibrium| equilibrium.settle(parts));
        let Ok(found) = found else {
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
    let most = FREE * structure.stiffness.largest();
    let holding = structure.holding(|node| part[node]);
    let mut is_idle: Vec<bool> = (0..part.len())
        .map(|number| holding.get(&number).is_none_or(|force| *force <= most))
        .collect();
    for (node, number) in part.iter().enumerate() {
        is_idle[*number] &= structure.preload.load[node] == 0.0 && structure.nodes[node].mass > 0.0;
    }
    part.iter().map(|number| is_idle[*number]).collect()
}
