//! Softened contacts by Runge-Kutta steps of order 4 that restart at events, found by bisection.

use super::*;
use crate::contact::ClippedLine;

/// The direction of a contact at its limit; 0 for open and 2 for closed or sticking.
type Phases = Vec<f64>;

const OPEN: f64 = 0.0;
const CLOSED: f64 = 2.0;

struct Restarts<'a> {
    s: &'a Structure,
    phases: Phases,
}

impl Restarts<'_> {
    /// The force of contact i; `y` has u, u' and the elongations of the friction springs.
    fn force(&self, i: usize, t: f64, y: &[f64]) -> f64 {
        let (n, contact, phase) = (self.s.len(), &self.s.contacts[i], self.phases[i]);
        let limit = contact.law.limit().map_or(0.0, |limit| limit.at(t));
        match contact.law.line() {
            _ if phase.abs() == 1.0 => phase * limit,
            _ if phase == OPEN => 0.0,
            Some(ClippedLine::Spring { stiffness }) => {
                stiffness * (self.s.relative(i, &y[..n]) + contact.gap)
            }
            Some(ClippedLine::Viscous { viscosity }) => {
                viscosity * self.s.relative(i, &y[n..2 * n])
            }
            Some(ClippedLine::Elastic { stiffness }) => stiffness * y[2 * n + i],
            _ => f64::NAN,
        }
    }

    fn rates(&self, t: f64, y: &[f64]) -> Vec<f64> {
        let (n, m) = (self.s.len(), self.s.contacts.len());
        let (u, v) = (&y[..n], &y[n..2 * n]);
        let [mut f, mut product] = [vec![0.0; n], vec![0.0; n]];
        self.s.add_loads(t, &mut f);
        self.s.stiffness.add_product(u, &mut product);
        self.s.damping.add_product(v, &mut product);
        for i in 0..m {
            let force = self.force(i, t, y);
            for (node, sign) in self.s.column(i) {
                f[node] -= sign * force;
            }
        }
        let a = (0..n).map(|i| (f[i] - product[i]) / self.s.nodes[i].mass);
        let slips = (0..m).map(|i| self.s.relative(i, v));
        v.iter().copied().chain(a).chain(slips).collect()
    }

    /// The state after a step. Times of loads stay below the end, where they may jump.
    fn step(&self, t: f64, h: f64, y: &[f64]) -> Vec<f64> {
        let add =
            |k: &[f64], c: f64| -> Vec<f64> { y.iter().zip(k).map(|(y, k)| y + c * k).collect() };
        let k1 = self.rates(t, y);
        let k2 = self.rates(t + 0.5 * h, &add(&k1, 0.5 * h));
        let k3 = self.rates(t + 0.5 * h, &add(&k2, 0.5 * h));
        let k4 = self.rates(t + h * (1.0 - 1e-10), &add(&k3, h));
        let sums = (0..y.len()).map(|i| k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        y.iter().zip(sums).map(|(y, k)| y + h / 6.0 * k).collect()
    }

    /// The phase that contact i changes to, if its present one is over.
    fn change(&self, i: usize, t: f64, y: &[f64]) -> Option<f64> {
        let (n, contact, phase) = (self.s.len(), &self.s.contacts[i], self.phases[i]);
        let rate = self.s.relative(i, &y[n..2 * n]);
        let force = self.force(i, t, y);
        let Some(limit) = contact.law.limit() else {
            let r = self.s.relative(i, &y[..n]) + contact.gap;
            return match phase {
                OPEN => (r < 0.0).then_some(CLOSED),
                _ => (r > 0.0).then_some(OPEN),
            };
        };
        let l = limit.at(t);
        if phase == CLOSED {
            return (force.abs() > l).then_some(force.signum());
        }
        let over = match contact.law.line() {
            Some(ClippedLine::Viscous { viscosity }) => phase * viscosity * rate < l,
            Some(ClippedLine::Elastic { stiffness }) => {
                let change = (limit.at(t + 1e-7) - limit.at(t - 1e-7)) / 2e-7;
                phase * rate < change / stiffness
            }
            _ => false,
        };
        over.then_some(CLOSED)
    }

    /// The elongations of sliding friction springs.
    fn stretch(&self, t: f64, y: &mut [f64]) {
        for (i, contact) in self.s.contacts.iter().enumerate() {
            if let (Some(ClippedLine::Elastic { stiffness }), Some(limit)) =
                (contact.law.line(), contact.law.limit())
                && self.phases[i].abs() == 1.0
            {
                y[2 * self.s.len() + i] = self.phases[i] * limit.at(t) / stiffness;
            }
        }
    }
}

/// u and u' at `end`.
pub fn restarts(s: &Structure, end: f64, count: usize) -> Vec<f64> {
    let (m, h) = (s.contacts.len(), end / count as f64);
    let mut y = [&s.displacement[..], &s.velocity, &vec![0.0; m]].concat();
    let start = |i: usize| match s.contacts[i].law.line() {
        Some(ClippedLine::Spring { .. }) => OPEN,
        _ => CLOSED,
    };
    let mut motion = Restarts {
        s,
        phases: (0..m).map(start).collect(),
    };
    for step in 0..count {
        let (mut t, until) = (step as f64 * h, (step + 1) as f64 * h);
        for _ in 0..100 {
            let over = |motion: &Restarts, d: f64| {
                let y = motion.step(t, d, &y);
                (0..m).find_map(|i| Some((i, motion.change(i, t + d * (1.0 - 1e-10), &y)?)))
            };
            let (mut low, mut high) = (0.0, until - t);
            let found = over(&motion, high);
            if found.is_some() {
                while high - low > 1e-13 * h {
                    let middle = 0.5 * (low + high);
                    match over(&motion, middle) {
                        Some(_) => high = middle,
                        None => low = middle,
                    }
                }
            }
            let found = over(&motion, high);
            y = motion.step(t, high, &y);
            t += high;
            motion.stretch(t, &mut y);
            let Some((i, phase)) = found else { break };
            motion.phases[i] = phase;
        }
    }
    y.truncate(2 * s.len());
    y
}
