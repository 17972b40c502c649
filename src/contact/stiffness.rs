//! The largest stiffness of a contact, for the critical step of a method.

use super::{ContactLaw, StepFlexibility};

impl ContactLaw {
    /// The largest dS/dr; of a law with delta^1.5 that at this overlap. A viscous law has none, rigid contact an infinite one.
    pub fn largest_stiffness(&self, overlap: f64) -> f64 {
        let curved = |k_h: f64| 1.5 * k_h * overlap.sqrt();
        match self {
            ContactLaw::DisplacementControl(law) => 1.0 / law.compliance,
            ContactLaw::BoucWen(law) => 1.0 / law.compliance,
            ContactLaw::Dahl(law) => 1.0 / law.compliance,
            ContactLaw::Lugre(law) => law.sigma0,
            ContactLaw::VelocityControl(_)
            | ContactLaw::Bearing(_)
            | ContactLaw::Tanh(_)
            | ContactLaw::Stribeck(_) => 0.0,
            ContactLaw::ImpactSpring(law) => law.stiffness,
            ContactLaw::KelvinVoigt(law) => law.stiffness,
            ContactLaw::Hertz(law) => curved(law.stiffness),
            ContactLaw::HertzDamp(law) => curved(law.stiffness),
            ContactLaw::HuntCrossley(law) => curved(law.stiffness),
            ContactLaw::Ye(law) => curved(law.stiffness),
            ContactLaw::Jankowski(law) => curved(law.stiffness),
            ContactLaw::Rigid(_) => f64::INFINITY,
        }
    }

    /// Whether every step with these flexibilities has one root; false for a law that falls, where a step may have several.
    pub fn has_one_root(&self, on: &StepFlexibility<1>) -> bool {
        match self {
            ContactLaw::Stribeck(law) => law.has_one_root(on),
            ContactLaw::Lugre(law) => law.has_one_root(on),
            _ => true,
        }
    }

    /// Whether a step may have several roots at all.
    pub fn falls(&self) -> bool {
        match self {
            ContactLaw::Stribeck(law) => law.static_limit > law.limit,
            ContactLaw::Lugre(law) => law.static_limit > law.limit,
            _ => false,
        }
    }
}
