//! Polynomials with proofs of their signs, small factors, and rows in the coordinates of a model.

pub(crate) mod bernstein;
pub(crate) mod cholesky;
pub(crate) mod factor;
pub(crate) mod kernel;
pub(crate) mod least;
pub(crate) mod matrix;
pub(crate) mod row;
pub(crate) mod signals;
pub(crate) mod sparse;
