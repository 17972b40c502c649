//! The coordinates of a structure: its nodes, or its modes.

pub(crate) mod flexible;
pub(crate) mod modal;
pub(crate) mod model;
pub(crate) mod modes;
pub(crate) mod pressed;
