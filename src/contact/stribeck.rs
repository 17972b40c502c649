//! Friction that falls from a static to a kinetic limit with velocity.

use super::saturation::rise;
use super::{Cycle, Law, StepFlexibility, StepLaw, StoredEnergy, Trial, curve, lanes, roots};
use crate::lane::Lane;

/// Velocity-control model [F (16)] with a Stribeck curve: viscous up to the static limit L_s at rdot^E = compliance L_s, beyond it
/// S = L_k + (L_s - L_k) exp(-(|rdot| - rdot^E)/v_S), the exponential form [Tustin 1947; Bo and Pavelescu 1982 with exponent 1].
///
/// S falls there, with the slope -(L_s - L_k)/v_S at most. A step has one root if h_rate (L_s - L_k) < v_S
/// ([`Stribeck::has_one_root`]). Otherwise up to three: one on the viscous branch and two while sliding, of which the slower is
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
    law: [Stribeck; L],
    /// Flexibilities for S(i) and S(i+1).
    h_rate: [Lane<L>; 2],
    /// S(i+1) of the viscous element for a unit of rdot.
    by_rate: Lane<L>,
}

impl Stribeck {
    /// Whether every step with this flexibility has one root.
    pub fn has_one_root(&self, on: &StepFlexibility<1>) -> bool {
        on.end.h_rate.0[0] * (self.static_limit - self.limit) < self.stribeck_velocity
    }

    /// S at `over` = (|rdot| - rdot^E)/v_S >= 0.
    fn sliding(&self, over: f64) -> f64 {
        self.static_limit - (self.static_limit - self.limit) * rise(over)
    }

    /// S for a motion that would have the velocity `free` >= 0 without S; `slides` if it slides already.
    fn force(&self, free: f64, slides: bool, h_rate: f64, by_rate: f64) -> f64 {
        // With x = (|rdot| - rdot^E)/v_S: x - k (1 - exp(-x)) = w, which is convex with its lowest point at ln k.
        let k = h_rate * (self.static_limit - self.limit) / self.stribeck_velocity;
        let reached = self.compliance * self.static_limit + h_rate * self.static_limit;
        let w = (free - reached) / self.stribeck_velocity;
        let lowest = if k > 1.0 { libm::log(k) } else { 0.0 };
        let slides_on = slides && k > 1.0 && w >= lowest - k * rise(lowest);
        if w > 0.0 || slides_on {
            let over = roots::rising(lowest, w + k, w + k, |x| {
                let m = rise(x);
                [x - k * m - w, 1.0 - k * (1.0 - m)]
            });
            self.sliding(over)
        } else {
            let viscous = free * by_rate;
            if viscous < self.static_limit {
                viscous
            } else {
                self.static_limit
            }
        }
    }
}

impl StoredEnergy for Stribeck {
    /// None: all work is dissipated.
    fn stored_energy(&self, _: f64, _: f64) -> f64 {
        0.0
    }
}

impl Law for Stribeck {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            law: *laws,
            h_rate: [on.start.h_rate, on.end.h_rate],
            by_rate: (lanes(laws, |law| law.compliance) + on.end.h_rate).map(|c| 1.0 / c),
        }
    }

    /// From -1.1 `reach` to 1.1 `reach`; a compliance of zero is the rigid law.
    fn cycle(&self, reach: f64) -> Cycle {
        let width = self.compliance * self.static_limit;
        curve::over_velocity(reach, |velocity| {
            let v = velocity.abs();
            let force = if v < width {
                v / self.compliance
            } else {
                self.sliding((v - width) / self.stribeck_velocity)
            };
            force.copysign(velocity)
        })
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, _: &mut ()) -> Lane<L> {
        let [start, end] = self.h_rate;
        let free = trial.rate - trial.force * start;
        let mut force = free;
        for (l, law) in self.law.iter().enumerate() {
            let along = trial.velocity.0[l] * if free.0[l] < 0.0 { -1.0 } else { 1.0 };
            let slides = along > law.compliance * law.static_limit;
            force.0[l] = law
                .force(free.0[l].abs(), slides, end.0[l], self.by_rate.0[l])
                .copysign(free.0[l]);
        }
        force
    }
}
