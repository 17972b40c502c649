//! Eliminations of right sides with few entries.

use super::{Entry, Factor, Triangle};

impl Factor {
    /// L^-1 b without its zeros, by rising places, for these entries of b in the order of elimination.
    ///
    /// An entry changes those that its column has rows in, and so on up the tree of elimination: all other columns are left out.
    pub fn eliminate_few(&self, b: &[(usize, f64)]) -> Vec<(usize, f64)> {
        let mut reached = Vec::new();
        for (start, _) in b {
            let parents = std::iter::successors(Some(*start), |place| self.parent(*place));
            reached.extend(parents);
        }
        reached.sort_unstable();
        reached.dedup();
        let mut x = vec![0.0; self.order.len()];
        for (at, value) in b {
            x[*at] += value;
        }
        let mut entries = Vec::with_capacity(reached.len());
        for place in reached {
            let own = x[place];
            if own != 0.0 {
                self.for_column(place, |entry| x[entry.at] -= entry.value * own);
                entries.push((place, own));
            }
        }
        entries
    }

    /// The first row that the column of a place has an entry in.
    fn parent(&self, place: usize) -> Option<usize> {
        let first = match &self.triangle {
            Triangle::Columns { columns, .. } => columns.column(place).first().copied(),
            Triangle::Blocks(blocks) => blocks.column(place).next(),
        };
        first.map(|entry| entry.at)
    }

    /// The entries of a column of L, whose rows rise.
    pub(super) fn for_column(&self, place: usize, each: impl FnMut(Entry)) {
        match &self.triangle {
            Triangle::Columns { columns, .. } => {
                columns.column(place).iter().copied().for_each(each);
            }
            Triangle::Blocks(blocks) => blocks.column(place).for_each(each),
        }
    }
}
