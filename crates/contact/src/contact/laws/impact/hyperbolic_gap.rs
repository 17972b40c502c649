//! The backfill of an abutment.

use super::hertz::POINTS;
use super::rigid_impact::{Duration, integral};
use super::{RigidImpact, loop_of, resisting};
use crate::contact::prelude::*;
use libm::{log1p, sqrt};
use std::f64::consts::FRAC_PI_2;

/// Backfill behind an abutment: F = -S over the overlap d = -r follows a hyperbola of the passive pressure (Duncan and Mokwa 2001),
/// and unloads and reloads with k_u:
///
/// ```text
/// F = max(min(k_u (d - s), d/(1/k + R_f d/F_ult)), 0)
/// ```
///
/// k is the stiffness at first, R_f the failure ratio: F tends to F_ult/R_f. s is where the force ends on unloading, d - F/k_u: the gap
/// that stays in the soil, which does not follow the abutment. OpenSees has it as `HyperbolicGapMaterial`. In the
/// form F = d/(A + B d) of Shamsabadi et al. (2007), k = 1/A and R_f = B F_ult.
///
/// In a step with d' = d* - h F the hyperbola is a quadratic equation, (F - d'/(A + B d'))(A + B d') = 0; its root with A + B d' > 0 is
/// F = 2 d*/(p + ((A + h - B d*)^2 + 4 A B d*)^(1/2)), p = A + h + B d*, for d* > 0. Both lines rise with d', so that the root is the
/// smaller one of their roots.
///
/// The soil stores F^2/(2 k_u) and dissipates F ds: a first push to a and back takes a/B - A/B^2 ln(1 + a B/A) - F^2/(2 k_u).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HyperbolicGap {
    /// k > 0.
    pub stiffness: f64,
    /// F_ult > 0.
    pub ultimate: f64,
    /// R_f, > 0 and <= 1.
    pub failure_ratio: f64,
    /// k_u >= k.
    pub unloading: f64,
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    /// A and B.
    hyperbola: [Lane<L>; 2],
    unloading: Lane<L>,
    /// 1/(1 + k_u h).
    share: Lane<L>,
    /// Flexibilities for S(i) and S(i+1).
    h: [Lane<L>; 2],
}

/// s of L contacts, as it was before the last force.
#[derive(Debug, Clone, Copy, Default)]
pub struct Left<const L: usize>(Lane<L>);

/// F_ult
const F_ULT: Number = Number::new(
    ["Fult", "*F*_ult_", "force"],
    Range::Positive,
    "ultimate passive force of {laws}",
);
/// R_f
const R_F: Number = Number::new(
    ["Rf", "*R*_f_", "1"],
    Range::Fraction,
    "failure ratio of {laws}: Fult over the force that the hyperbola tends to, > 0 and <= 1; default 0.7",
)
.usually(Usual::Is(0.7));
/// k_u
const K_UNLOADING: Number = Number::new(
    ["k_unloading", "*k*_u_", "force/length"],
    Range::Positive,
    "stiffness of {laws} on unloading and reloading, at least k",
)
.usually(Usual::Follows("k"));

impl HyperbolicGap {
    fn hyperbola(&self) -> [f64; 2] {
        [1.0 / self.stiffness, self.failure_ratio / self.ultimate]
    }

    /// F of a first loading to d >= 0.
    fn first(&self, d: f64) -> f64 {
        let [a, b] = self.hyperbola();
        d / (a + b * d)
    }

    /// Work of a first loading to d >= 0, and F: (x - ln(1 + x))/(k b^2), x = b d, b = R_f k/F_ult.
    fn work(&self, d: f64) -> [f64; 2] {
        let bend = self.failure_ratio * self.stiffness / self.ultimate;
        let x = bend * d;
        // Without the difference of two numbers that are alike.
        let less = match x < 1e-3 {
            true => x * x * (0.5 - x * (1.0 / 3.0 - x * (0.25 - x * (0.2 - x / 6.0)))),
            false => x - log1p(x),
        };
        [less * self.stiffness / (bend * bend), self.first(d)]
    }

