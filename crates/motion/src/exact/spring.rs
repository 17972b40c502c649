//! Two equal continuous bars with the impact spring between them: the limit of the mesh for n to infinity at fixed k_I.
//!
//! Time t is in T_I from the first touch, r in c T_I/2, rdot in c, F in F0. The force and the waves that return from the free end
//! after each T_I move the end of a bar, so
//!
//! ```text
//! rdot = -1 + F(t) + 2 F(t - 1) + 2 F(t - 2) + ...,   r' = 2 rdot,   F = -2 gamma n r for r < 0
//! ```
//!
//! With tau = 1/(4 gamma n), s = (t - 1)/tau and C = 2 - exp(-1/tau) the force in contact is
//!
//! ```text
//! t <= 1    F = 1 - exp(-t/tau)
//! t >= 1    F = -1 + (2 s + C) exp(-s)
//! ```
//!
//! up to t = 2, where F(t - 2) begins. After contact rdot has the period 1 and is above 0.4, so the bars meet only once.

use super::{State, bisect};
use libm::{exp, expm1};

/// The contact of two equal bars on the spring, at any time.
///
/// For tau much smaller than T_I contact lasts T_I + 1.678 tau, tau = T_I/(4 gamma n):
///
/// ```
/// use slipgap_motion::exact::spring::Spring;
///
/// let gamma_n = 1000.0;
/// let spring = Spring::new(gamma_n, 0.0).expect("gamma n is above 0.404");
/// assert!((spring.contact_duration() - (1.0 + 1.678 / (4.0 * gamma_n))).abs() < 1e-6);
/// // F = F0 (1 - exp(-t/tau)) while the first wave travels.
/// assert!((spring.at(2.5e-4).force - (1.0 - (-1.0_f64).exp())).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Time constant of the end of a bar on the spring, in T_I.
    tau: f64,
    /// Time of the first touch.
    touch: f64,
    /// Duration of contact in T_I, between 1 and 2.
    contact: f64,
}

impl Spring {
    /// For `gamma_n` = gamma n = k_I L/(E A) and a gap at t = 0 over c T_I/2.
    ///
    /// `None` for gamma n < 0.404, where contact is longer than 2 T_I: the spring still pushes when the third front arrives.
    pub fn new(gamma_n: f64, gap: f64) -> Option<Spring> {
        let mut spring = Spring {
            tau: 0.25 / gamma_n,
            touch: 0.5 * gap,
            contact: 2.0,
        };
        if spring.force(2.0) > 0.0 {
            return None;
        }
        [_, spring.contact] = bisect([1.0, 2.0], |t| spring.force(t) <= 0.0);
        Some(spring)
    }

    /// Duration of contact, in T_I.
    pub fn contact_duration(&self) -> f64 {
        self.contact
    }

    /// The state at t >= 0.
    pub fn at(&self, time: f64) -> State {
        let t = time - self.touch;
        if t < 0.0 {
            return State::flight(-2.0 * t);
        }
        let force = self.force(t);
        // Fronts that returned before the last contact duration have their whole impulse, and no force.
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
