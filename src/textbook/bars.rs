//! Assembled bars: two-node elements in a row, numbered so that K stays tridiagonal with the impact spring in it.

use super::Assembly;
use crate::structure::bar::{Bar, Mass};
use nalgebra::DMatrix;

/// The left bar from its free end to the contact, then the right bar from the contact on; without it, a wall.
pub fn assemble(left: Bar, right: Option<Bar>, gap: f64) -> Assembly {
    let count = |bar: Bar| bar.elements as usize + 1;
    let first = count(left);
    let size = first + right.map_or(0, count);
    let mut mass = DMatrix::zeros(size, size);
    let mut stiffness = DMatrix::zeros(size, size);
    for (bar, start) in [(Some(left), 0), (right, first)] {
        let Some(bar) = bar else { continue };
        let n = f64::from(bar.elements);
        let m = bar.mass / n;
        let rate = 2.0 * n / bar.trip; // C0/h
        let k = m * rate * rate; // EA/h
        let (own, other) = match bar.kind {
            Mass::Lumped => (m / 2.0, 0.0),
            Mass::Consistent => (m / 3.0, m / 6.0),
        };
        for i in start..start + bar.elements as usize {
            for (row, column, m, k) in [
                (i, i, own, k),
                (i + 1, i + 1, own, k),
                (i, i + 1, other, -k),
                (i + 1, i, other, -k),
            ] {
                mass[(row, column)] += m;
                stiffness[(row, column)] += k;
            }
        }
    }
    Assembly {
        mass,
        stiffness,
        nodes: [Some(first - 1), right.map(|_| first)],
        gap,
    }
}
