//! Problems: parameters, cases, metrics and references.
//!
//! A part of slipgap, whose names may change: who needs the solver uses `slipgap-solver`.

pub mod metrics;
pub mod problem;

use slipgap_contact::{contact, lane};
use slipgap_motion::{exact, history, solve};
use slipgap_system::{methods, system};

/// Hash of the code of this crate and of the crates of others that it computes with.
pub const CODE_KEY: &str = env!("SLIPGAP_CODE");
