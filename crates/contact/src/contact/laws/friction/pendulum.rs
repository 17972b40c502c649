//! The friction pendulum.

use super::DisplacementControl;
use crate::contact::laws::yielding::band::Band;
use crate::contact::prelude::*;
use crate::contact::saturation::rise;

/// Friction pendulum on a concave surface of radius R (Zayas, Low and Mahin 1990): S = F + (N/R) r, where F is friction with the limit
/// nu N, elastic with k up to it. N is the force that presses; both parts follow it, and an open contact has none of them.
///
/// In a step with r' = y - h S' the law lies between the lines (N/R) r' - nu N and (N/R) r' + nu N, with F + k (r' - r) + (N/R) r' between
/// them. All rise with r', so that the root is cut by the roots of the lines.
///
/// The coefficient may rise with velocity, as that of a bearing [Constantinou, Mokha and Reinhorn 1990]: then friction is
/// nu(rdot)/nu F, with nu = nu_max - (nu_max - nu_min) exp(-a |rdot|) and F elastic up to nu_max N, as in their model with a
/// hysteretic z. A step takes the speed that the last two tell for its end, which is of second order.
///
/// It stores F^2/(2 k) + N r^2/(2 R), of a rising coefficient with nu(rdot)/nu F in place of F, which r and S tell; and dissipates nu N |dr| while it slides: a cycle between -a and a takes
/// 4 nu N (a - nu N/k). OpenSees has it as `singleFPBearing` with constant friction, whose height does not change here, either.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pendulum {
    /// 1/k > 0.
    pub compliance: f64,
    /// nu N, >= 0.
    pub limit: f64,
    /// 1/(nu R) at rest, > 0: N/R for a limit of 1.
    pub restoring: f64,
    /// The limit at rest, and the power of N/N0 with which the limit follows, > 0: 1 where nu does not depend on N.
    pub at_rest: [f64; 2],
    /// nu_min/nu_max, in (0, 1], and a, >= 0, in 1/velocity; 1 and 0 for a constant coefficient.
    pub rising: [f64; 2],
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    limit: Lane<L>,
    /// k and N/R.
    stiffness: [Lane<L>; 2],
    /// 1/(1 + k h) with the flexibility for S(i+1), of both together and of N/R.
    share: [Lane<L>; 2],
    /// Flexibilities for S(i) and S(i+1).
    h: [Lane<L>; 2],
    /// nu_min/nu_max and a, if one of the coefficients rises.
    rising: Option<[Lane<L>; 2]>,
}

/// F of L contacts, their speeds at the start of the last step, and 1 after the first one.
#[derive(Debug, Clone, Copy, Default)]
pub struct Friction<const L: usize>(Lane<L>, Lane<L>, Lane<L>);

/// nu/nu_max at a speed.
pub(in crate::contact) fn coefficient([ratio, rate]: [f64; 2], speed: f64) -> f64 {
    match ratio == 1.0 {
        true => 1.0,
        false => ratio + (1.0 - ratio) * rise(rate * speed),
    }
}

/// The speed at the end of a step, from those at the starts of this one and of the one before.
pub(in crate::contact) fn expected(speed: f64, before: f64) -> f64 {
    (2.0 * speed - before).max(0.0)
}

/// R
const RADIUS: Number = Number::new(
    ["R", "*R*", "length"],
    Range::Positive,
    "radius of {laws}, whose restoring force is (N/R) r; it needs nu and N",
);

impl Pendulum {
    /// N/R.
    pub(crate) fn stiffness(&self) -> f64 {
        let [limit, power] = self.at_rest;
        match power == 1.0 || self.limit <= 0.0 {
            true => self.limit * self.restoring,
            false => limit * libm::pow(self.limit / limit, 1.0 / power) * self.restoring,
        }
    }
}

impl StoredEnergy for Pendulum {
    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        let k = self.stiffness();
        let friction = s - k * r;
        0.5 * (self.compliance * friction * friction + k * r * r)
    }
}

impl Described for Pendulum {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "pendulum";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let radius = given.need("R")?;
        let nu = given
            .given("nu")
            .ok_or(LawFault::Needs(Self::NAME, "nu and N"))?;
        if nu <= 0.0 {
            return Err(LawFault::NotPositive("nu"));
        }
        let power = 1.0 - given.given("pressure_exponent").unwrap_or(0.0);
        if power <= 0.0 {
            return Err(LawFault::Needs(Self::NAME, "pressure_exponent < 1"));
        }
        Ok(Form::of(Pendulum {
            compliance: 1.0 / given.stiffness()?,
            limit: given.limit(),
            restoring: 1.0 / (nu * radius),
            at_rest: [given.limit(), power],
            rising: given.bearing()?,
        }))
    })
        .also(&["frictionpendulum", "fps", "singlefpbearing"])
        .in_structures(
            "friction, elastic up to r^E, on a concave surface: plus (N/R) r (Zayas, Low and Mahin 1990)",
            &[&structure::K, &structure::R_E, &RADIUS, &structure::NU_MIN, &structure::NU_RATE],
        )];
    const IN_PLANE: InPlane<Self> = Some(|law, on| {
        let [compliance, limit] = [law.compliance, law.limit];
        let in_plane = ElasticInPlane {
            spring: law.stiffness(),
            rising: law.rising,
            ..DisplacementControl { compliance, limit }.into()
        };
        AnyPlaneLaw::new(in_plane, on)
    });
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let r = velocity * time;
        let friction = (r / law.compliance).min(law.limit);
        Some(coefficient(law.rising, velocity) * friction + law.stiffness() * r)
    });
}

