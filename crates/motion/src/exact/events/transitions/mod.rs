//! The phases and the impulses after an event.

pub(crate) mod resting_contact;
pub(crate) mod rigid;
pub(crate) mod rigid_phases;
pub(crate) mod softened_phases;
