//! A gap and a spring that yields.

use super::loop_of;
use super::yielding::Yielding;
use crate::contact::laws::yielding::one_sided::{self, HARDENING, OneSided};
use crate::contact::prelude::*;

/// A stop behind a gap that yields: F = -S over the overlap d = -r is elastic with k up to Fy, then hardens with eta k, and unloads with
/// k. A shear key, a column of soil; OpenSees has it as `ElasticPPGap`, with the same numbers.
///
/// With damage every yielding widens the gap by what it leaves: F is 0 up to d = s, s = d - F/k at the last unloading. Without
/// damage the gap closes again: what lies behind it follows the contact back, at most to d = 0, so that every new push finds
/// it where the contact turned. The part stores F^2/(2 k), and dissipates F ds. A push from d = 0 to a > Fy/k
/// and back dissipates
///
/// ```text
/// Fy b + eta k b^2/2 + (Fy^2 - F^2)/(2 k),   b = a - Fy/k,   F = Fy + eta k b
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapYield {
    /// k > 0.
    pub stiffness: f64,
    /// Fy > 0.
    pub yield_force: f64,
    /// eta, from 0 to 1.
    pub hardening: f64,
    /// Whether the gap that yielding leaves stays.
    pub damage: bool,
}

/// Whether a gap stays.
const DAMAGE: Number = Number::new(
    ["damage", "*d*", "1"],
    Range::ZeroOrOne,
    "{laws}: 1 if the gap grows by what yielding leaves, 0 if it closes again; default 1",
)
.usually(Usual::Is(1.0));

impl GapYield {
    fn spring(&self) -> OneSided {
        OneSided {
            stiffness: self.stiffness,
            yield_force: self.yield_force,
            hardening: self.hardening,
            returns: !self.damage,
            sign: -1.0,
            shift: 0.0,
        }
    }
}

impl StoredEnergy for GapYield {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        self.spring().stored_energy(s)
    }

    fn conservative_force(&self, r: f64, s: f64) -> f64 {
        -self.spring().conservative(-r, -s)
    }
}

impl Described for GapYield {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "gap-yield";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let law = GapYield {
            stiffness: given.need("k")?,
            yield_force: given.need("Fy")?,
            hardening: given.need("hardening")?,
            damage: given.need("damage")? != 0.0,
        };
        Ok(Form::of(law))
    })
        .also(&["elasticppgap", "shearkey"])
        .in_structures(
            "closes when r reaches 0; a spring k that yields at Fy and may leave a wider gap: a shear key, soil",
            &[&structure::K, &structure::FY, &HARDENING, &DAMAGE],
        )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, mass, speed| {
        let yielding = Yielding {
            stiffness: law.stiffness,
            yield_force: law.yield_force,
            after: law.hardening * law.stiffness,
        };
        yielding.permanent(mass, speed)
    });
}

impl Properties for GapYield {
    fn family(&self) -> Family {
        Family::Yielding(self.stiffness)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k =", self.stiffness), ("Fy =", self.yield_force)]
    }

    fn reach(&self) -> f64 {
        3.0 * self.yield_force / self.stiffness
    }

    fn bounds(&self) -> [f64; 2] {
        [-self.spring().most(), 0.0]
    }

    fn straight(&self) -> Option<Straight> {
        Some(Straight::OneSided(self.spring()))
    }
}

impl Law for GapYield {
    type Step<const L: usize> = one_sided::Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Self::Step<L> {
        OneSided::step(laws, Self::spring, on)
    }

    /// In to the overlap `reach`, and out.
    fn cycle(&self, reach: f64) -> Cycle {
        let spring = self.spring();
        let force = spring.first(reach);
        let turn = (self.yield_force / self.stiffness).min(reach);
        let states = [
            [turn, spring.first(turn)],
            [reach, force],
            [reach - force / self.stiffness, 0.0],
        ];
        loop_of(states.into_iter(), reach)
    }
}
