//! The method of Moreau and Jean: the theta method with impulses.
//!
//! M (v' - v) + dt K (u + theta dt v_theta) + dt B S' = 0, u' = u + dt v_theta, v_theta = theta v' + (1 - theta) v
//! (Moreau 1988, Jean 1999): dt S' is the impulse of the step, and S' its mean force.
//!
//! # The recursion of lanes
//!
//! It is the form of a sub-step for speed and small round-off. For a mode x'' + omega2 x = -phi2 S, with
//! V = dt v, W2 = (omega dt)^2, D = 1 + theta^2 W2 and p = x + theta V, the method is exactly
//!
//! ```text
//! n = (W2 p + phi2 dt^2 S')/D,   V' = V - n,   p' = p + V' - (2 theta - 1) n
//! ```
//!
//! The constraint of a rigid contact acts on velocities alone. Positions are not corrected, so r' can be below zero after an impact, by up
//! to dt times the velocity before it. The contact does the work dt S' ((1 - theta) rdot + theta rdot') in a step.

use super::amplification::{Amplification, of_two};
use super::lanes::{ContactState, ModeCount, ModeStart, Recursion, Start, Storage, sums};
use super::{Description, Method, MethodParameter, Scheme, SubStep};
use crate::contact::{ContactResponse, Flexibility, StepFlexibility, Trial};
use crate::lane::Lane;
use crate::range::Range;
use nalgebra::Matrix2;

/// Names and parameters.
pub(super) const DESCRIPTION: Description = Description {
    name: "moreau-jean",
    meaning: "velocities and impulses with the theta rule; rigid impacts with restitution (Moreau 1988, Jean 1999)",
    parameters: &[MethodParameter {
        name: "theta",
        symbol: "*θ*",
        range: Range::FromHalfToOne,
        default: 0.5,
        tried: &[0.5, 1.0],
        meaning: "theta of the Moreau-Jean method; no numerical damping at 1/2",
    }],
    method: |numbers| match *numbers {
        [theta] => Some(Method::MoreauJean(MoreauJean { theta })),
        _ => None,
    },
};

/// Moreau and Jean's method with impulses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoreauJean {
    /// theta, from 1/2 to 1.
    pub theta: f64,
}

impl MoreauJean {
    /// A - I for (u, dt v) of a free mode.
    pub fn change(&self, omega_dt: f64) -> Matrix2<f64> {
        let theta = self.theta;
        let w2 = omega_dt * omega_dt;
        let k = w2 / (1.0 + theta * theta * w2);
        Matrix2::new(-theta * k, 1.0 - theta * theta * k, -k, -theta * k)
    }
}

impl From<MoreauJean> for Method {
    fn from(method: MoreauJean) -> Method {
        Method::MoreauJean(method)
    }
}

impl Scheme for MoreauJean {
    const HAS_IMPULSES: bool = true;
    const FORCE_AT_END: bool = true;
    type Lanes<const L: usize, N: ModeCount> = Lanes<L, N::Of<ModeState<L>>>;

    /// a' = (v' - v)/dt. Jean (1999), section 5.
    fn sub_steps(&self, dt: f64) -> Vec<SubStep> {
        let theta = self.theta;
        vec![SubStep {
            length: dt,
            inertia: [0.0, 1.0],
            weights: [1.0 - theta, theta],
            forces: [0.0, 1.0],
            d1: dt,
            d2: theta * dt * dt,
            u_v: dt,
            u_a: 0.0,
            u_before: None,
            v_a: 0.0,
            v_d: 0.0,
        }]
    }

    /// With a contact it is 1: the impulse acts at the end of the step.
    fn order(&self) -> u32 {
        if self.theta == 0.5 { 2 } else { 1 }
    }

    fn amplification(&self, omega_dt: f64) -> Amplification {
        of_two(&self.change(omega_dt), omega_dt)
    }
}

/// Modes of L structures with one contact each; `M` stores the modes.
#[derive(Debug, Clone)]
pub struct Lanes<const L: usize, M = Vec<ModeState<L>>> {
    modes: M,
    theta: Lane<L>,
    /// 2 theta - 1
    excess: Lane<L>,
    dt: Lane<L>,
    /// 1/dt
    rate: Lane<L>,
    /// Sum of the modes' phi2 dt^2/D.
    compliance: Lane<L>,
    /// Sums of the modes' W2 p/D and V.
    predictor: Lane<L>,
    increment: Lane<L>,
    contact: ContactState<L>,
}

