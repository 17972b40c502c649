//! The linear spring and dashpot that do not pull.

use super::collision::Linear;
use super::hertz::POINTS;
use super::{Free, RigidImpact, loop_of, resisting};
use crate::contact::ImpactSpring;
use crate::contact::prelude::*;
use libm::{log, sqrt};
use std::f64::consts::PI;

/// F = k delta + c ddelta, or 0 if that is negative (Anagnostopoulos 1988).
///
/// The dashpot acts from the first touch, so F jumps there. Where it would pull, the contact is still overlapped and has no
/// force: the spring then loses to the dashpot what it stores.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KelvinVoigt {
    /// k, force over length.
    pub stiffness: f64,
    /// c, force over velocity.
    pub damping: f64,
}

impl KelvinVoigt {
    /// For a target of the coefficient of restitution in (0, 1] and m = m1 m2/(m1 + m2) of the bodies: c = 2 xi sqrt(k m). The
    /// formula of xi is that of a law that pulls; without pulling more of the speed remains.
    pub fn new(stiffness: f64, restitution: f64, mass: f64) -> Self {
        let loss = 0.0 - log(restitution);
        let ratio = loss / sqrt(PI * PI + loss * loss);
        KelvinVoigt {
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
    start: Flexibility<L>,
    /// F for a unit of delta* and of ddelta*.
    by_overlap: Lane<L>,
    by_closing: Lane<L>,
    /// 1/h for S(i+1).
    rigid: Lane<L>,
}

impl StoredEnergy for KelvinVoigt {
    fn stored_energy(&self, r: f64, _: f64) -> f64 {
        let overlap = (-r).max(0.0);
        0.5 * self.stiffness * overlap * overlap
    }

    fn conservative_force(&self, r: f64, _: f64) -> f64 {
        self.stiffness * r.min(0.0)
    }
}

impl Described for KelvinVoigt {
    const KIND: ContactKind = ContactKind::Impact;
    const NAME: &'static str = "kelvin-voigt";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let (k, restitution) = (given.need("k")?, given.need("restitution")?);
        let law = KelvinVoigt::new(k, restitution, given.need("colliding_mass")?);
        Ok(Form::of(law).with_restitution(restitution))
    })
    .also(&["viscoelastic", "linearviscoelastic"])
    .between_bars(
        "linear spring and dashpot that do not pull (Anagnostopoulos 1988)",
        &[&bars::RESTITUTION],
    )
    .in_structures(
        "impact with the spring k and a dashpot that do not pull (Anagnostopoulos 1988)",
        of_structures![K, RESTITUTION, COLLIDING_MASS],
    )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Collision(|law, mass, speed| {
        RigidImpact::linear(law.stiffness, law.ratio(mass), mass, speed)
    });
}

impl Properties for KelvinVoigt {
    fn family(&self) -> Family {
        Family::Spring(self.stiffness)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k =", self.stiffness), ("c =", self.damping)]
    }

    /// With xi = c/(2 m omega), omega = sqrt(k/m): delta is e^(-xi omega t) sin(omega_d t), omega_d = omega sqrt(1 - xi^2), and
    /// k delta + c ddelta is 0 again at t = 2 acos(xi)/omega_d; for xi > 1 the hyperbolic functions take their place.
    fn touching_time(&self, inverse_mass: f64, _: Option<f64>) -> Option<f64> {
        let omega = (self.stiffness * inverse_mass).sqrt();
        Some(2.0 * damped(self.ratio(1.0 / inverse_mass)) / omega)
    }

    fn undamped(&self) -> Option<ContactLaw> {
        let stiffness = self.stiffness;
        Some(ImpactSpring { stiffness }.into())
    }
}

impl Law for KelvinVoigt {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        let stiffness = lanes(laws, |law| law.stiffness);
        let damping = lanes(laws, |law| law.damping);
        let sum = Lane::splat(1.0) + (on.end.h * stiffness + on.end.h_rate * damping);
        let share = sum.map(|x| 1.0 / x);
        Step {
            start: on.start,
            by_overlap: stiffness * share,
            by_closing: damping * share,
            rigid: on.end.h.map(|h| 1.0 / h),
        }
    }

    /// A collision of two rigid masses, m = 1, up to the overlap `reach`.
    fn cycle(&self, reach: f64) -> Cycle {
        let collision = Linear {
            ratio: self.ratio(1.0),
        };
        // k/m = 1/s^2: the force over k is delta + 2 xi s ddelta.
        let unit = reach / collision.overlap();
        let states = (0..=2 * POINTS).map(|i| {
            let time = collision.duration() * f64::from(i) / f64::from(2 * POINTS);
            let [overlap, speed] = collision.state(time);
            let force = overlap + 2.0 * collision.ratio * speed;
            [unit * overlap, unit * self.stiffness * force.max(0.0)]
        });
        // Without force from there on.
        let parted = collision.state(collision.duration())[0];
        loop_of(states.chain([[unit * parted, 0.0]]), reach)
    }
}

/// acos(xi)/sqrt(1 - xi^2), which is acosh(xi)/sqrt(xi^2 - 1) above 1.
fn damped(xi: f64) -> f64 {
    let distance = 1.0 - xi * xi;
    match distance {
        // The next term is (1 - xi)/3 of it.
        _ if distance.abs() < 1e-9 => 1.0,
        _ if distance > 0.0 => libm::acos(xi) / distance.sqrt(),
        _ => libm::acosh(xi) / (-distance).sqrt(),
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let free = Free::new(trial, &self.start);
        let force = (free.overlap * self.by_overlap + free.closing * self.by_closing)
            .larger(Lane::splat(0.0));
        // The force of the dashpot may be more than closes the gap: then delta' = 0, in the jump of the force.
        let most = free
            .overlap
            .zip(self.rigid, |d, rigid| if d > 0.0 { d * rigid } else { 0.0 });
        resisting(force.smaller(most))
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_factor_of_critical_damping_is_continuous() {
        for xi in [1.0 - 1e-6, 1.0 - 1e-10, 1.0, 1.0 + 1e-10, 1.0 + 1e-6] {
            assert!((super::damped(xi) - 1.0).abs() < 1e-6, "{xi}");
        }
        assert!((super::damped(0.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }
}
