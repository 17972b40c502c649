//! A damper with a power of velocity.

use crate::contact::prelude::*;
use libm::pow;

/// Fluid viscous damper, S = c |rdot|^a sgn rdot. It stores nothing. A cycle r = x sin(w t) dissipates
/// 4 2^a gamma(1 + a/2)^2/gamma(2 + a) c x^(1 + a) w^a, which is pi c w x^2 for a = 1. OpenSees has it as `ViscousDamper` behind a
/// spring, and as `Viscous`.
///
/// A step has rdot' = v - h_rate S. With |v| for v and S >= 0, the root of S = c (v - h_rate S)^a is sought in the variable in which
/// the equation is convex: for a < 1, where the law is vertical at rdot = 0, z = S/c = rdot'^a,
///
/// ```text
/// z^(1/a) + h_rate c z = v     a < 1
/// x + h_rate c x^a = v         a > 1, x = rdot'
/// ```
///
/// The left sides rise and are convex, so that Newton's iteration from a bound above the root falls to it; a bracket makes
/// sure that it ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscous {
    /// c > 0.
    pub viscosity: f64,
    /// a, from 0.1 to 2.
    pub exponent: f64,
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    viscosity: Lane<L>,
    exponent: Lane<L>,
    /// Flexibilities for S(i) and S(i+1).
    h_rate: [Lane<L>; 2],
}

/// a
const A: Number = Number::new(
    ["a", "*a*", "1"],
    Range::FromTenthToTwo,
    "exponent of {laws}, S = c abs(rdot)^a sgn rdot, from 0.1 to 2; c has the unit force over velocity^a",
);

impl Viscous {
    /// S at a velocity >= 0.
    fn force(&self, v: f64) -> f64 {
        self.viscosity * power(v, self.exponent)
    }
}

/// x^a for x >= 0, with the bits of the square, the number and the root.
fn power(x: f64, a: f64) -> f64 {
    match a {
        1.0 => x,
        2.0 => x * x,
        0.5 => x.sqrt(),
        _ => pow(x, a),
    }
}

impl StoredEnergy for Viscous {}

impl Described for Viscous {
    const KIND: ContactKind = ContactKind::Link;
    const NAME: &'static str = "viscous";
    const OF_VELOCITY: bool = true;
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        Ok(Form::of(Viscous {
            viscosity: given.need("c")?,
            exponent: given.need("a")?,
        }))
    })
    .also(&["viscousdamper", "damper", "fluiddamper"])
    .in_structures(
        "damper with a power of velocity, S = c abs(rdot)^a sgn rdot",
        &[&structure::C, &A],
    )];
    const CLOSED_FORM: ClosedForm<Self> =
        ClosedForm::Driven(|law, velocity, _| Some(law.force(velocity)));
}

impl Properties for Viscous {
    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("c =", self.viscosity), ("a =", self.exponent)]
    }

    fn over_velocity(&self) -> bool {
        true
    }

    /// With a > 1 it is vertical at S = 0.
    fn rate_under(&self, force: f64) -> Option<[f64; 2]> {
        let z = force.abs() / self.viscosity;
        let rate = power(z, 1.0 / self.exponent);
        let slope = match z > 0.0 {
            true => rate / z / (self.exponent * self.viscosity),
            false if self.exponent < 1.0 => 0.0,
            false => 1.0 / self.viscosity,
        };
        (self.exponent <= 1.0).then_some([rate.copysign(force), slope])
    }
}

impl Law for Viscous {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            viscosity: lanes(laws, |law| law.viscosity),
            exponent: lanes(laws, |law| law.exponent),
            h_rate: [on.start.h_rate, on.end.h_rate],
        }
    }

    /// From -1.1 `reach` to 1.1 `reach`.
    fn cycle(&self, reach: f64) -> Cycle {
        curve::over_velocity(reach, |velocity| self.force(velocity))
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let free = trial.rate - trial.force * self.h_rate[0];
        let mut force = free;
        for l in 0..L {
            let law = Viscous {
                viscosity: self.viscosity.0[l],
                exponent: self.exponent.0[l],
            };
            force.0[l] = root(law, self.h_rate[1].0[l], free.0[l].abs());
        }
        force.zip(free, f64::copysign)
    }
}

/// S at the root of S = c (v - h_rate S)^a, for v >= 0.
fn root(law: Viscous, h_rate: f64, v: f64) -> f64 {
    let a = law.exponent;
    let grip = h_rate * law.viscosity;
    if v == 0.0 || grip == 0.0 {
        return law.force(v);
    }
    if a == 1.0 {
        return law.viscosity * v / (1.0 + grip);
    }
    if a < 1.0 {
        let inverse = 1.0 / a;
        let most = power(v, a).min(v / grip);
        let z = roots::rising_once(0.0, most, most, |z| {
            let grown = pow(z, inverse);
            let slope = if z > 0.0 { inverse * grown / z } else { 0.0 };
            [grown + grip * z - v, slope + grip]
        });
        return law.viscosity * z;
    }
    let most = pow(v / grip, 1.0 / a).min(v);
    let x = roots::rising_once(0.0, most, most, |x| {
        let grown = grip * pow(x, a);
        let slope = if x > 0.0 { a * grown / x } else { 0.0 };
        [x + grown - v, 1.0 + slope]
    });
    law.force(x)
}
