//! Cases of stored parts, found by the hash of their parameters.

use slipgap_motion::solve::MetricTable;
use std::collections::HashMap;

/// The cases of earlier parts.
#[derive(Debug, Default)]
pub struct EarlierCases {
    /// Table and row by the hash of the parameters.
    rows: HashMap<u128, (usize, usize)>,
    tables: Vec<MetricTable>,
}

impl EarlierCases {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Adds the metrics of a part, whose cases have these hashes.
    pub fn add(&mut self, hashes: Vec<u128>, metrics: MetricTable) {
        let table = self.tables.len();
        let rows = hashes.into_iter().enumerate();
        self.rows
            .extend(rows.map(|(row, hash)| (hash, (table, row))));
        self.tables.push(metrics);
    }

    /// The table and the row with the metrics of the case with this hash.
    pub fn get(&self, hash: u128) -> Option<(&MetricTable, usize)> {
        let (table, row) = self.rows.get(&hash)?;
        Some((&self.tables[*table], *row))
    }
}
