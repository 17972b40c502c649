//! Laws at rest: without their dampers, which have no static force.

use super::{ContactLaw, Hertz, ImpactSpring, Viscous};

impl ContactLaw {
    /// The law whose static force this one has; `None` if it is this law. The dampers of some impacts follow the ratio of rdot to the
    /// closing speed, which stays however slowly an equilibrium is reached.
    pub fn without_damper(&self) -> Option<ContactLaw> {
        let hertz = |stiffness| Some(ContactLaw::Hertz(Hertz { stiffness }));
        match self {
            ContactLaw::KelvinVoigt(law) => {
                let stiffness = law.stiffness;
                Some(ContactLaw::ImpactSpring(ImpactSpring { stiffness }))
            }
            ContactLaw::HertzDamp(law) => hertz(law.stiffness),
            ContactLaw::HuntCrossley(law) => hertz(law.stiffness),
            ContactLaw::Ye(law) => hertz(law.stiffness),
            ContactLaw::Jankowski(law) => hertz(law.stiffness),
            law if law.of_velocity() && !law.is_vertical() => Some(ContactLaw::Viscous(Viscous {
                viscosity: 0.0,
                exponent: 1.0,
            })),
            _ => None,
        }
    }

    /// Whether S is not a function of the motion: it may have any value within bounds at rest.
    pub fn is_vertical(&self) -> bool {
        match self {
            ContactLaw::Rigid(_) => true,
            ContactLaw::VelocityControl(law) => law.compliance == 0.0,
            ContactLaw::Bearing(law) => law.compliance == 0.0,
            ContactLaw::Stribeck(law) => law.compliance == 0.0,
            ContactLaw::Tanh(law) => law.compliance == 0.0,
            _ => false,
        }
    }
}
