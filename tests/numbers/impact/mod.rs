//! The impact of two bars.

mod budget;
mod contact;
mod invariants;
mod massless;
mod mesh;
mod mode;
mod printed;
mod spring;
mod two_forms;
