//! Newmark's family of methods in the generalised-alpha form: a file for each method, its coefficients, and the recursion of lanes.

pub(super) mod central_difference;
mod coefficients;
pub(super) mod generalized_alpha;
pub(super) mod hht;
mod lanes;
pub(super) mod linear_acceleration;
pub(super) mod newmark;

pub use coefficients::Coefficients;
