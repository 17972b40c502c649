//! Laws of links.

mod bilinear;
mod imk;
mod multilinear;
mod own;
mod restrainer;
mod viscous;

pub use bilinear::Bilinear;
pub use imk::Imk;
pub use multilinear::Multilinear;
pub use own::{Own, OwnAnswer, OwnFault, OwnLaw, OwnState, OwnStep, STATES};
pub use restrainer::Restrainer;
pub use viscous::Viscous;
