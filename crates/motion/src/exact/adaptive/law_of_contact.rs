//! The law of a contact in continuous time: between motions that are given, or behind springs.

use crate::contact::{ContactLaw, Evolution, Flexibility, StepFlexibility};
use crate::lane::Lane;

/// The law of a contact at a time.
pub struct LawOfContact {
    /// The law.
    pub law: ContactLaw,
    /// F of the springs behind which it is, if S is a state by them.
    pub brace: Option<f64>,
}

impl LawOfContact {
    /// What its state does; `None` where S follows from r and rdot.
    pub fn evolution(&self) -> Option<&dyn Evolution> {
        match self.brace {
            Some(_) => Some(self),
            None => self.law.evolution(),
        }
    }
}

/// Of a law of velocity behind springs: z is S, its rdot that of r*.
impl Evolution for LawOfContact {
    fn rate(&self, z: f64, rdot: f64) -> f64 {
        let own_rate = self.law.properties().rate_under(z);
        match (own_rate, self.brace) {
            (Some([own_rate, _]), Some(compliance)) => (rdot - own_rate) / compliance,
            _ => 0.0,
        }
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
