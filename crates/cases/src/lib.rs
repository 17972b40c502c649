//! The cases of a study: blocks of axes, derived parameters and conditions; each case is made from its number.
//!
//! An axis has the values of a parameter, listed or sampled by a design (`axis`). The combinations of the axes of a block that meet
//! its condition are its cases (`block`, `counts`), with parameters given by expressions (`formulas`). [`Enumeration`] numbers the
//! cases of all blocks, and gives them as columns.

pub mod alike;
pub mod axis;
pub mod block;
mod collapse;
mod complete;
mod counts;
mod enumeration;
pub mod filter;
pub mod formulas;
mod partners;
pub mod representative;
mod select;
mod tabulate;
#[cfg(test)]
mod tests_sobol;

pub use axis::design::{Design, Sampling};
pub use axis::group::{Axis, AxisGroup};
pub use axis::values::Values;
pub use block::Block;
pub use enumeration::Enumeration;
pub use filter::Filter;
pub use partners::{Found, Partners};
pub use select::Selected;
