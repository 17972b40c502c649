//! W of the steps to equilibrium, the factor with it, and the laws with its flexibility.

use crate::contact::ContactKind;
use crate::solve::Unsolvable;
use crate::solve::structure::contacts::curved::contacts::Curved;
use crate::solve::structure::linear_part::block_matrix::BlockMatrix;
use crate::system::structure::sparse::factor::Factor;
use crate::system::structure::{Structure, Symmetric};

/// Pivots of K below this part of the diagonal with the contacts are too soft: contacts hold something.
const SOFT: f64 = 1e-4;

/// Entries of K with the elastic contacts over those of W, for the first W. Larger numbers need fewer steps, but each one
/// leaves their round-off in u where contacts alone hold it.
pub(super) const LARGE: f64 = 100.0;

/// Most doublings of q until K + W with q/2 is positive definite.
const DOUBLINGS: usize = 200;

/// Time of a step: dashpots have no force in it.
pub(super) const LONG: f64 = 1e15;

/// The numbers of W.
#[derive(Debug, Clone)]
pub(super) struct Weights {
    pub(super) q: f64,
    /// k_c.
    pub(super) contacts: Vec<f64>,
    /// Part of the first W below which that of no contact falls.
    pub(super) part: f64,
}

/// The factor of K + W, and (K + W)^-1 B by columns.
pub(super) struct Linear {
    pub(super) factor: Factor,
    pub(super) columns: Vec<Vec<f64>>,
}

/// The largest stiffnesses of the contacts, as far as they are finite, else 0: what their forces are compared with.
pub(super) fn stiffnesses(structure: &Structure) -> Vec<f64> {
    let contacts = structure.contacts.iter();
    let stiffness = contacts.map(|contact| {
        let limit = contact.law.limit().map_or(0.0, |limit| limit.at(0.0));
        let law = contact.law.law(limit);
        let k = law.properties().largest_stiffness(contact.gap.abs());
        if k > 0.0 && k.is_finite() { k } else { 0.0 }
    });
    stiffness.collect()
}

/// K with the contacts at their largest stiffness.
pub(super) fn stiffened(structure: &Structure, stiffnesses: &[f64]) -> Symmetric {
    let mut stiffness = structure.initial_stiffness();
    for (contact, k) in structure
        .contacts
        .iter()
        .zip(stiffnesses)
        .filter(|(_, k)| **k > 0.0)
    {
        stiffness.add_along(&contact.along, *k);
    }
    stiffness
}

/// Whether K holds all nodes beside the contacts: no pivot is small beside the stiffness with them.
pub(super) fn holds(stiffness: &Symmetric, stiffened: &Symmetric) -> bool {
    let size = stiffness.size();
    let Ok(factor) = Factor::new(stiffness, &vec![false; size]) else {
        return false;
    };
    let diagonal = diagonal(stiffened);
    let mut pivots = factor.order().iter().zip(factor.reciprocals());
    pivots.all(|(row, reciprocal)| 1.0 >= SOFT * diagonal[*row] * *reciprocal)
}

pub(super) fn diagonal(matrix: &Symmetric) -> Vec<f64> {
    let mut diagonal = vec![0.0; matrix.size()];
    for ((i, _), x) in matrix.entries().filter(|((i, j), _)| i == j) {
        diagonal[i] += x;
    }
    diagonal
}

/// q for which q M is a small part of K with the contacts.
pub(super) fn first_q(structure: &Structure, stiffened: &Symmetric) -> f64 {
    let ratios = diagonal(stiffened)
        .into_iter()
        .zip(diagonal(&structure.mass()))
        .filter(|(k, m)| *k > 0.0 && *m > 0.0)
        .map(|(k, m)| k / m);
    let least = ratios.fold(f64::INFINITY, f64::min);
    match least.is_finite() {
        true => least / LARGE,
        false => 1.0,
    }
}

impl Weights {
    /// K + W.
    fn weighted(&self, structure: &Structure, mass: &Symmetric) -> Symmetric {
        let mut matrix = structure.stiffness.clone();
        matrix.add_matrix(mass, self.q);
        for (contact, k) in structure.contacts.iter().zip(&self.contacts) {
            if *k > 0.0 {
                matrix.add_along(&contact.along, *k);
            }
        }
        matrix
    }

    /// Makes q so large that K + W is positive definite, also with a negative stiffness: as little as possible, since more needs more
    /// steps.
    pub(super) fn enlarge(&mut self, structure: &Structure, mass: &Symmetric) {
        let free = vec![false; structure.len()];
        let mut half = Weights {
            q: 0.5 * self.q,
            ..self.clone()
        };
        for _ in 0..DOUBLINGS {
            if Factor::new(half.weighted(structure, mass), &free).is_ok() {
                self.q = 2.0 * half.q;
                return;
            }
            half.q *= 2.0;
        }
    }
}

/// The factor of K + W, and (K + W)^-1 B by columns.
pub(super) fn linear(
    structure: &Structure,
    mass: &Symmetric,
    weights: &Weights,
) -> Result<Linear, Unsolvable> {
    let matrix = weights.weighted(structure, mass);
    let factor = Factor::new(&matrix, &vec![false; structure.len()]).map_err(|why| {
        Unsolvable::NoEquilibrium {
            node: structure.nodes[why.row].name.clone(),
        }
    })?;
    let column = |contact: usize| {
        let mut column = vec![0.0; structure.len()];
        for (node, x) in structure.column(contact) {
            column[node] += x;
        }
        factor.solve(&mut column);
        column
    };
    let columns = (0..structure.contacts.len()).map(column).collect();
    Ok(Linear { factor, columns })
}

/// The laws of the contacts with H = B^T (K + W)^-1 B.
pub(super) fn curved(structure: &Structure, columns: &[Vec<f64>]) -> Curved {
    let m = columns.len();
    let mut flexibility = vec![0.0; m * m];
    for i in 0..m {
        for j in 0..=i {
            let h = structure.relative(i, &columns[j]);
            (flexibility[i * m + j], flexibility[j * m + i]) = (h, h);
        }
    }
    let flexibility = BlockMatrix::dense(flexibility, m);
    Curved::of_all(structure, &[], &flexibility, 1.0 / LONG, LONG)
}

/// Whether a link softens so much that a step may have several answers. Friction falls with velocity, of which there is none.
pub(super) fn softens(curved: &Curved) -> bool {
    curved.is_ambiguous_in(|kind| kind == ContactKind::Link)
}

/// Adds a multiple.
pub(super) fn add(to: &mut [f64], what: &[f64], factor: f64) {
    to.iter_mut()
        .zip(what)
        .for_each(|(to, x)| *to += factor * x);
}

/// The largest size.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a, x| f64::max(a, x.abs()))
}
