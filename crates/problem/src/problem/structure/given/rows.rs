//! Which rows of matrices are nodes, and which belong to supports.

use crate::system::import::Dofs;
use crate::system::structure::Direction;

/// What a row of matrices is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowNumber {
    /// A node, by its place among the nodes of these matrices.
    Free(usize),
    /// A row that moves with a support, by the place of its motion.
    Support(usize),
    /// A row of a support without motion in this direction.
    Fixed,
}

/// The rows of matrices.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rows {
    free: usize,
    numbers: Vec<RowNumber>,
}

impl Rows {
    /// The rows with these dofs. `motion` says which motion a support of [`Dofs::supports`] has in a direction.
    pub fn new(dofs: &Dofs, motion: impl Fn(&str, Direction) -> Option<usize>) -> Rows {
        let mut free = 0;
        let number = |dof: &crate::system::import::Dof| match dof.support {
            None => {
                free += 1;
                RowNumber::Free(free - 1)
            }
            Some(support) => match motion(&dofs.supports[support], dof.direction) {
                Some(motion) => RowNumber::Support(motion),
                None => RowNumber::Fixed,
            },
        };
        let numbers = dofs.rows().iter().map(number).collect();
        Rows { free, numbers }
    }

    /// Number of rows that are nodes.
    pub fn free(&self) -> usize {
        self.free
    }

    /// What a row is.
    pub fn number(&self, row: usize) -> RowNumber {
        self.numbers[row]
    }

    /// The rows that are nodes.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let rows = self.numbers.iter().enumerate();
        rows.filter(|(_, number)| matches!(number, RowNumber::Free(_)))
            .map(|(row, _)| row)
    }
}
