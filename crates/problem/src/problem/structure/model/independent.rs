//! Sparse rows of which none is a sum of multiples of others.

use std::collections::BTreeMap;

/// A remainder of a row below this part of its largest entry is round-off. Rows of contacts have factors of about 1.
const ROUND_OFF: f64 = 1e-9;

/// Independent rows, eliminated: each has 1 at its first column.
#[derive(Debug, Default)]
pub struct IndependentRows {
    /// By first column; the entries behind it.
    rows: BTreeMap<usize, Vec<(usize, f64)>>,
}

impl IndependentRows {
    /// Adds a row, in which a column may be more than once; false for one that depends on the rows so far, which is not added.
    pub fn add(&mut self, row: impl Iterator<Item = (usize, f64)>) -> bool {
        let mut rest: BTreeMap<usize, f64> = BTreeMap::new();
        for (column, x) in row {
            *rest.entry(column).or_default() += x;
        }
        let largest = rest.values().fold(0.0, |most: f64, x| most.max(x.abs()));
        while let Some((first, x)) = rest.pop_first() {
            if x.abs() <= ROUND_OFF * largest {
                continue;
            }
            let Some(known_row) = self.rows.get(&first) else {
                let new_row = rest.into_iter().map(|(column, y)| (column, y / x));
                self.rows.insert(first, new_row.collect());
                return true;
            };
            for (column, y) in known_row {
                *rest.entry(*column).or_default() -= x * y;
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_a_cycle_depend_on_one_another() {
        let mut rows = IndependentRows::default();
        // A spring between two nodes, and the ground where one of them is left out.
        assert!(rows.add([(0, -1.0), (1, 1.0)].into_iter()));
        assert!(rows.add([(1, -1.0), (2, 1.0)].into_iter()));
        assert!(!rows.add([(0, 1.0), (2, -1.0)].into_iter()));
        assert!(rows.add([(2, 1.0)].into_iter()));
        assert!(!rows.add([(0, 3.0)].into_iter()));
        assert!(!rows.add([(3, 1.0), (3, -1.0)].into_iter()));
        assert!(rows.add([(3, 0.6), (1, 0.8)].into_iter()));
        assert!(!rows.add([].into_iter()));
    }
}
