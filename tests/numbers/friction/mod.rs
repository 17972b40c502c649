//! The friction oscillator.

mod budget;
mod static_ratio;
mod steps;
mod two_forms;
mod work;
