//! The constant average acceleration method for a structure's modes and one contact.
//!
//! Newmark's method with gamma = 1/2, beta = 1/4 [F section 4, I section 3]. For a mode x'' + omega2 x = -phi2 S,
//! with D = 1 + omega2 dt^2/4 and the increments P = x + dt v/2, W = dt v, the method is exactly
//!
//! ```text
//! W(i+1) = W(i) - omega2 dt^2/D P(i) - phi2 dt^2/(2 D) (S(i) + S(i+1))
//! P(i+1) = P(i) + W(i+1),   x(i+1) = P(i) + W(i+1)/2,   v(i+1) = W(i+1)/dt
//! ```
//!
//! Three additions a step, and round-off stays that of the increments however small the step. The sum of the x gives
//! r = r* - h S(i+1), the law gives the root, a second pass brings the force to the modes: O(modes) a step.

use crate::lane::Lane;
use crate::law::{Law, Trial};
use crate::structure::Mode;

/// State of the contact at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact<const L: usize> {
    /// Relative displacement r.
    pub displacement: Lane<L>,
    /// Relative velocity rdot.
    pub velocity: Lane<L>,
    /// Force S.
    pub force: Lane<L>,
}

/// Modes on their way through time.
#[derive(Debug, Clone)]
pub struct Stepper<const L: usize> {
    modes: Vec<Moving<L>>,
    /// Gap at rest: r = gap + sum x.
    gap: Lane<L>,
    rate: Lane<L>,
    h: Lane<L>,
    contact: Contact<L>,
}

/// One mode: its two coefficients and its two increments.
#[derive(Debug, Clone, Copy)]
struct Moving<const L: usize> {
    stiffness: Lane<L>,
    force: Lane<L>,
    p: Lane<L>,
    w: Lane<L>,
}

/// A mode at rest or in motion at T = 0, the same mode of each lane's case.
#[derive(Debug, Clone, Copy)]
pub struct Start<const L: usize> {
    /// Each lane's mode.
    pub mode: [Mode; L],
    /// Scaled coordinate x.
    pub displacement: Lane<L>,
    /// Its velocity.
    pub velocity: Lane<L>,
}

impl<const L: usize> Stepper<L> {
    /// Modes at T = 0 with steps `dt`, the contact's `gap` and the force S(0) there: by equilibrium this is a(0).
    pub fn new(dt: Lane<L>, start: &[Start<L>], gap: Lane<L>, force: Lane<L>) -> Self {
        let rate = dt.map(|dt| 1.0 / dt);
        let zero = Lane::splat(0.0);
        let mut stepper = Stepper {
            modes: Vec::with_capacity(start.len()),
            gap,
            rate,
            h: zero,
            contact: Contact {
                displacement: gap,
                velocity: zero,
                force,
            },
        };
        for Start {
            mode,
            displacement,
            velocity,
        } in start
        {
            let omega2 = Lane(mode.map(|m| m.omega2));
            let phi2 = Lane(mode.map(|m| m.phi2));
            let shrink = (omega2 * dt * dt).map(|o| 1.0 / (1.0 + 0.25 * o));
            let w = dt * *velocity;
            let moving = Moving {
                stiffness: omega2 * dt * dt * shrink,
                force: phi2 * dt * dt * shrink * 0.5,
                p: *displacement + w * 0.5,
                w,
            };
            stepper.h = stepper.h + moving.force * 0.5;
            stepper.contact.displacement = stepper.contact.displacement + *displacement;
            stepper.contact.velocity = stepper.contact.velocity + *velocity;
            stepper.modes.push(moving);
        }
        stepper
    }

    /// The contact as it stands.
    pub fn contact(&self) -> Contact<L> {
        self.contact
    }

    /// One step; `law` gives the force at its end.
    #[inline(always)]
    pub fn step(&mut self, law: &mut impl Law<L>) -> Contact<L> {
        let (mut displacement, mut increment) = (self.gap, Lane::splat(0.0));
        for mode in &mut self.modes {
            mode.w = mode.w - mode.stiffness * mode.p - mode.force * self.contact.force;
            displacement = displacement + (mode.p + mode.w * 0.5);
            increment = increment + mode.w;
        }
        let trial = Trial {
            displacement,
            velocity: increment * self.rate,
            h: self.h,
            h_rate: self.h * self.rate * 2.0,
        };
        let force = law.respond(&trial);
        for mode in &mut self.modes {
            mode.w = mode.w - mode.force * force;
            mode.p = mode.p + mode.w;
        }
        self.contact = Contact {
            displacement: trial.displacement - trial.h * force,
            velocity: trial.velocity - trial.h_rate * force,
            force,
        };
        self.contact
    }

