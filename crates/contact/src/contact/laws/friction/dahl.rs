//! Dahl's model of friction.

use super::hysteresis::{self, Hysteresis, Motion};
use crate::contact::prelude::*;

/// Dahl's model [Dahl 1968, 1976]: dS/dr = sigma (1 - (S/L) sgn rdot)^n, sigma = 1/compliance. n = 0 is the displacement-control model.
///
/// The law does not depend on time, so a step needs only r(i+1) - r(i). The flow is exact for a motion in one direction:
/// with q = 1 - (S/L) sgn rdot and z = sigma |r(i+1) - r(i)|/L,
///
/// ```text
/// q(z) = q(0) exp(-z)                                        n = 1
/// q(z) = q(0) (1 + (n - 1) q(0)^(n-1) z)^(-1/(n-1))          n > 1, and for n < 1 until q = 0
/// ```
///
/// The contact stores S^2/(2 sigma). Then it dissipates S (1 - q^n) dr >= 0: both factors change sign with S. It creeps: under a
/// small cycle about a force S that is not zero the displacement drifts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dahl {
    /// 1/sigma, > 0, sigma = dS/dr at S = 0; alpha in dimensionless units.
    pub compliance: f64,
    /// L = `nu |N| <N>`, >= 0.
    pub limit: f64,
    /// n >= 0.
    pub exponent: f64,
}

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize>(Hysteresis<L>);

impl StoredEnergy for Dahl {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        0.5 * self.compliance * s * s
    }
}

impl Described for Dahl {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "dahl";
    const OFFERS: &'static [Offer] = &[hysteresis::offer(
        Self::NAME,
        |given| {
            Ok(Form::of(Dahl {
                compliance: given.compliance()?,
                limit: given.limit(),
                exponent: given.need("exponent")?,
            }))
        },
        [
            "hysteretic, its stiffness falls towards the friction limit (Dahl 1968)",
            "friction, hysteretic, its stiffness falls towards the limit (Dahl 1968)",
        ],
        of_structures![K, R_E, EXPONENT],
    )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let z = velocity * time / (law.compliance * law.limit);
        let n = law.exponent;
        let rest = match n == 1.0 {
            true => libm::exp(-z),
            false => libm::pow((1.0 + (n - 1.0) * z).max(0.0), -1.0 / (n - 1.0)),
        };
        Some(law.limit * (1.0 - rest))
    });
}

impl Properties for Dahl {
    fn family(&self) -> Family {
        Family::Elastic(self.compliance, self.limit)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k =", 1.0 / self.compliance), ("exponent", self.exponent)]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        // Unloading from the limit.
        libm::pow(2.0, self.exponent) / self.compliance
    }

    fn unbent_force(&self, _: f64) -> Option<f64> {
        Some(0.0)
    }

    fn evolution(&self) -> Option<&dyn Evolution> {
        Some(self)
    }
}

impl Law for Dahl {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        Dahl { limit, ..self }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let numbers = |law: &Self| [law.compliance, law.limit, law.exponent];
        Step(Hysteresis::new(laws, numbers, |n| n == 1.0, on))
    }
}

/// z is S.
impl Evolution for Dahl {
    fn rate(&self, z: f64, rdot: f64) -> f64 {
        if self.limit <= 0.0 {
            return 0.0;
        }
        let along = if rdot < 0.0 { -z } else { z };
        let q = (1.0 - along / self.limit).max(0.0);
        let power = if self.exponent == 1.0 {
            q
        } else {
            libm::pow(q, self.exponent)
        };
        rdot / self.compliance * power
    }

    fn bound(&self) -> f64 {
        self.limit
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let Step(step) = self;
        let motion = step.motion(trial);
        // z + c (q(0) - q(z)) = w
        let Motion { along, w, c, .. } = motion;
        let q = along.map(|along| 1.0 - along);
        let mut less = Lane::splat(0.0);
        if step.closed[0] {
            less = q * saturation::root(c * q, less, w);
        }
        if !step.closed[1] {
            for l in 0..L {
                let n = step.exponent.0[l];
                if n != 1.0 {
                    less.0[l] = power_step(n, q.0[l], c.0[l], w.0[l]);
                }
            }
        }
        motion.end(less)
    }
}

/// q(0) - q(z) at the root of z + c (q(0) - q(z)) = w for the exponent n, not 1. The sum is concave, so Newton's iteration rises to
/// the root from the left.
fn power_step(n: f64, q: f64, c: f64, w: f64) -> f64 {
    if q <= 0.0 {
        return 0.0;
    }
    // q(0) - q(z) and -dq/dz = q^n, without cancellation for small z and for n near 1.
    let steepness = libm::pow(q, n - 1.0);
    let fallen = |z: f64| {
        let grown = (n - 1.0) * steepness * z;
        if grown <= -1.0 {
            return [q, 0.0];
        }
        let less = -q * libm::expm1(-libm::log1p(grown) / (n - 1.0));
        [less, (q - less) * steepness / (1.0 + grown)]
    };
    let [saturated, linear] = [w - c * q, w / (1.0 + c * q * steepness)];
    let start = if saturated > linear {
        saturated
    } else {
        linear
    };
    let z = roots::rising_once(0.0, w, start, |z| {
        let [less, slope] = fallen(z);
        [z + c * less - w, 1.0 + c * slope]
    });
    fallen(z)[0]
}
