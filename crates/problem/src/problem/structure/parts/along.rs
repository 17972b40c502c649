//! A node with its factor.

use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::node::NodeName;

/// A node with its factor in a relative displacement.
#[derive(Debug, Clone)]
pub struct Term {
    /// The node.
    pub node: NodeName,
    /// Its factor.
    pub factor: Amount,
    /// Whether the study names a tied dof instead, of which this is a part.
    pub tied: bool,
}
