//! Modes of the structure, and a damping ratio in each of them.

use crate::system::structure::{Structure, Symmetric};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Most nodes of a structure whose modes are computed: the matrices are full.
pub const MOST_MODES: usize = 1000;

/// Adds C = M sum 2 ratio_k omega_k phi_k phi_k^T M of all modes. Nodes without mass get none. It acts on the motion beside what nodes
/// follow supports at rest.
pub fn add_modal(structure: &mut Structure, modes: &Modes, ratios: &[f64]) {
    let damping = modal(structure, modes, ratios);
    structure.damp_beside_supports(&damping);
}

fn modal(structure: &Structure, modes: &Modes, ratios: &[f64]) -> Symmetric {
    let mut damping = Symmetric::zeros(structure.len());
    let (nodes, omega2) = (&modes.nodes, &modes.omega2);
    let shapes = match &modes.root {
        None => {
            let masses = nodes.iter().map(|i| structure.nodes[*i].mass.sqrt());
            let roots: Vec<f64> = masses.collect();
            for (i, node) in nodes.iter().enumerate() {
                for j in 0..=i {
                    let terms = (0..nodes.len()).map(|k| {
                        2.0 * ratios[k]
                            * omega2[k].max(0.0).sqrt()
                            * modes.shapes[(i, k)]
                            * modes.shapes[(j, k)]
                    });
                    let c = roots[i] * roots[j] * terms.sum::<f64>();
                    damping.add(*node, nodes[j], c);
                }
            }
            return damping;
        }
        Some(root) => root * &modes.shapes,
    };
    for (i, node) in nodes.iter().enumerate() {
        for j in 0..=i {
            let terms = (0..nodes.len()).map(|k| {
                2.0 * ratios[k] * omega2[k].max(0.0).sqrt() * shapes[(i, k)] * shapes[(j, k)]
            });
            damping.add(*node, nodes[j], terms.sum::<f64>());
        }
    }
    damping
}

/// The modes of the nodes with mass. The others follow them, K_ss u_s = -K_sr u_r.
#[derive(Debug, Clone)]
pub struct Modes {
    /// The nodes with mass.
    pub nodes: Vec<usize>,
    /// Squares of the natural frequencies.
    pub omega2: Vec<f64>,
    /// The shapes R^T u, M = R R^T, as columns of an orthogonal matrix.
    pub shapes: DMatrix<f64>,
    /// R where masses are coupled; without it, R is the roots of the masses.
    root: Option<DMatrix<f64>>,
}

impl Modes {
    /// phi^T f of each mode for a force on nodes, or the factor of each mode in a sum of displacements. Nodes without mass are left out,
    /// and supports, whose numbers follow those of the nodes: no mode moves them.
    pub fn components(&self, structure: &Structure, along: &[(usize, f64)]) -> Vec<f64> {
        let mut values = vec![0.0; structure.len()];
        for (node, value) in along {
            if let Some(sum) = values.get_mut(*node) {
                *sum += value;
            }
        }
        let of_nodes = self.nodes.iter().map(|node| values[*node]);
        let force = DVector::from_iterator(self.nodes.len(), of_nodes);
        let scaled = match &self.root {
            Some(root) => root.solve_lower_triangular(&force),
            None => {
                let roots = self
                    .nodes
                    .iter()
                    .map(|node| structure.nodes[*node].mass.sqrt());
                Some(force.component_div(&DVector::from_iterator(self.nodes.len(), roots)))
            }
        };
        scaled.map_or(Vec::new(), |vector| self.shapes.tr_mul(&vector).data.into())
    }

    /// phi^T C phi/(2 omega) of each mode; `None` without damping, and where nodes without mass follow others.
    pub fn ratios(&self, structure: &Structure) -> Option<Vec<f64>> {
        let damping = &structure.damping;
        let is_damped = damping.entries().any(|(_, c)| c != 0.0);
        if !is_damped || self.nodes.len() < structure.len() {
            return None;
        }
        let shapes = match &self.root {
            Some(root) => root.tr_solve_lower_triangular(&self.shapes)?,
            None => {
                let mut shapes = self.shapes.clone();
                for (mut row, node) in shapes.row_iter_mut().zip(&structure.nodes) {
                    row /= node.mass.sqrt();
                }
                shapes
            }
        };
        let mut powers = vec![0.0; self.omega2.len()];
        for ((i, j), c) in damping.entries() {
            let twice = if i == j { c } else { 2.0 * c };
            for (mode, power) in powers.iter_mut().enumerate() {
                *power += twice * shapes[(i, mode)] * shapes[(j, mode)];
            }
        }
        let pairs = powers.iter().zip(&self.omega2);
        let mut ratios: Vec<f64> = pairs
            .map(|(power, omega2)| 0.5 * power / omega2.sqrt())
            .collect();
        let finite = ratios.iter().filter(|ratio| ratio.is_finite());
        let largest = finite.fold(0.0, |largest: f64, ratio| largest.max(ratio.abs()));
        for ratio in &mut ratios {
            // Round-off of the sums over the nodes.
            if ratio.abs() < 1e-12 * largest {
                *ratio = 0.0;
            }
        }
        Some(ratios)
    }