    /// Scaled coordinates and velocities of the modes, lane by lane, for energies and profiles.
    pub fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_ {
        self.modes
            .iter()
            .map(|mode| (mode.p - mode.w * 0.5, mode.w * self.rate))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::Modal;
    use nalgebra::{DVector, dmatrix, dvector};

    /// A force that is given, not found; it keeps the h that the stepper offers.
    struct Given {
        forces: Vec<f64>,
        h: f64,
        h_rate: f64,
    }

    impl Law<1> for Given {
        fn respond(&mut self, trial: &Trial<1>) -> Lane<1> {
            (self.h, self.h_rate) = (trial.h.0[0], trial.h_rate.0[0]);
            Lane([self.forces.remove(0)])
        }
    }

    fn none(steps: usize) -> Given {
        Given {
            forces: vec![0.0; steps],
            h: 0.0,
            h_rate: 0.0,
        }
    }

    #[test]
    fn free_vibration_has_the_methods_exact_period() {
        // Phase 2 atan(W/2) a step, W = omega dt: the period is 2 pi/omega (W/2)/atan(W/2), the amplitude stays.
        for w in [1e-3, 0.1, 1.0, 2.0, 20.0] {
            let omega = 3.0;
            let start = Start {
                mode: [Mode {
                    omega2: omega * omega,
                    phi2: 0.7,
                }],
                displacement: Lane([1.0]),
                velocity: Lane([0.4 * omega]),
            };
            let zero = Lane([0.0]);
            let mut stepper = Stepper::new(Lane([w / omega]), &[start], zero, zero);
            let mut law = none(1000);
            for step in 1..=1000 {
                let contact = stepper.step(&mut law);
                let (sin, cos) = libm::sincos(f64::from(step) * 2.0 * libm::atan(0.5 * w));
                let (x, v) = (cos + 0.4 * sin, omega * (0.4 * cos - sin));
                // Each step rounds p and w once; where W is large, v is a small difference turned by W/2.
                let tolerance = 4.0 * f64::EPSILON * f64::from(step) * (1.0 + w);
                assert!(
                    (contact.displacement.0[0] - x).abs() < tolerance,
                    "W = {w}, step {step}"
                );
                assert!(
                    (contact.velocity.0[0] - v).abs() < tolerance * omega,
                    "W = {w}, step {step}"
                );
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
        let modal = Modal::new(&m, &k, &b).unwrap();
        for dt in [0.01, 0.3, 2.0] {
            let (x, xdot) = (&modal.to_modes * &u, &modal.to_modes * &v);
            let start: Vec<_> = modal
                .modes
                .iter()
                .zip(x.iter().zip(xdot.iter()))
                .map(|(&mode, (&x, &v))| Start {
                    mode: [mode],
                    displacement: Lane([x]),
                    velocity: Lane([v]),
                })
                .collect();
            let mut stepper = Stepper::new(Lane([dt]), &start, Lane([gap]), Lane([force]));
            let mut law = none(0);
            law.forces = (1..=100).map(|i| libm::sin(0.37 * f64::from(i))).collect();
            let forces = law.forces.clone();
            let solve = |f: DVector<f64>| m.clone().lu().solve(&f).unwrap();
            let mut a = solve(-(&k * &u + &b * force));
            let effective = (&m * (4.0 / (dt * dt)) + &k).lu();
            for s in forces {
                let inertia = &m * (&u * (4.0 / (dt * dt)) + &v * (4.0 / dt) + &a);
                let next = effective.solve(&(inertia - &b * s)).unwrap();
                let change = (&next - &u) * (2.0 / dt);
                v = &change - &v;
                u = next;
                a = solve(-(&k * &u + &b * s));
                let contact = stepper.step(&mut law);
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
            }
            let h = b.dot(&effective.solve(&b).unwrap());
            assert!((law.h / h - 1.0).abs() < 1e-13, "dt = {dt}");
            assert!(
                (law.h_rate / (2.0 * h / dt) - 1.0).abs() < 1e-13,
                "dt = {dt}"
            );
            // Modes give their part of r back.
            let sum: f64 = stepper.modes().map(|(x, _)| x.0[0]).sum();
            assert!((sum - b.dot(&u)).abs() < 1e-11);
        }
    }
}
