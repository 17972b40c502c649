//! The constant average acceleration method for a structure's modes and one contact.
//!
//! Newmark's method with gamma = 1/2, beta = 1/4 [F section 4, I section 3]. For a mode x'' + omega2 x = -phi2 S,
//! with D = 1 + omega2 dt^2/4, K = omega2 dt^2/D, G = phi2 dt^2/(2 D) and the increments P = x + dt v/2, W = dt v, the
//! method is exactly
//!
//! ```text
//! W(i+1) = W(i) - K P(i) - G (S(i) + S(i+1)),   P(i+1) = P(i) + W(i+1)
//! x(i+1) = P(i+1) - W(i+1)/2,   v(i+1) = W(i+1)/dt
//! ```
//!
//! and round-off stays that of the increments however small the step. What W(i+1) would be without the forces is ready
//! a step ahead, in each mode (`free`) and in their sum. The sum gives what the contact would do free of the force; the
//! law gives the root S(i+1); then one pass moves every mode: four additions a mode and step.

use crate::lane::Lane;
use crate::law::{Flexibility, Law, Trial};
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
    /// Energy of the structure, kinetic and elastic, summed over its modes.
    pub energy: Lane<L>,
}

impl<const L: usize> Contact<L> {
    /// Whether the motion of each lane is still one of finite numbers; if not, it never is again.
    pub fn finite(&self) -> [bool; L] {
        let all = [self.displacement, self.velocity, self.force];
        std::array::from_fn(|l| all.iter().all(|x| x.0[l].is_finite()))
    }
}

/// Modes on their way through time; `M` holds them, an array where their number is known.
#[derive(Debug, Clone)]
pub struct Stepper<const L: usize, M = Vec<Moving<L>>> {
    modes: M,
    rate: Lane<L>,
    /// Sum of the modes' G.
    give: Lane<L>,
    /// Sum of the modes' `free`.
    free: Lane<L>,
    contact: Contact<L>,
    /// dt rdot.
    increment: Lane<L>,
}

/// The lanes that end at a step.
#[derive(Debug, Clone, Copy)]
pub struct Ending<const L: usize>([bool; L]);

impl<const L: usize> Ending<L> {
    #[inline(always)]
    fn new(last: &[u64; L], step: u64) -> Self {
        let mut ending = [false; L];
        for (ending, last) in ending.iter_mut().zip(last) {
            *ending = *last == step;
        }
        Ending(ending)
    }

    /// `now` in the lanes that end, `before` in the others.
    #[inline(always)]
    pub fn pick(&self, now: Lane<L>, mut before: Lane<L>) -> Lane<L> {
        for ((before, now), ending) in before.0.iter_mut().zip(now.0).zip(self.0) {
            *before = if ending { now } else { *before };
        }
        before
    }
}

/// One mode on its way: its coefficients and its state, where a cache line begins.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct Moving<const L: usize> {
    /// K
    stiffness: Lane<L>,
    /// G
    give: Lane<L>,
    /// P
    p: Lane<L>,
    /// W - K P, the next W but for the forces.
    free: Lane<L>,
    /// Energy for a unit of W^2, 1/(4 G).
    weight: Lane<L>,
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
        let modes = start.iter().map(|start| Moving::new(dt, start)).collect();
        Stepper::holding(modes, dt, gap, force)
    }
}

impl<const L: usize> Stepper<L, [Moving<L>; 1]> {
    /// The same for a structure of one mode, which needs no list of them.
    #[inline(always)]
    pub fn single(dt: Lane<L>, start: &Start<L>, gap: Lane<L>, force: Lane<L>) -> Self {
        Stepper::holding([Moving::new(dt, start)], dt, gap, force)
    }
}

impl<const L: usize> Moving<L> {
    #[inline(always)]
    fn new(dt: Lane<L>, start: &Start<L>) -> Self {
        let omega2 = Lane(start.mode.map(|m| m.omega2));
        let phi2 = Lane(start.mode.map(|m| m.phi2));
        let shrink = (omega2 * dt * dt).map(|o| 1.0 / (1.0 + 0.25 * o));
        let stiffness = omega2 * dt * dt * shrink;
        let give = phi2 * dt * dt * shrink * 0.5;
        let w = dt * start.velocity;
        let p = start.displacement + w * 0.5;
        Moving {
            stiffness,
            give,
            p,
            free: w - stiffness * p,
            weight: give.map(|g| 0.25 / g),
        }
    }

    /// One step under S(i) + S(i+1); gives `free` and the energy.
    #[inline(always)]
    fn step(&mut self, both: Lane<L>) -> (Lane<L>, Lane<L>) {
        let w = self.free - self.give * both;
        self.p = self.p + w;
        let pull = self.stiffness * self.p;
        self.free = w - pull;
        (self.free, self.energy(w, pull))
    }

    /// W, x and the energy, (v^2 + omega2 x^2)/(2 phi2) in increments.
    #[inline(always)]
    fn now(&self) -> (Lane<L>, Lane<L>, Lane<L>) {
        let pull = self.stiffness * self.p;
        let w = self.free + pull;
        (w, self.p - w * 0.5, self.energy(w, pull))
    }

    #[inline(always)]
    fn energy(&self, w: Lane<L>, pull: Lane<L>) -> Lane<L> {
        self.weight * (w * self.free + pull * self.p)
    }
}