    /// The node that moves most in a mode, by its share of the mass.
    pub fn most_moved(&self, mode: usize) -> usize {
        let shape = self.shapes.column(mode);
        let places =
            (0..self.nodes.len()).max_by(|i, j| shape[*i].abs().total_cmp(&shape[*j].abs()));
        places.map_or(0, |row| self.nodes[row])
    }
}

/// The modes of M and this K; `None` if there are too many nodes, or a matrix is not positive definite.
pub fn modes(structure: &Structure, stiffness: &Symmetric) -> Option<Modes> {
    let size = structure.len();
    if size > MOST_MODES {
        return None;
    }
    let coupled = structure.coupled_mass.nonzero_rows();
    let has_mass = |i: &usize| structure.nodes[*i].mass != 0.0 || coupled[*i];
    let nodes: Vec<usize> = (0..size).filter(has_mass).collect();
    if nodes.len() < size || coupled.contains(&true) {
        return coupled_modes(structure, stiffness, nodes);
    }
    let root: Vec<f64> = structure.nodes.iter().map(|n| n.mass.sqrt()).collect();
    let mut matrix = DMatrix::zeros(size, size);
    for ((i, j), k) in stiffness.entries() {
        matrix[(i, j)] = k / (root[i] * root[j]);
        matrix[(j, i)] = matrix[(i, j)];
    }
    let eigen = SymmetricEigen::new(matrix);
    Some(Modes {
        nodes,
        omega2: eigen.eigenvalues.iter().copied().collect(),
        shapes: eigen.eigenvectors,
        root: None,
    })
}

/// The same for coupled masses and nodes without mass.
fn coupled_modes(structure: &Structure, stiffness: &Symmetric, nodes: Vec<usize>) -> Option<Modes> {
    let size = structure.len();
    let stiffness = stiffness.full();
    // Between contacts in series there may be nodes without springs, which follow nothing.
    let is_between = structure.chain_nodes();
    let others: Vec<usize> = (0..size)
        .filter(|i| !nodes.contains(i) && !is_between[*i])
        .collect();
    let mut condensed = stiffness.select_rows(&nodes).select_columns(&nodes);
    if !others.is_empty() {
        let inner = stiffness.select_rows(&others).select_columns(&others);
        let mixed = stiffness.select_rows(&others).select_columns(&nodes);
        condensed -= mixed.transpose() * inner.cholesky()?.solve(&mixed);
    }
    let root = structure.mass().block(&nodes).full().cholesky()?.l();
    let left = root.solve_lower_triangular(&condensed)?;
    let scaled = root.solve_lower_triangular(&left.transpose())?;
    let eigen = SymmetricEigen::new((&scaled + scaled.transpose()) * 0.5);
    Some(Modes {
        nodes,
        omega2: eigen.eigenvalues.iter().copied().collect(),
        shapes: eigen.eigenvectors,
        root: Some(root),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::structure::Node;

    #[test]
    fn every_mode_of_a_chain_has_the_ratio() {
        let masses = [2.0, 1.0, 3.0];
        let node = |mass: f64| Node {
            name: String::new(),
            mass,
            direction: Default::default(),
        };
        let mut structure = Structure::new(masses.map(node).to_vec());
        structure.stiffness.add_spring([None, Some(0)], 100.0);
        structure.stiffness.add_spring([Some(0), Some(1)], 70.0);
        structure.stiffness.add_spring([Some(1), Some(2)], 30.0);
        let k = structure.stiffness.clone();
        let found = modes(&structure, &k).unwrap();
        add_modal(&mut structure, &found, &[0.05; 3]);
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
