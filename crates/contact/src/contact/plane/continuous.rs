//! The laws in a plane in continuous time.

use super::{Form, PlaneLaw, PlaneMemory, PlaneTrial};
use crate::contact::laws::friction::pendulum::coefficient;
use crate::contact::pair::{Pair, cut, dot, length, map};

impl PlaneLaw {
    /// Whether the law has a state z: friction without the spring beside it, or the force of bristles.
    pub fn has_state(&self) -> bool {
        !matches!(self.form, Form::OfVelocity { .. })
    }

    /// Whether z follows the motion up to its limit, without a bend.
    pub fn is_cut(&self) -> bool {
        matches!(self.form, Form::Elastic(_))
    }

    /// The largest |z|.
    pub fn bound(&self) -> f64 {
        match &self.form {
            Form::OfVelocity { .. } => f64::INFINITY,
            Form::Elastic(elastic) => elastic.own.law.limit,
            Form::BoucWen(law) => law.limit,
            Form::Lugre(law) => law.static_limit,
        }
    }

    /// z of a contact at r, at rest under `at_rest` before; of one that nothing has bent without it.
    pub fn state(&self, at_rest: Option<Pair>, r: Pair) -> Pair {
        match at_rest {
            Some(force) => {
                let part = match &self.form {
                    Form::Elastic(elastic) => elastic.own.rising[0],
                    Form::OfVelocity { .. } | Form::BoucWen(_) | Form::Lugre(_) => 1.0,
                };
                map(force, r, |s, r| (s - self.spring * r) / part)
            }
            None => self.unbent(r),
        }
    }

    /// dz/dt below the limit.
    pub fn rate(&self, z: Pair, rdot: Pair) -> Pair {
        match &self.form {
            Form::OfVelocity { .. } => [0.0; 2],
            Form::Elastic(elastic) => rdot.map(|v| v / elastic.own.law.compliance),
            Form::BoucWen(law) if law.limit <= 0.0 => [0.0; 2],
            Form::BoucWen(law) => {
                let along = dot(z, rdot).max(0.0);
                let size = length(z);
                let turn = match size > 0.0 {
                    true => libm::pow(size / law.limit, law.exponent) * along / (size * size),
                    false => 0.0,
                };
                map(rdot, z, |v, z| (v - turn * z) / law.compliance)
            }
            Form::Lugre(law) => {
                let speed = length(rdot);
                let g = law.strength_at(speed);
                match g > 0.0 {
                    true => map(rdot, z, |v, z| law.sigma0 * (v - speed * z / g)),
                    false => [0.0; 2],
                }
            }
        }
    }

    /// S of z, r and rdot; of a law without a state it follows from rdot.
    pub fn force(&self, z: Pair, r: Pair, rdot: Pair) -> Pair {
        match &self.form {
            Form::OfVelocity { .. } => {
                let trial = PlaneTrial {
                    velocity: rdot,
                    rate: rdot,
                    ..PlaneTrial::default()
                };
                self.follow(&trial, &PlaneMemory::default())
            }
            Form::Elastic(elastic) => {
                let z = cut(z, elastic.own.law.limit);
                let part = coefficient(elastic.own.rising, length(rdot));
                map(r, z, |r, z| self.spring * r + part * z)
            }
            Form::BoucWen(law) => cut(z, law.limit),
            Form::Lugre(law) if law.limit <= 0.0 => [0.0; 2],
            Form::Lugre(law) => {
                let rate = self.rate(z, rdot);
                std::array::from_fn(|i| {
                    z[i] + law.sigma1 / law.sigma0 * rate[i] + law.sigma2 * rdot[i]
                })
            }
        }
    }
}
