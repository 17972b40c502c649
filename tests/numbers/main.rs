//! The numbers of the solver: exact solutions, independent programs, identities, orders of convergence.

#[path = "../common/mod.rs"]
mod common;

mod all_metrics;
mod exact;
mod friction;
mod impact;
mod lanes;
mod plane;
mod recommend_robust;
mod recommend_study;
mod structures;
