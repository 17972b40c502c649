//! Contact laws: the force S of a contact from its relative displacement r and velocity rdot. A law is one file and one line
//! in the list of `any.rs`.
//!
//! S *resists*: it has the sign of the motion it opposes ([F (1)] and [F (6)] disagree on it; this sign agrees with
//! [F (9), (16), (19)]). Over a step from i to i+1 the structure leaves
//!
//! ```text
//! r(i+1)    = r(i) + change - start.h      S(i) - end.h      S(i+1)
//! rdot(i+1) =          rate - start.h_rate S(i) - end.h_rate S(i+1)
//! ```
//!
//! The method of integration decides how much of S(i) is still to be applied: all of it in the constant average acceleration
//! method (`start` = `end`), nothing in a method whose prediction contains it (`start` = 0). Each law gives the one root of
//! both equations in closed form. Newton's iteration of the papers has the same root if it converges; on clipped laws it can
//! cycle.

mod any;
mod at_rest;
pub mod coupled;
mod curve;
#[cfg(test)]
mod friction_tests;
mod law;
mod laws;
mod offers;
mod pair;
pub mod plane;
mod prelude;
mod roots;
mod saturation;
mod series;

pub use any::{ALL, AnyRunningLaw, ContactLaw, LAWS, OneLaw, WhichLaw};
pub use coupled::{CoupledForces, RigidForces, Unsolved};
pub use law::{
    ClippedLine, ClosedForm, ContactKind, Described, Evolution, Family, GivenLaw, Properties,
    element,
};
pub use laws::friction::{
    Bearing, BoucWen, Dahl, Decay, DisplacementControl, Lugre, Pendulum, Stribeck, Tanh,
    VelocityControl,
};
pub use laws::impact::{
    self, GapYield, Hertz, HertzDamp, HuntCrossley, HyperbolicGap, ImpactSpring, ImpactYield,
    Jankowski, KelvinVoigt, Rigid, Ye,
};
pub use laws::link::{
    Bilinear, Imk, Multilinear, Own, OwnAnswer, OwnFault, OwnLaw, OwnState, OwnStep, Restrainer,
    STATES, Viscous,
};
pub use laws::yielding::{Band, OneSided, Straight};
pub use offers::{GivenNumbers, LawFault, number, numbers, offer};
pub use plane::{AnyPlaneLaw, ElasticInPlane, InPlane, OfVelocity};
pub use series::in_series;

use crate::lane::Lane;

/// A contact at the start of a step, and its motion over the step without contact forces.
#[derive(Debug, Clone, Copy)]
pub struct Trial<const L: usize> {
    /// r(i).
    pub displacement: Lane<L>,
    /// rdot(i).
    pub velocity: Lane<L>,
    /// S(i).
    pub force: Lane<L>,
    /// r(i+1) - r(i) without the contact forces that are still to be applied.
    pub change: Lane<L>,
    /// rdot(i+1) without them.
    pub rate: Lane<L>,
}

/// Reduction of the motion of the contact over a step by a unit of contact force.
#[derive(Debug, Clone, Copy)]
pub struct Flexibility<const L: usize> {
    /// From r(i+1): h = b^T Khat^-1 b for the constant average acceleration method.
    pub h: Lane<L>,
    /// From rdot(i+1): 2 h/dt for that method.
    pub h_rate: Lane<L>,
}

/// Flexibility of a structure for the forces at both ends of a step.
#[derive(Debug, Clone, Copy)]
pub struct StepFlexibility<const L: usize> {
    /// For the part of S(i) that the trial does not contain.
    pub start: Flexibility<L>,
    /// For S(i+1); `h_rate` > 0, and `h` > 0 unless the method is explicit.
    pub end: Flexibility<L>,
    /// Length of the step, or of the sub-step.
    pub dt: Lane<L>,
    /// Whether the force acts as an impulse on the velocities of the step (Moreau-Jean).
    pub by_impulse: bool,
}

