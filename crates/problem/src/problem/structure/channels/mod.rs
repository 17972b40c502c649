//! Channels: quantities of a structure over time, computed and measured, by their names.

pub mod channel;
pub mod measured;
pub mod names;
pub mod sample;
pub mod words;
