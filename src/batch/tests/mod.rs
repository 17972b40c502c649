//! Runs of whole studies: their columns, computed values, and what is made once.

mod columns;
mod computed;
mod samples;
