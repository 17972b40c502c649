//! The motion on a piece between events, with its event functions and its energy.

pub(crate) mod book;
mod contact_series;
pub(crate) mod flexible_pieces;
pub(crate) mod gaps;
pub(crate) mod pressing;
pub(crate) mod scales;
pub(crate) mod series;
pub(crate) mod state_buffers;
pub(crate) mod watch;
