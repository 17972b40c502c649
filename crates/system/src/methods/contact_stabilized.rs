//! The contact-stabilised Newmark method: the mean of both ends for the structure, the contact force at the end, and displacements of
//! rigid contacts that are corrected before the step.
//!
//! M (v' - v) + dt K (u + u')/2 + dt B S' = 0, u' = u + dt (v + v')/2 + s
//! (Kane, Repetto, Ortiz and Marsden 1999; with s Deuflhard, Krause and Ertel 2008). Without contact it is constant average acceleration.
//! s = -dt^2 M^-1 B Lambda is the smallest change, in the norm of M, with which u + dt v + s does not overlap at rigid contacts. It moves
//! displacements only: without it, a rigid contact of Newmark's method gets its whole correction by forces, which swing.
//!
//! # The recursion of lanes
//!
//! It is the form of a sub-step for speed and small round-off. For a mode x'' + omega2 x = -phi2 S, with V = dt v, W2 = (omega dt)^2,
//! D = 1 + W2/4, q = x + V/2 and p = q + s/2, the method is exactly
//!
//! ```text
//! n = (W2 p + phi2 dt^2 S')/D,   V' = V - n,   q' = q + V' + s
//! ```
//!
//! With a contact the order is 1, since its force acts at the end of the step. A rigid contact loses some energy in an impact; its
//! forces are quiet. The contact does the work dt S' (rdot + rdot')/2 in a step.

use super::amplification::{Amplification, of_two};
use super::lanes::{ContactState, ModeCount, ModeStart, Recursion, Start, Storage, sums};
use super::{Description, Method, MoreauJean, Scheme, SubStep};
use crate::contact::{ContactResponse, Flexibility, StepFlexibility, Trial};
use crate::lane::Lane;

/// Names and parameters.
pub(super) const DESCRIPTION: Description = Description {
    name: "contact-stabilized-newmark",
    meaning: "constant average acceleration with the contact force at the end of the step; rigid contacts correct displacements first (Deuflhard, Krause and Ertel 2008)",
    parameters: &[],
    method: |_| Some(Method::ContactStabilized(ContactStabilized)),
};

/// Without contact forces its equations are those of the theta method at 1/2.
const MEAN: MoreauJean = MoreauJean { theta: 0.5 };

/// The contact-stabilised Newmark method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactStabilized;

impl From<ContactStabilized> for Method {
    fn from(method: ContactStabilized) -> Method {
        Method::ContactStabilized(method)
    }
}

impl Scheme for ContactStabilized {
    const FORCE_AT_END: bool = true;
    const CORRECTS: bool = true;
    type Lanes<const L: usize, N: ModeCount> = Lanes<L, N::Of<ModeState<L>>>;

    /// a' = (v' - v)/dt, without s.
    fn sub_steps(&self, dt: f64) -> Vec<SubStep> {
        MEAN.sub_steps(dt)
    }

    /// With a contact it is 1: the force acts at the end of the step.
    fn order(&self) -> u32 {
        2
    }

    fn amplification(&self, omega_dt: f64) -> Amplification {
        of_two(&MEAN.change(omega_dt), omega_dt)
    }
}

/// Modes of L structures with one contact each; `M` stores the modes.
#[derive(Debug, Clone)]
pub struct Lanes<const L: usize, M = Vec<ModeState<L>>> {
    modes: M,
    dt: Lane<L>,
    /// 1/dt
    rate: Lane<L>,
    /// Sum of the modes' phi2 dt^2/D.
    compliance: Lane<L>,
    /// 1 over the sum of the modes' phi2 dt^2.
    inertia: Lane<L>,
    /// Sum of the modes' V.
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
    /// phi2 dt^2
    mobility: Lane<L>,
    /// V
    v: Lane<L>,
    /// q; p within a step.
    q: Lane<L>,
}

