//! The places of the entries of L.

use crate::system::structure::sparse::lists::Lists;

/// Most columns of a panel: some rows of it fit into the first cache.
const WIDTH: usize = 32;

/// Columns of L that follow one another, with the same rows below the last one.
#[derive(Debug)]
pub(super) struct Panel {
    pub(super) first: usize,
    /// The column after the last one.
    pub(super) end: usize,
    /// Rows below the last column, which rise.
    pub(super) rows: Vec<usize>,
}

impl Panel {
    /// Number of entries of a column.
    pub(super) fn entries(&self, column: usize) -> usize {
        self.end - 1 - column + self.rows.len()
    }

    /// Rows of the entries of a column, which rise.
    pub(super) fn rows_of(&self, column: usize) -> impl Iterator<Item = usize> + '_ {
        (column + 1..self.end).chain(self.rows.iter().copied())
    }
}

/// The panels of L for the entries (row, value) of each column of the matrix below its diagonal.
///
/// Column j has the rows of its own entries and of all columns whose first row is j.
pub(super) fn panels(columns: &Lists<(usize, f64)>) -> Vec<Panel> {
    let size = columns.len();
    let mut panels: Vec<Panel> = Vec::new();
    // The panels that end with a column whose first row is this one.
    let mut children = vec![Vec::new(); size];
    let mut marks = vec![0; size];
    for column in 0..size {
        let own_rows = || columns.list(column).iter().map(|(row, _)| *row);
        let last = panels.len();
        if let Some(before) = panels.last_mut() {
            let first = before.rows.first().copied();
            if first == Some(column) && column - before.first < WIDTH {
                let stamp = 2 * column + 1;
                before.rows.iter().for_each(|row| marks[*row] = stamp);
                let below = |panel: &usize| &panels[*panel].rows[1..];
                let mut below_children = children[column].iter().flat_map(below);
                if own_rows().all(|row| marks[row] == stamp)
                    && below_children.all(|row| marks[*row] == stamp)
                {
                    let before = &mut panels[last - 1];
                    before.rows.remove(0);
                    before.end += 1;
                    continue;
                }
            }
            if let Some(first) = first {
                children[first].push(last - 1);
            }
        }
        let stamp = 2 * column + 2;
        let below = |panel: &usize| panels[*panel].rows[1..].iter().copied();
        let candidates = own_rows().chain(children[column].iter().flat_map(below));
        let is_new = |row: &usize| std::mem::replace(&mut marks[*row], stamp) != stamp;
        let mut rows: Vec<usize> = candidates.filter(is_new).collect();
        rows.sort_unstable();
        panels.push(Panel {
            first: column,
            end: column + 1,
            rows,
        });
    }
    panels
}
