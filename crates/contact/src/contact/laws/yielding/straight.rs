//! Laws of straight lines between r and S, with yielding.

use super::band::Band;
use super::one_sided::OneSided;
use crate::contact::Multilinear;

/// The lines of a law.
#[derive(Debug, Clone, Copy)]
pub enum Straight {
    /// Elastic between two parallel lines.
    Band {
        /// The lines.
        band: Band,
        /// Whether its elastic part has no force at t = 0, for every r.
        unbent: bool,
        /// Whether it acts for r < 0 alone.
        is_stop: bool,
    },
    /// A spring on one side of a gap.
    OneSided(OneSided),
    /// Parts that yield one after the other.
    Parts(Multilinear),
}
