//! Nodes without mass and damping in a step: K u + B S = p holds at its end, and no velocity of theirs is a state.

use crate::system::structure::Structure;

/// A node without mass and damping.
#[derive(Debug, Clone)]
pub(crate) struct Massless {
    /// Its place.
    pub(crate) place: usize,
    /// Its row of K: places and entries.
    pub(crate) row: Vec<(usize, f64)>,
    /// The contacts that it belongs to.
    pub(crate) contacts: Vec<usize>,
}

/// The nodes without mass and damping, by place.
pub(crate) fn rows(structure: &Structure, row_of: &[usize]) -> Vec<Massless> {
    let massless = structure.massless();
    if !massless.contains(&true) {
        return Vec::new();
    }
    let mut number = vec![None; structure.len()];
    let mut rows = Vec::new();
    for node in (0..structure.len()).filter(|node| massless[*node]) {
        number[node] = Some(rows.len());
        rows.push(Massless {
            place: row_of[node],
            row: Vec::new(),
            contacts: Vec::new(),
        });
    }
    for ((i, j), k) in structure.stiffness.entries() {
        if let Some(row) = number[i] {
            rows[row].row.push((row_of[j], k));
        }
        if let (Some(row), true) = (number[j], i != j) {
            rows[row].row.push((row_of[i], k));
        }
    }
    for (c, contact) in structure.contacts.iter().enumerate() {
        for row in contact.along.iter().filter_map(|(node, _)| number[*node]) {
            rows[row].contacts.push(c);
        }
    }
    rows
}
