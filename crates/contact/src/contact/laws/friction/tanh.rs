//! Friction with a hyperbolic tangent of the velocity.

use crate::contact::prelude::*;
use crate::contact::saturation::rise;

/// S = nu(rdot) N tanh(rdot/rdot^E), rdot^E = compliance limit: the velocity-control model without corners [Andersson, Soderberg
/// and Bjorklund 2007].
///
/// The coefficient rises from `ratio` nu_max at rest to nu_max: nu = nu_max - (nu_max - nu_min) exp(-a |rdot|) [Constantinou, Mokha
/// and Reinhorn 1990]. With `ratio` = 1 it is constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tanh {
    /// rdot^E over the limit, > 0; 1/(dS/drdot) at rest if `ratio` = 1; beta in dimensionless units.
    pub compliance: f64,
    /// `nu_max |N| <N>`, >= 0.
    pub limit: f64,
    /// nu_min/nu_max, in (0, 1].
    pub ratio: f64,
    /// a, >= 0, in 1/velocity.
    pub rate: f64,
}

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    /// `nu_max |N| <N>`, >= 0; may change from step to step.
    limit: Lane<L>,
    compliance: Lane<L>,
    ratio: Lane<L>,
    rate: Lane<L>,
    /// Flexibilities for S(i) and S(i+1).
    h_rate: [Lane<L>; 2],
    /// Whether no coefficient depends on velocity.
    constant: bool,
}

impl Tanh {
    /// S at a velocity >= 0, and dS/drdot.
    #[inline(always)]
    fn force(&self, velocity: f64) -> [f64; 2] {
        // Without a limit the width is not used: all products with the limit are zero.
        let width = self.compliance * if self.limit > 0.0 { self.limit } else { 1.0 };
        let [m, low] = [rise(2.0 * velocity / width), 1.0 - self.ratio];
        let t = m / (2.0 - m);
        let less = low * (1.0 - rise(self.rate * velocity));
        let slope = (1.0 - less) * (1.0 - t * t) / width + self.rate * less * t;
        [self.limit * (1.0 - less) * t, self.limit * slope]
    }
}

impl StoredEnergy for Tanh {}

impl Described for Tanh {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "tanh";
    const OF_VELOCITY: bool = true;
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let limit = given.limit();
        let [ratio, rate] = given.bearing()?;
        Ok(Form::of(Tanh {
            compliance: given.fluidity(limit)?,
            limit,
            ratio,
            rate,
        }))
    })
    .in_oscillator(
        "nu N tanh(rdot/rdot^E), without corners (Andersson, Soderberg and Bjorklund 2007)",
        of_oscillator![BETA, NU_RATIO, NU_RATE],
    )
    .in_structures(
        "friction, limit times tanh(rdot/rdot^E)",
        of_structures![C, RDOT_E, NU_MIN, NU_RATE],
    )];
    const IN_PLANE: InPlane<Self> = Some(OfVelocity::over);
    const CLOSED_FORM: ClosedForm<Self> =
        ClosedForm::Driven(|law, velocity, _| Some(law.force(velocity)[0]));
}

impl Properties for Tanh {
    fn family(&self) -> Family {
        Family::Viscous(self.compliance, self.limit)
    }
}

impl Law for Tanh {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        Tanh { limit, ..self }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            limit: lanes(laws, |law| law.limit),
            compliance: lanes(laws, |law| law.compliance),
            ratio: lanes(laws, |law| law.ratio),
            rate: lanes(laws, |law| law.rate),
            h_rate: [on.start.h_rate, on.end.h_rate],
            constant: laws.iter().all(|law| law.ratio == 1.0),
        }
    }

    /// From -1.1 `reach` to 1.1 `reach`.
    fn cycle(&self, reach: f64) -> Cycle {
        curve::over_velocity(reach, |velocity| self.force(velocity)[0])
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        // With z = 2 rdot/rdot^E: z + C tanh(z/2) = w. S is odd, so |w| is enough.
        let [start, end] = self.h_rate;
        let free = trial.rate - trial.force * start;
        let two = self.compliance.map(|compliance| 2.0 / compliance);
        let w = (free * two).zip(self.limit, |w, limit| {
            if limit > 0.0 { (w / limit).abs() } else { 0.0 }
        });
        let m = saturation::root(end * two, Lane::splat(1.0), w);
        let mut force = self.limit * m.map(|m| m / (2.0 - m));
        if !self.constant {
            force = self.bearing(free.map(f64::abs), force);
        }
        force.zip(free, f64::copysign)
    }
}

impl<const L: usize> Step<L> {
    /// |S| with the coefficient that depends on velocity, from its value with nu_max. This one is larger, so the velocity is at least
    /// the one with it.
    #[inline(always)]
    fn bearing(&self, free: Lane<L>, above: Lane<L>) -> Lane<L> {
        let h = self.h_rate[1];
        let law = |l: usize| Tanh {
            compliance: self.compliance.0[l],
            limit: self.limit.0[l],
            ratio: self.ratio.0[l],
            rate: self.rate.0[l],
        };
        let velocity = roots::rising(Lane::splat(0.0), free, free - h * above, |l, velocity| {
            let [force, slope] = law(l).force(velocity);
            [velocity + h.0[l] * force - free.0[l], 1.0 + h.0[l] * slope]
        });
        let mut force = above;
        for l in 0..L {
            // With a constant coefficient the bits do not depend on the other lanes.
            if self.ratio.0[l] != 1.0 {
                [force.0[l], _] = law(l).force(velocity.0[l]);
            }
        }
        force
    }
}