/// A contact law with the numbers of one case. For most laws S is the only state variable: a slip is r - S/k^C.
///
/// A step of an elastic contact satisfies r' = r* - h S', S' = k_I r' for r' < 0 [I (7)], so that S' = r*/(1/k_I + h):
///
/// ```
/// use slipgap_contact::contact::{Flexibility, ImpactSpring, Law, StepFlexibility, StepLaw, Trial};
/// use slipgap_contact::lane::Lane;
///
/// let end = Flexibility { h: Lane([0.5]), h_rate: Lane([10.0]) };
/// let on = StepFlexibility { start: end, end, dt: Lane([0.1]), by_impulse: false };
/// let law = ImpactSpring::step(&[ImpactSpring { stiffness: 2.0 }], &on);
/// // r* = 0.25 - 0.75 without the force of this step.
/// let [zero, r] = [Lane([0.0]), Lane([0.25])];
/// let trial = Trial { displacement: r, velocity: zero, force: zero, change: Lane([-0.75]), rate: zero };
/// let Lane([force]) = law.force(&trial, &mut ());
/// assert_eq!(force, -0.5 / (1.0 / 2.0 + 0.5));
/// // The root: r' = r* - h S' and S' = k_I r'.
/// assert_eq!(force, 2.0 * (-0.5 - 0.5 * force));
/// ```
pub trait Law: Described + Properties {
    /// The law over a step, for L cases.
    type Step<const L: usize>: StepLaw<L>;

    /// The law over a step, for cases on structures of this flexibility.
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Self::Step<L>;

    /// The law of friction with another limit, the static one in proportion; another law has none.
    fn at_limit(self, _limit: f64) -> Self {
        self
    }

    /// Points (r, S), or (rdot, S) for a viscous law, of a cycle between -`reach` and `reach`, and which of them carry a
    /// marker in figures. Without a form of its own from rest to `reach`, to -`reach` and back.
    fn cycle(&self, reach: f64) -> Cycle {
        curve::over_displacement(*self, reach)
    }
}

/// The deflection of a closed contact under S.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deflection {
    /// r.
    pub r: f64,
    /// dr/dS.
    pub slope: f64,
}

/// What a contact stores.
pub trait StoredEnergy: Copy {
    /// Energy that the contact stores at r under S; a law that stores nothing dissipates all work.
    fn stored_energy(&self, _r: f64, _s: f64) -> f64 {
        0.0
    }

    /// The deflection of the closed contact under S; `None` for a law whose r does not follow from S alone.
    fn deflection(&self, _s: f64) -> Option<Deflection> {
        None
    }

    /// The part of S that does its work on the stored energy: S itself for a law without damping.
    fn conservative_force(&self, _r: f64, s: f64) -> f64 {
        s
    }
}

/// A curve of a law, and the points of it that carry a marker.
pub type Cycle = (Vec<[f64; 2]>, Vec<usize>);

/// A law whose coefficients for a step are known.
pub trait StepLaw<const L: usize>: Copy {
    /// What the law remembers from step to step besides S, such as the closing speed of an impact; `()` for most laws.
    type Memory: Copy + Default + std::fmt::Debug;

    /// S(i+1), and the memory after the step.
    fn force(&self, trial: &Trial<L>, memory: &mut Self::Memory) -> Lane<L>;

    /// What a contact without compliance adds to this r so that it does not overlap; 0 for the others.
    #[inline(always)]
    fn correction(&self, _displacement: Lane<L>) -> Lane<L> {
        Lane::splat(0.0)
    }
}

/// What answers the trials of a run, step by step: a law with its memory.
pub trait ContactResponse<const L: usize> {
    /// S at the end of the sub-step `part`, 0 or 1; 0 in a method without sub-steps.
    fn force(&mut self, part: usize, trial: &Trial<L>) -> Lane<L>;

    /// See [`StepLaw::correction`].
    #[inline(always)]
    fn correction(&self, _displacement: Lane<L>) -> Lane<L> {
        Lane::splat(0.0)
    }
}

/// A law over the steps of a run: its coefficients for each sub-step, and its memory.
#[derive(Debug, Clone, Copy)]
pub struct RunningLaw<S: StepLaw<L>, const L: usize> {
    /// The law over both sub-steps.
    pub parts: [S; 2],
    /// Its memory after the last step.
    pub memory: S::Memory,
}

impl<S: StepLaw<L>, const L: usize> RunningLaw<S, L> {
    /// The law at the start of a run, for a method without sub-steps.
    pub fn new(step: S) -> Self {
        RunningLaw {
            parts: [step; 2],
            memory: S::Memory::default(),
        }
    }

