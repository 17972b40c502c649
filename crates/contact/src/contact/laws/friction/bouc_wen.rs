//! The Bouc-Wen model of friction.

use super::hysteresis::{self, Hysteresis, Motion};
use crate::contact::prelude::*;

/// Bouc-Wen model [Bouc 1967, Wen 1976] of friction: S = L z, dz/dr = (1 - |z|^n (1 + sgn(rdot z))/2)/u_y with u_y = compliance L,
/// that is A = 1, beta = gamma = 1/2. It unloads elastically and tends to the displacement-control model for n to infinity.
///
/// The law does not depend on time, so a step needs only r(i+1) - r(i). With u = |r(i+1) - r(i)|/u_y, while z falls to 0 it
/// changes by u. Then, for a motion in one direction,
///
/// ```text
/// 1 - z(u) = (1 - z(0)) exp(-u)                 n = 1
/// z(u) = tanh(atanh z(0) + u)                   n = 2
/// z(u) - z(0) = u (1 - zm^n) up to z(u) = 1, zm = (z(0) + z(u))/2, another n
/// ```
///
/// Both closed forms are exact. The last line is the implicit midpoint rule, of second order; it rises with u.
///
/// The contact stores S^2/(2 k), k = 1/compliance. Then it dissipates S dr |z|^n while |z| grows and nothing while it falls. It
/// drifts: reloading after a small unloading is softer than unloading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoucWen {
    /// u_y/L > 0; alpha in dimensionless units.
    pub compliance: f64,
    /// L = `nu |N| <N>`, >= 0.
    pub limit: f64,
    /// n > 0.
    pub exponent: f64,
}

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize>(Hysteresis<L>);

impl StoredEnergy for BoucWen {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        0.5 * self.compliance * s * s
    }
}

impl Described for BoucWen {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "bouc-wen";
    const OFFERS: &'static [Offer] = &[hysteresis::offer(
        Self::NAME,
        |given| {
            Ok(Form::of(BoucWen {
                compliance: given.compliance()?,
                limit: given.limit(),
                exponent: given.need("exponent")?,
            }))
        },
        [
            "hysteretic; tends to displacement-control as the exponent rises (Wen 1976)",
            "friction, hysteretic; tends to displacement-control as the exponent rises (Wen 1976)",
        ],
    )];
    const IN_PLANE: InPlane<Self> = Some(|law, on| AnyPlaneLaw::new(*law, on));
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let u = velocity * time / (law.compliance * law.limit);
        match law.exponent {
            1.0 => Some(law.limit * -libm::expm1(-u)),
            2.0 => Some(law.limit * libm::tanh(u)),
            _ => None,
        }
    });
}

impl Properties for BoucWen {
    fn family(&self) -> Family {
        Family::Elastic(self.compliance, self.limit)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k =", 1.0 / self.compliance), ("exponent", self.exponent)]
    }

    fn unbent_force(&self, _: f64) -> Option<f64> {
        Some(0.0)
    }

    fn evolution(&self) -> Option<&dyn Evolution> {
        Some(self)
    }
}

impl Law for BoucWen {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        BoucWen { limit, ..self }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let numbers = |law: &Self| [law.compliance, law.limit, law.exponent];
        Step(Hysteresis::new(laws, numbers, |n| n == 1.0 || n == 2.0, on))
    }
}

/// z is S.
impl Evolution for BoucWen {
    fn rate(&self, z: f64, rdot: f64) -> f64 {
        if self.limit <= 0.0 {
            return 0.0;
        }
        let elastic = rdot / self.compliance;
        if z * rdot <= 0.0 {
            return elastic;
        }
        let part = z.abs() / self.limit;
        let power = match self.exponent {
            1.0 => part,
            2.0 => part * part,
            n => libm::pow(part, n),
        };
        elastic * (1.0 - power).max(0.0)
    }

    fn bound(&self) -> f64 {
        self.limit
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let zero = Lane::splat(0.0);
        let Step(step) = self;
        let motion = step.motion(trial);
        // u + c (z(u) - z(0)) = w, elastic up to z = 0.
        let Motion { along: z, w, c, .. } = motion;
        let below = (-z).larger(zero);
        let elastic = w.zip(c, |w, c| w / (1.0 + c)).smaller(below);
        let z = z.larger(zero);
        let beyond = w.zip(c, |w, _| w) - below - c * below;
        let w = beyond.larger(zero);
        let mut grown = zero;
        if step.closed[0] {
            let one = step.exponent.map(|n| if n == 1.0 { 1.0 } else { 2.0 });
            let far = z.map(|z| 1.0 - z);
            // For n = 2: tanh is a quotient in exp(-2 u).
            let d = z.zip(one, |z, one| {
                if one == 1.0 {
                    0.0
                } else {
                    (1.0 - z) / (1.0 + z)
                }
            });
            let m = saturation::root(one * c * far, d, one * w);
            grown = far * m.zip(d, |m, d| m / (1.0 + d - d * m));
        }
        if !step.closed[1] {
            for l in 0..L {
                let n = step.exponent.0[l];
                if n != 1.0 && n != 2.0 {
                    grown.0[l] = midpoint(n, z.0[l], c.0[l], w.0[l]);
                }
            }
        }
        motion.end(elastic + grown)
    }
}

/// z(u) - z(0) at the root of u + c (z(u) - z(0)) = w by the midpoint rule, for z(0) >= 0.
fn midpoint(n: f64, z: f64, c: f64, w: f64) -> f64 {
    // With t = zm - z(0): u = 2 t/(1 - zm^n), both sides times 1 - zm^n. Beyond z(u) = 1 the force stays at its limit.
    let most = 0.5 * (1.0 - z);
    let residual = |t: f64| {
        let power = libm::pow(z + t, n);
        let rest = 2.0 * t * c - w;
        let slope = 2.0 + 2.0 * c * (1.0 - power) - rest * n * power / (z + t);
        [2.0 * t + rest * (1.0 - power), slope]
    };
    if most <= 0.0 || residual(most)[0] <= 0.0 {
        return 2.0 * most;
    }
    let elastic = 0.5 * w / (1.0 + c);
    2.0 * roots::rising_once(0.0, most, elastic, residual)
}
