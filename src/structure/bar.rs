//! A uniform free bar of n two-node elements, seen from one end: its modes are cosines, in closed form.
//!
//! With theta = j pi/n, mode j of the chain has the shape cos(theta i) at node i, and with s = sin(theta/2)
//!
//! ```text
//! lumped      omega^2 = 4 s^2 (C0/h)^2                 modal mass  m  (j = 0, n),  m/2  (else)
//! consistent  omega^2 = 12 s^2/(3 - 2 s^2) (C0/h)^2    the same times (3 - 2 s^2)/3
//! ```
//!
//! because M and K of either kind turn a cosine into a multiple of (m_i cos(theta i)), m_i the lumped masses.

use super::Mode;
use libm::{cos, sin};
use std::f64::consts::PI;

/// How a bar's mass is laid on its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mass {
    /// Half of an element's mass on each of its nodes, so half a node's mass at the ends [I section 3].
    Lumped,
    /// By the displacement's own shape functions.
    Consistent,
}

/// A uniform bar, free at both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// Number of elements.
    pub elements: u32,
    /// Mass of the whole bar.
    pub mass: f64,
    /// Travel time there and back, 2 L/C0.
    pub trip: f64,
    /// How the mass is laid.
    pub kind: Mass,
}

impl Bar {
    /// Modes 0..=n as the contact end feels them; mode 0 is the rigid-body mode.
    pub fn modes(&self) -> impl Iterator<Item = Mode> + '_ {
        (0..=self.elements).map(|j| {
            let (omega2, mass) = self.mode(j);
            Mode {
                omega2,
                phi2: 1.0 / mass,
            }
        })
    }

    /// omega^2 and modal mass of mode `j`, its shape being 1 at the contact end.
    fn mode(&self, j: u32) -> (f64, f64) {
        let n = f64::from(self.elements);
        let s = sin(f64::from(j) * PI / (2.0 * n));
        let rate = 2.0 * n / self.trip; // C0/h
        let ends = if j == 0 || j == self.elements {
            1.0
        } else {
            0.5
        };
        let lumped = (4.0 * s * s * rate * rate, self.mass * ends);
        match self.kind {
            Mass::Lumped => lumped,
            Mass::Consistent => {
                let spread = (3.0 - 2.0 * s * s) / 3.0;
                (lumped.0 / spread, lumped.1 * spread)
            }
        }
    }

    /// Shape of mode `j` at node `i`, counted from the contact.
    pub fn shape(&self, j: u32, i: u32) -> f64 {
        // The angle in whole periods first: j i may be large.
        let turn = (u64::from(j) * u64::from(i)) % (2 * u64::from(self.elements));
        cos(turn as f64 * PI / f64::from(self.elements))
    }
}
