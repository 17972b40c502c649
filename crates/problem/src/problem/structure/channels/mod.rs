//! Channels: quantities of a structure over time, computed and measured, by their names.

pub mod channel;
pub mod channel_words;
pub mod measured_channels;
pub mod names;
pub mod sample;
