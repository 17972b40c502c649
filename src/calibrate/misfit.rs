//! The misfit of an alternative at points of its free parameters, many cases side by side.

use indicatif::ProgressBar;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_recommend::Stop;
use slipgap_recommend::calibrate::{Objective, Stopped};
use slipgap_recommend::study::sweep;
use slipgap_study::{PointCases, Study};

/// The misfit of an alternative.
pub struct Misfit<'a> {
    /// The study, in which `minimise` is the metric.
    pub study: &'a Study,
    /// Its cases.
    pub cases: PointCases<'a>,
    /// Row of the measure that is minimised.
    pub measure: usize,
    /// How the tests have one misfit.
    pub pooling: Pooling,
    /// Counts cases.
    pub bar: &'a ProgressBar,
    /// Ends the search.
    pub stop: &'a Stop,
    /// Number of cases solved so far.
    pub solved: u64,
}

/// How several tests have one misfit.
#[derive(Debug, Clone, PartialEq)]
pub enum Pooling {
    /// Root of the mean square of all points: the number of points of each test.
    Points(Vec<f64>),
    /// Mean of the tests.
    Mean,
}

impl Pooling {
    /// The misfit of the tests together.
    pub fn misfit(&self, tests: &[f64]) -> f64 {
        match self {
            Pooling::Points(points) => {
                let squares = points.iter().zip(tests).map(|(n, x)| n * x * x);
                let sum: f64 = squares.fold(0.0, |sum, x| sum + x);
                (sum / points.iter().fold(0.0, |sum, n| sum + n)).sqrt()
            }
            // A single one is kept to the bit.
            Pooling::Mean => tests.iter().fold(0.0, |sum, x| sum + x) / tests.len() as f64,
        }
    }
}

impl Misfit<'_> {
    /// The measure in each of some cases; infinite where it has no value.
    pub fn values(&mut self, cases: &Cases) -> Result<Vec<f64>, Stopped> {
        let tick = |solved| self.bar.inc(solved);
        let (rows, table) = sweep(&*self.study.problem, cases, self.stop, &tick)?;
        self.solved += rows.len() as u64;
        let mut values = vec![f64::INFINITY; cases.len()];
        let mut shown = cases.shown();
        for (position, row) in rows.into_iter().map(|row| row as usize).enumerate() {
            let metric = |metric: usize| table.value(position, metric);
            let value = self
                .study
                .measure_value(self.measure, shown.at(row), &metric);
            values[row] = value.unwrap_or(f64::INFINITY);
        }
        Ok(values)
    }

    /// The misfits of points from the values of their cases, those of each test together.
    pub fn pooled(&self, values: &[f64], points: usize) -> Vec<f64> {
        let tests = self.cases.tests();
        let point = |at: usize| {
            let of_tests: Vec<f64> = (0..tests).map(|test| values[test * points + at]).collect();
            self.pooling.misfit(&of_tests)
        };
        (0..points).map(point).collect()
    }
}

impl Objective for Misfit<'_> {
    fn misfits(&mut self, points: &[Vec<f64>]) -> Result<Vec<f64>, Stopped> {
        let cases = self.cases.cases(points);
        let values = self.values(&cases)?;
        Ok(self.pooled(&values, points.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_tests_have_the_root_of_the_mean_square_of_all_points() {
        // Errors 1, 1 and 3: the mean square is (1 + 1 + 9)/3.
        let pooled = Pooling::Points(vec![2.0, 1.0]).misfit(&[1.0, 3.0]);
        assert_eq!(pooled, (11.0f64 / 3.0).sqrt());
        assert_eq!(Pooling::Mean.misfit(&[1.0, 4.0]), 2.5);
        assert_eq!(Pooling::Mean.misfit(&[0.1]), 0.1);
        assert_eq!(Pooling::Mean.misfit(&[0.1, f64::INFINITY]), f64::INFINITY);
    }
}
