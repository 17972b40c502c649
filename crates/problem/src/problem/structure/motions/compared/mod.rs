//! Motions beside each other: perturbed, exact, and with halved steps.

pub(crate) mod diverge;
pub(crate) mod exact_metrics;
pub(crate) mod friction_limits;
pub(crate) mod reference_error;
