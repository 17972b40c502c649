//! Structures: laws, matrices, records, equilibria.

mod at_rest;
mod bridge_parts;
mod exact;
mod laws;
mod motions;
mod negative;
mod own_structure;
mod records;
mod reduction;
mod series;
mod sets;
mod statics;
mod studies;
mod written;
