//! The units of scaled results, and what they measure.

/// What a number measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// A time.
    Time,
    /// A length.
    Length,
    /// A length over a time.
    Velocity,
    /// A force.
    Force,
}

/// A unit of scaled results. Its size differs from case to case: [`super::Problem::size`].
#[derive(Debug)]
pub struct Unit {
    /// What it measures.
    pub dimension: Dimension,
    /// Its name in the tables of metrics, as in `F0`.
    pub name: &'static str,
    /// How symbols and titles divide by it, in markup, as in `/*F*_0_`.
    pub over: &'static str,
}

/// Dimensions of the six columns of a history: time, displacement, velocity, force, exact displacement, exact velocity.
pub const OF_HISTORY: [Dimension; 6] = [
    Dimension::Time,
    Dimension::Length,
    Dimension::Velocity,
    Dimension::Force,
    Dimension::Length,
    Dimension::Velocity,
];
