//! Sparse factors L D L^T of symmetric positive definite matrices.

mod order;

use super::Symmetric;
use order::Remaining;
use std::collections::BTreeMap;
use std::fmt;

/// A matrix in the order of elimination, factored: P A P^T = L D L^T, L with a diagonal of 1.
///
/// The order is that of the smallest degree (Tinney and Walker 1967). The factor of a tree, such as bars and piers in rows,
/// has as many entries as the tree has edges.
#[derive(Debug, Clone)]
pub struct Factor {
    order: Vec<usize>,
    /// 1/D.
    reciprocals: Vec<f64>,
    rows: Lists,
    columns: Lists,
}

/// Lists of entries, one list for each row or column of L without its diagonal.
#[derive(Debug, Clone)]
struct Lists {
    starts: Vec<usize>,
    entries: Vec<Entry>,
}

/// An entry of L.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// Column of an entry in a row, row of an entry in a column.
    pub at: usize,
    /// The number.
    pub value: f64,
}

/// A matrix is not positive definite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotPositive {
    /// Row whose pivot is not positive.
    pub row: usize,
}

impl fmt::Display for NotPositive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the matrix is not positive definite, row {}", self.row)
    }
}

impl std::error::Error for NotPositive {}

impl Lists {
    fn new(lists: &[Vec<Entry>]) -> Lists {
        let ends = lists.iter().scan(0, |end, list| {
            *end += list.len();
            Some(*end)
        });
        Lists {
            starts: std::iter::once(0).chain(ends).collect(),
            entries: lists.concat(),
        }
    }

    #[inline(always)]
    fn list(&self, i: usize) -> &[Entry] {
        &self.entries[self.starts[i]..self.starts[i + 1]]
    }
}

impl Factor {
    /// Factors a matrix. Rows of `late` come late in the order where that costs nothing.
    ///
    /// # Errors
    /// [`NotPositive`] if the matrix is not positive definite.
    pub fn new(matrix: &Symmetric, late: &[bool]) -> Result<Factor, NotPositive> {
        let n = matrix.size();
        let mut diagonal = vec![0.0; n];
        let mut rows = vec![BTreeMap::new(); n];
        for ((i, j), value) in matrix.entries() {
            if i == j {
                diagonal[i] = value;
            } else {
                rows[i].insert(j, value);
                rows[j].insert(i, value);
            }
        }
        let mut remaining = Remaining::new(&rows, late);
        let mut order = Vec::with_capacity(n);
        let mut columns = Vec::with_capacity(n);
        while let Some(row) = remaining.next() {
            let pivot = diagonal[row];
            if !(pivot > 0.0 && pivot.is_finite()) {
                return Err(NotPositive { row });
            }
            let column: Vec<(usize, f64)> = std::mem::take(&mut rows[row]).into_iter().collect();
            for (i, a) in &column {
                let l = a / pivot;
                diagonal[*i] -= l * a;
                rows[*i].remove(&row);
                for (j, b) in column.iter().filter(|(j, _)| j != i) {
                    // One product for both triangles, so that they stay equal.
                    let product = if i < j { l * b } else { a * (b / pivot) };
                    *rows[*i].entry(*j).or_default() -= product;
                }
            }
            for (i, _) in &column {
                remaining.eliminated(row, *i, rows[*i].len());
            }
            columns.push(column.into_iter().map(move |(i, a)| (i, a / pivot)));
            order.push(row);
        }
        Ok(Factor::renumbered(order, diagonal, columns))
    }

    /// The factor in the order of elimination.
    fn renumbered(
        order: Vec<usize>,
        diagonal: Vec<f64>,
        columns: Vec<impl Iterator<Item = (usize, f64)>>,
    ) -> Factor {
        let mut place = vec![0; order.len()];
        for (k, row) in order.iter().enumerate() {
            place[*row] = k;
        }
        let mut by_rows = vec![Vec::new(); order.len()];
        let mut by_columns = vec![Vec::new(); order.len()];
        for (k, column) in columns.into_iter().enumerate() {
            for (row, value) in column {
                by_rows[place[row]].push(Entry { at: k, value });
                let at = place[row];
                by_columns[k].push(Entry { at, value });
            }
        }
        for column in &mut by_columns {
            column.sort_unstable_by_key(|entry| entry.at);
        }
        Factor {
            reciprocals: order.iter().map(|row| 1.0 / diagonal[*row]).collect(),
            order,
            rows: Lists::new(&by_rows),
            columns: Lists::new(&by_columns),
        }
    }

    /// The rows of the matrix in the order of elimination.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// 1/D of the row at place `i` of the order.
    #[inline(always)]
    pub fn reciprocal(&self, i: usize) -> f64 {
        self.reciprocals[i]
    }

    /// Row `i` of L, left of the diagonal, in the order of elimination.
    #[inline(always)]
    pub fn row(&self, i: usize) -> &[Entry] {
        self.rows.list(i)
    }

    /// Column `i` of L, below the diagonal, in the order of elimination.
    #[inline(always)]
    pub fn column(&self, i: usize) -> &[Entry] {
        self.columns.list(i)
    }

    /// Number of entries of L below its diagonal.
    pub fn entries(&self) -> usize {
        self.rows.entries.len()
    }
}
