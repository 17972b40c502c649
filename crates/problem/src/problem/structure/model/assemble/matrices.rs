//! The matrices of other programs in a structure under construction.

use super::Draft;
use crate::system::structure::{Direction, Node, Structure, Symmetric};

impl Draft<'_> {
    /// The matrices of other programs on the diagonal of M, C and K.
    pub(super) fn matrices(&mut self) {
        if !self.is_built() {
            return;
        }
        for (block, matrices) in self.template.matrices.iter().enumerate() {
            let first = self.numbering.first_row(block);
            let imported = matrices.in_case(self.case);
            let node = |row: usize| Node {
                name: format!("{}.{}", matrices.name, imported.dofs.name(row)),
                mass: 0.0,
                direction: imported.dofs.rows()[row].direction,
            };
            let nodes = &mut self.structure.nodes;
            match &self.reduced[block] {
                None => {
                    nodes.extend(matrices.rows.nodes().map(node));
                    let numbers: Vec<_> = (0..imported.len())
                        .map(|row| self.numbering.row(block, row))
                        .collect();
                    add_matrices(
                        &mut self.structure,
                        |row| numbers[row],
                        [&imported.mass, &imported.stiffness],
                        imported.damping.as_deref(),
                    );
                }
                Some(reduced) => {
                    let kept = reduced.kept();
                    let own_rows: Vec<usize> = matrices.rows.nodes().collect();
                    let are_nodes = kept
                        .iter()
                        .filter(|row| own_rows.binary_search(row).is_ok());
                    let before = nodes.len();
                    nodes.extend(are_nodes.map(|row| node(*row)));
                    let first_mode = first + (nodes.len() - before);
                    nodes.extend((1..=reduced.modes()).map(|mode| Node {
                        name: format!("{}.mode{mode}", matrices.name),
                        mass: 0.0,
                        direction: Direction::Modal,
                    }));
                    let (mass, stiffness) = (reduced.mass(), reduced.stiffness());
                    let damping = reduced.damping();
                    add_matrices(
                        &mut self.structure,
                        |row| match kept.get(row) {
                            Some(row) => self.numbering.row(block, *row),
                            None => Some(first_mode + (row - kept.len())),
                        },
                        [&mass, &stiffness],
                        damping.as_ref(),
                    );
                }
            }
        }
    }
}

/// Adds M, K and C with these numbers of their rows to those of a structure that has the nodes. Rows without a number are left out.
fn add_matrices(
    to: &mut Structure,
    number: impl Fn(usize) -> Option<usize> + Copy,
    [mass, stiffness]: [&Symmetric; 2],
    damping: Option<&Symmetric>,
) {
    for ((row, column), m) in mass.entries() {
        let (Some(i), Some(j)) = (number(row), number(column)) else {
            continue;
        };
        match to.nodes.get_mut(i) {
            Some(node) if i == j => node.mass = m,
            // Supports come after the nodes and have no masses of their own.
            _ if m != 0.0 => to.coupled_mass.add(i, j, m * sides([row, column], [i, j])),
            _ => {}
        }
    }
    add_block(stiffness, number, &mut to.stiffness);
    if let Some(damping) = damping {
        add_block(damping, number, &mut to.damping);
    }
}

/// Adds the entries of a matrix to another one with these numbers of its rows; those of rows without a number are left out.
fn add_block(from: &Symmetric, number: impl Fn(usize) -> Option<usize>, to: &mut Symmetric) {
    // The only matrix of a structure is in memory once.
    let mut rows = 0..from.size();
    if to.is_empty() && to.size() == from.size() && rows.all(|row| number(row) == Some(row)) {
        let mut entries = from.entries();
        if entries.all(|(_, value)| value != 0.0) {
            *to = from.clone();
            return;
        }
    }
    for ((row, column), value) in from.entries().filter(|(_, value)| *value != 0.0) {
        if let (Some(i), Some(j)) = (number(row), number(column)) {
            to.add(i, j, value * sides([row, column], [i, j]));
        }
    }
}

/// How often an entry of a symmetric matrix counts: twice if two rows of one support meet.
fn sides([row, column]: [usize; 2], [i, j]: [usize; 2]) -> f64 {
    if row != column && i == j { 2.0 } else { 1.0 }
}
