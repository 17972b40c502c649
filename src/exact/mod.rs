//! Exact solutions. They never import the stepper, so that the one can judge the other.

pub mod chain;
pub mod coulomb;
pub mod regularised;
pub mod spring;
pub mod wave;
