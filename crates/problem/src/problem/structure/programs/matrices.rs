//! Matrices and vectors of a request.

use super::json::{list, number};
use crate::system::structure::{Inertia, Load, Structure, Symmetric};

/// The entries of a matrix with both triangles, row by row.
pub(super) fn both_triangles(text: &mut String, matrix: &Symmetric) {
    let mut entries: Vec<(usize, usize, f64)> = Vec::new();
    for ((i, j), value) in matrix.entries().filter(|entry| entry.1 != 0.0) {
        entries.push((i, j, value));
        if i != j {
            entries.push((j, i, value));
        }
    }
    entries.sort_by_key(|entry| (entry.0, entry.1));
    list(text, &entries, |text, (i, j, value)| {
        text.push_str(&format!("[{i},{j},"));
        number(text, *value);
        text.push(']');
    });
}

/// Indices with their factors.
pub(super) fn pairs(text: &mut String, pairs: &[(usize, f64)]) {
    list(text, pairs, |text, (i, x)| {
        text.push_str(&format!("[{i},"));
        number(text, *x);
        text.push(']');
    });
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
