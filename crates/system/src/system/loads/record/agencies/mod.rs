//! Formats of agencies whose headers have labels in words.

mod accelerogram;
mod channel;
mod labelled;
mod nsmp;
mod stated;

pub(super) use accelerogram::FORMAT as ACCELEROGRAM;
pub(super) use labelled::{ESM, UNAM};
pub(super) use nsmp::FORMAT as NSMP;
