//! Modes of the structure, and one damping ratio in each of them.

use crate::system::structure::{Structure, Symmetric};
use nalgebra::{DMatrix, SymmetricEigen};

/// Most nodes of a structure whose modes are computed: the matrices are full.
pub const MOST_MODES: usize = 1000;

/// Adds C = M sum 2 ratio omega_k phi_k phi_k^T M of all modes of M and this K; `None` if there are too many nodes.
pub fn add_modal(structure: &mut Structure, stiffness: &Symmetric, ratio: f64) -> Option<()> {
    let (omega2, shapes) = modes(structure, stiffness)?;
    let masses: Vec<f64> = structure.nodes.iter().map(|node| node.mass).collect();
    let size = masses.len();
    for i in 0..size {
        for j in 0..=i {
            let modes = (0..size)
                .map(|k| 2.0 * ratio * omega2[k].max(0.0).sqrt() * shapes[(i, k)] * shapes[(j, k)]);
            let c = masses[i].sqrt() * masses[j].sqrt() * modes.sum::<f64>();
            structure.damping.add(i, j, c);
        }
    }
    Some(())
}

/// Squares of the natural frequencies of M and this K, and the shapes as columns of an orthogonal matrix: sqrt(mass) times the displacement.
pub fn modes(structure: &Structure, stiffness: &Symmetric) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let size = structure.len();
    if size > MOST_MODES {
        return None;
    }
    let root: Vec<f64> = structure.nodes.iter().map(|n| n.mass.sqrt()).collect();
    let mut matrix = DMatrix::zeros(size, size);
    for ((i, j), k) in stiffness.entries() {
        matrix[(i, j)] = k / (root[i] * root[j]);
        matrix[(j, i)] = matrix[(i, j)];
    }
    let eigen = SymmetricEigen::new(matrix);
    Some((
        eigen.eigenvalues.iter().copied().collect(),
        eigen.eigenvectors,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::structure::Node;

    #[test]
    fn every_mode_of_a_chain_has_the_ratio() {
        let masses = [2.0, 1.0, 3.0];
        let mut structure = Structure {
            nodes: masses
                .map(|mass| Node {
                    name: String::new(),
                    mass,
                })
                .to_vec(),
            stiffness: Symmetric::zeros(3),
            damping: Symmetric::zeros(3),
            contacts: Vec::new(),
            loads: Vec::new(),
            displacement: vec![0.0; 3],
            velocity: vec![0.0; 3],
        };
        structure.stiffness.add_spring([None, Some(0)], 100.0);
        structure.stiffness.add_spring([Some(0), Some(1)], 70.0);
        structure.stiffness.add_spring([Some(1), Some(2)], 30.0);
        let k = structure.stiffness.clone();
        add_modal(&mut structure, &k, 0.05).unwrap();
        // C K^-1-free identity: with all modes at one ratio, (M^-1/2 C M^-1/2)^2 = 4 ratio^2 M^-1/2 K M^-1/2.
        let scaled = |matrix: &Symmetric| {
            let mut full = DMatrix::zeros(3, 3);
            for ((i, j), x) in matrix.entries() {
                full[(i, j)] = x / f64::sqrt(masses[i] * masses[j]);
                full[(j, i)] = full[(i, j)];
            }
            full
        };
        let (c, k) = (scaled(&structure.damping), scaled(&structure.stiffness));
        // Round-off of an eigensolver, relative to the largest entry of 170/2.
        assert!((&c * &c - k * 0.01).amax() < 1e-13 * 85.0);
    }
}
