//! From the parts of a case to the equations of its structure.

pub(crate) mod assemble;
pub mod contact_duration;
pub(crate) mod damping;
pub(crate) mod independent;
pub(crate) mod massless;
