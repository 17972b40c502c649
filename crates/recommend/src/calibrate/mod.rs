//! Searches parameters for the smallest misfit, and how sharply the misfit determines them. It knows no studies: points have
//! coordinates from 0 to 1, and an objective computes many of them in one call.

mod arm;
mod between;
mod cma_es;
mod counted;
mod determine;
mod ends;
mod global;
mod linear;
mod local;
mod minimum;
mod model;
mod reached;
mod search_start;

#[cfg(test)]
mod tests;

pub use between::Between;
pub use determine::determine;
pub use global::search;

/// The misfit to be minimised.
pub trait Objective {
    /// The misfit of each point; infinite if the point has no solution. NaN counts as infinite, too.
    ///
    /// # Errors
    /// The user ended the search.
    fn misfits(&mut self, points: &[Vec<f64>]) -> Result<Vec<f64>, Stopped>;
}

/// The user ended a search before its result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stopped;

/// The numbers of a search.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// Seed of its random numbers.
    pub seed: u64,
    /// Points for a whole calibration: [`search`] computes three quarters of them at most, the rest is for [`determine`].
    pub cases: u64,
}

/// The best point of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Best {
    /// Its coordinates; the middle of the ranges if no point has a solution.
    pub at: Vec<f64>,
    /// Its misfit; infinite if no point has a solution.
    pub misfit: f64,
    /// Number of points computed.
    pub solved: u64,
    /// Number of independent starts that ended with the best misfit (to 1 %), and of all that ended.
    pub starts: [usize; 2],
    /// Whether the search ended because all cases were spent.
    pub spent: bool,
}

/// How sharply the misfit determines the coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct Determined {
    /// The best point; better than that of the search if a profile found a smaller misfit. `solved` is that of the search.
    pub best: Best,
    /// For each coordinate.
    pub profiles: Vec<Profile>,
    /// Correlation of the coordinates from the curvature of the squared misfit; `None` if it has no minimum there.
    pub correlation: Option<Vec<Vec<f64>>>,
    /// The direction (of length 1) in which the squared misfit changes least, if it does not limit the coordinates within their ranges.
    pub undetermined: Option<Vec<f64>>,
    /// The coordinates in this direction of which only a combination is determined: each is limited while the others stay. Fewer than two
    /// are no combination: the others have no influence.
    pub combined: Vec<usize>,
    /// Jumps of the misfit (contacts that begin or vanish between values) widen the intervals by this factor, and ranges of 10 %
    /// that are smaller; 1 without jumps.
    pub widened: f64,
    /// Whether the squared misfit is a quadratic function over the intervals: then intervals and correlation describe it well.
    pub quadratic: bool,
    /// Number of points computed in addition to those of the search.
    pub solved: u64,
}

impl Determined {
    /// A best point about which nothing else is known.
    pub fn only(best: Best) -> Determined {
        Determined {
            best,
            profiles: Vec::new(),
            correlation: None,
            undetermined: None,
            combined: Vec::new(),
            widened: 1.0,
            quadratic: false,
            solved: 0,
        }
    }
}

/// The smallest misfit for values of one coordinate, over all values of the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// By coordinate.
    pub points: Vec<ProfilePoint>,
    /// Ends of the 95 % interval; `None` if the misfit has no probability.
    pub interval: Option<[End; 2]>,
    /// Ends of the range with misfits at most 10 % above the best.
    pub within_tenth: [End; 2],
}

/// A point of a profile.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfilePoint {
    /// The coordinate.
    pub at: f64,
    /// The smallest misfit found there.
    pub misfit: f64,
    /// The other coordinates, in their order.
    pub others: Vec<f64>,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// At this coordinate.
    At(f64),
    /// The end of the coordinate's range is still inside.
    Open,
}
