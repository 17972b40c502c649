//! The tables of a study in the page: results, indices and quantiles, by columns.

pub(super) mod compressed_column;
pub(super) mod indices;
pub(super) mod quantiles;
pub(super) mod results;
pub(super) mod used;
