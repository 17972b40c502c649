//! Two equal bars on the impact spring as continua: what is left of the chain when n grows at fixed k_I.
//!
//! Time t is in T_I from the first touch, r in c T_I/2, rdot in c, F in F0. A bar's end feels the force and what comes
//! back from the free end after each trip, so
//!
//! ```text
//! rdot = -1 + F(t) + 2 F(t - 1) + 2 F(t - 2) + ...,   r' = 2 rdot,   F = -2 gamma n r where r < 0
//! ```
//!
//! With tau = 1/(4 gamma n), s = (t - 1)/tau and C = 2 - exp(-1/tau) the force is, as long as contact lasts,
//!
//! ```text
//! t <= 1    F = 1 - exp(-t/tau)
//! t >= 1    F = -1 + (2 s + C) exp(-s)
//! ```
//!
//! which holds to t = 2, where F(t - 2) sets in. After that rdot has the period 1 and stays above 0.4: the bars meet
//! only once.

use super::wave::State;
use libm::{exp, expm1};

/// The contact of two equal bars on the spring, at any time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Time constant of a bar's end on the spring.
    tau: f64,
    /// When the bars first touch.
    touch: f64,
    /// How long they do, in T_I: between 1 and 2.
    contact: f64,
}

impl Spring {
    /// For `gamma_n` = gamma n = k_I L/(E A) and a gap at t = 0 over c T_I/2.
    ///
    /// `None` where contact outlasts 2 T_I, for gamma n < 0.404: a softer spring still pushes when the third front
    /// comes in.
    pub fn new(gamma_n: f64, gap: f64) -> Option<Spring> {
        let mut spring = Spring {
            tau: 0.25 / gamma_n,
            touch: 0.5 * gap,
            contact: 2.0,
        };
        if spring.force(2.0) > 0.0 {
            return None;
        }
        let (mut pushes, mut parted) = (1.0, 2.0);
        loop {
            let middle = 0.5 * (pushes + parted);
            if !(pushes < middle && middle < parted) {
                break;
            }
            if spring.force(middle) > 0.0 {
                pushes = middle;
            } else {
                parted = middle;
            }
        }
        spring.contact = parted;
        Some(spring)
    }

    /// How long the ends press on each other, in T_I.
    pub fn contact_duration(&self) -> f64 {
        self.contact
    }

    /// The state at t >= 0.
    pub fn at(&self, time: f64) -> State {
        let t = time - self.touch;
        if t < 0.0 {
            return State {
                displacement: -2.0 * t,
                velocity: -1.0,
                force: 0.0,
            };
        }
        let force = self.force(t);
        // Of fronts that came back long ago the whole impulse, and no force any more.
        let long = (t - 2.0 - self.contact).max(0.0).floor();
        let (mut returned, mut impulse) = (0.0, long * self.impulse(self.contact));
        let mut since = t - 1.0 - long;
        while since > 0.0 {
            returned += self.force(since);
            impulse += self.impulse(since);
            since -= 1.0;
        }
        State {
            displacement: if t < self.contact {
                -2.0 * self.tau * force
            } else {
                2.0 * (self.impulse(t) + 2.0 * impulse - t)
            },
            velocity: force + 2.0 * returned - 1.0,
            force,
        }
    }

    /// F at t >= 0 from the first touch.
    fn force(&self, t: f64) -> f64 {
        if t >= self.contact && self.contact < 2.0 {
            0.0
        } else if t <= 1.0 {
            -expm1(-t / self.tau)
        } else {
            let s = (t - 1.0) / self.tau;
            (2.0 * s + 1.0 - expm1(-1.0 / self.tau)) * exp(-s) - 1.0
        }
    }

    /// The integral of F from 0 to t >= 0, over F0 T_I.
    fn impulse(&self, t: f64) -> f64 {
        let first = |t: f64| t + self.tau * expm1(-t / self.tau);
        if t <= 1.0 {
            return first(t);
        }
        let s = (t.min(self.contact) - 1.0) / self.tau;
        let c = 1.0 - expm1(-1.0 / self.tau);
        first(1.0) + self.tau * (2.0 - s - 2.0 * (1.0 + s) * exp(-s) - c * expm1(-s))
    }
}