    /// The laws of L cases at the start of a run with a method of these flexibilities.
    #[inline(always)]
    pub fn of<W: Law<Step<L> = S>>(laws: &[W; L], on: &[StepFlexibility<L>; 2]) -> Self {
        RunningLaw {
            parts: [W::step(laws, &on[0]), W::step(laws, &on[1])],
            memory: S::Memory::default(),
        }
    }
}

impl<S: StepLaw<L>, const L: usize> ContactResponse<L> for RunningLaw<S, L> {
    #[inline(always)]
    fn force(&mut self, part: usize, trial: &Trial<L>) -> Lane<L> {
        self.parts[part].force(trial, &mut self.memory)
    }

    #[inline(always)]
    fn correction(&self, displacement: Lane<L>) -> Lane<L> {
        self.parts[0].correction(displacement)
    }
}

/// Energies that L contacts store at r under S, and the parts of S that do their work on them.
#[inline(always)]
pub fn energies<W: StoredEnergy, const L: usize>(
    laws: &[W; L],
    r: Lane<L>,
    s: Lane<L>,
) -> [Lane<L>; 2] {
    let (mut stored, mut force) = (r, s);
    for (l, law) in laws.iter().enumerate() {
        let [r, s] = [r.0[l], s.0[l]];
        (stored.0[l], force.0[l]) = (law.stored_energy(r, s), law.conservative_force(r, s));
    }
    [stored, force]
}

/// Friction limit `nu |N| <N>`: zero for an open contact, N >= 0 [F (1), (3)].
pub fn friction_limit(nu: f64, normal_force: f64) -> f64 {
    if normal_force < 0.0 {
        nu * normal_force.abs()
    } else {
        0.0
    }
}

