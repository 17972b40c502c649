//! The non-linear viscoelastic law, with damping while the bodies approach.

use super::newton::newton;
use super::{Hertz, POINTS, bound, conservative_force, push, stored_energy};
use crate::contact::impact::collision::HertzDashpot;
use crate::contact::impact::hertz;
use crate::contact::impact::{Free, RigidImpact, loop_of, resisting};
use crate::contact::prelude::*;
use libm::sqrt;
use std::f64::consts::PI;

/// F = k_h delta^1.5 + C delta^0.25 ddelta while approaching, k_h delta^1.5 while parting (Jankowski 2005).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jankowski {
    /// k_h, force over length^1.5.
    pub stiffness: f64,
    /// C = 2 xi sqrt(k_h m), force over velocity and length^0.25.
    pub damping: f64,
}

impl Jankowski {
    /// For a target of the coefficient of restitution in (0, 1], with xi of Jankowski 2006; 1 gives no damping.
    /// m = m1 m2/(m1 + m2) of the bodies.
    pub fn new(stiffness: f64, restitution: f64, mass: f64) -> Self {
        let e = restitution;
        let ratio = 4.5 * sqrt(5.0) * (1.0 - e) * (1.0 + e) / (e * (e * (9.0 * PI - 16.0) + 16.0));
        Jankowski {
            stiffness,
            damping: 2.0 * ratio * (sqrt(stiffness) * sqrt(mass)),
        }
    }

    /// xi for bodies of this m.
    pub fn ratio(&self, mass: f64) -> f64 {
        0.5 * self.damping / (sqrt(self.stiffness) * sqrt(mass))
    }
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    hertz: hertz::Step<L>,
    /// C, and h C and h_rate C with the flexibility for S(i+1).
    damping: Lane<L>,
    by_overlap: Lane<L>,
    by_rate: Lane<L>,
}

impl StoredEnergy for Jankowski {
    fn stored_energy(&self, r: f64, _: f64) -> f64 {
        stored_energy(self.stiffness, r)
    }

    fn conservative_force(&self, r: f64, _: f64) -> f64 {
        conservative_force(self.stiffness, r)
    }
}

impl Described for Jankowski {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "jankowski";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let (k_h, restitution) = (given.need("k_h")?, given.need("restitution")?);
        let law = Jankowski::new(k_h, restitution, given.need("colliding_mass")?);
        Ok(Form::of(law).with_restitution(restitution))
    })
    .between_bars(
        "hertz with a dashpot while approaching (Jankowski 2005, 2006)",
        &[&bars::K_H, &bars::RESTITUTION],
    )
    .in_structures(
        "hertz with a dashpot while approaching (Jankowski 2005, 2006)",
        of_structures![K_H, RESTITUTION, COLLIDING_MASS],
    )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, mass, speed| {
        RigidImpact::dashpot(law.stiffness, law.ratio(mass), mass, speed)
    });
}

impl Properties for Jankowski {
    fn family(&self) -> Family {
        Family::Hertz(self.stiffness)
    }

    fn undamped(&self) -> Option<ContactLaw> {
        let stiffness = self.stiffness;
        Some(Hertz { stiffness }.into())
    }
}

impl Law for Jankowski {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let damping = lanes(laws, |law| law.damping);
        Step {
            hertz: hertz::Step::new(lanes(laws, |law| law.stiffness), on),
            damping,
            by_overlap: on.end.h * damping,
            by_rate: on.end.h_rate * damping,
        }
    }

    /// A collision of two rigid masses, m = 1, up to the overlap `reach`.
    fn cycle(&self, reach: f64) -> Cycle {
        let collision = HertzDashpot {
            ratio: self.ratio(1.0),
        };
        let steps = (0..=POINTS).map(|i| f64::from(i) / f64::from(POINTS));
        let greatest = collision.overlap();
        let approach = steps.clone().map(|p| {
            // Points are near one another at first touch, where the force rises as the fourth root of the overlap.
            let [overlap, speed] = collision.approach(p * p * p);
            let force =
                overlap * sqrt(overlap) + 2.0 * collision.ratio * sqrt(sqrt(overlap)) * speed;
            let unit = reach / greatest;
            [unit * overlap, push(self.stiffness, unit) * force]
        });
        let overlaps = steps.map(|p| reach * (1.0 - p));
        let parting = overlaps.map(|overlap| [overlap, push(self.stiffness, overlap)]);
        loop_of(approach.chain(parting), reach)
    }
}