/// Coefficients and the state of one mode. The alignment puts it at the start of a cache line.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct ModeState<const L: usize> {
    /// W2/D
    stiffness: Lane<L>,
    /// phi2 dt^2/D
    compliance: Lane<L>,
    /// V
    v: Lane<L>,
    p: Lane<L>,
}

impl<const L: usize> ModeState<L> {
    #[inline(always)]
    fn new(theta: Lane<L>, dt: Lane<L>, start: &ModeStart<L>) -> Self {
        let omega2 = Lane(start.mode.map(|m| m.omega2)) * dt * dt;
        let mobility = Lane(start.mode.map(|m| m.phi2)) * dt * dt;
        let shrink = (theta * theta * omega2).map(|d| 1.0 / (1.0 + d));
        let v = dt * start.velocity;
        ModeState {
            stiffness: omega2 * shrink,
            compliance: mobility * shrink,
            v,
            p: start.displacement + theta * v,
        }
    }

    /// One step under a force; adds W2 p/D and V to their sums.
    // One loop over the lanes keeps the numbers between in registers.
    #[inline(always)]
    fn step(&mut self, force: &Lane<L>, excess: &Lane<L>, sums: &mut [Lane<L>; 2]) {
        let [predictors, increments] = sums;
        for l in 0..L {
            let n = self.stiffness.0[l] * self.p.0[l] + self.compliance.0[l] * force.0[l];
            let v = self.v.0[l] - n;
            let p = self.p.0[l] + (v - excess.0[l] * n);
            self.v.0[l] = v;
            self.p.0[l] = p;
            predictors.0[l] += self.stiffness.0[l] * p;
            increments.0[l] += v;
        }
    }
}

impl<const L: usize, M: Storage<ModeState<L>>> Recursion<L> for Lanes<L, M> {
    type Scheme = MoreauJean;

    /// The method does not use S(0).
    // A loop: with more than 16 lanes, maps of arrays are not inlined.
    #[inline(always)]
    fn new(start: &Start<L>, modes: impl Iterator<Item = ModeStart<L>>) -> Option<Self> {
        let mut theta = Lane::splat(0.5);
        for l in 0..L {
            let Method::MoreauJean(moreau_jean) = start.method[l] else {
                return None;
            };
            theta.0[l] = moreau_jean.theta;
        }
        let dt = start.dt;
        let mut modes = M::collect(modes.map(|mode| ModeState::new(theta, dt, &mode)))?;
        let [compliance] = sums(modes.as_mut(), |mode| [mode.compliance]);
        let [predictor, increment, displacement] = sums(modes.as_mut(), |mode| {
            [mode.stiffness * mode.p, mode.v, mode.p - theta * mode.v]
        });
        let rate = dt.map(|dt| 1.0 / dt);
        Some(Lanes {
            modes,
            theta,
            excess: theta * 2.0 - Lane::splat(1.0),
            dt,
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
        let zero = Lane::splat(0.0);
        let flexibility = StepFlexibility {
            start: Flexibility {
                h: zero,
                h_rate: zero,
            },
            end: Flexibility {
                h: self.theta * self.compliance,
                h_rate: self.compliance * self.rate,
            },
            dt: self.dt,
            by_impulse: true,
        };
        [flexibility; 2]
    }

    #[inline(always)]
    fn step(&mut self, law: &mut impl ContactResponse<L>) -> ContactState<L> {
        let before = self.contact;
        let trial = Trial {
            displacement: before.displacement,
            velocity: before.velocity,
            force: before.force,
            change: self.increment - self.theta * self.predictor,
            rate: (self.increment - self.predictor) * self.rate,
        };
        let end = law.force(0, &trial);
        let n = self.predictor + self.compliance * end;
        let change = self.increment - self.theta * n;
        let (excess, mut sums) = (self.excess, [Lane::splat(0.0); 2]);
        for mode in self.modes.as_mut() {
            mode.step(&end, &excess, &mut sums);
        }
        [self.predictor, self.increment] = sums;
        self.contact = ContactState {
            displacement: before.displacement + change,
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
        Some(first.v * self.rate)
    }

    fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_ {
        let modes = self.modes.as_ref().iter();
        modes.map(|mode| (mode.p - self.theta * mode.v, mode.v * self.rate))
    }
}
