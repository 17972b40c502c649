//! The law of a contact in continuous time: between motions that are given, or behind springs.

use crate::contact::{ContactLaw, Evolution, Flexibility, StepFlexibility};
use crate::lane::Lane;

/// The law of a contact at a time.
pub struct Own {
    /// The law.
    pub law: ContactLaw,
    /// The same behind springs.
    pub braced: Option<Braced>,
}

impl Own {
    /// What its state does; `None` where S follows from r and rdot.
    pub fn evolution(&self) -> Option<&dyn Evolution> {
        match &self.braced {
            Some(braced) => Some(braced),
            None => self.law.evolution(),
        }
    }
}

/// A law of velocity behind springs. z is S, its rdot that of r*.
pub struct Braced {
    /// The law.
    pub law: ContactLaw,
    /// F.
    pub compliance: f64,
}

impl Evolution for Braced {
    fn rate(&self, z: f64, rdot: f64) -> f64 {
        let own = self.law.properties().rate_under(z);
        own.map_or(0.0, |[own, _]| (rdot - own) / self.compliance)
    }

    fn bound(&self) -> f64 {
        let [_, high] = self.law.properties().bounds();
        high
    }
}

/// The flexibility of a contact whose motion is given, but for this part of rdot.
pub fn flexibility(h_rate: f64) -> StepFlexibility<1> {
    let zero = Lane([0.0]);
    let none = Flexibility {
        h: zero,
        h_rate: zero,
    };
    StepFlexibility {
        start: none,
        end: Flexibility {
            h: zero,
            h_rate: Lane([h_rate]),
        },
        dt: Lane([1.0]),
        by_impulse: false,
    }
}
