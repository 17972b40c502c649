//! Searches and profiles of functions whose minima and intervals are known.

mod examples;
mod intervals;
mod searches;
mod strategy;