    /// Two masses that collide with the law.
    fn collision(&self, mass: f64, speed: f64) -> RigidImpact {
        let energy = 0.5 * mass * speed * speed;
        // The hyperbola is below k d; x - ln(1 + x) >= x^2/(2 (1 + x)).
        let least = speed * sqrt(mass / self.stiffness);
        let bend = self.failure_ratio * self.stiffness / self.ultimate;
        let scaled = energy * bend * bend / self.stiffness;
        let most = (scaled + sqrt(scaled * (scaled + 2.0))) / bend;
        let overlap = roots::rising_once(least, most, least, |d| {
            let [work, force] = self.work(d);
            [work - energy, force]
        });
        let force = self.first(overlap);
        // dt = dd/v with d = overlap (1 - p^2); near the turn the energy left is the force times the way.
        let approach = integral(|p| {
            let way = overlap * p * p;
            let left = match p < 1e-4 {
                true => force * way,
                false => energy - self.work(overlap - way)[0],
            };
            2.0 * overlap * p / sqrt(2.0 * left / mass)
        });
        let omega = sqrt(self.unloading / mass);
        RigidImpact {
            // Round-off of an impact that hardly bends.
            restitution: (force / (omega * mass * speed)).min(1.0),
            duration: Duration::Known(approach + FRAC_PI_2 / omega),
            overlap,
        }
    }
}

impl StoredEnergy for HyperbolicGap {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        0.5 * s * s / self.unloading
    }

    fn conservative_force(&self, r: f64, s: f64) -> f64 {
        let d = (-r).max(0.0);
        let [a, b] = self.hyperbola();
        let root = a + b * d;
        // Round-off of r and S.
        match -s * root >= d * (1.0 - 8.0 * f64::EPSILON) {
            true => s * (a / (root * root)) / self.unloading,
            false => s,
        }
    }
}

impl Described for HyperbolicGap {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "hyperbolic-gap";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let stiffness = given.need("k")?;
        let unloading = given.given("k_unloading").unwrap_or(stiffness);
        given.at_most("k", stiffness, ("k_unloading", unloading))?;
        let law = HyperbolicGap {
            stiffness,
            ultimate: given.need("Fult")?,
            failure_ratio: given.need("Rf")?,
            unloading,
        };
        Ok(Form::of(law))
    })
        .also(&["hyperbolicgapmaterial", "backfill", "abutment"])
        .in_structures(
            "closes when r reaches 0; pushes along a hyperbola: the backfill of an abutment (Duncan and Mokwa 2001, Shamsabadi et al. 2007)",
            &[&structure::K, &F_ULT, &R_F, &K_UNLOADING],
        )];
    const CLOSED_FORM: ClosedForm<Self> =
        ClosedForm::Collision(|law, mass, speed| law.collision(mass, speed));
}

impl Properties for HyperbolicGap {
    fn family(&self) -> Family {
        Family::Yielding(self.unloading)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k =", self.stiffness), ("Fult =", self.ultimate)]
    }

    fn initial_stiffness(&self, overlap: f64) -> f64 {
        let [a, b] = self.hyperbola();
        let root = a + b * overlap;
        if overlap > 0.0 {
            a / (root * root)
        } else {
            0.0
        }
    }

    fn reach(&self) -> f64 {
        2.0 * self.ultimate / self.stiffness
    }
}

impl Law for HyperbolicGap {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let unloading = lanes(laws, |law| law.unloading);
        Step {
            hyperbola: [0, 1].map(|which| lanes(laws, |law| law.hyperbola()[which])),
            unloading,
            share: (Lane::splat(1.0) + unloading * on.end.h).map(|x| 1.0 / x),
            h: [on.start.h, on.end.h],
        }
    }

    /// In to the overlap `reach`, and out.
    fn cycle(&self, reach: f64) -> Cycle {
        let part = |i: u32| reach * f64::from(i) / f64::from(POINTS);
        let states = (0..=POINTS).map(|i| [part(i), self.first(part(i))]);
        let end = reach - self.first(reach) / self.unloading;
        loop_of(states.chain([[end, 0.0]]), reach)
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = Left<L>;

    /// s follows from the start of the step alone: it is the same for every trial of the step.
    #[inline(always)]
    fn force(&self, trial: &Trial<L>, left: &mut Left<L>) -> Lane<L> {
        let [d, force] = [-trial.displacement, -trial.force];
        let [a, b] = self.hyperbola;
        for l in 0..L {
            if force.0[l] > 0.0 {
                left.0.0[l] = d.0[l] - force.0[l] / self.unloading.0[l];
            }
        }
        let free = d + (trial.force * self.h[0] - trial.change);
        let elastic = self.unloading * (free - left.0) * self.share;
        let mut envelope = free.larger(Lane::splat(0.0));
        for l in 0..L {
            let (a, b, h, d) = (a.0[l], b.0[l], self.h[1].0[l], envelope.0[l]);
            let difference = a + h - b * d;
            let root = (difference * difference + 4.0 * a * b * d).sqrt();
            envelope.0[l] = 2.0 * d / (a + h + b * d + root);
        }
        resisting(elastic.smaller(envelope).larger(Lane::splat(0.0)))
    }
}
