//! The recursion of lanes of Newmark's family: the form of its sub-step for speed and small round-off.
//!
//! For a mode x'' + omega2 x = -phi2 S, with V = dt v, A = dt^2 a, W2 = omega2 dt^2 and D = 1 - am + (1 - af) beta W2, a step of
//! [`Coefficients`] gives A' from x, V and A. V - gamma A and x - beta A change by A and V alone, so that in
//!
//! ```text
//! Q = V + (1 - gamma) A,   P = x + (3/2 - gamma) Q - (1/2 - gamma + beta) A
//! ```
//!
//! the method is exactly, with k = W2/D, g = phi2 dt^2/D, c = (W2 af (gamma - 1/2 - beta) - am)/D, m = 1/2 + af - gamma and the
//! weighted force Sw = af S + (1 - af) S'
//!
//! ```text
//! A' = c A - k (P - m Q) - g Sw,   Q' = Q + A',   P' = P + Q'
//! ```
//!
//! Only increments are added to Q and P, which keeps the round-off small however small the step is. A' without the forces is
//! known one step ahead, for each mode and in their sum. That sum and the sum of Q give the contact's motion without forces.

use super::Coefficients;
use crate::contact::{ContactResponse, Flexibility, StepFlexibility, Trial};
use crate::lane::Lane;
use crate::methods::Method;
use crate::methods::lanes::{ContactState, ModeStart, Recursion, Start, Storage, sums};

/// Modes of L structures with one contact each; `M` stores the modes.
#[derive(Debug, Clone)]
pub struct Lanes<const L: usize, M = Vec<ModeState<L>>> {
    modes: M,
    weights: Weights<L>,
    dt: Lane<L>,
    /// 1/dt
    rate: Lane<L>,
    /// Sum of the modes' g.
    compliance: Lane<L>,
    /// Sum of the modes' predictors.
    predictor: Lane<L>,
    /// Sum of the modes' Q.
    increment: Lane<L>,
    /// Sum of V + (1/2 - beta) A: the change of r over the next step without the next A.
    drift: Lane<L>,
    contact: ContactState<L>,
}

/// Coefficients and the state of one mode. The alignment puts it at the start of a cache line.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct ModeState<const L: usize> {
    /// g
    compliance: Lane<L>,
    /// c
    inertia: Lane<L>,
    /// k
    stiffness: Lane<L>,
    /// Q
    q: Lane<L>,
    /// P
    p: Lane<L>,
    /// A
    acceleration: Lane<L>,
    /// c A - k (P - m Q): the next A without the contact forces.
    predictor: Lane<L>,
}

/// The coefficients of the method, a case in each lane.
#[derive(Debug, Clone, Copy)]
struct Weights<const L: usize> {
    alpha_m: Lane<L>,
    alpha_f: Lane<L>,
    beta: Lane<L>,
    gamma: Lane<L>,
    /// m
    shift: Lane<L>,
}

impl<const L: usize> Weights<L> {
    /// `None` for a method that has no such coefficients.
    // A loop: with more than 16 lanes, maps of arrays are not inlined.
    #[inline(always)]
    fn new(methods: &[Method; L]) -> Option<Self> {
        let zero = Lane::splat(0.0);
        let mut weights = Weights {
            alpha_m: zero,
            alpha_f: zero,
            beta: zero,
            gamma: zero,
            shift: zero,
        };
        for (l, method) in methods.iter().enumerate() {
            let Method::Family(coefficients) = *method else {
                return None;
            };
            weights.alpha_m.0[l] = coefficients.alpha_m;
            weights.alpha_f.0[l] = coefficients.alpha_f;
            weights.beta.0[l] = coefficients.beta;
            weights.gamma.0[l] = coefficients.gamma;
            weights.shift.0[l] = 0.5 + coefficients.alpha_f - coefficients.gamma;
        }
        Some(weights)
    }

    /// The weights of S(i) and S(i+1).
    #[inline(always)]
    fn force(&self) -> [Lane<L>; 2] {
        [self.alpha_f, Lane::splat(1.0) - self.alpha_f]
    }

    /// 1/2 - beta.
    #[inline(always)]
    fn first(&self) -> Lane<L> {
        Lane::splat(0.5) - self.beta
    }
}

impl<const L: usize> ModeState<L> {
    #[inline(always)]
    fn new(weights: &Weights<L>, dt: Lane<L>, start: &ModeStart<L>, force: Lane<L>) -> Self {
        let Weights {
            alpha_m,
            alpha_f,
            beta,
            gamma,
            shift,
        } = *weights;
        let omega2 = Lane(start.mode.map(|m| m.omega2)) * dt * dt;
        let phi2 = Lane(start.mode.map(|m| m.phi2)) * dt * dt;
        let one = Lane::splat(1.0);
        let shrink = (one - alpha_m + (one - alpha_f) * beta * omega2).map(|d| 1.0 / d);
        let half = Lane::splat(0.5);
        let inertia = (omega2 * alpha_f * (gamma - half - beta) - alpha_m) * shrink;
        let stiffness = omega2 * shrink;
        let acceleration = -(omega2 * start.displacement + phi2 * force);
        let q = dt * start.velocity + (one - gamma) * acceleration;
        let p =
            start.displacement + ((one + half - gamma) * q - (half - gamma + beta) * acceleration);
        ModeState {
            compliance: phi2 * shrink,
            inertia,
            stiffness,
            q,
            p,
            acceleration,
            predictor: inertia * acceleration - stiffness * (p - shift * q),
        }
    }

