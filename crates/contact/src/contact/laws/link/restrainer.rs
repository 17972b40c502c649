//! A cable that restrains.

use crate::contact::laws::yielding::one_sided::{self, HARDENING, OneSided};
use crate::contact::prelude::*;

/// A restrainer of a bridge, a cable or rod with slack: S = 0 up to r = slack, then it pulls with k up to Fy and hardens with eta k.
/// It unloads with k and never pushes; yielding makes it longer, so that the slack grows by what it leaves.
///
/// With d = r - slack, s = d - S/k at the last unloading: S = max(min(k (d - s), Fy (1 - eta) + eta k d), 0). It stores S^2/(2 k), and
/// dissipates S ds. OpenSees has it as `ElasticPPGap` in tension, with damage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restrainer {
    /// Slack >= 0.
    pub slack: f64,
    /// k > 0.
    pub stiffness: f64,
    /// Fy > 0.
    pub yield_force: f64,
    /// eta, from 0 to 1.
    pub hardening: f64,
}

/// Slack.
const SLACK: Number = Number::new(
    ["slack", "*s*", "length"],
    Range::NotNegative,
    "r up to which {laws} has no force; default 0",
)
.usually(Usual::Is(0.0));

impl Restrainer {
    fn spring(&self) -> OneSided {
        OneSided {
            stiffness: self.stiffness,
            yield_force: self.yield_force,
            hardening: self.hardening,
            returns: false,
            sign: 1.0,
            shift: -self.slack,
        }
    }
}

impl StoredEnergy for Restrainer {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        self.spring().stored_energy(s)
    }
}

impl Described for Restrainer {
    const KIND: ContactKind = ContactKind::Link;
    const NAME: &'static str = "restrainer";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        Ok(Form::of(Restrainer {
            slack: given.need("slack")?,
            stiffness: given.need("k")?,
            yield_force: given.need("Fy")?,
            hardening: given.need("hardening")?,
        }))
    })
        .also(&["cable", "cablerestrainer", "hook", "tensiononly"])
        .in_structures(
            "pulls where r is more than its slack, with k; yields at Fy and becomes longer: a cable or rod",
            &[&SLACK, &structure::K, &structure::FY, &HARDENING],
        )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let d = velocity * time - law.slack;
        let after = law.yield_force + law.hardening * (law.stiffness * d - law.yield_force);
        Some((law.stiffness * d).min(after).max(0.0))
    });
}

impl Properties for Restrainer {
    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("slack =", self.slack), ("k =", self.stiffness)]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        self.stiffness
    }

    fn reach(&self) -> f64 {
        self.slack + 3.0 * self.yield_force / self.stiffness
    }

    fn bounds(&self) -> [f64; 2] {
        [0.0, self.spring().most()]
    }

    fn straight(&self) -> Option<Straight> {
        Some(Straight::OneSided(self.spring()))
    }
}

impl Law for Restrainer {
    type Step<const L: usize> = one_sided::Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Self::Step<L> {
        OneSided::step(laws, Self::spring, on)
    }
}
