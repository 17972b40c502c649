//! Time stepping of structures by every method but constant average acceleration.
//!
//! A step has one or two sub-steps of one form ([`crate::methods::SubStep`]). The unknown of each is one acceleration vector a', and the matrix in
//! front of it is L D L^T, as sparse as the structure. No displacement is divided by dt^2, so round-off stays small for short
//! steps. At its end a contact has r' = r* - (d2 s1) G S' and rdot' = rdot* - (d1 s1) G S' with G = B^T (..)^-1 B, so that every
//! law is a clipped line as in the constant average acceleration method, and the forces are the same small convex problem
//! ([`crate::contact::coupled`]). If d2 = 0, laws of displacements know their forces beforehand.
//!
//! In the method of Moreau and Jean dt S' is an impulse. A rigid stop is active where the step would overlap without it; then
//! rdot' >= -e rdot. More stops are active if the forces on the first ones make them overlap. Coulomb friction holds a contact at
//! the level of velocities, rdot' = 0. The overlap that remains is projected back with the inverse mass (`impact`), and contacts at
//! rest get a velocity of 0 without round-off (`rest`).

mod books;
mod critical;
mod curved;
mod held;
mod mass;
mod meet;
mod repeat;
mod rigid;
mod stages;
mod start;
mod state;
mod stepper;
mod sub_step_contacts;
mod two_limits;

pub(super) use crate::solve::structure::general::stages::General;
pub use critical::{CriticalFault, critical_fault, critical_step};
