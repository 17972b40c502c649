//! The parts of maps: the colour bar, filled contours, the numbers on them, and the line along a ridge.

pub mod bands;
pub mod bar;
mod contours;
mod labels;
pub mod ridge;

pub use labels::RIM;

/// The value that a line along a map follows from column to column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ridge {
    /// The smallest.
    Least,
    /// The largest.
    Greatest,
    /// The one nearest to 1.
    NearestToOne,
}