/// Sum from the first term on, so that the sum over one mode is that mode.
#[inline(always)]
fn sum<const L: usize>(modes: &[Moving<L>], of: impl Fn(&Moving<L>) -> Lane<L>) -> Lane<L> {
    let Some((first, others)) = modes.split_first() else {
        return Lane::splat(0.0);
    };
    let mut sum = of(first);
    for mode in others {
        sum = sum + of(mode);
    }
    sum
}

impl<const L: usize, M: AsRef<[Moving<L>]> + AsMut<[Moving<L>]>> Stepper<L, M> {
    #[inline(always)]
    fn holding(modes: M, dt: Lane<L>, gap: Lane<L>, force: Lane<L>) -> Self {
        let all = modes.as_ref();
        let rate = dt.map(|dt| 1.0 / dt);
        let increment = sum(all, |mode| mode.now().0);
        Stepper {
            rate,
            give: sum(all, |mode| mode.give),
            free: sum(all, |mode| mode.free),
            contact: Contact {
                displacement: gap + sum(all, |mode| mode.now().1),
                velocity: increment * rate,
                force,
                energy: sum(all, |mode| mode.now().2),
            },
            increment,
            modes,
        }
    }

    /// The contact as it stands.
    #[inline(always)]
    pub fn contact(&self) -> Contact<L> {
        self.contact
    }

    /// What a unit of the contact's force does to it in a step.
    #[inline(always)]
    pub fn flexibility(&self) -> Flexibility<L> {
        Flexibility {
            h: self.give * 0.5,
            h_rate: self.give * self.rate,
        }
    }

    /// One step; `law` gives the force at its end.
    #[inline(always)]
    pub fn step(&mut self, law: &impl Law<L>) -> Contact<L> {
        let before = self.contact;
        let force = law.respond(&Trial {
            displacement: before.displacement,
            force: before.force,
            change: (self.increment + self.free) * 0.5,
            rate: self.free * self.rate,
        });
        let both = before.force + force;
        let increment = self.free - self.give * both;
        // From the first mode on, not from zero: a structure of one mode has no sums then.
        let (mut free, mut energy) = (Lane::splat(0.0), Lane::splat(0.0));
        if let [first, others @ ..] = self.modes.as_mut() {
            (free, energy) = first.step(both);
            for mode in others {
                let (own, kept) = mode.step(both);
                (free, energy) = (free + own, energy + kept);
            }
        }
        self.contact = Contact {
            displacement: before.displacement + (self.increment + increment) * 0.5,
            velocity: increment * self.rate,
            force,
            energy,
        };
        (self.free, self.increment) = (free, increment);
        self.contact
    }

    /// Steps 0..=`last` of each lane: `walk` moves by a number of steps, `end` is told the first mode's velocity whenever
    /// lanes end, and which. Gives each lane's contact at its own last step.
    ///
    /// A lane that has ended moves on beside the others and touches none of them.
    pub fn run(
        &mut self,
        last: &[u64; L],
        mut walk: impl FnMut(&mut Self, usize),
        mut end: impl FnMut(Lane<L>, &Ending<L>),
    ) -> Contact<L> {
        let mut ends = self.contact;
        let (mut at, mut from) = (0, 0);
        while let Some(next) = last.iter().copied().filter(|n| *n >= from).min() {
            walk(self, (next - at) as usize);
            let now = Ending::new(last, next);
            ends = Contact {
                displacement: now.pick(self.contact.displacement, ends.displacement),
                velocity: now.pick(self.contact.velocity, ends.velocity),
                force: now.pick(self.contact.force, ends.force),
                energy: now.pick(self.contact.energy, ends.energy),
            };
            if let Some(first) = self.modes.as_ref().first() {
                end(first.now().0 * self.rate, &now);
            }
            (at, from) = (next, next + 1);
        }
        ends
    }

    /// Scaled coordinates and velocities of the modes, lane by lane, for profiles.
    pub fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_ {
        let now = self.modes.as_ref().iter().map(Moving::now);
        now.map(|(w, x, _)| (x, w * self.rate))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::Modal;
    use nalgebra::{DVector, dmatrix, dvector};

    /// A force that is given, not found.
    struct Given(f64);

    impl Law<1> for Given {
        fn respond(&self, _: &Trial<1>) -> Lane<1> {
            Lane([self.0])
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
            let first = stepper.contact().energy.0[0];
            for step in 1..=1000 {
                let contact = stepper.step(&Given(0.0));
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
                let energy = (v * v + omega * omega * x * x) / (2.0 * 0.7);
                assert!((contact.energy.0[0] - energy).abs() < 2.0 * tolerance * energy);
                assert!((contact.energy.0[0] - first).abs() < 2.0 * tolerance * first);
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
                let contact = stepper.step(&Given(s));
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
                assert!((contact.energy.0[0] / energy - 1.0).abs() < 10.0 * tolerance);
            }
            let h = b.dot(&effective.solve(&b).unwrap());
            let Flexibility { h: given, h_rate } = stepper.flexibility();
            assert!((given.0[0] / h - 1.0).abs() < 1e-13, "dt = {dt}");
            assert!(
                (h_rate.0[0] / (2.0 * h / dt) - 1.0).abs() < 1e-13,
                "dt = {dt}"
            );
            // Modes give their part of r back.
            let sum: f64 = stepper.modes().map(|(x, _)| x.0[0]).sum();
            assert!((sum - b.dot(&u)).abs() < 1e-11);
        }
    }
}
