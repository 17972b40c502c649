//! Properties of any law: whether it is rigid, its largest stiffness, whether it falls; its reach in figures.

use super::{ContactLaw, LawKind, StepFlexibility};

impl ContactLaw {
    /// Whether r >= 0 holds without compliance.
    pub fn rigid(&self) -> bool {
        self.kind() == LawKind::Rigid
    }

    /// The largest dS/dr; of a law with delta^1.5 that at this overlap. A viscous law has none, rigid contact an infinite one.
    pub fn largest_stiffness(&self, overlap: f64) -> f64 {
        let curved = |k_h: f64| 1.5 * k_h * overlap.sqrt();
        match self {
            ContactLaw::DisplacementControl(law) => 1.0 / law.compliance,
            ContactLaw::BoucWen(law) => 1.0 / law.compliance,
            // Unloading from the limit.
            ContactLaw::Dahl(law) => libm::pow(2.0, law.exponent) / law.compliance,
            ContactLaw::Lugre(law) => law.sigma0 * (1.0 + law.static_limit / law.limit),
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

    /// Whether figures draw the law over velocity: it depends on velocity alone, or its loop over velocity shows it better.
    pub fn over_velocity(&self) -> bool {
        matches!(
            self,
            ContactLaw::VelocityControl(_)
                | ContactLaw::Lugre(_)
                | ContactLaw::Bearing(_)
                | ContactLaw::Tanh(_)
                | ContactLaw::Stribeck(_)
        )
    }

    /// A displacement or velocity that shows the law in a figure: some widths of a friction law, the overlap of an impact law under
    /// a force of 1.
    pub fn reach(&self) -> f64 {
        match self {
            ContactLaw::DisplacementControl(law) => 4.0 * law.compliance * law.limit,
            ContactLaw::BoucWen(law) => 4.0 * law.compliance * law.limit,
            ContactLaw::Dahl(law) => 4.0 * law.compliance * law.limit,
            ContactLaw::Lugre(law) => (4.0 * law.static_limit / law.sigma0).max(1.0),
            ContactLaw::VelocityControl(law) if law.compliance == 0.0 => 1.0,
            ContactLaw::VelocityControl(law) => 4.0 * law.compliance * law.limit,
            ContactLaw::Bearing(law) => 4.0 * (law.compliance * law.limit + 1.0 / law.rate),
            ContactLaw::Tanh(law) => 4.0 * law.compliance * law.limit,
            ContactLaw::Stribeck(law) => {
                2.0 * law.compliance * law.static_limit + 3.0 * law.stribeck_velocity
            }
            ContactLaw::ImpactSpring(law) => 1.0 / law.stiffness,
            ContactLaw::KelvinVoigt(law) => 1.0 / law.stiffness,
            ContactLaw::Hertz(law) => overlap(law.stiffness),
            ContactLaw::HertzDamp(law) => overlap(law.stiffness),
            ContactLaw::HuntCrossley(law) => overlap(law.stiffness),
            ContactLaw::Ye(law) => overlap(law.stiffness),
            ContactLaw::Jankowski(law) => overlap(law.stiffness),
            ContactLaw::Rigid(_) => 1.0,
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

/// The overlap of k_h delta^1.5 under a force of 1.
fn overlap(k_h: f64) -> f64 {
    1.0 / (libm::cbrt(k_h) * libm::cbrt(k_h))
}
