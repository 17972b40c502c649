//! What a law says of itself.

mod described;
pub mod element;
mod evolution;
mod family;
mod in_plane;
mod kind;
mod line;

pub use described::{ClosedForm, Described, Properties};
pub use evolution::Evolution;
pub use family::Family;
pub use in_plane::{ElasticInPlane, InPlane};
pub use kind::ContactKind;
pub use line::{ClippedLine, GivenLaw};