/// Relative size of the last step: some units of round-off, because a step that passes the kink is not quadratic.
pub(in crate::contact) const LAST: f64 = 16.0 * f64::EPSILON;

impl<const L: usize> Step<L> {
    /// F >= 0.
    ///
    /// Let delta' = delta*/s^4. With E = h k_h delta*^0.5, D = h_rate C delta*^0.25 and G = h C delta*^-0.75 ddelta*, the
    /// equations of a step that approaches at its end are, and those of one that parts are without the last term,
    ///
    /// ```text
    /// T(s) = s - s^-3 - E s^-5 - max(0, G - D (1 - s^-4)) = 0,   s >= 1
    /// ```
    ///
    /// T rises and is concave, being the smaller of two functions that do and are. Newton's iteration from anywhere is below
    /// the root after one step, and then rises to it without passing it.
    #[inline(always)]
    fn push(&self, free: &Free<L>) -> Lane<L> {
        let root = free.overlap.map(f64::sqrt);
        let fourth = root.map(f64::sqrt);
        let e = self.hertz.by_overlap * root;
        let d = self.by_rate * fourth;
        let closing = self.by_overlap * fourth * free.closing;
        let g = closing.zip(
            free.overlap,
            |g, overlap| if overlap > 0.0 { g / overlap } else { 0.0 },
        );
        let inverse = contraction(e, d, g).map(|s| 1.0 / s);
        let square = inverse * inverse;
        let hertz = self.hertz.stiffness * (free.overlap * root) * (square * square * square);
        let dashpot = fourth * inverse;
        let damped = (hertz + self.damping * dashpot * free.closing)
            * (Lane::splat(1.0) + self.by_rate * dashpot).map(|x| 1.0 / x);
        // Approaching, ddelta* > h_rate F, is the same as a damped force above that of the spring.
        hertz.larger(damped)
    }
}

/// The root of T.
#[inline(always)]
pub(in crate::contact) fn contraction<const L: usize>(
    e: Lane<L>,
    d: Lane<L>,
    g: Lane<L>,
) -> Lane<L> {
    if e.0.iter().zip(&g.0).all(|(e, g)| *e == 0.0 && *g == 0.0) {
        return Lane::splat(1.0);
    }
    let start = start(e, d, g);
    newton(start - step(start, e, d, g), LAST, |s| {
        rising(step(s, e, d, g))
    })
}

/// Near the root without damping, or G - D: T(s) <= s + D - G, so the root is not below it.
#[inline(always)]
pub(in crate::contact) fn start<const L: usize>(e: Lane<L>, d: Lane<L>, g: Lane<L>) -> Lane<L> {
    bound(e, Lane::splat(0.0)).map(f64::sqrt).larger(g - d)
}

/// A step that rises. Only round-off makes it fall after the first one; at the kink it could return the iteration to its start.
#[inline(always)]
pub(in crate::contact) fn rising<const L: usize>(step: Lane<L>) -> Lane<L> {
    step.smaller(Lane::splat(0.0))
}

/// T/T', not so large that s becomes less than 1.
#[inline(always)]
pub(in crate::contact) fn step<const L: usize>(
    mut s: Lane<L>,
    e: Lane<L>,
    d: Lane<L>,
    g: Lane<L>,
) -> Lane<L> {
    for (l, s) in s.0.iter_mut().enumerate() {
        let (e, d, g) = (e.0[l], d.0[l], g.0[l]);
        // Not G - D (1 - s^-4): for large G and D its round-off would be larger than the last step.
        let rest = g - d;
        let inverse = 1.0 / *s;
        let square = inverse * inverse;
        let (third, fourth) = (square * inverse, square * square);
        let fifth = fourth * inverse;
        let damped = rest + d * fourth;
        let approaches = damped > 0.0;
        let value = *s - third - e * fifth - if approaches { damped } else { 0.0 };
        let slope = 1.0
            + 3.0 * fourth
            + 5.0 * e * (fifth * inverse)
            + if approaches { 4.0 * d * fifth } else { 0.0 };
        let (step, most) = (value / slope, *s - 1.0);
        *s = if step > most { most } else { step };
    }
    s
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        resisting(self.push(&Free::new(trial, &self.hertz.start)))
    }
}