    /// One step under a `push`, the weighted force with the other sign; adds the predictor and Q to their sums.
    // One loop over the lanes keeps the numbers between in registers, and a sum with the other sign needs one load less.
    #[inline(always)]
    fn step(&mut self, push: &Lane<L>, shift: &Lane<L>, sums: &mut [Lane<L>; 2]) {
        let [predictors, increments] = sums;
        for l in 0..L {
            let a = self.predictor.0[l] + self.compliance.0[l] * push.0[l];
            let q = self.q.0[l] + a;
            let p = self.p.0[l] + q;
            let next = self.inertia.0[l] * a - self.stiffness.0[l] * (p - shift.0[l] * q);
            self.acceleration.0[l] = a;
            self.q.0[l] = q;
            self.p.0[l] = p;
            self.predictor.0[l] = next;
            predictors.0[l] += next;
            increments.0[l] += q;
        }
    }

    /// x and V.
    #[inline(always)]
    fn state(&self, weights: &Weights<L>) -> [Lane<L>; 2] {
        let Weights { beta, gamma, .. } = *weights;
        let (q, a) = (self.q, self.acceleration);
        let half = Lane::splat(0.5);
        let x = self.p - ((Lane::splat(1.5) - gamma) * q - (half - gamma + beta) * a);
        [x, q - (Lane::splat(1.0) - gamma) * a]
    }
}

impl<const L: usize, M: Storage<ModeState<L>>> Recursion<L> for Lanes<L, M> {
    type Scheme = Coefficients;

    #[inline(always)]
    fn new(start: &Start<L>, modes: impl Iterator<Item = ModeStart<L>>) -> Option<Self> {
        let weights = Weights::new(&start.method)?;
        let (dt, force) = (start.dt, start.force);
        let mut modes = M::collect(modes.map(|mode| ModeState::new(&weights, dt, &mode, force)))?;
        let [compliance, predictor, increment] = sums(modes.as_mut(), |mode| {
            [mode.compliance, mode.predictor, mode.q]
        });
        let [displacement, velocity, acceleration] = sums(modes.as_mut(), |mode| {
            let [x, v] = mode.state(&weights);
            [x, v, mode.acceleration]
        });
        let rate = dt.map(|dt| 1.0 / dt);
        Some(Lanes {
            modes,
            weights,
            dt,
            rate,
            compliance,
            predictor,
            increment,
            drift: velocity + weights.first() * acceleration,
            contact: ContactState {
                displacement: start.gap + displacement,
                velocity: velocity * rate,
                force,
            },
        })
    }

    #[inline(always)]
    fn contact(&self) -> ContactState<L> {
        self.contact
    }

    #[inline(always)]
    fn flexibilities(&self) -> [StepFlexibility<L>; 2] {
        let [start, end] = self.weights.force().map(|weight| {
            let moved = self.compliance * weight;
            Flexibility {
                h: self.weights.beta * moved,
                h_rate: self.weights.gamma * moved * self.rate,
            }
        });
        let flexibility = StepFlexibility {
            start,
            end,
            dt: self.dt,
            by_impulse: false,
        };
        [flexibility; 2]
    }

    #[inline(always)]
    fn step(&mut self, law: &mut impl ContactResponse<L>) -> ContactState<L> {
        let (before, weights) = (self.contact, self.weights);
        let trial = Trial {
            displacement: before.displacement,
            velocity: before.velocity,
            force: before.force,
            change: self.drift + weights.beta * self.predictor,
            rate: (self.increment + weights.gamma * self.predictor) * self.rate,
        };
        let end = law.force(0, &trial);
        let [first, last] = weights.force();
        let weighted = first * before.force + last * end;
        let acceleration = self.predictor - self.compliance * weighted;
        let velocity = self.increment + weights.gamma * acceleration;
        let change = self.drift + weights.beta * acceleration;
        let (push, mut sums) = (-weighted, [Lane::splat(0.0); 2]);
        for mode in self.modes.as_mut() {
            mode.step(&push, &weights.shift, &mut sums);
        }
        [self.predictor, self.increment] = sums;
        self.drift = velocity + weights.first() * acceleration;
        self.contact = ContactState {
            displacement: before.displacement + change,
            velocity: velocity * self.rate,
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
        Some(first.state(&self.weights)[1] * self.rate)
    }

    fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_ {
        let states = self.modes.as_ref().iter();
        states.map(|mode| {
            let [x, v] = mode.state(&self.weights);
            (x, v * self.rate)
        })
    }
}
