//! What a law says of itself.

mod described;
pub mod element;
mod evolution;
mod family;
mod kind;
mod line;

pub use described::{ClosedForm, Described, Properties};
pub use evolution::Evolution;
pub use family::Family;
pub use kind::ContactKind;
pub use line::{ClippedLine, GivenLaw};
