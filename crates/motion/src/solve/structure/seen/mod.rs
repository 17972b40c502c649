//! What a run shows: the state after each step, energies, and what warnings need.

pub(crate) mod books;
pub(crate) mod ledger;
mod runaway;
pub(crate) mod step_view;
pub(crate) mod watch;
