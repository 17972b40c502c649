//! Laws of friction.

mod bearing;
mod bouc_wen;
mod dahl;
mod displacement_control;
mod hysteresis;
pub(in crate::contact) mod lugre;
pub(in crate::contact) mod pendulum;
mod stribeck;
mod tanh;
mod velocity_control;

pub use bearing::Bearing;
pub use bouc_wen::BoucWen;
pub use dahl::Dahl;
pub use displacement_control::DisplacementControl;
pub use lugre::Lugre;
pub use pendulum::Pendulum;
pub use stribeck::{Decay, Stribeck};
pub use tanh::Tanh;
pub use velocity_control::VelocityControl;

/// The static limit of a law with another kinetic one, to which it stays in proportion.
fn in_proportion(static_limit: f64, kinetic: f64, limit: f64) -> f64 {
    match kinetic > 0.0 {
        true => static_limit / kinetic * limit,
        false => limit,
    }
}
