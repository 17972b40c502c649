//! What was measured in a case, for curves.

use slipgap_problem::problem::{Case, MeasuredChannel, Quantity};
use slipgap_study::Study;

/// The measured channels of a case.
pub struct Measured(Vec<MeasuredChannel>);

impl Measured {
    /// Those of a completed case; none without.
    pub fn of(study: &Study, case: &Case) -> Measured {
        Measured(study.measured(case))
    }

    /// Times and values of a quantity, if it was measured; an error was not.
    pub fn quantity(&self, quantity: &Quantity) -> Option<(&[f64], &[f64])> {
        let mut series = self.0.iter().filter(|_| !quantity.error);
        let channel = series.find(|measured| measured.column == quantity.channel)?;
        Some((&channel.time, &channel.values))
    }
}
