//! Numbers that describe many values: quantiles, distributions and their intervals, tests and fits, Sobol' indices. They
//! know no studies.

pub mod beta;
pub mod binomial;
mod bootstrap;
pub mod empirical;
pub mod fisher;
pub mod fragility;
pub mod gamma;
pub mod kolmogorov_smirnov;
pub mod median;
pub mod moments;
pub mod normal;
pub mod quantile;
pub mod sobol;
mod student;

/// Confidence of all intervals and bands.
pub const CONFIDENCE: f64 = 0.95;
