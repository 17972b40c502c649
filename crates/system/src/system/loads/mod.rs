//! Loads of structures: recorded, synthetic and pulse-like ground motions as data, parts of them, their response spectra
//! and intensity measures.
//!
//! All is text in, data out; the caller reads the files. Accelerations become a [`Table`](super::structure::Table) that is 0 beyond
//! the motion.

pub mod cut;
pub mod cycles;
pub mod measures;
pub mod pair;
pub mod pulse;
pub mod record;
mod signal;
pub mod spectrum;
pub mod synthetic;
pub mod target;
mod unit;

pub use signal::{SignalFault, signal};
pub use unit::{STANDARD_GRAVITY, Unit};
