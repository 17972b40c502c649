//! tests.csv: whether the distribution of a metric over each ensemble is that of the tests.

use super::{EnsembleMetrics, text};
use rayon::prelude::*;
use slipgap_problem::problem::numbers::parameter::real;
use slipgap_statistics::kolmogorov_smirnov::{interval, test};
use slipgap_statistics::median;
use slipgap_statistics::quantile::quantile;
use std::io::{self, Write};

/// Columns of numbers, behind those of names.
const NUMBERS: [&str; 15] = [
    "tests",
    "cases",
    "D",
    "D_low",
    "D_high",
    "p",
    "verdict",
    "median_tests",
    "median_tests_low",
    "median_tests_high",
    "median_cases",
    "q16_tests",
    "q16_cases",
    "q84_tests",
    "q84_cases",
];

/// Probability below which an ensemble is refused.
const LEVEL: f64 = 0.05;

/// What a row says: the tests may be of the same distribution, or not.
const VERDICTS: [&str; 2] = ["accepted", "refused"];

impl EnsembleMetrics<'_> {
    /// Whether ensembles are compared with tests.
    pub fn has_tests(&self) -> bool {
        let mut columns = self.study.columns.iter();
        columns.any(|column| self.study.in_tests(*column).is_some())
    }

    /// Writes tests.csv, metric by metric, with the ensembles in the order of their first cases.
    pub fn write_tests(&self, out: impl Write) -> io::Result<()> {
        let varying = self.varying();
        let mut writer = csv::Writer::from_writer(out);
        let numbers = NUMBERS.map(String::from).into_iter();
        writer.write_record(self.name_columns().into_iter().chain(numbers))?;
        for (column, measure) in self.study.columns.iter().enumerate() {
            let Some(tests) = self.study.in_tests(*measure) else {
                continue;
            };
            let samples = self.samples(column);
            let cells: Vec<_> = samples
                .par_iter()
                .map(|sample| cells(&tests, &sample.rising))
                .collect();
            for (values, cells) in self.ensembles.iter().zip(cells) {
                let values = varying
                    .iter()
                    .map(|column_index| text(values[*column_index]));
                let names = std::iter::once(self.metric(column).to_owned()).chain(values);
                writer.write_record(names.chain(cells))?;
            }
        }
        writer.flush()
    }
}

/// The numbers of tests and cases by rising value.
fn cells(tests: &[f64], cases: &[f64]) -> [String; NUMBERS.len()] {
    let found = test(tests, cases);
    let number = |x: Option<f64>| x.map(real).unwrap_or_default();
    let end = |ends: Option<[f64; 2]>, end: usize| number(ends.map(|ends| ends[end]));
    let (ends, median) = (interval(tests, cases), median::interval(tests));
    let verdict = found.map(|comparison| VERDICTS[usize::from(comparison.p < LEVEL)]);
    [
        tests.len().to_string(),
        cases.len().to_string(),
        number(found.map(|comparison| comparison.distance)),
        end(ends, 0),
        end(ends, 1),
        number(found.map(|comparison| comparison.p)),
        verdict.unwrap_or_default().to_owned(),
        number(quantile(tests, 0.5)),
        end(median, 0),
        end(median, 1),
        number(quantile(cases, 0.5)),
        number(quantile(tests, 0.16)),
        number(quantile(cases, 0.16)),
        number(quantile(tests, 0.84)),
        number(quantile(cases, 0.84)),
    ]
}
