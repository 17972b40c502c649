//! Figures of motions: histories, one quantity over another, profiles, spectra and laws.

pub(super) mod curve;
mod cycles;
pub(super) mod history;
pub(super) mod law;
pub(super) mod orbit;
pub(super) mod profile;
mod response;
mod set;
pub(super) mod spectrum;
pub(super) mod wave;
