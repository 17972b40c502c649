//! two_samples.csv: whether the distributions of a metric differ between the values of a parameter.

use super::compared_ensembles::Pair;
use super::{EnsembleMetrics, text};
use rayon::prelude::*;
use slipgap_problem::problem::numbers::parameter::{Value, real};
use slipgap_statistics::kolmogorov_smirnov::test;
use std::io::{self, Write};

impl EnsembleMetrics<'_> {
    /// Whether ensembles can be compared.
    pub fn has_pairs(&self) -> bool {
        !self.pairs().is_empty()
    }

    /// Writes two_samples.csv, metric by metric.
    pub fn write_two_samples(&self, out: impl Write) -> io::Result<()> {
        let (varying, mut pairs) = (self.varying(), self.pairs());
        let value = |pair: &Pair| self.ensembles[pair.ensembles[0]][pair.place];
        let is_whole = |pair: &Pair| matches!(value(pair), Some(Value::Whole(_)));
        let whole = pairs.iter().all(is_whole);
        // Names first, because the first rows decide the type that other programs take.
        let is_name = |pair: &Pair| matches!(value(pair), Some(Value::Name(_)));
        pairs.sort_by_key(|pair| !is_name(pair));
        let mut writer = csv::Writer::from_writer(out);
        let names = varying.iter().map(|column| self.column_name(*column));
        let header = ["metric", "parameter", "value_1", "value_2"].into_iter();
        writer.write_record(header.chain(names).chain(["n_1", "n_2", "D", "p"]))?;
        for column in 0..self.columns.len() {
            let samples = self.samples(column);
            let of_pairs = pairs.par_iter().map(|pair| {
                let [a, b] = pair.ensembles.map(|ensemble| &samples[ensemble].rising);
                let test = test(a, b);
                let cells =
                    test.map_or_else(Default::default, |test| [test.distance, test.p].map(real));
                let counts = [a.len(), b.len()].map(|count| count.to_string());
                counts.into_iter().chain(cells).collect::<Vec<String>>()
            });
            let rows: Vec<Vec<String>> = of_pairs.collect();
            for (pair, numbers) in pairs.iter().zip(rows) {
                let names = [self.metric(column), self.column_name(pair.place)];
                let cells = names.map(String::from).into_iter();
                let row = cells.chain(self.values(pair, (&varying, whole)));
                writer.write_record(row.chain(numbers))?;
            }
        }
        writer.flush()
    }

    /// Both values of the parameter of a pair, which are whole numbers only where those of all pairs are, and what both ensembles share, or one alone has.
    fn values(&self, pair: &Pair, (varying, whole): (&[usize], bool)) -> Vec<String> {
        let [a, b] = pair.ensembles.map(|ensemble| &self.ensembles[ensemble]);
        let both = [a, b].map(|values| match values[pair.place] {
            Some(Value::Whole(n)) if !whole => text(Some(Value::Number(n as f64))),
            value => text(value),
        });
        let shared = varying.iter().map(|column| match (a[*column], b[*column]) {
            (Some(a), Some(b)) if !Value::identical(Some(a), Some(b)) => String::new(),
            (a, b) => text(a.or(b)),
        });
        both.into_iter().chain(shared).collect()
    }
}