/// One number of each law.
#[inline(always)]
fn lanes<W, const L: usize>(laws: &[W; L], number: impl Fn(&W) -> f64) -> Lane<L> {
    let mut lanes = Lane::splat(0.0);
    for (lane, law) in lanes.0.iter_mut().zip(laws) {
        *lane = number(law);
    }
    lanes
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The root of S = law(r* - h S) by bisection: `residual` = S - law(r* - h S) rises with S.
    fn bisection(residual: impl Fn(f64) -> f64, reach: f64) -> f64 {
        let (mut low, mut high) = (-reach, reach);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if residual(middle) > 0.0 {
                high = middle
            } else {
                low = middle
            }
        }
        0.5 * (low + high)
    }

    fn on(h: f64, dt: f64) -> StepFlexibility<1> {
        let end = Flexibility {
            h: Lane([h]),
            h_rate: Lane([2.0 * h / dt]),
        };
        StepFlexibility {
            start: end,
            end,
            dt: Lane([dt]),
            by_impulse: false,
        }
    }

    fn trial(displacement: f64, force: f64, change: f64, rate: f64) -> Trial<1> {
        Trial {
            displacement: Lane([displacement]),
            velocity: Lane([0.0]),
            force: Lane([force]),
            change: Lane([change]),
            rate: Lane([rate]),
        }
    }

    fn answer(law: impl StepLaw<1, Memory = ()>, trial: &Trial<1>) -> f64 {
        law.force(trial, &mut ()).0[0]
    }

    fn displacement_control(
        compliance: f64,
        limit: f64,
        on: &StepFlexibility<1>,
    ) -> <DisplacementControl as Law>::Step<1> {
        DisplacementControl::step(&[DisplacementControl { compliance, limit }], on)
    }

    fn velocity_control(
        compliance: f64,
        limit: f64,
        on: &StepFlexibility<1>,
    ) -> <VelocityControl as Law>::Step<1> {
        VelocityControl::step(&[VelocityControl { compliance, limit }], on)
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn every_law_gives_the_one_root_and_rises(
            r in -3.0..3.0_f64,
            before in -2.0..2.0_f64,
            change in -3.0..3.0_f64,
            rate in -3.0..3.0_f64,
            compliance in 1e-3..5.0_f64,
            h in 1e-3..5.0_f64,
            dt in 0.1..2.0_f64,
            limit in 0.0..2.0_f64,
            more in 0.0..1.0_f64,
        ) {
            let now = trial(r, before, change, rate);
            let further = trial(r, before, change + more, rate + more);
            let on = on(h, dt);
            // The inputs are rounded to eps of some 8, which the steepest law, 1/(compliance + h), turns into this much.
            let near = |a: f64, b: f64| (a - b).abs() < 64.0 * f64::EPSILON * (1.0 + 1.0 / (compliance + h));
            // The motion with the force of this step.
            let displacement = |s: f64| r + change - h * (before + s);
            let velocity = |s: f64| rate - 2.0 * h / dt * (before + s);

            let law = displacement_control(compliance, limit, &on);
            let force = answer(law, &now);
            let slip = r - compliance * before;
            let root = bisection(|s| s - ((displacement(s) - slip) / compliance).clamp(-limit, limit), limit);
            prop_assert!(near(force, root), "displacement-control {force} {root}");
            prop_assert!(answer(law, &further) >= force);

            let law = velocity_control(compliance, limit, &on);
            let force = answer(law, &now);
            let root = bisection(|s| s - (velocity(s) / compliance).clamp(-limit, limit), limit);
            prop_assert!(near(force, root), "velocity-control {force} {root}");
            prop_assert!(answer(law, &further) >= force);

            let law = ImpactSpring::step(&[ImpactSpring { stiffness: 1.0 / compliance }], &on);
            let force = answer(law, &now);
            let root = bisection(|s| s - displacement(s).min(0.0) / compliance, 20.0 / compliance);
            // Here the bisection starts from up to 20000.
            prop_assert!((force - root).abs() < 1e-11, "impact spring {force} {root}");
            prop_assert!(answer(law, &further) >= force);
        }
    }

    #[test]
    fn an_open_contact_has_no_friction_and_no_slip() {
        for (nu, normal, limit) in [
            (0.5, -2.0, 1.0),
            (0.3, -10.0, 3.0),
            (0.5, 0.0, 0.0),
            (0.5, 2.0, 0.0),
        ] {
            assert_eq!(friction_limit(nu, normal), limit);
        }
        let mut law = displacement_control(0.1, 0.0, &on(0.3, 0.1));
        assert_eq!(answer(law, &trial(2.0, 0.7, 0.5, 0.0)), 0.0);
        // The contact closes again with S = 0: the slip starts at the present displacement.
        law.limit = Lane([1.0]);
        let force = answer(law, &trial(2.0, 0.0, 0.2, 0.0));
        assert!((force - 0.2 / (0.1 + 0.3)).abs() < 1e-15);
        let law = velocity_control(0.1, 0.0, &on(0.3, 0.1));
        assert_eq!(answer(law, &trial(2.0, 0.0, 1.0, 0.0)), 0.0);
    }

    /// Energy that the contact dissipates over a step between two states (r, S), the force being the mean of both as in the
    /// constant average acceleration method.
    pub(super) fn dissipated_energy(
        law: &impl StoredEnergy,
        [r, s]: [f64; 2],
        [r_end, s_end]: [f64; 2],
    ) -> f64 {
        let work = 0.5 * (s + s_end) * (r_end - r);
        work - (law.stored_energy(r_end, s_end) - law.stored_energy(r, s))
    }

    #[test]
    fn sticking_stores_and_sliding_dissipates() {
        let law = DisplacementControl {
            compliance: 0.5,
            limit: 1.0,
        };
        // Elastic: S = r/0.5 from 0.1 to 0.4. Sliding at the limit over 0.3: the slip is 0.3.
        assert!(dissipated_energy(&law, [0.1, 0.2], [0.4, 0.8]).abs() < 1e-16);
        assert!((dissipated_energy(&law, [0.7, 1.0], [1.0, 1.0]) - 0.3).abs() < 1e-16);
        let law = VelocityControl {
            compliance: 0.5,
            limit: 1.0,
        };
        assert!((dissipated_energy(&law, [0.0, 0.6], [0.1, 0.8]) - 0.07).abs() < 1e-16);
        let law = ImpactSpring { stiffness: 4.0 };
        assert!(dissipated_energy(&law, [-0.25, -1.0], [-0.5, -2.0]).abs() < 1e-16);
    }
}
