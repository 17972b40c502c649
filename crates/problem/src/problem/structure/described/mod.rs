//! A case for people: in words and as a scheme.

pub(crate) mod describe;
pub(crate) mod excitation;
pub(crate) mod ground_motion;
mod lists;
pub(crate) mod participation;
pub mod scheme;
