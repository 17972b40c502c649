//! Nodes without mass and damping in a step: K u + B S = p holds at its end, and no velocity of theirs is a state.

use super::state::Average;
use crate::lane::Lane;
use crate::system::structure::Structure;

/// A node without mass and damping.
#[derive(Debug, Clone)]
pub(super) struct Massless {
    /// Its place.
    pub(super) place: usize,
    /// Its row of K: places and entries.
    pub(super) row: Vec<(usize, f64)>,
    /// The contacts that it belongs to.
    pub(super) contacts: Vec<usize>,
}

/// The nodes without mass and damping, by place.
pub(super) fn rows(structure: &Structure, place: &[usize]) -> Vec<Massless> {
    let massless = structure.massless();
    if !massless.contains(&true) {
        return Vec::new();
    }
    let mut number = vec![None; structure.len()];
    let mut rows = Vec::new();
    for node in (0..structure.len()).filter(|node| massless[*node]) {
        number[node] = Some(rows.len());
        rows.push(Massless {
            place: place[node],
            row: Vec::new(),
            contacts: Vec::new(),
        });
    }
    for ((i, j), k) in structure.stiffness.entries() {
        if let Some(row) = number[i] {
            rows[row].row.push((place[j], k));
        }
        if let (Some(row), true) = (number[j], i != j) {
            rows[row].row.push((place[i], k));
        }
    }
    for (c, contact) in structure.contacts.iter().enumerate() {
        for row in contact.along.iter().filter_map(|(node, _)| number[*node]) {
            rows[row].contacts.push(c);
        }
    }
    rows
}

impl<const L: usize> Average<'_, L> {
    /// The right sides of the nodes without mass: p(i+1)/2 + K u(i)/2, of which the springs take K P.
    #[cold]
    pub(super) fn prescribe_massless(&mut self, step: usize) {
        // The loads at the end of the step; the list is filled anew after it.
        self.moved.fill(Lane::splat(0.0));
        self.inputs.add_ends(step, &mut self.moved);
        for node in &self.prepared.massless {
            let mut sum = self.moved[node.place];
            for (at, k) in &node.row {
                sum = sum + (self.p[*at] - self.w[*at] * 0.5) * *k;
            }
            self.work[node.place] = sum * 0.5;
        }
    }

    /// The displacements of the nodes without mass after the solution, which moved them as others.
    #[cold]
    pub(super) fn move_massless(&mut self) {
        self.moved.fill(Lane::splat(0.0));
        for Massless { place, .. } in &self.prepared.massless {
            let half = self.w[*place] * 0.5;
            self.p[*place] = self.p[*place] - half;
            self.w[*place] = Lane::splat(0.0);
            self.moved[*place] = half;
        }
    }
}
