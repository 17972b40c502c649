//! Laws at rest: without their dampers, which have no static force.

use super::{ContactLaw, Viscous};

impl ContactLaw {
    /// The law whose static force this one has; `None` if it is this law. The dampers of some impacts follow the ratio of rdot to the
    /// closing speed, which stays however slowly an equilibrium is reached.
    pub fn without_damper(&self) -> Option<ContactLaw> {
        let none = Viscous {
            viscosity: 0.0,
            exponent: 1.0,
        };
        let properties = self.properties();
        let is_damper = self.of_velocity() && !properties.is_vertical();
        properties.undamped().or(is_damper.then(|| none.into()))
    }
}
