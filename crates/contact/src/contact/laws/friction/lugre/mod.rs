//! The LuGre model of friction.

use super::in_proportion;
use crate::contact::prelude::*;
use crate::contact::saturation::{self, rise};
mod described;

/// LuGre model [Canudas de Wit, Olsson, Astrom and Lischinsky 1995]: bristles with the mean deflection z,
///
/// ```text
/// dz/dt = rdot - sigma0 |rdot| z/g(rdot),   S = sigma0 z + sigma1 dz/dt + sigma2 rdot
/// g = L_k + (L_s - L_k) exp(-(rdot/v_S)^2)
/// ```
///
/// The step: z follows its flow for the mean velocity of the step, which is exact while g is constant, so |sigma0 z| <= L_s for every
/// dt; dz/dt at the end is the slope of the parabola through the last three z; both are of second order. In the first step it is
/// the difference quotient, which makes S(1) alone of first order. A contact that moves at t = 0 has z = 0, dz/dt = rdot and so
/// S(0) = (sigma1 + sigma2) rdot; with S(0) = 0 a method that uses S(0) would leave out half a step of this force, an impulse of
/// dt S(0)/2, and the motion would be of first order. For g constant and sigma1 = sigma2 = 0 it is Dahl's model with n = 1.
///
/// S rises with r(i+1) and rdot(i+1) if L_s = L_k. If g falls, a step has one root where [`crate::contact::Properties::has_one_root`] says so; problems
/// refuse other steps.
///
/// The bristles store sigma0 z^2/2. The model then never gives energy if sigma2 >= sigma1 (L_s/L_k - 1) [Barabanov and Ortega
/// 2000]; the product of S and rdot less the stored power is |rdot| (g x^2 + (sigma1 + sigma2) |rdot| - sigma1 x rdot), x = sigma0
/// z/g, |x| <= L_s/L_k.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lugre {
    /// Stiffness of the bristles, > 0.
    pub sigma0: f64,
    /// Damping of the bristles, >= 0.
    pub sigma1: f64,
    /// Viscous damping, >= 0.
    pub sigma2: f64,
    /// L_k, >= 0.
    pub limit: f64,
    /// L_s >= L_k.
    pub static_limit: f64,
    /// v_S > 0.
    pub stribeck_velocity: f64,
}

/// The bristles after a step.
#[derive(Debug, Clone, Copy)]
pub struct Bristles<const L: usize> {
    /// sigma0 z.
    pub force: Lane<L>,
    /// Change of z in the step over its length, and this length.
    rate: Lane<L>,
    dt: Lane<L>,
    /// Whether there was a step. Before the first one sigma0 z = S(0) at rest; the bristles of a contact that moves are unbent.
    begun: bool,
}

impl<const L: usize> Default for Bristles<L> {
    fn default() -> Self {
        let zero = Lane::splat(0.0);
        Bristles {
            force: zero,
            rate: zero,
            dt: zero,
            begun: false,
        }
    }
}

/// The model over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    law: [Lugre; L],
    on: StepFlexibility<L>,
    sigma0: Lane<L>,
    sigma1: Lane<L>,
    sigma2: Lane<L>,
    /// L_s.
    limit: Lane<L>,
    /// Whether g is constant in all lanes.
    constant: bool,
}

impl Lugre {
    /// Energy of the bristles under their force sigma0 z.
    pub(in crate::contact) fn bristle_energy(&self, force: f64) -> f64 {
        0.5 * force * force / self.sigma0
    }

    /// g at a velocity, and dg/drdot.
    #[inline(always)]
    fn strength(&self, velocity: f64) -> [f64; 2] {
        let range = self.static_limit - self.limit;
        let v = velocity / self.stribeck_velocity;
        let part = range * (1.0 - rise(v * v));
        [self.limit + part, -2.0 * v / self.stribeck_velocity * part]
    }

    /// g at a velocity.
    pub(in crate::contact) fn strength_at(&self, velocity: f64) -> f64 {
        self.strength(velocity)[0]
    }

    /// Change of sigma0 |z| over x = |r(i+1) - r(i)| in a step dt from a force `along` of the bristles in the direction of the motion,
    /// and its derivative.
    #[inline(always)]
    fn flow(&self, along: f64, dt: f64, x: f64) -> [f64; 2] {
        let [g, falling] = self.strength(x / dt);
        let part = self.sigma0 * x / g;
        let m = rise(part);
        let slope = self.sigma0 / g - part * falling / (dt * g);
        [
            (g - along) * m,
            falling / dt * m + (g - along) * (1.0 - m) * slope,
        ]
    }
}

impl Law for Lugre {
    type Step<const L: usize> = Step<L>;

