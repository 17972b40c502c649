//! Equilibrium under static loads, and the forces at t = 0.

mod damped;
pub(crate) mod equilibrium;
mod first_force;
pub(crate) mod initial;
pub(crate) mod instant;
pub(crate) mod preload;
