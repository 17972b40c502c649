//! What all steps of a structure share: the factor of the step's matrix, the nodes without mass, and supports.

pub(crate) mod between;
pub(crate) mod block_matrix;
pub(crate) mod linear;
pub(crate) mod links;
pub(crate) mod massless;
pub(crate) mod moving;
pub(crate) mod prepared;
pub(crate) mod reduced;