impl<const L: usize> ModeState<L> {
    #[inline(always)]
    fn new(dt: Lane<L>, start: &ModeStart<L>) -> Self {
        let omega2 = Lane(start.mode.map(|m| m.omega2)) * dt * dt;
        let mobility = Lane(start.mode.map(|m| m.phi2)) * dt * dt;
        let shrink = omega2.map(|w2| 1.0 / (1.0 + 0.25 * w2));
        let v = dt * start.velocity;
        ModeState {
            stiffness: omega2 * shrink,
            compliance: mobility * shrink,
            mobility,
            v,
            q: start.displacement + v * 0.5,
        }
    }

    /// Moves the mode by half of a correction; adds W2 p/D to its sum.
    #[inline(always)]
    fn correct(&mut self, half: &Lane<L>, predictor: &mut Lane<L>) {
        for l in 0..L {
            let p = self.q.0[l] + self.mobility.0[l] * half.0[l];
            self.q.0[l] = p;
            predictor.0[l] += self.stiffness.0[l] * p;
        }
    }

    /// One step under a force, and the other half of the correction; adds V to its sum.
    // One loop over the lanes keeps the numbers between in registers.
    #[inline(always)]
    fn step(&mut self, force: &Lane<L>, half: &Lane<L>, increment: &mut Lane<L>) {
        for l in 0..L {
            let n = self.stiffness.0[l] * self.q.0[l] + self.compliance.0[l] * force.0[l];
            let v = self.v.0[l] - n;
            let q = self.q.0[l] + v + self.mobility.0[l] * half.0[l];
            self.v.0[l] = v;
            self.q.0[l] = q;
            increment.0[l] += v;
        }
    }
}

impl<const L: usize, M: Storage<ModeState<L>>> Recursion<L> for Lanes<L, M> {
    type Scheme = ContactStabilized;

    /// The method does not use S(0).
    #[inline(always)]
    fn new(start: &Start<L>, modes: impl Iterator<Item = ModeStart<L>>) -> Option<Self> {
        for method in &start.method {
            let Method::ContactStabilized(_) = method else {
                return None;
            };
        }
        let dt = start.dt;
        let mut modes = M::collect(modes.map(|mode| ModeState::new(dt, &mode)))?;
        let [compliance, mobility] = sums(modes.as_mut(), |mode| [mode.compliance, mode.mobility]);
        let [increment, displacement] =
            sums(modes.as_mut(), |mode| [mode.v, mode.q - mode.v * 0.5]);
        let rate = dt.map(|dt| 1.0 / dt);
        Some(Lanes {
            modes,
            dt,
            rate,
            compliance,
            inertia: mobility.map(|sum| 1.0 / sum),
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
                h: self.compliance * 0.5,
                h_rate: self.compliance * self.rate,
            },
            dt: self.dt,
            by_impulse: false,
        };
        [flexibility; 2]
    }

    #[inline(always)]
    fn step(&mut self, law: &mut impl ContactResponse<L>) -> ContactState<L> {
        let before = self.contact;
        // The correction of r, and half of it over the mobility.
        let correction = law.correction(before.displacement + self.increment);
        let half = correction * self.inertia * 0.5;
        let mut predictor = Lane::splat(0.0);
        for mode in self.modes.as_mut() {
            mode.correct(&half, &mut predictor);
        }
        let trial = Trial {
            displacement: before.displacement,
            velocity: before.velocity,
            force: before.force,
            change: self.increment + correction - predictor * 0.5,
            rate: (self.increment - predictor) * self.rate,
        };
        let end = law.force(0, &trial);
        let n = predictor + self.compliance * end;
        let change = self.increment + correction - n * 0.5;
        self.increment = Lane::splat(0.0);
        for mode in self.modes.as_mut() {
            mode.step(&end, &half, &mut self.increment);
        }
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
        modes.map(|mode| (mode.q - mode.v * 0.5, mode.v * self.rate))
    }
}
