//! The bounds and the forces of a contact in lanes.

use crate::lane::Lane;

/// A contact of L structures.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact<const L: usize> {
    /// g.
    pub(super) compliance: Lane<L>,
    pub(super) low: Lane<L>,
    pub(super) high: Lane<L>,
    /// -1 at the low bound, 0 free, 1 at the high bound.
    pub(super) side: Lane<L>,
    /// The bound where it is not free.
    pub(super) fixed: Lane<L>,
    /// A times the fixed forces.
    pub(super) held: Lane<L>,
    /// 1/D, or 0 where it is not free.
    pub(super) reciprocal: Lane<L>,
    /// The free force.
    pub(super) free: Lane<L>,
    /// d without the fixed forces.
    pub(super) rest: Lane<L>,
}

/// Numbers of one lane: d, low, high, size, force.
#[derive(Debug, Clone)]
pub(super) struct Scratch(pub(super) [Vec<f64>; 5]);
