//! Friction that falls from a static to a kinetic limit with velocity.

use super::in_proportion;
use crate::contact::prelude::*;
use crate::contact::saturation::rise;

/// Velocity-control model [F (16)] with a Stribeck curve: viscous up to the static limit L_s at rdot^E = compliance L_s, beyond it
/// S = L_k + (L_s - L_k) exp(-x), x = (|rdot| - rdot^E)/v_S, the exponential form [Tustin 1947; Bo and Pavelescu 1982 with exponent 1],
/// or L_k + (L_s - L_k)/(1 + x), the hyperbolic one.
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
    /// How S falls.
    pub decay: Decay,
}

/// How friction falls from its static to its kinetic limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decay {
    /// exp(-x) is left at x.
    Exponential,
    /// 1/(1 + x) is left.
    Hyperbolic,
}

impl Decay {
    /// The part by which it has fallen at x >= 0, and the slope of this part.
    #[inline(always)]
    fn fallen(self, x: f64) -> [f64; 2] {
        match self {
            Decay::Exponential => {
                let m = rise(x);
                [m, 1.0 - m]
            }
            // Also where x is infinite.
            Decay::Hyperbolic => {
                let left = 1.0 / (1.0 + x);
                [1.0 - left, left * left]
            }
        }
    }

    /// x where the slope is 1/k, for k > 1.
    fn slope_falls_to(self, k: f64) -> f64 {
        match self {
            Decay::Exponential => libm::log(k),
            Decay::Hyperbolic => k.sqrt() - 1.0,
        }
    }
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
    decay: [Decay; L],
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
        self.static_limit - (self.static_limit - self.limit) * self.decay.fallen(over)[0]
    }
}

fn form(given: &GivenNumbers, decay: Decay) -> Result<Form, LawFault> {
    let limit = given.limit();
    let static_limit = given.need("static_ratio")? * limit;
    let stribeck_velocity = given.need("stribeck_velocity")?;
    Ok(Form::of(Stribeck {
        // rdot^E is that of the static limit.
        compliance: given.fluidity(static_limit)?,
        limit,
        static_limit,
        stribeck_velocity,
        decay,
    }))
}

impl StoredEnergy for Stribeck {}

impl Described for Stribeck {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "stribeck";
    const OF_VELOCITY: bool = true;
    const OFFERS: &'static [Offer] = &[
        Offer::new(Self::NAME, |given| form(given, Decay::Exponential))
            .in_oscillator(
                "velocity-control with a static limit, from which the force falls to the kinetic limit as the velocity rises",
                of_oscillator![BETA, STATIC_RATIO, STRIBECK_VELOCITY],
            )
            .in_structures(
                "friction, viscous up to the static limit, which falls to the kinetic one with rdot (Stribeck 1902)",
                of_structures![C, RDOT_E, STATIC_RATIO, STRIBECK_VELOCITY],
            ),
        Offer::new("stribeck-hyperbolic", |given| form(given, Decay::Hyperbolic))
            .in_oscillator(
                "the same, falling as 1/(1 + v/v_S)",
                of_oscillator![BETA, STATIC_RATIO, STRIBECK_VELOCITY],
            )
            .in_structures(
                "the same, falling as 1/(1 + v/v_S)",
                of_structures![C, RDOT_E, STATIC_RATIO, STRIBECK_VELOCITY],
            ),
    ];
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
        let decay = std::array::from_fn(|l| laws[l].decay);
        let (mut lowest, mut fallen) = (Lane::splat(0.0), Lane::splat(0.0));
        for l in 0..L {
            if k.0[l] > 1.0 {
                lowest.0[l] = decay[l].slope_falls_to(k.0[l]);
                fallen.0[l] = decay[l].fallen(lowest.0[l])[0];
            }
        }
        Step {
            limit,
            range,
            inverse,
            h_rate: [on.start.h_rate, on.end.h_rate],
            by_rate: (compliance + on.end.h_rate).map(|c| 1.0 / c),
            width: compliance * limit,
            reached: (compliance + on.end.h_rate) * limit,
            lowest,
            least: lowest - k * fallen,
            decay,
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
        // With m the part by which S has fallen at x: x - k m(x) = w, which is convex.
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
            let [m, slope] = self.decay[l].fallen(x);
            let value = x - k.0[l] * m - right.0[l];
            [
                if slides.0[l] > 0.0 { value } else { 0.0 },
                1.0 - k.0[l] * slope,
            ]
        });
        let mut fallen = over;
        for l in 0..L {
            fallen.0[l] = self.decay[l].fallen(over.0[l])[0];
        }
        let sliding = self.limit - self.range * fallen;
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