    fn at_limit(self, limit: f64) -> Self {
        Lugre {
            limit,
            static_limit: in_proportion(self.static_limit, self.limit, limit),
            ..self
        }
    }

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            law: *laws,
            on: *on,
            sigma0: lanes(laws, |law| law.sigma0),
            sigma1: lanes(laws, |law| law.sigma1),
            sigma2: lanes(laws, |law| law.sigma2),
            limit: lanes(laws, |law| law.static_limit),
            constant: laws.iter().all(|law| law.static_limit == law.limit),
        }
    }

    /// (rdot, S) for rdot = `reach` sin t, from rest and then one period more: a loop, because S is larger while the velocity grows
    /// [Canudas de Wit et al. 1995, Fig. 4].
    fn cycle(&self, reach: f64) -> Cycle {
        const POINTS: i32 = 400;
        const INNER: i32 = 10;
        let dt = std::f64::consts::TAU / f64::from(POINTS * INNER);
        let step = curve::law_of_motion(*self, dt);
        let mut bristles = Bristles::default();
        let mut s = 0.0;
        let mut points = vec![[0.0, 0.0]];
        for k in 1..=2 * POINTS * INNER {
            let [before, now] = [f64::from(k - 1) * dt, f64::from(k) * dt];
            let rate = reach * libm::sin(now);
            let change = reach * (libm::cos(before) - libm::cos(now));
            let trial = Trial {
                displacement: Lane([0.0]),
                velocity: Lane([reach * libm::sin(before)]),
                force: Lane([s]),
                change: Lane([change]),
                rate: Lane([rate]),
            };
            [s] = step.force(&trial, &mut bristles).0;
            if k % INNER == 0 {
                points.push([rate, s]);
            }
        }
        (points, Vec::new())
    }
}

/// z is the force of the bristles, sigma0 times their deflection.
impl Evolution for Lugre {
    fn rate(&self, z: f64, rdot: f64) -> f64 {
        let [g, _] = self.strength(rdot);
        if g <= 0.0 {
            return 0.0;
        }
        self.sigma0 * (rdot - rdot.abs() * z / g)
    }

    fn force(&self, z: f64, _: f64, rdot: f64) -> f64 {
        match self.limit > 0.0 {
            true => z + self.sigma1 / self.sigma0 * self.rate(z, rdot) + self.sigma2 * rdot,
            false => 0.0,
        }
    }

    fn bound(&self) -> f64 {
        self.static_limit
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = Bristles<L>;

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, bristles: &mut Bristles<L>) -> Lane<L> {
        let StepFlexibility { start, end, dt, .. } = self.on;
        // 0 in the first step, where dz/dt is the difference quotient.
        let share = dt.zip(bristles.dt, |dt, last| dt / (dt + last));
        let weight = if bristles.begun {
            share
        } else {
            Lane::splat(0.0)
        };
        let uncut = if bristles.begun {
            bristles.force
        } else {
            let at_rest = |s: f64, rdot: f64| if rdot == 0.0 { s } else { 0.0 };
            trial.force.zip(trial.velocity, at_rest)
        };
        let before = uncut.cut(self.limit);

        // S (1 + sigma2 h_rate) = known + grip y, y = sigma0 (z(i+1) - z(i)) in the direction of the motion.
        let quotient = (self.sigma0 * dt).map(|x| 1.0 / x);
        let grip = Lane::splat(1.0) + self.sigma1 * (Lane::splat(1.0) + weight) * quotient;
        let rate = trial.rate - trial.force * start.h_rate;
        let known = before - self.sigma1 * weight * bristles.rate + self.sigma2 * rate;
        let shrink = (self.sigma2 * end.h_rate).map(|x| 1.0 / (1.0 + x));

        // x + flexibility y = |free|, x = |r(i+1) - r(i)|.
        let flexibility = end.h * shrink * grip;
        let free = trial.change - trial.force * start.h - end.h * shrink * known;
        let along = before.zip(free, |s, free| if free < 0.0 { -s } else { s });
        let reach = free.map(f64::abs);
        // g at the last velocity, which is g if it is constant.
        let mut g = self.limit;
        if !self.constant {
            for (l, law) in self.law.iter().enumerate() {
                [g.0[l], _] = law.strength(trial.velocity.0[l]);
            }
        }
        let inverse = g.map(|g| if g > 0.0 { 1.0 / g } else { 0.0 });
        let part = Lane::splat(1.0) - along * inverse;
        let zero = Lane::splat(0.0);
        let c = (self.sigma0 * flexibility * part).larger(zero);
        let mut y = g * part * saturation::root(c, zero, self.sigma0 * reach * inverse);
        if !self.constant {
            let falling = self.falling(along, flexibility, reach, reach - flexibility * y);
            for (l, law) in self.law.iter().enumerate() {
                // With a constant g the bits do not depend on the other lanes.
                if law.static_limit > law.limit {
                    y.0[l] = falling.0[l];
                }
            }
        }

        let change = y.zip(free, |y, free| if free < 0.0 { -y } else { y });
        *bristles = Bristles {
            force: before + change,
            rate: change * quotient,
            dt,
            begun: true,
        };
        let force = (known + grip * change) * shrink;
        force.zip(
            self.limit,
            |force, limit| if limit > 0.0 { force } else { 0.0 },
        )
    }
}

impl<const L: usize> Step<L> {
    /// y at the root of x + flexibility y(x) = reach, from a first x.
    #[inline(always)]
    fn falling(
        &self,
        along: Lane<L>,
        flexibility: Lane<L>,
        reach: Lane<L>,
        start: Lane<L>,
    ) -> Lane<L> {
        let zero = Lane::splat(0.0);
        // Bristles beyond L_k fall back at most to it.
        let beyond = (along - lanes(&self.law, |law| law.limit)).larger(zero);
        let dt = self.on.dt;
        let x = roots::rising(zero, reach + flexibility * beyond, start, |l, x| {
            let [change, slope] = self.law[l].flow(along.0[l], dt.0[l], x);
            [
                x + flexibility.0[l] * change - reach.0[l],
                1.0 + flexibility.0[l] * slope,
            ]
        });
        let mut y = x;
        for (l, law) in self.law.iter().enumerate() {
            [y.0[l], _] = law.flow(along.0[l], dt.0[l], x.0[l]);
        }
        y
    }
}
