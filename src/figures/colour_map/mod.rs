//! The parts of maps: the colour bar, filled contours, the numbers on them, and the line along a ridge.

pub mod bands;
pub mod bar;
mod contours;
mod labels;
pub mod ridge;

pub use labels::RIM;
