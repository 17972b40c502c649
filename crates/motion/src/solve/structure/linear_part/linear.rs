//! The linear part of a sub-step.

use crate::methods::SubStep;
use crate::solve::Unsolvable;
use crate::solve::structure::linear_part::between;
use crate::solve::structure::linear_part::block_matrix::BlockMatrix;
use crate::solve::structure::linear_part::links::{Elimination, Link, links};
use crate::solve::structure::linear_part::reduced::{
    Reduced, flexibility, place_of, places, reduce,
};
use crate::system::structure::sparse::factor::{Factor, NotPositive};
use crate::system::structure::sparse::lists::Lists;
use crate::system::structure::{Structure, Symmetric};

/// A sub-step with its matrix m1 M + w1 d1 C + w1 d2 K = L D L^T in the order of elimination.
#[derive(Debug, Clone)]
pub(crate) struct Linear {
    pub(crate) sub_step: SubStep,
    /// The matrix; c is not divided by dt.
    pub(crate) elimination: Elimination,
    /// Couplings of nodes of different directions.
    pub(crate) couplings: Vec<Link>,
    /// L^-1 B by columns.
    pub(crate) reduced: Lists<Reduced>,
    /// What a force takes from the relations of the contacts: d2 s1 B^T (..)^-1 B, or d1 s1 B^T (..)^-1 B if d2 = 0.
    pub(crate) flexibility: BlockMatrix,
}

impl Linear {
    /// The linear part and the place of each node in the order of elimination, which depends on the places of the springs and
    /// dashpots only.
    pub(in crate::solve::structure) fn new(
        structure: &Structure,
        touches: &[bool],
        sub_step: SubStep,
    ) -> Result<(Linear, Vec<usize>), Unsolvable> {
        let [of_c, of_k] = [sub_step.d1, sub_step.d2].map(|d| sub_step.weights[1] * d);
        let factor = Factor::new(matrix(structure, &sub_step), touches).map_err(|NotPositive { row }| {
            Unsolvable::BrokenRules(format!(
                "the matrix of a step, {m} M + {of_c:e} C + {of_k:e} K, is not positive definite at node {}",
                structure.nodes[row].name,
                m = sub_step.inertia[1],
            ))
        })?;
        let row_of = place_of(&factor);
        let places = places(structure, &row_of);
        let reduced: Vec<_> = places.iter().map(|along| reduce(&factor, along)).collect();
        let [links, couplings] = links(structure, &row_of, 1.0);
        let linear = Linear {
            elimination: Elimination::new(factor, links),
            couplings,
            flexibility: flexibility(structure, &reduced, sub_step.flexibility()),
            reduced: Lists::new(&reduced),
            sub_step,
        };
        Ok((linear, row_of))
    }
}

/// The matrix of a sub-step.
fn matrix(structure: &Structure, sub_step: &SubStep) -> Symmetric {
    let mut matrix = Symmetric::zeros(structure.len());
    structure.add_mass(sub_step.inertia[1], &mut matrix);
    let [of_c, of_k] = [sub_step.d1, sub_step.d2].map(|d| sub_step.weights[1] * d);
    matrix.add_matrix(&structure.damping, of_c);
    matrix.add_matrix(&structure.stiffness, of_k);
    between::hold(structure, &mut matrix);
    matrix
}
