//! The numbers of the solver: exact solutions, independent programs, identities, orders of convergence.

#[path = "../common/mod.rs"]
mod common;

mod all_metrics;
mod at_rest;
mod bridge_parts;
mod budget;
mod budget_impact;
mod exact_references;
mod exact_starts;
mod friction;
mod friction_work;
mod impact;
mod impact_contact;
mod impact_invariants;
mod impact_mode;
mod independent;
mod lanes;
mod massless;
mod mesh;
mod motions;
mod negative;
mod own_structure;
mod plane;
mod plane_exact;
mod recommend_laws;
mod recommend_study;
mod records;
mod reduction;
mod regularised;
mod series;
mod spring;
mod static_ratio;
mod statics;
mod structures;
mod structures_exact;
mod structures_laws;
mod sweep;
mod two_forms;
mod two_forms_impact;
mod written;
