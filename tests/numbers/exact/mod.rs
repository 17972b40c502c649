//! Exact motions, and independent programs with many digits.

mod independent;
mod references;
mod regularised;
mod starts;
