//! Figures of ensembles of cases: samples, quantiles and fragility.

pub(super) mod distribution;
pub(super) mod ensembles;
mod envelope;
pub(super) mod fragility;
mod fragility_text;
pub(super) mod quantiles;
