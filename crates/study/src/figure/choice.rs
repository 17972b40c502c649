//! What keys of figures choose.

/// How the lognormal function of a fragility figure is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fit {
    /// The largest likelihood of the parts that exceed.
    #[default]
    Likelihood,
    /// From the place at which each member of the ensemble reaches the limit.
    Incremental,
    /// From a line through the logarithms of all cases.
    Cloud,
}

impl Fit {
    /// All of them, in the order of their names.
    pub(crate) const ALL: [Fit; 3] = [Fit::Likelihood, Fit::Incremental, Fit::Cloud];
}

/// What a response figure draws of each cycle of the excitation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Each {
    /// The largest absolute value.
    #[default]
    Peak,
    /// The largest value.
    Max,
    /// The smallest value.
    Min,
    /// The value at its start.
    Start,
}

impl Each {
    /// All of them, in the order of their names.
    pub(crate) const ALL: [Each; 4] = [Each::Peak, Each::Max, Each::Min, Each::Start];
}

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
