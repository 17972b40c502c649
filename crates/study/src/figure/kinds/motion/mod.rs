//! Figures of motions: over time, along the structure, and their spectra.

pub(super) mod curve;
pub(super) mod history;
pub(super) mod orbit;
pub(super) mod profile;
pub(super) mod response;
pub(super) mod set;
pub(super) mod spectrum;
pub(super) mod wave;
