//! The Bouc-Wen model of friction.

use super::hysteresis::{self, Hysteresis, Motion};
use crate::contact::prelude::*;

/// Bouc-Wen model [Bouc 1967, Wen 1976] of friction: S = L z, dz/dr = (1 - |z|^n (beta sgn(rdot z) + gamma))/u_y with u_y = compliance L
/// and beta + gamma = 1: A and beta + gamma of other forms of it are in the compliance and the limit. For beta = 1/2 it unloads
/// elastically and tends to the displacement-control model for n to infinity.
///
/// The law does not depend on time, so a step needs only r(i+1) - r(i). With u = |r(i+1) - r(i)|/u_y and d = beta - gamma, while y = |z|
/// falls to 0, dy/du = -(1 + d y^n). Then, for a motion in one direction,
///
/// ```text
/// 1 - z(u) = (1 - z(0)) exp(-u)                 n = 1
/// z(u) = tanh(atanh z(0) + u)                   n = 2
/// z(u) - z(0) = u (1 - zm^n) up to z(u) = 1, zm = (z(0) + z(u))/2, another n
/// ```
///
/// and likewise with -d in place of 1 for the fall. The closed forms are exact. The last line is the implicit midpoint rule, of second
/// order; it rises with u.
///
/// The contact stores S^2/(2 k), k = 1/compliance. Then it dissipates S dr |z|^n while |z| grows and -d S dr |z|^n while it falls, less
/// than 0 for beta < 1/2, but never less than 0 until z is again what it was. It drifts: reloading after a small unloading is softer
/// than unloading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoucWen {
    /// u_y/L > 0; alpha in dimensionless units.
    pub compliance: f64,
    /// L = `nu |N| <N>`, >= 0.
    pub limit: f64,
    /// n > 0.
    pub exponent: f64,
    /// beta > 0; gamma = 1 - beta.
    pub beta: f64,
}

/// beta of elastic unloading.
const ELASTIC: f64 = 0.5;

const BETA: Number = Number::new(
    ["beta", "*β*", "1"],
    Range::Positive,
    "{laws}: beta of 1 - abs(z)^n (beta sgn(rdot z) + gamma), gamma = 1 - beta; default 0.5, elastic unloading",
)
.usually(Usual::Is(ELASTIC));

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    hysteresis: Hysteresis<L>,
    /// beta - gamma, and whether it is another number than 0 in a lane.
    d: Lane<L>,
    bends: bool,
}

impl BoucWen {
    /// beta - gamma.
    pub(in crate::contact) fn d(&self) -> f64 {
        2.0 * self.beta - 1.0
    }
}

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
                // The oscillator has another number of this name.
                beta: given.given(BETA.key).unwrap_or(ELASTIC),
            }))
        },
        [
            "hysteretic; tends to displacement-control as the exponent rises (Wen 1976)",
            "friction, hysteretic; tends to displacement-control as the exponent rises (Wen 1976)",
        ],
        &[&structure::K, &structure::R_E, &structure::EXPONENT, &BETA],
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

    fn largest_stiffness(&self, _: f64) -> f64 {
        // Unloading from the limit.
        (2.0 * self.beta).max(1.0) / self.compliance
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
        let d = lanes(laws, BoucWen::d);
        Step {
            hysteresis: Hysteresis::new(laws, numbers, |n| n == 1.0 || n == 2.0, on),
            d,
            bends: d != Lane::splat(0.0),
        }
    }
}

/// z is S.
impl Evolution for BoucWen {
    fn rate(&self, z: f64, rdot: f64) -> f64 {
        if self.limit <= 0.0 {
            return 0.0;
        }
        let elastic = rdot / self.compliance;
        let falls = z * rdot <= 0.0;
        if falls && self.beta == ELASTIC {
            return elastic;
        }
        let power = power(self.exponent, z.abs() / self.limit);
        match falls {
            true => elastic * (1.0 + self.d() * power),
            false => elastic * (1.0 - power).max(0.0),
        }
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
        let step = &self.hysteresis;
        let motion = step.motion(trial);
        // u + c (z(u) - z(0)) = w, elastic up to z = 0 if d = 0.
        let Motion { along: z, w, c, .. } = motion;
        let below = (-z).larger(zero);
        let mut fallen = w.zip(c, |w, c| w / (1.0 + c)).smaller(below);
        let mut to_zero = below;
        if self.bends {
            for l in 0..L {
                let [n, d, y] = [step.exponent.0[l], self.d.0[l], below.0[l]];
                if d != 0.0 && y > 0.0 {
                    to_zero.0[l] = fall(n, d, y, y)[0];
                    fallen.0[l] = fallen_by(n, d, y, [c.0[l], w.0[l]]);
                }
            }
        }
        let z = z.larger(zero);
        let beyond = w - to_zero - c * below;
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
        motion.end(fallen + grown)
    }
}

/// y^n.
fn power(n: f64, y: f64) -> f64 {
    match n {
        1.0 => y,
        2.0 => y * y,
        n => libm::pow(y, n),
    }
}

/// u over which y falls by t, and du/dt.
fn fall(n: f64, d: f64, y: f64, t: f64) -> [f64; 2] {
    let end = y - t;
    let slope = 1.0 / (1.0 + d * power(n, end));
    if n == 1.0 {
        return [libm::log1p(d * t * slope) / d, slope];
    }
    if n == 2.0 {
        let root = d.abs().sqrt();
        let part = root * t / (1.0 + d * y * end);
        let u = match d > 0.0 {
            true => libm::atan(part),
            false => libm::atanh(part),
        };
        return [u / root, slope];
    }
    // By the midpoint rule. The slope of y^n is that at the middle.
    let middle = y - 0.5 * t;
    let share = 1.0 / (1.0 + d * power(n, middle));
    let bend = 0.5 * d * n * libm::pow(middle, n - 1.0);
    [t * share, share * (1.0 + t * share * bend)]
}

/// The fall t <= y at the root of u + c t = w.
fn fallen_by(n: f64, d: f64, y: f64, [c, w]: [f64; 2]) -> f64 {
    let residual = |t: f64| {
        let [u, slope] = fall(n, d, y, t);
        [u + c * t - w, slope + c]
    };
    if residual(y)[0] <= 0.0 {
        return y;
    }
    roots::rising_once(0.0, y, w / (fall(n, d, y, 0.0)[1] + c), residual)
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
