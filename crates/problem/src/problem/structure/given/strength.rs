//! Strengths of the motion of a ground in a case, such as pseudo-accelerations.

use crate::problem::{Case, Violation};
use crate::system::loads::measures::Measure;
use crate::system::loads::pair::Component;
use std::fmt::Debug;

/// Which strength is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// The largest acceleration or a pseudo-acceleration.
    pub measure: Measure,
    /// Of what of a pair; a motion in one direction has one strength.
    pub component: Option<Component>,
}

/// A motion, or the pair of a station.
pub trait Strengths: Debug + Send + Sync {
    /// The strength in a case, > 0. `metre` is the study's unit of length in m.
    ///
    /// # Errors
    /// There is none, or the first rule that a number breaks.
    fn strength(&self, asked: Asked, case: &Case, metre: f64) -> Result<f64, Violation>;

    /// What identifies the motion among all cases.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    fn identity(&self, case: &Case) -> Result<Vec<u64>, Violation>;
}
