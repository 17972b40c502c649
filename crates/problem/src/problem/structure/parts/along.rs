//! A node with its factor.

use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::node::NodeName;
use crate::system::structure::Direction;
use std::sync::Arc;

/// A node with its factor in a relative displacement.
#[derive(Debug, Clone)]
pub struct Term {
    /// The node.
    pub node: NodeName,
    /// Its factor.
    pub factor: Amount,
    /// The tied dof that the study names instead, of which this is a part.
    pub tied: Option<Arc<TiedDof>>,
}

/// A dof of matrices that is a sum of rows, with its factor.
#[derive(Debug, Clone)]
pub struct TiedDof {
    /// The place of the matrices.
    pub matrices: usize,
    /// The name of its node.
    pub node: String,
    /// Its direction.
    pub direction: Direction,
    /// Its factor.
    pub factor: Amount,
}
