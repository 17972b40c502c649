//! What results have: tables, figures and columns of each kind of study.

mod between_steps;
mod cut;
mod designs;
mod ensembles;
mod memory;
mod pictures;
mod plane;
mod reductions;
mod restitution;
mod types;
mod units;
mod untouched;
