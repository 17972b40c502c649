//! Lognormal fragility functions: fits to trials, capacities and clouds, their intervals, and mean annual frequencies.

mod capacities;
mod cloud;
pub mod hazard;
pub mod jackknife;
mod likelihood;
mod line;
mod no_fit;
mod spread;
mod trials;

pub use capacities::Capacities;
pub use cloud::Cloud;
pub use line::Line;
pub use no_fit::NoFit;
pub use trials::{Trials, of_trials};

use crate::normal::cumulative;
use libm::log;
use spread::Spread;

/// P(x) = Phi(ln(x/median)/dispersion).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fragility {
    /// Where half of the trials exceed.
    pub median: f64,
    /// Standard deviation of the logarithm of the value from which on a trial exceeds.
    pub dispersion: f64,
}

impl Fragility {
    /// The probability of exceeding at a value.
    pub fn probability(&self, x: f64) -> f64 {
        match x > 0.0 {
            true => cumulative(self.distance(x)),
            false => 0.0,
        }
    }

    /// ln(x/median)/dispersion.
    fn distance(&self, x: f64) -> f64 {
        log(x / self.median) / self.dispersion
    }
}

/// A function that was fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// The function.
    pub function: Fragility,
    /// Of a cloud, the line through its logarithms.
    pub line: Option<Line>,
    spread: Spread,
}

impl Fit {
    /// 95 % intervals of the median and of the dispersion.
    pub fn intervals(&self) -> [[f64; 2]; 2] {
        self.spread.intervals(&self.function)
    }
}

#[cfg(test)]
mod tests {
    use super::Fit;

    /// Compares a fit with median, dispersion and the ends of their intervals.
    pub(super) fn compare(fit: &Fit, expected: [f64; 6], tolerance: f64) {
        let parameters = [fit.function.median, fit.function.dispersion];
        let numbers = parameters
            .into_iter()
            .chain(fit.intervals().into_iter().flatten());
        for (number, expected) in numbers.zip(expected) {
            assert!(
                (number / expected - 1.0).abs() < tolerance,
                "{number} {expected}"
            );
        }
    }
}
