//! Matrices and vectors of a request.

use super::json::value;
use crate::system::structure::{Inertia, Load, Structure, Symmetric};

/// The entries of a matrix with both triangles, row by row.
pub(super) fn both_triangles(text: &mut Vec<u8>, matrix: &Symmetric) {
    let mut entries: Vec<(usize, usize, f64)> = Vec::new();
    for ((i, j), x) in matrix.entries().filter(|entry| entry.1 != 0.0) {
        entries.push((i, j, x));
        if i != j {
            entries.push((j, i, x));
        }
    }
    entries.sort_by_key(|entry| (entry.0, entry.1));
    value(text, entries);
}

/// The accelerations of all nodes with that of the ground: M^-1 times the load of the ground for 1.
pub(super) fn influence(structure: &Structure, load: &Load, scale: f64) -> Vec<f64> {
    let mut forces = vec![0.0; structure.len()];
    for (node, force) in &load.pattern {
        forces[*node] -= force / scale;
    }
    if let Ok(inertia) = Inertia::new(structure) {
        inertia.divide(&mut forces);
    }
    forces
}
