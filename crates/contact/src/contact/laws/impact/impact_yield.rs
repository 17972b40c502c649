//! The bilinear law of impact with yielding.

use super::yielding::Yielding;
use super::{loop_of, resisting};
use crate::contact::laws::yielding::band::{self, Band};
use crate::contact::prelude::*;

/// Bilinear law of impact that yields (Muthukumar and DesRoches 2006): F = -S over the overlap d = -r rises with k1 up to the overlap
/// delta_y, then with k2 < k1. It unloads with k1 by the width delta_y, then along k2 d, and ends at d = 0.
///
/// ```text
/// F = max(F + k1 dd between the lines k2 d and k2 d + (k1 - k2) delta_y, 0)
/// ```
///
/// It stores k2 d^2/2 + (F - k2 d)^2/(2 (k1 - k2)). An impact up to the overlap d_m > delta_y dissipates the parallelogram
/// (k1 - k2) delta_y (d_m - delta_y). The authors design it for the d_m and the energy Delta E of an impact by Hertz's law with damping:
/// with delta_y = a d_m and the secant stiffness k_eff = k_h d_m^(1/2),
/// k1 = k_eff + Delta E/(a d_m^2), k2 = k_eff - Delta E/((1 - a) d_m^2), Delta E = k_h d_m^2.5 (1 - e^2)/2.5, a = 0.1. OpenSees has it as
/// `ImpactMaterial`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactYield {
    /// k1 > 0.
    pub stiffness: f64,
    /// k2 > 0, at most k1.
    pub hardening: f64,
    /// delta_y > 0.
    pub yield_overlap: f64,
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize>(band::Step<L>);

/// delta_y
const DELTA_Y: Number = Number::new(
    ["delta_y", "*δ*_y_", "length"],
    Range::Positive,
    "overlap at which {laws} yields",
);

impl ImpactYield {
    fn band(&self) -> Band {
        Band {
            stiffness: [self.stiffness, self.hardening],
            bounds: [0.0, self.width()],
        }
    }

    /// Distance of the two lines.
    fn width(&self) -> f64 {
        (self.stiffness - self.hardening) * self.yield_overlap
    }
}

impl StoredEnergy for ImpactYield {
    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        match r < 0.0 {
            true => self.band().stored_energy(-r, -s),
            false => 0.0,
        }
    }

    fn conservative_force(&self, r: f64, s: f64) -> f64 {
        let line = self.hardening * (-r).max(0.0);
        // Round-off of r and S.
        let yields = -s >= (line + self.width()) * (1.0 - 8.0 * f64::EPSILON);
        if yields { -line } else { s }
    }
}

impl Described for ImpactYield {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "impact-yield";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let (stiffness, hardening) = (given.need("k1")?, given.need("k2")?);
        if hardening <= 0.0 {
            return Err(LawFault::NotPositive("k2"));
        }
        let law = ImpactYield {
            stiffness,
            hardening: given.at_most("k2", hardening, ("k1", stiffness))?,
            yield_overlap: given.need("delta_y")?,
        };
        Ok(Form::of(law))
    })
        .also(&["impactmaterial", "bilinearimpact", "muthukumardesroches"])
        .in_structures(
            "impact with k1, from delta_y on k2, unloading with k1, then k2 (Muthukumar and DesRoches 2006)",
            &[&structure::K1, &structure::K2, &DELTA_Y],
        )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, mass, speed| {
        let yielding = Yielding {
            stiffness: law.stiffness,
            yield_force: law.stiffness * law.yield_overlap,
            after: law.hardening,
        };
        yielding.returning(mass, speed)
    });
}

impl Properties for ImpactYield {
    fn family(&self) -> Family {
        Family::Yielding(self.stiffness)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k1 =", self.stiffness), ("k2 =", self.hardening)]
    }

    fn reach(&self) -> f64 {
        10.0 * self.yield_overlap
    }

    /// S = -F falls to the line where F yields.
    fn straight(&self) -> Option<Straight> {
        let band = Band {
            bounds: [-self.width(), 0.0],
            ..self.band()
        };
        Some(Straight::Band {
            band,
            unbent: false,
            is_stop: true,
        })
    }
}

impl Law for ImpactYield {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step(Band::step(laws, Self::band, on))
    }

    /// In to the overlap `reach`, and out.
    fn cycle(&self, reach: f64) -> Cycle {
        let [k1, k2] = [self.stiffness, self.hardening];
        let turn = self.yield_overlap.min(reach);
        let force = k1 * turn + k2 * (reach - turn);
        let states = [
            [turn, k1 * turn],
            [reach, force],
            [reach - turn, k2 * (reach - turn)],
        ];
        loop_of(states.into_iter(), reach)
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let [mut d, force] = [-trial.displacement, -trial.force];
        let mut change = trial.force * self.0.start - trial.change;
        for l in 0..L {
            // Open, or not loaded yet: from d = 0 on. A contact that was loaded has a force wherever d > 0.
            if force.0[l] == 0.0 {
                change.0[l] += d.0[l];
                d.0[l] = 0.0;
            }
        }
        resisting(self.0.force(d, force, change).larger(Lane::splat(0.0)))
    }
}
