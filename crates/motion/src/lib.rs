//! Motions of structures with contacts: step by step, exact, and by the papers' own equations.
//!
//! A part of slipgap, whose names may change: who needs the solver uses `slipgap-solver`.

pub mod exact;
pub mod history;
pub mod solve;
pub mod textbook;

use slipgap_contact::{contact, lane};
use slipgap_system::{methods, system};

/// Hash of the code of this crate and of the crates of others that it computes with.
pub const CODE_KEY: &str = env!("SLIPGAP_CODE");
