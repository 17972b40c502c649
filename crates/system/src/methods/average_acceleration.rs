//! The constant average acceleration method: Newmark's with gamma = 1/2, beta = 1/4 [F section 4, I section 3].
//!
//! # The recursion of lanes
//!
//! It is the form of a sub-step for speed and small round-off. For a mode x'' + omega2 x = -phi2 S,
//! with D = 1 + omega2 dt^2/4, K = omega2 dt^2/D, G = phi2 dt^2/(2 D) and the increments P = x + dt v/2, W = dt v, the
//! method is exactly
//!
//! ```text
//! W(i+1) = W(i) - K P(i) - G (S(i) + S(i+1)),   P(i+1) = P(i) + W(i+1)
//! x(i+1) = P(i+1) - W(i+1)/2,   v(i+1) = W(i+1)/dt
//! ```
//!
//! The increments keep the round-off small however small the step is. W(i+1) without the forces is known one step ahead, for
//! each mode (`predictor`) and in their sum. The sum is the contact's motion without its forces. The law gives the root
//! S(i+1). One pass then moves all modes: three additions for each mode and step.

use super::amplification::{Amplification, of_three};
use super::lanes::{ContactState, ModeCount, ModeStart, Recursion, Start, Storage};
use super::{Coefficients, Description, Method, Scheme, SubStep};
use crate::contact::{ContactResponse, Flexibility, StepFlexibility, Trial};
use crate::lane::Lane;

/// Names and parameters.
pub(super) const DESCRIPTION: Description = Description {
    name: AverageAcceleration::NAME,
    meaning: "constant average acceleration, Newmark's method with beta = 1/4, gamma = 1/2 [F section 4, I section 3]",
    parameters: &[],
    method: |_| Some(Method::AverageAcceleration(AverageAcceleration)),
};

/// Constant average acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AverageAcceleration;

impl AverageAcceleration {
    /// Its name in studies.
    pub const NAME: &'static str = "average-acceleration";
    /// Its coefficients in Newmark's family.
    pub(super) const COEFFICIENTS: Coefficients = Coefficients::newmark(0.25, 0.5);
}

impl From<AverageAcceleration> for Method {
    #[inline(always)]
    fn from(method: AverageAcceleration) -> Method {
        Method::AverageAcceleration(method)
    }
}

impl Scheme for AverageAcceleration {
    const CONSERVES: bool = true;
    type Lanes<const L: usize, N: ModeCount> = Lanes<L, N::Of<ModeState<L>>>;

    fn sub_steps(&self, dt: f64) -> Vec<SubStep> {
        vec![AverageAcceleration::COEFFICIENTS.sub_step(dt)]
    }

    fn order(&self) -> u32 {
        2
    }

    fn amplification(&self, omega_dt: f64) -> Amplification {
        of_three(
            &AverageAcceleration::COEFFICIENTS.change(omega_dt),
            omega_dt,
        )
    }
}

/// Modes of L structures with one contact each; `M` stores the modes, in an array if their number is known.
///
/// Without force a mode vibrates with the exact amplitude and the period 2 pi/omega (W/2)/atan(W/2), W = omega dt. At W = 2 the
/// phase of a step is 2 atan(1) = pi/2, so the mode is at -1 after two steps:
///
/// ```
/// use slipgap_contact::contact::{ImpactSpring, RunningLaw};
/// use slipgap_contact::lane::Lane;
/// use slipgap_system::methods::{AverageAcceleration, ManyModes, ModeStart, Recursion, Scheme, Start};
/// use slipgap_system::system::Mode;
///
/// let start = ModeStart {
///     mode: [Mode::new(4.0, 1.0)],
///     displacement: Lane([1.0]),
///     velocity: Lane([0.0]),
/// };
/// let at = Start {
///     method: [AverageAcceleration.into()],
///     dt: Lane([1.0]),
///     gap: Lane([10.0]),
///     force: Lane([0.0]),
/// };
/// type Lanes = <AverageAcceleration as Scheme>::Lanes<1, ManyModes>;
/// let mut method = Lanes::new(&at, [start].into_iter()).expect("one mode");
/// // The gap keeps the contact open.
/// let mut law = RunningLaw::of(&[ImpactSpring { stiffness: 1.0 }], &method.flexibilities());
/// let r: Vec<f64> = (0..4).map(|_| method.step(&mut law).displacement.0[0] - 10.0).collect();
/// for (r, expected) in r.iter().zip([0.0, -1.0, 0.0, 1.0]) {
///     assert!((r - expected).abs() < 1e-14);
/// }
/// ```
#[derive(Debug, Clone)]
pub struct Lanes<const L: usize, M = Vec<ModeState<L>>> {
    modes: M,
    /// 1/dt
    rate: Lane<L>,
    /// Sum of the modes' G.
    compliance: Lane<L>,
    /// Sum of the modes' predictors.
    predictor: Lane<L>,
    contact: ContactState<L>,
    /// dt rdot
    increment: Lane<L>,
}

