//! Structures with friction and impact: integrated step by step, solved exactly, and the error measured.
//!
//! A structure answers the forces of its contacts, a contact is one scalar law, a method is a small recursion, a step is one
//! small convex problem for the contact forces; with one contact it is a scalar root.
//!
//! ```text
//! x_k'' + omega_k^2 x_k = -phi_k^2 S            modes, scaled so that r = sum x_k (+ gap)      system
//! W' = W - K P - G (S + S'),  P' = P + W'       constant average acceleration, exactly         methods
//! r' = r* - h S'(r', state)                     the law's root                                 contact
//! ```
//!
//! The modules from top to bottom; each uses only those below it: [`problem`] (parameters, metrics and systems of a case),
//! [`metrics`], [`solve`], [`textbook`], [`exact`], [`system`], [`methods`], [`contact`], [`expression`], [`range`], [`lane`], [`history`].
//!
//! Everything that determines a result is in this crate, except the reader of structures: [`VERSION_KEY`] is a hash of its code.

pub use slipgap_contact::{contact, lane, range};
pub use slipgap_motion::{exact, history, solve, textbook};
pub use slipgap_problem::{metrics, problem};
pub use slipgap_system::{methods, system};

/// Hashes of the code of all crates that determine a result. A change of it makes stored results outdated; a change of comments,
/// documentation or tests does not change it.
pub const VERSION_KEYS: [&str; 4] = [
    slipgap_contact::CODE_KEY,
    slipgap_system::CODE_KEY,
    slipgap_motion::CODE_KEY,
    slipgap_problem::CODE_KEY,
];
