//! What channels need of a structure besides its equations: its springs, the elements of its bars, the motion of the ground, and the
//! equations of its supports.

use super::{Along, Direction, Signal};
use std::sync::Arc;

/// What channels need of a structure besides its equations.
#[derive(Debug, Clone, Default)]
pub struct Observed {
    /// All springs, in the order of the study.
    pub springs: Vec<Spring>,
    /// The elements of each bar.
    pub bars: Vec<Elements>,
    /// The accelerations of the ground.
    pub ground: Vec<Ground>,
    /// The equations of the supports that move, in the order of [`super::Structure::supports`].
    pub reactions: Vec<Reaction>,
}

/// A spring with a dashpot: its force is k e + c e', e = sum of factor times u.
#[derive(Debug, Clone)]
pub struct Spring {
    /// The factors in its extension; supports follow the nodes.
    pub along: Along,
    /// Stiffness.
    pub k: f64,
    /// Dashpot.
    pub c: f64,
}

/// The elements of a bar, all alike.
#[derive(Debug, Clone, Copy)]
pub struct Elements {
    /// Stiffness of each.
    pub k: f64,
    /// Dashpot of each.
    pub c: f64,
}

/// An acceleration of the ground.
#[derive(Debug, Clone)]
pub struct Ground {
    /// Its direction.
    pub direction: Direction,
    /// Its course in time.
    pub signal: Arc<Signal>,
    /// Factor of the signal.
    pub scale: f64,
}

/// The row of a support that moves, in the matrices of nodes and supports.
#[derive(Debug, Clone, Default)]
pub struct Reaction {
    /// Its entries in M, C and K of nodes.
    pub nodes: [Along; 3],
    /// Its entries in M, C and K of supports.
    pub supports: [Along; 3],
    /// Its factor in r of each contact.
    pub contacts: Along,
}
