//! Studies and files with faults: each is reported at its place.

mod calibrate;
mod files;
mod impact;
mod measured;