/// The coefficients and the state of one mode. The alignment puts it at the start of a cache line.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct ModeState<const L: usize> {
    /// K
    stiffness: Lane<L>,
    /// G
    compliance: Lane<L>,
    /// P
    p: Lane<L>,
    /// W - K P: the next W without the contact forces.
    predictor: Lane<L>,
}

impl<const L: usize> ModeState<L> {
    #[inline(always)]
    fn new(dt: Lane<L>, start: &ModeStart<L>) -> Self {
        let omega2 = Lane(start.mode.map(|m| m.omega2));
        let phi2 = Lane(start.mode.map(|m| m.phi2));
        let shrink = (omega2 * dt * dt).map(|o| 1.0 / (1.0 + 0.25 * o));
        let stiffness = omega2 * dt * dt * shrink;
        let compliance = phi2 * dt * dt * shrink * 0.5;
        let w = dt * start.velocity;
        let p = start.displacement + w * 0.5;
        ModeState {
            stiffness,
            compliance,
            p,
            predictor: w - stiffness * p,
        }
    }

    /// One step under S(i) + S(i+1); returns the predictor.
    #[inline(always)]
    fn step(&mut self, force_sum: Lane<L>) -> Lane<L> {
        let w = self.predictor - self.compliance * force_sum;
        self.p = self.p + w;
        self.predictor = w - self.stiffness * self.p;
        self.predictor
    }

    /// W and x.
    #[inline(always)]
    fn state(&self) -> [Lane<L>; 2] {
        let w = self.predictor + self.stiffness * self.p;
        [w, self.p - w * 0.5]
    }
}

/// Sum from the first term on, so that the sum over one mode is that mode.
#[inline(always)]
fn sum<const L: usize>(modes: &[ModeState<L>], of: impl Fn(&ModeState<L>) -> Lane<L>) -> Lane<L> {
    let Some((first, others)) = modes.split_first() else {
        return Lane::splat(0.0);
    };
    let mut sum = of(first);
    for mode in others {
        sum = sum + of(mode);
    }
    sum
}

impl<const L: usize, M: Storage<ModeState<L>>> Recursion<L> for Lanes<L, M> {
    type Scheme = AverageAcceleration;

    #[inline(always)]
    fn new(start: &Start<L>, modes: impl Iterator<Item = ModeStart<L>>) -> Option<Self> {
        let dt = start.dt;
        let modes = M::collect(modes.map(|start| ModeState::new(dt, &start)))?;
        let every_mode = modes.as_ref();
        let rate = dt.map(|dt| 1.0 / dt);
        let increment = sum(every_mode, |mode| mode.state()[0]);
        Some(Lanes {
            rate,
            compliance: sum(every_mode, |mode| mode.compliance),
            predictor: sum(every_mode, |mode| mode.predictor),
            contact: ContactState {
                displacement: start.gap + sum(every_mode, |mode| mode.state()[1]),
                velocity: increment * rate,
                force: start.force,
            },
            increment,
            modes,
        })
    }

    #[inline(always)]
    fn contact(&self) -> ContactState<L> {
        self.contact
    }

