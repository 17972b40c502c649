//! Many cases at a time.

mod single;
mod sweep;
