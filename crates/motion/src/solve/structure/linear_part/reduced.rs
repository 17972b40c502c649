//! L^-1 B of the contacts, and the flexibility of a step.

use super::block_matrix::{BlockMatrix, blocks};
use crate::system::structure::sparse::factor::Factor;
use crate::system::structure::{Along, Structure};

/// An entry of L^-1 B.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reduced {
    pub(crate) at: usize,
    pub(crate) value: f64,
    /// value/D.
    pub(crate) by_pivot: f64,
}

/// The place of each node in the order of elimination.
pub(crate) fn place_of(factor: &Factor) -> Vec<usize> {
    let mut row_of = vec![0; factor.order().len()];
    for (k, node) in factor.order().iter().enumerate() {
        row_of[*node] = k;
    }
    row_of
}

/// Places of each contact with their factors.
pub(crate) fn places(structure: &Structure, row_of: &[usize]) -> Vec<Along> {
    let of = |along: &Along| {
        along
            .iter()
            .map(|(node, factor)| (row_of[*node], *factor))
            .collect()
    };
    structure
        .contacts
        .iter()
        .map(|contact| of(&contact.along))
        .collect()
}

/// L^-1 B of a contact by its places and their factors.
pub(crate) fn reduce(factor: &Factor, along: &[(usize, f64)]) -> Vec<Reduced> {
    let entry = |(at, value): (usize, f64)| Reduced {
        at,
        value,
        by_pivot: value * factor.reciprocals()[at],
    };
    let entries = factor.eliminate_few(along);
    entries.into_iter().map(entry).collect()
}

/// A factor times B^T (L D L^T)^-1 B = (L^-1 B)^T D^-1 (L^-1 B).
pub(crate) fn flexibility(
    structure: &Structure,
    reduced: &[Vec<Reduced>],
    factor: f64,
) -> BlockMatrix {
    let product = |a: &[Reduced], b: &[Reduced]| {
        let (mut sum, mut b) = (0.0, b.iter().peekable());
        for x in a {
            while b.next_if(|y| y.at < x.at).is_some() {}
            if let Some(y) = b.next_if(|y| y.at == x.at) {
                sum += x.by_pivot * y.value;
            }
        }
        factor * sum
    };
    let columns = reduced.iter().map(|row| row.iter().map(|entry| entry.at));
    BlockMatrix::new(blocks(structure, columns), |i, j| {
        product(&reduced[i], &reduced[j])
    })
}
