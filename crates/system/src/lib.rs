//! Structures with their matrices, loads and records, and the methods of integration.
//!
//! A part of slipgap, whose names may change: who needs the solver uses `slipgap-solver`.

pub mod methods;
pub mod system;

use slipgap_contact::{contact, lane, range};

/// Hash of the code of this crate and of the crates of others that it computes with.
pub const CODE_KEY: &str = env!("SLIPGAP_CODE");
