//! Sparse symmetric matrices, their factors, and lists.

pub mod factor;
pub mod lists;
pub(crate) mod matrix;