impl Properties for Pendulum {
    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("N/R =", self.stiffness()), ("k =", 1.0 / self.compliance)]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        1.0 / self.compliance + self.stiffness()
    }

    fn initial_stiffness(&self, _: f64) -> f64 {
        match self.limit > 0.0 {
            true => self.rising[0] / self.compliance + self.stiffness(),
            false => 0.0,
        }
    }

    fn reach(&self) -> f64 {
        let elastic = self.compliance * self.limit;
        match self.limit > 0.0 {
            // Where (N/R) r is as large as friction, if that is not far.
            true => (4.0 * elastic).max((self.limit / self.stiffness()).min(40.0 * elastic)),
            false => 1.0,
        }
    }

    fn evolution(&self) -> Option<&dyn Evolution> {
        Some(self)
    }

    fn straight(&self) -> Option<Straight> {
        let surface = self.stiffness();
        let is_straight = self.limit > 0.0 && self.rising[0] == 1.0;
        is_straight.then_some(Straight::Band {
            band: Band {
                stiffness: [1.0 / self.compliance + surface, surface],
                bounds: [-self.limit, self.limit],
            },
            unbent: true,
            is_stop: false,
        })
    }
}

impl Law for Pendulum {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        Pendulum { limit, ..self }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let elastic = lanes(laws, |law| 1.0 / law.compliance);
        let surface = lanes(laws, Pendulum::stiffness);
        let share = |k: Lane<L>| (Lane::splat(1.0) + k * on.end.h).map(|x| 1.0 / x);
        Step {
            limit: lanes(laws, |law| law.limit),
            stiffness: [elastic, surface],
            share: [share(elastic + surface), share(surface)],
            h: [on.start.h, on.end.h],
            rising: laws
                .iter()
                .any(|law| law.rising[0] != 1.0)
                .then(|| [0, 1].map(|i| lanes(laws, |law| law.rising[i]))),
        }
    }
}

/// z is F.
impl Evolution for Pendulum {
    fn rate(&self, _: f64, rdot: f64) -> f64 {
        rdot / self.compliance
    }

    fn force(&self, z: f64, r: f64, rdot: f64) -> f64 {
        coefficient(self.rising, rdot.abs()) * z + self.stiffness() * r
    }

    fn state(&self, s: f64, r: f64) -> f64 {
        (s - self.stiffness() * r) / self.rising[0]
    }

    fn bound(&self) -> f64 {
        self.limit
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = Friction<L>;

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, friction: &mut Friction<L>) -> Lane<L> {
        let change = trial.change - trial.force * self.h[0];
        let [k, surface] = self.stiffness;
        let free = trial.displacement + change;
        let line = surface * free;
        if let Some(rising) = self.rising {
            let part = self.coefficient(rising, trial, friction);
            let share = (Lane::splat(1.0) + (k * part + surface) * self.h[1]).map(|x| 1.0 / x);
            let sticking = ((friction.0 + k * change) * part + line) * share;
            let limit = self.limit * part;
            let force = sticking
                .smaller((line + limit) * self.share[1])
                .larger((line - limit) * self.share[1]);
            let friction_free = force - surface * (free - self.h[1] * force);
            friction.0 = (friction_free * part.map(|x| 1.0 / x)).cut(self.limit);
            return force;
        }
        let sticking = (friction.0 + k * change + line) * self.share[0];
        let force = sticking
            .smaller((line + self.limit) * self.share[1])
            .larger((line - self.limit) * self.share[1]);
        friction.0 = (force - surface * (free - self.h[1] * force)).cut(self.limit);
        force
    }
}

impl<const L: usize> Step<L> {
    /// nu/nu_max at the end of the step; remembers the speed at its start.
    fn coefficient(
        &self,
        [ratio, rate]: [Lane<L>; 2],
        trial: &Trial<L>,
        friction: &mut Friction<L>,
    ) -> Lane<L> {
        let mut part = Lane::splat(1.0);
        for l in 0..L {
            let speed = trial.velocity.0[l].abs();
            let before = match friction.2.0[l] > 0.0 {
                true => friction.1.0[l],
                false => speed,
            };
            let rising = [ratio.0[l], rate.0[l]];
            part.0[l] = coefficient(rising, expected(speed, before));
            friction.1.0[l] = speed;
        }
        friction.2 = Lane::splat(1.0);
        part
    }
}
