//! Assembled structures. Bars are two-node elements in a row, numbered so that K stays tridiagonal with the impact spring.

use super::Assembly;
use crate::system::bar::{Bar, Mass};
use crate::system::{BarPair, Linear};
use nalgebra::{DMatrix, DVector};

/// A structure with its displacements and velocities at t = 0; bars in the frame of the mean of their velocities, a bar at a
/// wall in that of the wall.
pub fn assemble(linear: &Linear, gap: f64) -> (Assembly, DVector<f64>, DVector<f64>) {
    match linear {
        Linear::Oscillator { mode, displacement } => {
            let mass = 1.0 / mode.phi2;
            let assembly = Assembly {
                mass: DMatrix::from_element(1, 1, mass),
                stiffness: DMatrix::from_element(1, 1, mode.omega2 * mass),
                nodes: [None, Some(0)],
                gap,
            };
            let single = |x| DVector::from_element(1, x);
            (assembly, single(*displacement), single(0.0))
        }
        Linear::Bars(BarPair {
            left,
            right,
            velocity,
        }) => {
            let assembly = assemble_bars(*left, *right, gap);
            let first = left.elements as usize + 1;
            let size = assembly.mass.nrows();
            let [v_left, v_right] = match right {
                Some(_) => [-0.5 * velocity, 0.5 * velocity],
                None => [-velocity, 0.0],
            };
            let v = DVector::from_fn(size, |i, _| if i < first { v_left } else { v_right });
            (assembly, DVector::zeros(size), v)
        }
    }
}

/// The left bar from its free end to the contact, then the right bar from the contact on; without it, a wall.
pub fn assemble_bars(left: Bar, right: Option<Bar>, gap: f64) -> Assembly {
    let count = |bar: Bar| bar.elements as usize + 1;
    let first = count(left);
    let size = first + right.map_or(0, count);
    let mut mass = DMatrix::zeros(size, size);
    let mut stiffness = DMatrix::zeros(size, size);
    for (bar, start) in [(Some(left), 0), (right, first)] {
        let Some(bar) = bar else { continue };
        let n = f64::from(bar.elements);
        let m = bar.mass / n;
        let rate = 2.0 * n / bar.travel_time; // C0/h
        let k = m * rate * rate; // EA/h
        let (diagonal, other) = match bar.kind {
            Mass::Lumped | Mass::MasslessContact => (m / 2.0, 0.0),
            Mass::Consistent => (m / 3.0, m / 6.0),
        };
        for i in start..start + bar.elements as usize {
            for (row, column, m, k) in [
                (i, i, diagonal, k),
                (i + 1, i + 1, diagonal, k),
                (i, i + 1, other, -k),
                (i + 1, i, other, -k),
            ] {
                mass[(row, column)] += m;
                stiffness[(row, column)] += k;
            }
        }
        if bar.kind == Mass::MasslessContact {
            // The contact node is the last one of the left bar and the first one of the right bar.
            let contact = if start == 0 { first - 1 } else { first };
            let neighbour = if start == 0 { first - 2 } else { first + 1 };
            mass[(neighbour, neighbour)] += diagonal;
            mass[(contact, contact)] = 0.0;
        }
    }
    Assembly {
        mass,
        stiffness,
        nodes: [Some(first - 1), right.map(|_| first)],
        gap,
    }
}
