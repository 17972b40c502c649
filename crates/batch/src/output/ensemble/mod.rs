//! The metrics of ensembles, collected part by part: quantiles.csv, two_samples.csv and tests.csv.

mod against_tests;
mod compared_ensembles;
mod quantiles;
#[cfg(test)]
mod tests;
mod two_samples;

use crate::PartResult;
use rayon::prelude::*;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::{Study, alike};
use std::collections::HashMap;

pub use quantiles::Distribution;

/// The metrics of a study with an ensemble: 8 bytes for each metric of each case.
#[derive(Debug)]
pub struct EnsembleMetrics<'a> {
    study: &'a Study,
    /// Parameters whose values distinguish the ensembles.
    outside: Vec<usize>,
    /// Their values in each ensemble, in the order of the cases.
    ensembles: Vec<Vec<Option<Value>>>,
    /// Which ensemble has the values.
    known: HashMap<alike::Identity, u32>,
    /// The ensemble of each case.
    ensemble_of: Vec<u32>,
    /// For each column of the study its value in each case; an undefined one is NaN.
    columns: Vec<Vec<f64>>,
}

/// A metric in an ensemble.
#[derive(Debug, Clone, PartialEq, Default)]
struct Sample {
    /// Number of cases.
    cases: usize,
    /// The values of those that have one, rising.
    rising: Vec<f64>,
}

impl<'a> EnsembleMetrics<'a> {
    /// No metrics yet; `None` for a study without an ensemble.
    pub fn new(study: &'a Study) -> Option<EnsembleMetrics<'a>> {
        (!study.ensemble.is_empty()).then(|| EnsembleMetrics {
            study,
            outside: study.outside_ensemble(&[]),
            ensembles: Vec::new(),
            known: HashMap::new(),
            ensemble_of: Vec::new(),
            columns: vec![Vec::new(); study.columns.len()],
        })
    }

    /// Adds a part. Parts are added in order.
    pub fn add(&mut self, part: &PartResult) {
        let mut shown = part.cases.shown();
        for row in 0..part.len() {
            let case = shown.at(row);
            let identity = alike::identity(case, &self.outside);
            let ensembles = &mut self.ensembles;
            let outside = &self.outside;
            let ensemble = self.known.entry(identity).or_insert_with(|| {
                ensembles.push(outside.iter().map(|row| case.values[*row]).collect());
                ensembles.len() as u32 - 1
            });
            self.ensemble_of.push(*ensemble);
        }
        for (column, metric) in self.columns.iter_mut().zip(&self.study.columns) {
            let values = part.metrics.column(*metric);
            column.extend(values.map(|value| value.unwrap_or(f64::NAN)));
        }
    }

    /// Number of cases.
    pub fn cases(&self) -> usize {
        self.ensemble_of.len()
    }

    /// Each metric that is empty in a case, with the number of these cases.
    pub fn empty(&self) -> impl Iterator<Item = (&str, usize)> {
        let columns = self.columns.iter().zip(&self.study.columns);
        columns.filter_map(|(column, metric)| {
            let empty = column.iter().filter(|x| x.is_nan()).count();
            let name = self.study.measures[*metric].name.as_str();
            (empty > 0).then_some((name, empty))
        })
    }

    /// The sample of a column in each ensemble.
    fn samples(&self, column: usize) -> Vec<Sample> {
        let mut samples = vec![Sample::default(); self.ensembles.len()];
        for (ensemble, value) in self.ensemble_of.iter().zip(&self.columns[column]) {
            let sample = &mut samples[*ensemble as usize];
            sample.cases += 1;
            if !value.is_nan() {
                sample.rising.push(*value);
            }
        }
        let sort = |sample: &mut Sample| sample.rising.sort_unstable_by(f64::total_cmp);
        samples.par_iter_mut().for_each(sort);
        samples
    }

    /// The places in `outside` of the parameters that differ between ensembles: the columns of both tables.
    fn varying(&self) -> Vec<usize> {
        let differs = |column: &usize| {
            let mut values = self.ensembles.iter().map(|values| values[*column]);
            let first = values.next().flatten();
            values.any(|value| !Value::identical(value, first))
        };
        (0..self.outside.len()).filter(differs).collect()
    }

    /// The column of the parameter at a place in `outside`.
    fn column_name(&self, column: usize) -> &str {
        self.study.problem.parameters()[self.outside[column]].column_name()
    }

    /// The name of the metric of a column.
    fn metric(&self, column: usize) -> &str {
        &self.study.measures[self.study.columns[column]].name
    }
}

/// A value as a cell; empty for one that does not apply.
fn text(value: Option<Value>) -> String {
    value.map(|value| value.cell()).unwrap_or_default()
}
