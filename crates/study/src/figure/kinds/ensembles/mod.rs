//! Figures of samples and ensembles.

pub(super) mod distribution;
pub(super) mod fragility;
pub(super) mod quantiles;
pub(super) mod samples;
pub(super) mod sobol;
