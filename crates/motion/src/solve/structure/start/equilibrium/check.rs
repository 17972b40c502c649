//! What an equilibrium must satisfy: the balance of each node, and the law of each contact. Nothing here comes from the search.

use super::Equilibrium;
use super::weights::largest;
use crate::system::structure::Structure;

/// Part of the terms of a balance, or of a force, that may be left.
const LEFT: f64 = 1e-10;

/// Part of the displacements that r may be wrong by, and of those without contacts, of which they may be differences.
const PLACE: f64 = 1e-11;
const ROUND_OFF: f64 = 1e-15;

impl Equilibrium<'_> {
    /// What is not in equilibrium with this load: a node or a contact by its name. `loose` is a part of the largest force that may be
    /// left beside.
    pub(super) fn fault(&mut self, load: &[f64], loose: f64) -> Option<String> {
        let structure = self.structure;
        let beside = loose * largest(load).max(largest(&self.forces));
        if let Some(node) = unbalanced(structure, load, &self.u, &self.forces, beside) {
            return Some(structure.nodes[node].name.clone());
        }
        let width = PLACE.max(loose) * largest(&self.u) + ROUND_OFF.max(loose) * self.reach;
        let end = self.curved.memory();
        self.curved.recall(self.start.2.iter().copied());
        let broken = (0..structure.contacts.len()).find(|c| {
            if structure.contacts[*c].law.row().is_some() {
                return false;
            }
            let change = structure.relative(*c, &self.u) - structure.relative(*c, &self.start.0);
            let [low, high] = [-width, width].map(|offset| self.curved.follow(*c, change + offset));
            let force = self.forces[*c];
            let left = LEFT * force.abs() + beside;
            let holds = low - left <= force && force <= high + left;
            !holds
        });
        self.curved.recall(end.into_iter());
        broken.map(|c| structure.contacts[c].name.clone())
    }
}

/// The node whose p - K u - B S is more than round-off of its terms.
fn unbalanced(
    structure: &Structure,
    load: &[f64],
    u: &[f64],
    forces: &[f64],
    beside: f64,
) -> Option<usize> {
    let mut left = load.to_vec();
    let mut terms: Vec<f64> = load.iter().map(|p| p.abs()).collect();
    let mut add = |node: usize, force: f64| {
        left[node] -= force;
        terms[node] += force.abs();
    };
    for ((i, j), k) in structure.stiffness.entries() {
        add(i, k * u[j]);
        if i != j {
            add(j, k * u[i]);
        }
    }
    for (c, force) in forces.iter().enumerate() {
        for (node, factor) in structure.column(c) {
            add(node, factor * force);
        }
    }
    let mut nodes = left.iter().zip(&terms);
    nodes.position(|(left, terms)| left.is_nan() || left.abs() > LEFT * terms + beside)
}
