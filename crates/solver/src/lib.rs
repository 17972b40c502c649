//! Structures with friction and impact: integrated step by step, solved exactly, and the error measured.
//!
//! ```text
//! M u'' + C u' + K u + B S = p(t),   r = B^T u + gap          Structure
//! S of each contact from r, rdot and what its law remembers    Contact with a StructureLaw
//! ```
//!
//! A structure answers the forces of its contacts, a contact is one scalar law, a method is a small recursion, and a step is one small
//! convex problem for the contact forces. [`run`] steps a [`Structure`] with a [`Method`]; [`exact`] gives the motion that the steps
//! approach. The names of this page stay; the crates below it (`slipgap-contact`, `slipgap-system`, `slipgap-motion`,
//! `slipgap-problem`) may change theirs.
//!
//! Everything that determines a result is in those four crates and in `slipgap-notation`, except the reader of structures: [`VERSION_KEYS`] has a hash of each.

mod solution;

pub use slipgap_contact::contact::{
    ClippedLine, ContactKind, ContactLaw, LawFault, Own, OwnAnswer, OwnLaw, OwnState,
};
pub use slipgap_motion::exact::events::{Event, EventKind, EventsFault, Phase};
pub use slipgap_motion::solve::Unsolvable;
pub use slipgap_system::methods::{
    AverageAcceleration, Bathe, Coefficients, ContactStabilized, Method, MoreauJean,
};
pub use slipgap_system::system::structure::{
    Baseline, Contact, Direction, Limit, Load, Motion, Node, Preload, Pressure, Signal, Structure,
    StructureLaw, Support, Symmetric, Table,
};
pub use solution::{Solution, exact, run};

/// The laws of contacts that are no clipped lines, with their numbers.
pub mod laws {
    pub use slipgap_contact::contact::{
        Bearing, Bilinear, BoucWen, Dahl, GapYield, Hertz, HertzDamp, HuntCrossley, HyperbolicGap,
        Imk, ImpactYield, Jankowski, KelvinVoigt, Lugre, Multilinear, Pendulum, Restrainer,
        Stribeck, Tanh, Viscous, Ye,
    };
}

/// Hashes of the code of all crates that determine a result. A change of it makes stored results outdated; a change of comments,
/// documentation or tests does not change it.
pub const VERSION_KEYS: [&str; 5] = [
    slipgap_notation::CODE_KEY,
    slipgap_contact::CODE_KEY,
    slipgap_system::CODE_KEY,
    slipgap_motion::CODE_KEY,
    slipgap_problem::CODE_KEY,
];
