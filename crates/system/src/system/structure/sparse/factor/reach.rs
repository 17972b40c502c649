//! Eliminations of right sides with few entries.

use super::{Entry, Factor, Triangle};

impl Factor {
    /// L^-1 b without its zeros, by rising places, for these entries of b in the order of elimination.
    ///
    /// An entry changes those that its column has rows in, and so on up the tree of elimination: all other columns are left out.
    pub fn eliminate_few(&self, b: &[(usize, f64)]) -> Vec<(usize, f64)> {
        let mut reached = Vec::new();
        for (start, _) in b {
            let parents = std::iter::successors(Some(*start), |column| self.parent(*column));
            reached.extend(parents);
        }
        reached.sort_unstable();
        reached.dedup();
        let mut x = vec![0.0; self.order.len()];
        for (at, value) in b {
            x[*at] += value;
        }
        let mut entries = Vec::with_capacity(reached.len());
        for column in reached {
            let value = x[column];
            if value != 0.0 {
                self.for_column(column, |entry| x[entry.at] -= entry.value * value);
                entries.push((column, value));
            }
        }
        entries
    }

    /// The first row that the column of a place has an entry in.
    fn parent(&self, column: usize) -> Option<usize> {
        let first = match &self.triangle {
            Triangle::Columns { columns, .. } => columns.column(column).first().copied(),
            Triangle::Blocks(blocks) => blocks.column(column).next(),
        };
        first.map(|entry| entry.at)
    }

    /// The entries of a column of L, whose rows rise.
    pub(super) fn for_column(&self, column: usize, each: impl FnMut(Entry)) {
        match &self.triangle {
            Triangle::Columns { columns, .. } => {
                columns.column(column).iter().copied().for_each(each);
            }
            Triangle::Blocks(blocks) => blocks.column(column).for_each(each),
        }
    }
}
