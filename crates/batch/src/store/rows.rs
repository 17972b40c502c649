//! Results as text, read from a store or from results.csv.

/// A table of results as text: results.csv, or the same from a store.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rows {
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Cells, in the order of the columns; empty if there is no value.
    pub rows: Vec<Vec<String>>,
}

impl Rows {
    /// Adds rows of the same columns.
    pub fn extend(&mut self, more: Rows) {
        self.columns = more.columns;
        self.rows.extend(more.rows);
    }
}
