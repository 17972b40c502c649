//! The friction oscillator.

mod budget;
mod pressed;
mod static_ratio;
mod steps;
mod two_forms;
mod work;
