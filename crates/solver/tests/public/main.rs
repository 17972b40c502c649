//! The solver as a program of a user sees it.

mod names;
mod own_law;
mod refused;
