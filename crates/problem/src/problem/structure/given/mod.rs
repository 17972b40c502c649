//! What a study gives: numbers and names that parameters may set, nodes, and functions of time.

pub mod amount;
pub mod chosen;
pub mod motion_set;
pub mod node;
pub mod pair;
pub mod rows;
pub mod scale_to;
pub mod shape;
pub(crate) mod signal_cache;
pub mod source;
pub mod strength;
pub mod supports;
pub mod target_spectrum;

#[cfg(test)]
mod tests_strength;
