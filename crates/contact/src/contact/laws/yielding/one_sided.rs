//! A yielding spring that acts on one side of its gap.

use crate::contact::prelude::*;

/// Tangent after yielding over k.
pub(in crate::contact) const HARDENING: Number = Number::new(
    ["hardening", "*η*", "1"],
    Range::UpToOne,
    "stiffness of {laws} after yielding over k; default 0",
)
.usually(Usual::Is(0.0));

/// A spring k with a force F >= 0 at a deflection d > 0, which yields at Fy and hardens with eta k:
///
/// ```text
/// F = max(min(k (d - s), Fy (1 - eta) + eta k d), 0)
/// ```
///
/// s is where the force ends on unloading, d - F/k while there is a force: the gap that yielding leaves. Without a force it stays, or
/// the free end comes back with d, as far as to 0. The spring stores F^2/(2 k) and dissipates F ds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneSided {
    /// k > 0.
    pub stiffness: f64,
    /// Fy > 0.
    pub yield_force: f64,
    /// eta, from 0 to 1.
    pub hardening: f64,
    /// Whether s comes back with d.
    pub returns: bool,
    /// 1 of a spring that pulls, S = F, or -1 of one that pushes, S = -F.
    pub sign: f64,
    /// d at r = 0: d = sign r + shift.
    pub shift: f64,
}

/// The spring over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    /// k and eta k.
    stiffness: [Lane<L>; 2],
    /// Fy (1 - eta).
    start: Lane<L>,
    returns: [bool; L],
    sign: Lane<L>,
    shift: Lane<L>,
    /// Flexibility for S(i).
    h: Lane<L>,
    /// 1/(1 + k h) with the flexibility for F(i+1), for both.
    share: [Lane<L>; 2],
}

/// s of L springs, as it was before the last force.
#[derive(Debug, Clone, Copy, Default)]
pub struct Set<const L: usize>(Lane<L>);

impl OneSided {
    /// The force of a first loading.
    pub(in crate::contact) fn first(&self, d: f64) -> f64 {
        (self.stiffness * d).min(self.line(d)).max(0.0)
    }

    fn line(&self, d: f64) -> f64 {
        self.yield_force * (1.0 - self.hardening) + self.hardening * self.stiffness * d
    }

    /// The largest force.
    pub(in crate::contact) fn most(&self) -> f64 {
        match self.hardening > 0.0 {
            true => f64::INFINITY,
            false => self.yield_force,
        }
    }

    pub(in crate::contact) fn stored_energy(&self, force: f64) -> f64 {
        0.5 * force * force / self.stiffness
    }

    /// The part of F at d that is stored: eta F while it yields.
    pub(in crate::contact) fn conservative(&self, d: f64, force: f64) -> f64 {
        // Round-off of d and F.
        let yields = force >= self.line(d) * (1.0 - 8.0 * f64::EPSILON);
        if yields {
            self.hardening * force
        } else {
            force
        }
    }

    #[inline(always)]
    pub(in crate::contact) fn step<W, const L: usize>(
        laws: &[W; L],
        spring: impl Fn(&W) -> OneSided,
        on: &StepFlexibility<L>,
    ) -> Step<L> {
        let of = |number: fn(OneSided) -> f64| lanes(laws, |law| number(spring(law)));
        let stiffness = [
            of(|law| law.stiffness),
            of(|law| law.hardening * law.stiffness),
        ];
        let mut returns = [false; L];
        for (returns, law) in returns.iter_mut().zip(laws) {
            *returns = spring(law).returns;
        }
        Step {
            stiffness,
            start: of(|law| law.yield_force * (1.0 - law.hardening)),
            returns,
            sign: of(|law| law.sign),
            shift: of(|law| law.shift),
            h: on.start.h,
            share: stiffness.map(|k| (Lane::splat(1.0) + k * on.end.h).map(|x| 1.0 / x)),
        }
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = Set<L>;

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, set: &mut Set<L>) -> Lane<L> {
        let d = self.sign * trial.displacement + self.shift;
        let change = self.sign * (trial.change - trial.force * self.h);
        let force = self.push(d, self.sign * trial.force, change, set);
        // The sum makes no negative zero.
        Lane::splat(0.0) + self.sign * force
    }
}

impl<const L: usize> Step<L> {
    /// F(i+1), from d and F, for the change of d without F(i+1): d' = d + change - h F'.
    ///
    /// Both lines rise with d', so that the root is the smaller one of their roots. s follows from the start of the step alone: it is
    /// the same for every trial of the step.
    #[inline(always)]
    fn push(&self, d: Lane<L>, force: Lane<L>, change: Lane<L>, set: &mut Set<L>) -> Lane<L> {
        for l in 0..L {
            let set_of_lane = &mut set.0.0[l];
            if force.0[l] > 0.0 {
                *set_of_lane = d.0[l] - force.0[l] / self.stiffness[0].0[l];
            } else if self.returns[l] {
                *set_of_lane = set_of_lane.min(d.0[l]).max(0.0);
            }
        }
        let free = d + change;
        let elastic = self.stiffness[0] * (free - set.0) * self.share[0];
        let line = (self.start + self.stiffness[1] * free) * self.share[1];
        elastic.smaller(line).larger(Lane::splat(0.0))
    }
}
