//! Contact laws, and the forces of several contacts in a step.
//!
//! A part of slipgap, whose names may change: who needs the solver uses `slipgap-solver`.

pub mod contact;
pub mod lane;
pub mod range;

/// Hash of the code of this crate and of the crates of others that it computes with.
pub const CODE_KEY: &str = env!("SLIPGAP_CODE");