    #[inline(always)]
    fn flexibilities(&self) -> [StepFlexibility<L>; 2] {
        let end = Flexibility {
            h: self.compliance * 0.5,
            h_rate: self.compliance * self.rate,
        };
        let on = StepFlexibility {
            start: end,
            end,
            dt: self.rate.map(|rate| 1.0 / rate),
            by_impulse: false,
        };
        [on; 2]
    }

    #[inline(always)]
    fn step(&mut self, law: &mut impl ContactResponse<L>) -> ContactState<L> {
        let before = self.contact;
        let trial = Trial {
            displacement: before.displacement,
            velocity: before.velocity,
            force: before.force,
            change: (self.increment + self.predictor) * 0.5,
            rate: self.predictor * self.rate,
        };
        let force = law.force(0, &trial);
        let force_sum = before.force + force;
        let increment = self.predictor - self.compliance * force_sum;
        // From the first mode on, not from zero, so that a structure of one mode needs no sum.
        let mut predictor = Lane::splat(0.0);
        if let [first, others @ ..] = self.modes.as_mut() {
            predictor = first.step(force_sum);
            for mode in others {
                predictor = predictor + mode.step(force_sum);
            }
        }
        self.contact = ContactState {
            displacement: before.displacement + (self.increment + increment) * 0.5,
            velocity: increment * self.rate,
            force,
        };
        (self.predictor, self.increment) = (predictor, increment);
        self.contact
    }

    #[inline(always)]
    fn take(&mut self) -> Self {
        Lanes {
            modes: self.modes.take(),
            rate: self.rate,
            compliance: self.compliance,
            predictor: self.predictor,
            contact: self.contact,
            increment: self.increment,
        }
    }

    fn first_velocity(&self) -> Option<Lane<L>> {
        let first = self.modes.as_ref().first()?;
        Some(first.state()[0] * self.rate)
    }

    fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_ {
        let states = self.modes.as_ref().iter().map(ModeState::state);
        states.map(|[w, x]| (x, w * self.rate))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Modal, Mode};
    use nalgebra::{DMatrix, DVector, dmatrix, dvector};

    /// A prescribed force.
    #[derive(Clone, Copy)]
    struct Prescribed(f64);

    impl ContactResponse<1> for Prescribed {
        fn force(&mut self, _: usize, _: &Trial<1>) -> Lane<1> {
            Lane([self.0])
        }
    }

    fn at(dt: f64, gap: f64, force: f64) -> Start<1> {
        Start {
            method: [AverageAcceleration.into()],
            dt: Lane([dt]),
            gap: Lane([gap]),
            force: Lane([force]),
        }
    }

    #[test]
    fn free_vibration_has_the_methods_exact_period() {
        // Phase 2 atan(W/2) a step, W = omega dt: the period is 2 pi/omega (W/2)/atan(W/2), the amplitude stays.
        for w in [1e-3, 0.1, 1.0, 2.0, 20.0] {
            let omega = 3.0;
            let start = ModeStart {
                mode: [Mode::new(omega * omega, 0.7)],
                displacement: Lane([1.0]),
                velocity: Lane([0.4 * omega]),
            };
            let at = at(w / omega, 0.0, 0.0);
            let mut stepper = Lanes::<1>::new(&at, [start].into_iter()).unwrap();
            let energy = |stepper: &Lanes<1>| {
                let (x, v) = stepper.modes().next().unwrap();
                start.mode[0].energy(x.0[0], v.0[0])
            };
            let first = energy(&stepper);
            for step in 1..=1000 {
                let contact = stepper.step(&mut Prescribed(0.0));
                let (sin, cos) = libm::sincos(f64::from(step) * 2.0 * libm::atan(0.5 * w));
                let (x, v) = (cos + 0.4 * sin, omega * (0.4 * cos - sin));
                // Each step rounds p and w once; for large W, v is a small difference times W/2.
                let tolerance = 4.0 * f64::EPSILON * f64::from(step) * (1.0 + w);
                assert!(
                    (contact.displacement.0[0] - x).abs() < tolerance,
                    "W = {w}, step {step}"
                );
                assert!(
                    (contact.velocity.0[0] - v).abs() < tolerance * omega,
                    "W = {w}, step {step}"
                );
                let exact = (v * v + omega * omega * x * x) / (2.0 * 0.7);
                assert!((energy(&stepper) - exact).abs() < 2.0 * tolerance * exact);
                assert!((energy(&stepper) - first).abs() < 2.0 * tolerance * first);
            }
        }
    }

