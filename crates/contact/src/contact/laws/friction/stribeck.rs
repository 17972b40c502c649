//! Friction that falls from a static to a kinetic limit with velocity.

use super::in_proportion;
use crate::contact::prelude::*;
use crate::contact::saturation::rise;

/// Velocity-control model [F (16)] with a Stribeck curve: viscous up to the static limit L_s at rdot^E = compliance L_s, beyond it
/// S = L_k + (L_s - L_k) exp(-(|rdot| - rdot^E)/v_S), the exponential form [Tustin 1947; Bo and Pavelescu 1982 with exponent 1].
///
/// S falls there, with the slope -(L_s - L_k)/v_S at most. A step has one root if h_rate (L_s - L_k) < v_S
/// ([`Properties::has_one_root`]). Otherwise up to three: one on the viscous branch and two while sliding, of which the slower is
/// unstable. The rule is then that the contact stays on its branch as long as this has a root: it slides on if it slides at the
/// start in the direction of the trial, else it sticks. Such a result depends on dt, so problems refuse such a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stribeck {
    /// 1/c^C, >= 0; beta in dimensionless units.
    pub compliance: f64,
    /// L_k, >= 0.
    pub limit: f64,
    /// L_s >= L_k.
    pub static_limit: f64,
    /// v_S > 0.
    pub stribeck_velocity: f64,
}

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    /// L_s, and L_s - L_k.
    limit: Lane<L>,
    range: Lane<L>,
    /// 1/v_S.
    inverse: Lane<L>,
    /// Flexibilities for S(i) and S(i+1).
    h_rate: [Lane<L>; 2],
    /// S(i+1) of the viscous element for a unit of rdot.
    by_rate: Lane<L>,
    /// rdot^E, and the velocity without S that leads to it.
    width: Lane<L>,
    reached: Lane<L>,
    /// The lowest point of the residual of a sliding contact, and w there: below it, sliding has no root.
    lowest: Lane<L>,
    least: Lane<L>,
}

impl Stribeck {
    /// S at a velocity >= 0.
    fn force(&self, v: f64) -> f64 {
        let width = self.compliance * self.static_limit;
        match v < width {
            true => v / self.compliance,
            false => self.sliding((v - width) / self.stribeck_velocity),
        }
    }

    /// S at `over` = (|rdot| - rdot^E)/v_S >= 0.
    fn sliding(&self, over: f64) -> f64 {
        self.static_limit - (self.static_limit - self.limit) * rise(over)
    }
}

impl StoredEnergy for Stribeck {}

impl Described for Stribeck {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "stribeck";
    const OF_VELOCITY: bool = true;
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let limit = given.limit();
        let static_limit = given.need("static_ratio")? * limit;
        let stribeck_velocity = given.need("stribeck_velocity")?;
        Ok(Form::of(Stribeck {
            // rdot^E is that of the static limit.
            compliance: given.fluidity(static_limit)?,
            limit,
            static_limit,
            stribeck_velocity,
        }))
    })
        .in_oscillator(
            "velocity-control with a static limit, from which the force falls to the kinetic limit as the velocity rises",
            of_oscillator![BETA, STATIC_RATIO, STRIBECK_VELOCITY],
        )
        .in_structures(
            "friction, viscous up to the static limit, which falls to the kinetic one with rdot (Stribeck 1902)",
            of_structures![C, RDOT_E, STATIC_RATIO, STRIBECK_VELOCITY],
        )];
    const IN_PLANE: InPlane<Self> = Some(OfVelocity::over);
    const CLOSED_FORM: ClosedForm<Self> =
        ClosedForm::Driven(|law, velocity, _| Some(law.force(velocity)));
}

impl Properties for Stribeck {
    fn family(&self) -> Family {
        Family::Viscous(self.compliance, self.static_limit)
    }

    fn reach(&self) -> f64 {
        2.0 * self.compliance * self.static_limit + 3.0 * self.stribeck_velocity
    }

    fn falls(&self) -> bool {
        self.static_limit > self.limit
    }

    fn has_one_root(&self, on: &StepFlexibility<1>) -> bool {
        on.end.h_rate.0[0] * (self.static_limit - self.limit) < self.stribeck_velocity
    }

    fn corner(&self, rdot: f64) -> f64 {
        rdot.abs() - self.compliance * self.static_limit
    }
}

impl Law for Stribeck {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        Stribeck {
            limit,
            static_limit: in_proportion(self.static_limit, self.limit, limit),
            ..self
        }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let compliance = lanes(laws, |law| law.compliance);
        let limit = lanes(laws, |law| law.static_limit);
        let range = lanes(laws, |law| law.static_limit - law.limit);
        let inverse = lanes(laws, |law| 1.0 / law.stribeck_velocity);
        let k = on.end.h_rate * range * inverse;
        let lowest = k.map(|k| if k > 1.0 { libm::log(k) } else { 0.0 });
        Step {
            limit,
            range,
            inverse,
            h_rate: [on.start.h_rate, on.end.h_rate],
            by_rate: (compliance + on.end.h_rate).map(|c| 1.0 / c),
            width: compliance * limit,
            reached: (compliance + on.end.h_rate) * limit,
            lowest,
            least: lowest - k * lowest.map(rise),
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
        // With x = (|rdot| - rdot^E)/v_S: x - k (1 - exp(-x)) = w, which is convex with its lowest point at ln k.
        let [start, end] = self.h_rate;
        let free = trial.rate - trial.force * start;
        let w = (free.map(f64::abs) - self.reached) * self.inverse;
        let along = trial
            .velocity
            .zip(free, |v, free| if free < 0.0 { -v } else { v });
        let slides_on = (along - self.width).zip(w - self.least, |slides, root| {
            if slides > 0.0 && root >= 0.0 {
                1.0
            } else {
                0.0
            }
        });
        let slides = w.zip(
            slides_on,
            |w, on| if w > 0.0 || on > 0.0 { 1.0 } else { 0.0 },
        );
        let k = end * self.range * self.inverse;
        // The root is on the right of the lowest point. A contact that does not slide has nothing to search.
        let right = w.zip(slides, |w, slides| if slides > 0.0 { w } else { 0.0 });
        let high = (right + k).larger(self.lowest);
        let over = roots::rising(self.lowest, high, high, |l, x| {
            let m = rise(x);
            let value = x - k.0[l] * m - right.0[l];
            [
                if slides.0[l] > 0.0 { value } else { 0.0 },
                1.0 - k.0[l] * (1.0 - m),
            ]
        });
        let sliding = self.limit - self.range * over.map(rise);
        let viscous = (free.map(f64::abs) * self.by_rate).smaller(self.limit);
        let mut force = viscous;
        for l in 0..L {
            force.0[l] = if slides.0[l] > 0.0 {
                sliding.0[l]
            } else {
                viscous.0[l]
            };
        }
        force.zip(free, f64::copysign)
    }
}
