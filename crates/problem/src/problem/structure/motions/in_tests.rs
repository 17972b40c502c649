//! Metrics in tests that are compared as a sample.

use crate::problem::structure::StructureProblem;
use crate::problem::structure::metrics::function::Function;
use crate::problem::structure::metrics::window::within;

impl StructureProblem {
    /// A metric, by its row, in each test that the study compares as a sample: the reduction of the measured values. `None` without
    /// such tests, and if they do not have it.
    pub fn in_tests(&self, metric: usize) -> Option<Vec<f64>> {
        let metric = self.metrics.get(metric).filter(|found| !found.measured)?;
        let Function::Values(function) = metric.reduction.row().function else {
            return None;
        };
        let sample = self.template.sample.as_ref()?;
        let mut tests = sample.channel(metric.channel.as_ref()?)?;
        let limits = metric.window.constant()?;
        tests.try_fold(Vec::new(), |mut results, (time, values)| {
            let points = within(limits, time)?;
            let time = &time[points.clone()];
            results.push(function(&values[points], &|i| time[i])?);
            Some(results)
        })
    }

    /// The line of the sample for `explain`.
    pub(crate) fn sample_described(&self) -> String {
        let Some(sample) = &self.template.sample else {
            return String::new();
        };
        let rows = (0..self.metrics.len()).filter(|row| self.in_tests(*row).is_some());
        let names: Vec<&str> = rows.map(|row| self.metrics[row].name.as_str()).collect();
        let tests = sample.tests.len();
        format!(
            "measured: {} of {tests} tests, compared with each ensemble\n",
            names.join(", ")
        )
    }
}
