//! Springs that yield, of which several laws are made.

pub(in crate::contact) mod band;
pub(in crate::contact) mod one_sided;
mod straight;

pub use band::Band;
pub use one_sided::OneSided;
pub use straight::Straight;
