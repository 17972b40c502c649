//! The units of scaled results, and their dimensions.

use super::text::Text;

/// Wave speeds of materials of bars in m/s.
pub const WAVE_SPEEDS: [f64; 2] = [500.0, 8000.0];

/// The dimension of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// A time.
    Time,
    /// A length.
    Length,
    /// A length over a time.
    Velocity,
    /// A length over a time squared.
    Acceleration,
    /// A force.
    Force,
    /// An energy.
    Energy,
}

impl Dimension {
    /// All dimensions.
    pub const ALL: [Dimension; 6] = [
        Dimension::Time,
        Dimension::Length,
        Dimension::Velocity,
        Dimension::Acceleration,
        Dimension::Force,
        Dimension::Energy,
    ];

    /// Its name with an article, for messages.
    pub fn in_words(self) -> &'static str {
        match self {
            Dimension::Time => "a time",
            Dimension::Length => "a length",
            Dimension::Velocity => "a velocity",
            Dimension::Acceleration => "an acceleration",
            Dimension::Force => "a force",
            Dimension::Energy => "an energy or a moment",
        }
    }
}

/// A unit of scaled results. Its size differs from case to case: [`crate::problem::Textbook::size`].
#[derive(Debug, Clone)]
pub struct Unit {
    /// Its dimension.
    pub dimension: Dimension,
    /// Its name in the tables of metrics, as in `F0`.
    pub name: Text,
    /// How symbols and titles divide by it, in markup, as in `/*F*_0_`.
    pub over: Text,
}
