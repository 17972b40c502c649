//! The composite method of Bathe: two sub-steps of h = dt/2, the trapezoidal rule, then the three-point backward difference (Bathe and
//! Baig 2005, Bathe 2007). The contact has a force at the end of both.
//!
//! # The recursion of lanes
//!
//! It is the form of both sub-steps for speed and small round-off. For a mode x'' + omega2 x = -phi2 S, with W2 = (omega dt)^2,
//! w = h v and p = x + w/2 as in the average acceleration method, K = 4 W2/(16 + W2), G = 2 phi2 dt^2/(16 + W2) and
//! E = 9 + W2, the method is exactly
//!
//! ```text
//! n = K p + G (S0 + S1),   w1 = w - n,   t = p + 3/2 w1,   e = (n/2 + W2 t + phi2 dt^2 S2)/E
//! w2 = w1 - n/4 - 3/2 e,   x2 = t - e,   p2 = x2 + w2/2
//! ```
//!
//! with x1 = x + w - n/2. Only increments are added: the round-off stays small however small the step is. Each sub-step is one pass.

use super::amplification::{Amplification, of_two};
use super::bathe_mode::ModeState;
use super::lanes::{ContactState, ModeCount, ModeStart, Recursion, Start, Storage, sums};
use super::{AverageAcceleration, Description, Method, Scheme, SubStep};
use crate::contact::{ContactResponse, Flexibility, StepFlexibility, Trial};
use crate::lane::Lane;
use nalgebra::Matrix2;

/// Names and parameters.
pub(super) const DESCRIPTION: Description = Description {
    name: "bathe",
    meaning: "two sub-steps: trapezoidal rule, then three-point backward difference (Bathe and Baig 2005)",
    parameters: &[],
    method: |_| Some(Method::Bathe(Bathe)),
};

/// Bathe's method of two sub-steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bathe;

impl Bathe {
    /// A - I for (u, dt v) of a free mode (Bathe and Baig 2005).
    pub fn change(omega_dt: f64) -> Matrix2<f64> {
        let w2 = omega_dt * omega_dt;
        let d = (9.0 + w2) * (16.0 + w2);
        let same = -w2 * (72.0 + w2) / d;
        let other = (144.0 - 5.0 * w2) / d;
        Matrix2::new(same, other, -w2 * other, same)
    }
}

impl From<Bathe> for Method {
    fn from(method: Bathe) -> Method {
        Method::Bathe(method)
    }
}

impl Scheme for Bathe {
    const SUB_STEPS: u64 = 2;
    type Lanes<const L: usize, N: ModeCount> = Lanes<L, N::Of<ModeState<L>>>;

    fn sub_steps(&self, dt: f64) -> Vec<SubStep> {
        let trapezoidal = AverageAcceleration::COEFFICIENTS.sub_step(0.5 * dt);
        // v' = (u0 - 4 u + 3 u')/dt and a' = (v0 - 4 v + 3 v')/dt.
        let backward_difference = SubStep {
            length: 0.5 * dt,
            inertia: [0.0, 1.0],
            weights: [0.0, 1.0],
            forces: [0.0, 1.0],
            d1: dt / 3.0,
            d2: dt * dt / 9.0,
            u_v: dt / 3.0,
            u_a: 0.0,
            u_before: Some([1.0 / 3.0, dt / 9.0]),
            v_a: 0.0,
            v_d: 1.0 / 3.0,
        };
        vec![trapezoidal, backward_difference]
    }

    /// v' = v0 + dt (a0 + a + a')/3.
    fn load_weights(&self) -> Vec<f64> {
        vec![1.0 / 3.0; 3]
    }

    fn order(&self) -> u32 {
        2
    }

    fn amplification(&self, omega_dt: f64) -> Amplification {
        of_two(&Bathe::change(omega_dt), omega_dt)
    }
}

/// Modes of L structures with one contact each; `M` stores the modes.
#[derive(Debug, Clone)]
pub struct Lanes<const L: usize, M = Vec<ModeState<L>>> {
    modes: M,
    /// dt/2
    dt: Lane<L>,
    /// 2/dt
    rate: Lane<L>,
    /// Sums of the modes' G and of phi2 dt^2/E.
    compliance: [Lane<L>; 2],
    /// Sums of the modes' K p and w.
    predictor: Lane<L>,
    increment: Lane<L>,
    contact: ContactState<L>,
}

