//! quantiles.csv: the distribution of every metric over each ensemble.

use super::{EnsembleMetrics, Sample, text};
use crate::output::failures_and_histories::cell;
use rayon::prelude::*;
use slipgap_statistics::{median, moments, quantile::quantile};
use std::io::{self, Write};

/// Columns of numbers of cases.
const COUNTS: [&str; 2] = ["cases", "empty"];

/// Columns of quantiles with their probabilities.
const QUANTILES: [(&str, f64); 9] = [
    ("min", 0.0),
    ("q05", 0.05),
    ("q16", 0.16),
    ("q25", 0.25),
    ("median", 0.5),
    ("q75", 0.75),
    ("q84", 0.84),
    ("q95", 0.95),
    ("max", 1.0),
];

/// Columns after them.
const MOMENTS: [&str; 4] = ["mean", "standard_deviation", "median_low", "median_high"];

/// The distribution of a metric over an ensemble.
#[derive(Debug, Clone, PartialEq)]
pub struct Distribution {
    /// Number of cases, and of those without a value.
    pub counts: [usize; 2],
    /// Smallest value, quantiles and largest value.
    pub quantiles: [Option<f64>; 9],
    /// Mean, standard deviation with n - 1, and both ends of the interval of the median.
    pub moments: [Option<f64>; 4],
}

impl Distribution {
    fn of(sample: &Sample) -> Distribution {
        let rising = &sample.rising;
        let ends = median::interval(rising);
        Distribution {
            counts: [sample.cases, sample.cases - rising.len()],
            quantiles: QUANTILES.map(|(_, p)| quantile(rising, p)),
            moments: [
                moments::mean(rising),
                moments::standard_deviation(rising),
                ends.map(|ends| ends[0]),
                ends.map(|ends| ends[1]),
            ],
        }
    }
}

impl EnsembleMetrics<'_> {
    /// The first columns of quantiles.csv: the metric, and the parameters that differ between ensembles.
    pub fn name_columns(&self) -> Vec<String> {
        let varying = self.varying().into_iter();
        let names = varying.map(|column| self.column_name(column));
        ["metric"]
            .into_iter()
            .chain(names)
            .map(String::from)
            .collect()
    }

    /// Number of rows of quantiles.csv.
    pub fn quantile_rows(&self) -> usize {
        self.columns.len() * self.ensembles.len()
    }

    /// Gives the rows of quantiles.csv to `take`, metric by metric, with the ensembles in the order of their first cases. Each is
    /// given as the names and values before the counts, and the distribution.
    ///
    /// # Errors
    /// Those of `take`, which end the rows.
    pub fn quantiles<E>(
        &self,
        mut take: impl FnMut(Vec<String>, Distribution) -> Result<(), E>,
    ) -> Result<(), E> {
        let varying = self.varying();
        for column in 0..self.columns.len() {
            let samples = self.samples(column);
            let found: Vec<Distribution> = samples.par_iter().map(Distribution::of).collect();
            for (values, distribution) in self.ensembles.iter().zip(found) {
                let values = varying.iter().map(|column| text(values[*column]));
                let names = std::iter::once(self.metric(column).to_owned());
                take(names.chain(values).collect(), distribution)?;
            }
        }
        Ok(())
    }

    /// Writes quantiles.csv.
    pub fn write_quantiles(&self, out: impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(out);
        let quantiles = QUANTILES.iter().map(|(name, _)| *name);
        let numbers = COUNTS.into_iter().chain(quantiles).chain(MOMENTS);
        writer.write_record(
            self.name_columns()
                .into_iter()
                .chain(numbers.map(String::from)),
        )?;
        self.quantiles(|names, of| {
            let counts = of.counts.map(|count| count.to_string());
            let numbers = of.quantiles.into_iter().chain(of.moments).map(cell);
            writer.write_record(names.into_iter().chain(counts).chain(numbers))
        })?;
        writer.flush()
    }
}
