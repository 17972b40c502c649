//! The choice of a method with its parameters.

use super::Coefficients;

/// A method and its parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MethodChoice {
    /// Constant average acceleration [F section 4, I section 3].
    AverageAcceleration,
    /// A method of Newmark's family or one of its alpha methods.
    Family(Coefficients),
    /// Bathe's method of two sub-steps.
    Bathe,
    /// Moreau and Jean's method with impulses.
    MoreauJean {
        /// theta, from 1/2 to 1.
        theta: f64,
    },
}

/// The kinds of methods, which share a loop over steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum MethodKind {
    /// See [`MethodChoice::AverageAcceleration`].
    AverageAcceleration,
    /// See [`MethodChoice::Family`].
    Family,
    /// See [`MethodChoice::Bathe`].
    Bathe,
    /// See [`MethodChoice::MoreauJean`].
    MoreauJean,
}

impl MethodChoice {
    /// Number of sub-steps of a step.
    pub fn sub_steps(&self) -> u64 {
        match self {
            MethodChoice::Bathe => 2,
            _ => 1,
        }
    }

    /// Its kind.
    pub fn kind(&self) -> MethodKind {
        match self {
            MethodChoice::AverageAcceleration => MethodKind::AverageAcceleration,
            MethodChoice::Family(_) => MethodKind::Family,
            MethodChoice::Bathe => MethodKind::Bathe,
            MethodChoice::MoreauJean { .. } => MethodKind::MoreauJean,
        }
    }
}
