//! Rigid stops: impulses, projected overlaps, and contacts at rest.

pub(crate) mod correct;
pub(crate) mod impact;
pub(crate) mod rest;
