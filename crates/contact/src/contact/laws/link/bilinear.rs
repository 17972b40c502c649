//! A yielding part with kinematic hardening.

use crate::contact::DisplacementControl;
use crate::contact::laws::yielding::band::{self, Band};
use crate::contact::prelude::*;

/// Elastic with k1 up to the force Fy, then hardening with k2 <= k1: kinematic, so that the elastic range keeps its width 2 Fy and
/// moves with the force (Prager 1956). A column, a lead-rubber bearing; OpenSees has it as `Steel01` with b = k2/k1.
///
/// With k2 < 0 it softens: the lines fall with r, through S = 0 and beyond, as those of a column under its weight (P-delta). The spring
/// k2 then stores less than nothing, and gives it back. A step has one root while 1 + k2 h > 0.
///
/// The force stays between the lines k2 r - q and k2 r + q, q = Fy (1 - k2/k1), and is elastic between them. The part stores
/// k2 r^2/2 + (S - k2 r)^2/(2 (k1 - k2)); while it yields it dissipates q |dr|, so that a closed loop between -a and a,
/// a > Fy/k1, takes 4 q (a - Fy/k1). At t = 0 it has the force of its first loading from r = 0 to r(0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bilinear {
    /// k1 > 0.
    pub stiffness: f64,
    /// Fy > 0.
    pub yield_force: f64,
    /// k2 <= k1; below 0 it softens.
    pub hardening: f64,
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize>(band::Step<L>);

/// Whether the law has had a step: r and S then are its whole state.
#[derive(Debug, Clone, Copy, Default)]
pub struct Begun(bool);

/// k2/k1
const RATIO: Number = Number::new(
    ["ratio", "*k*_2_/*k*_1_", "1"],
    Range::AtMostOne,
    "k2/k1, instead of k2",
)
.instead_of("k2");

impl Bilinear {
    fn band(&self) -> Band {
        let width = self.yield_force * (1.0 - self.hardening / self.stiffness);
        Band {
            stiffness: [self.stiffness, self.hardening],
            bounds: [-width, width],
        }
    }
}

impl StoredEnergy for Bilinear {
    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        self.band().stored_energy(r, s)
    }
}

impl Described for Bilinear {
    const KIND: ContactKind = ContactKind::Link;
    const NAME: &'static str = "bilinear";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let stiffness = given.need("k1")?;
        let hardening = match (given.given("k2"), given.given("ratio")) {
            (Some(k2), None) => k2,
            (None, Some(ratio)) => ratio * stiffness,
            _ => return Err(LawFault::Needs(Self::NAME, "k2 or ratio")),
        };
        Ok(Form::of(Bilinear {
            stiffness,
            yield_force: given.need("Fy")?,
            hardening: given.at_most("k2", hardening, ("k1", stiffness))?,
        }))
    })
        .also(&["steel01", "uniaxialbilin", "elastoplastic"])
        .in_structures(
            "yields at Fy in both directions, with kinematic hardening, or softening if k2 < 0: a column, a lead-rubber bearing (Prager 1956)",
            &[&structure::K1, &structure::FY, &structure::K2, &RATIO],
        )];
    const IN_PLANE: InPlane<Self> = Some(|law, on| {
        let [_, limit] = law.band().bounds;
        let compliance = 1.0 / (law.stiffness - law.hardening);
        let in_plane = ElasticInPlane {
            spring: law.hardening,
            from_zero: true,
            ..DisplacementControl { compliance, limit }.into()
        };
        AnyPlaneLaw::new(in_plane, on)
    });
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let r = velocity * time;
        let beyond = r - law.yield_force / law.stiffness;
        Some((law.stiffness * r).min(law.yield_force + law.hardening * beyond))
    });
}

impl Properties for Bilinear {
    fn family(&self) -> Family {
        Family::Link(self.stiffness)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k1 =", self.stiffness), ("Fy =", self.yield_force)]
    }

    fn reach(&self) -> f64 {
        4.0 * self.yield_force / self.stiffness
    }

    fn bounds(&self) -> [f64; 2] {
        let most = match self.hardening == 0.0 {
            true => self.yield_force,
            false => f64::INFINITY,
        };
        [-most, most]
    }

    fn falls(&self) -> bool {
        self.hardening < 0.0
    }

    fn has_one_root(&self, on: &StepFlexibility<1>) -> bool {
        1.0 + self.hardening * on.end.h.0[0] > 0.0
    }

    fn straight(&self) -> Option<Straight> {
        Some(Straight::Band {
            band: self.band(),
            unbent: false,
            is_stop: false,
        })
    }
}

impl Law for Bilinear {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step(Band::step(laws, Self::band, on))
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = Begun;

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, begun: &mut Begun) -> Lane<L> {
        let change = trial.change - trial.force * self.0.start;
        let [mut r, mut rest] = [trial.displacement, change];
        if !begun.0 {
            // Without a force yet: loaded from r = 0 on.
            for l in 0..L {
                if trial.force.0[l] == 0.0 {
                    rest.0[l] += r.0[l];
                    r.0[l] = 0.0;
                }
            }
        }
        begun.0 = true;
        self.0.force(r, trial.force, rest)
    }
}
