//! Structures with friction and impact: integrated step by step, solved exactly, and the error measured.
//!
//! ```text
//! M u'' + C u' + K u + B S = p(t),   r = B^T u + gap          Structure
//! S of each contact from r, rdot and what its law remembers    Contact with a StructureLaw
//! ```
//!
//! A structure answers the forces of its contacts, a contact is one scalar law, a method is a small recursion, and a step is one small
//! convex problem for the contact forces. [`run`] steps a [`Structure`] with a [`Method`]; [`exact`] gives the motion that the steps
//! approach. The names of this page stay; the crates below it (`slipgap-contact`, `slipgap-system`, `slipgap-motion`) may change theirs.
//!
//! Everything that determines a motion is in those three crates and in `slipgap-notation`: [`VERSION_KEYS`] has a hash of each.

mod contacts;
pub mod laws;
mod methods;
mod motions;
mod own;
mod structures;

pub use contacts::*;
pub use methods::*;
pub use motions::*;
pub use own::*;
pub use structures::*;

/// Hashes of the code of all crates that determine a motion. A change of it makes stored results outdated; a change of comments,
/// documentation or tests does not change it.
///
/// ```
/// let keys = slipgap_solver::VERSION_KEYS;
/// assert!(keys.iter().all(|key| !key.is_empty()));
/// ```
pub const VERSION_KEYS: [&str; 4] = [
    slipgap_notation::CODE_KEY,
    slipgap_contact::CODE_KEY,
    slipgap_system::CODE_KEY,
    slipgap_motion::CODE_KEY,
];
