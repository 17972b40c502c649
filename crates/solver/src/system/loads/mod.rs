//! Loads of structures: recorded, synthetic and pulse-like ground motions as data, and their response spectra.
//!
//! All is text in, data out; the caller reads the files. Accelerations become a [`Table`](super::structure::Table) that is 0 beyond
//! the motion.

pub mod pulse;
pub mod record;
mod signal;
pub mod spectrum;
pub mod synthetic;
mod unit;

pub use signal::{SignalFault, signal};
pub use unit::{STANDARD_GRAVITY, Unit};