impl<const L: usize, M: Storage<ModeState<L>>> Lanes<L, M> {
    /// The first sub-step; returns the contact at its end, and the sums of w1 - n/4 and of e without S2.
    #[inline(always)]
    fn trapezoidal(
        &mut self,
        law: &mut impl ContactResponse<L>,
    ) -> (ContactState<L>, [Lane<L>; 2]) {
        let before = self.contact;
        let trial = Trial {
            displacement: before.displacement,
            velocity: before.velocity,
            force: before.force,
            change: self.increment - self.predictor * 0.5,
            rate: (self.increment - self.predictor) * self.rate,
        };
        let end = law.force(0, &trial);
        let force_sum = before.force + end;
        let n = self.predictor + self.compliance[0] * force_sum;
        let w = self.increment - n;
        let mut e = Lane::splat(0.0);
        for mode in self.modes.as_mut() {
            mode.trapezoidal(&force_sum, &mut e);
        }
        let change = self.increment - n * 0.5;
        let middle = ContactState {
            displacement: before.displacement + change,
            velocity: w * self.rate,
            force: end,
        };
        // x2 - x1 = w1 - e
        self.increment = w;
        (middle, [w - n * 0.25, e])
    }
}

impl<const L: usize, M: Storage<ModeState<L>>> Recursion<L> for Lanes<L, M> {
    type Scheme = Bathe;

    #[inline(always)]
    fn new(start: &Start<L>, modes: impl Iterator<Item = ModeStart<L>>) -> Option<Self> {
        let dt = start.dt;
        let mut modes = M::collect(modes.map(|mode| ModeState::new(dt, &mode)))?;
        let compliance = sums(modes.as_mut(), |mode| [mode.compliance, mode.back[2]]);
        let [predictor, increment, displacement] = sums(modes.as_mut(), |mode| {
            [mode.stiffness * mode.p, mode.w, mode.displacement()]
        });
        let rate = dt.map(|dt| 2.0 / dt);
        Some(Lanes {
            modes,
            dt: dt * 0.5,
            rate,
            compliance,
            predictor,
            increment,
            contact: ContactState {
                displacement: start.gap + displacement,
                velocity: increment * rate,
                force: start.force,
            },
        })
    }

    #[inline(always)]
    fn contact(&self) -> ContactState<L> {
        self.contact
    }

    #[inline(always)]
    fn flexibilities(&self) -> [StepFlexibility<L>; 2] {
        let [trapezoidal, backward] = self.compliance;
        let of = |h: Lane<L>, moved: Lane<L>| Flexibility {
            h,
            h_rate: moved * self.rate,
        };
        let zero = Lane::splat(0.0);
        let both = of(trapezoidal * 0.5, trapezoidal);
        let ends = [[both, both], [of(zero, zero), of(backward, backward * 1.5)]];
        ends.map(|[start, end]| StepFlexibility {
            start,
            end,
            dt: self.dt,
            by_impulse: false,
        })
    }

    #[inline(always)]
    fn step(&mut self, law: &mut impl ContactResponse<L>) -> ContactState<L> {
        let (middle, [w, e]) = self.trapezoidal(law);
        let trial = Trial {
            displacement: middle.displacement,
            velocity: middle.velocity,
            force: middle.force,
            change: self.increment - e,
            rate: (w - e * 1.5) * self.rate,
        };
        let end = law.force(1, &trial);
        let change = self.increment - (e + self.compliance[1] * end);
        let mut sums = [Lane::splat(0.0); 2];
        for mode in self.modes.as_mut() {
            mode.backward(&end, &mut sums);
        }
        [self.predictor, self.increment] = sums;
        self.contact = ContactState {
            displacement: middle.displacement + change,
            velocity: self.increment * self.rate,
            force: end,
        };
        self.contact
    }

    #[inline(always)]
    fn take(&mut self) -> Self {
        Lanes {
            modes: self.modes.take(),
            ..*self
        }
    }

    fn first_velocity(&self) -> Option<Lane<L>> {
        let first = self.modes.as_ref().first()?;
        Some(first.w * self.rate)
    }

    fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_ {
        let modes = self.modes.as_ref().iter();
        modes.map(|mode| (mode.displacement(), mode.w * self.rate))
    }
}
