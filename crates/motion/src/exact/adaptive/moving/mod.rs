//! A structure as a flow: its forces, its rates, and how its planes begin to slide and come to rest.

pub(crate) mod begin;
pub mod braced;
pub(crate) mod creep;
pub(crate) mod damper;
mod flow;
pub(crate) mod forces;
pub(crate) mod rest;
pub(crate) mod rigid_planes;
pub(crate) mod structure;
pub(crate) mod substitute;