    #[test]
    fn modes_under_a_force_follow_the_textbook_recursion() {
        // M a + K u + b S = 0 at the step's end, u and v by the mean of both accelerations; a(0) from equilibrium.
        let m = dmatrix![2.0, 0.3, 0.0; 0.3, 1.0, -0.2; 0.0, -0.2, 0.5];
        let k = dmatrix![3.0, -1.0, 0.0; -1.0, 2.5, -1.5; 0.0, -1.5, 2.0];
        let b = dvector![-1.0, 0.0, 1.0];
        let (gap, force) = (0.25, 0.6);
        let (mut u, mut v) = (dvector![0.7, -1.3, 2.1], dvector![1.0, 0.0, -0.5]);
        let modal = Modal::new(&m, &k, &DMatrix::from_column_slice(3, 1, b.as_slice())).unwrap();
        let modes = modal.modes(0);
        for dt in [0.01, 0.3, 2.0] {
            let (x, xdot) = (modal.shares(0, &u), modal.shares(0, &v));
            let start = modes
                .iter()
                .zip(x.iter().zip(xdot.iter()))
                .map(|(&mode, (&x, &v))| ModeStart {
                    mode: [mode],
                    displacement: Lane([x]),
                    velocity: Lane([v]),
                });
            let mut stepper = Lanes::<1>::new(&at(dt, gap, force), start).unwrap();
            let solve = |f: DVector<f64>| m.clone().lu().solve(&f).unwrap();
            let mut a = solve(-(&k * &u + &b * force));
            let effective = (&m * (4.0 / (dt * dt)) + &k).lu();
            for s in (1..=100).map(|i| libm::sin(0.37 * f64::from(i))) {
                let inertia = &m * (&u * (4.0 / (dt * dt)) + &v * (4.0 / dt) + &a);
                let next = effective.solve(&(inertia - &b * s)).unwrap();
                let change = (&next - &u) * (2.0 / dt);
                v = &change - &v;
                u = next;
                a = solve(-(&k * &u + &b * s));
                let contact = stepper.step(&mut Prescribed(s));
                let (r, rdot) = (b.dot(&u) + gap, b.dot(&v));
                // The recursion takes v from displacements over dt/2 in each of 100 steps.
                let tolerance = 1e-14 * 100.0 * (1.0 + 1.0 / dt);
                assert!(
                    (contact.displacement.0[0] - r).abs() < tolerance,
                    "dt = {dt}"
                );
                assert!(
                    (contact.velocity.0[0] - rdot).abs() < tolerance,
                    "dt = {dt}"
                );
                assert_eq!(contact.force.0[0], s);
                let energy = 0.5 * (v.dot(&(&m * &v)) + u.dot(&(&k * &u)));
                let modes = modes.iter().zip(stepper.modes());
                let sum: f64 = modes
                    .map(|(mode, (x, v))| mode.energy(x.0[0], v.0[0]))
                    .sum();
                assert!((sum / energy - 1.0).abs() < 10.0 * tolerance);
            }
            let h = b.dot(&effective.solve(&b).unwrap());
            let Flexibility {
                h: h_method,
                h_rate,
            } = stepper.flexibilities()[0].end;
            assert!((h_method.0[0] / h - 1.0).abs() < 1e-13, "dt = {dt}");
            assert!(
                (h_rate.0[0] / (2.0 * h / dt) - 1.0).abs() < 1e-13,
                "dt = {dt}"
            );
            // The coordinates of the modes add up to r.
            let sum: f64 = stepper.modes().map(|(x, _)| x.0[0]).sum();
            assert!((sum - b.dot(&u)).abs() < 1e-11);
        }
    }
}
