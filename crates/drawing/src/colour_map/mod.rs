//! The parts of maps: the colour bar, filled contours, the numbers on them, and the line along a ridge.

pub mod bands;
pub mod bar;
mod contours;
mod labels;
pub mod ridge;

pub use labels::RIM;

/// Places that a map marks.
#[derive(Debug, Clone, PartialEq)]
pub struct Marks {
    /// What the legend calls them, in markup.
    pub label: String,
    /// Their values of the two axes' parameters.
    pub at: Vec<[f64; 2]>,
}

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
