//! A node with its factor.

use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::node::{NodeName, TiedDof};
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
