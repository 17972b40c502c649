//! The phases of contacts, and the lines of laws of straight lines.

pub(crate) mod contact_phase;
pub(crate) mod contact_state;
pub(crate) mod lines;
