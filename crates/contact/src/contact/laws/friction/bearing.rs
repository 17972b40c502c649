//! The velocity-control model with the coefficient of friction of a sliding bearing.

use crate::contact::prelude::*;
use crate::contact::saturation::rise;

/// Velocity-control model [F (16)] whose coefficient rises with velocity, nu = nu_max - (nu_max - nu_min) exp(-a |rdot|)
/// [Constantinou, Mokha and Reinhorn 1990]: viscous, S = rdot/compliance, up to the limit nu N at the same velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    /// 1/c^C, >= 0; beta in dimensionless units.
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
    ratio: Lane<L>,
    rate: Lane<L>,
    /// Flexibilities for S(i) and S(i+1).
    h_rate: [Lane<L>; 2],
    /// S(i+1) of the viscous element for a unit of rdot.
    by_rate: Lane<L>,
}

impl Bearing {
    /// nu N at a velocity >= 0.
    fn sliding(&self, v: f64) -> f64 {
        self.limit * (self.ratio + (1.0 - self.ratio) * rise(self.rate * v))
    }

    /// S at a velocity >= 0.
    fn force(&self, v: f64) -> f64 {
        let limit = self.sliding(v);
        match v < self.compliance * limit {
            true => v / self.compliance,
            false => limit,
        }
    }
}

impl StoredEnergy for Bearing {}

impl Described for Bearing {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "velocity-control";
    const OF_VELOCITY: bool = true;
    const OFFERS: &'static [Offer] = &[];
    const IN_PLANE: InPlane<Self> = Some(OfVelocity::over);
    const CLOSED_FORM: ClosedForm<Self> =
        ClosedForm::Driven(|law, velocity, _| Some(law.force(velocity)));
}

impl Properties for Bearing {
    fn family(&self) -> Family {
        Family::Viscous(self.compliance, self.limit)
    }

    fn reach(&self) -> f64 {
        4.0 * (self.compliance * self.limit + 1.0 / self.rate)
    }

    fn corner(&self, rdot: f64) -> f64 {
        self.sliding(rdot.abs()) - rdot.abs() / self.compliance
    }
}

impl Law for Bearing {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        Bearing { limit, ..self }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            limit: lanes(laws, |law| law.limit),
            ratio: lanes(laws, |law| law.ratio),
            rate: lanes(laws, |law| law.rate),
            h_rate: [on.start.h_rate, on.end.h_rate],
            by_rate: (lanes(laws, |law| law.compliance) + on.end.h_rate).map(|c| 1.0 / c),
        }
    }

    /// From -1.1 `reach` to 1.1 `reach`; a compliance of zero is the rigid law.
    fn cycle(&self, reach: f64) -> Cycle {
        curve::over_velocity(reach, |velocity| self.force(velocity))
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        // S = min(rdot/compliance, nu N) for rdot >= 0. Both rise, so the root is the smaller one of the two roots. For sliding,
        // with z = a rdot: z + C (1 - exp(-z)) = w, C = a h_rate (nu_max - nu_min) N.
        let [start, end] = self.h_rate;
        let free = trial.rate - trial.force * start;
        let least = self.limit * self.ratio;
        let range = self.limit - least;
        let w = self.rate * (free.map(f64::abs) - end * least);
        let m = saturation::root(
            self.rate * end * range,
            Lane::splat(0.0),
            w.larger(Lane::splat(0.0)),
        );
        let sliding = least + range * m;
        (free.map(f64::abs) * self.by_rate)
            .smaller(sliding)
            .zip(free, f64::copysign)
    }
}
