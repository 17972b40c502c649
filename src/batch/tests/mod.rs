//! Runs of whole studies: their columns, and what is made once.

mod columns;
mod measured;
mod samples;
