//! Exact motions, and independent programs with many digits.

mod dampers;
mod independent;
mod references;
mod regularised;
mod starts;
