//! The verbs of the program besides `run`.

mod begin;
mod calibrate;
mod checks;
mod claims;
mod claims_near;
mod compare;
mod helpful;
mod usage;
