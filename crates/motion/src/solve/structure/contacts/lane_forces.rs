//! The bounds and the forces of a contact in lanes.

use crate::lane::Lane;

/// A contact of L structures.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contact<const L: usize> {
    /// g.
    pub(crate) compliance: Lane<L>,
    pub(crate) low: Lane<L>,
    pub(crate) high: Lane<L>,
    /// -1 at the low bound, 0 free, 1 at the high bound.
    pub(crate) side: Lane<L>,
    /// The bound where it is not free.
    pub(crate) fixed: Lane<L>,
    /// A times the fixed forces.
    pub(crate) held: Lane<L>,
    /// 1/D, or 0 where it is not free.
    pub(crate) reciprocal: Lane<L>,
    /// The free force.
    pub(crate) free: Lane<L>,
    /// d without the fixed forces.
    pub(crate) rest: Lane<L>,
}

/// Numbers of one lane: d, low, high, size, force.
#[derive(Debug, Clone)]
pub(crate) struct Scratch(pub(crate) [Vec<f64>; 5]);
