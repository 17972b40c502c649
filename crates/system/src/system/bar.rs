//! A uniform free bar of n two-node elements with its contact at one end: its modes are cosines, in closed form.
//!
//! With theta = j pi/n, mode j has the shape cos(theta i) at node i, and with s = sin(theta/2)
//!
//! ```text
//! lumped      omega^2 = 4 s^2 (C0/h)^2                 modal mass  m  (j = 0, n),  m/2  (else)
//! consistent  omega^2 = 12 s^2/(3 - 2 s^2) (C0/h)^2    the same times (3 - 2 s^2)/3
//! ```
//!
//! because M and K of both kinds map a cosine to a multiple of (m_i cos(theta i)), where m_i are the lumped masses. A bar whose
//! contact node has no mass has other angles, see [`super::massless`].

use super::Mode;
use super::massless::MasslessMode;
use libm::{cos, sin};
use std::f64::consts::PI;

/// The mass matrix of a bar.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mass {
    /// Half of the mass of an element at each of its nodes, so that the ends have half of the mass of a node [I section 3].
    Lumped,
    /// From the shape functions of the displacement.
    Consistent,
    /// Lumped, but the mass of the contact node is at its neighbour (Khenous, Laborde and Renard 2008).
    MasslessContact,
}

/// A uniform bar, free at both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// Number of elements.
    pub elements: u32,
    /// Mass of the bar.
    pub mass: f64,
    /// Travel time there and back, 2 L/C0.
    pub travel_time: f64,
    /// Mass matrix.
    pub kind: Mass,
}

impl Bar {
    /// Number of modes: of nodes with mass.
    pub fn mode_count(&self) -> u32 {
        match self.kind {
            Mass::Lumped | Mass::Consistent => self.elements + 1,
            Mass::MasslessContact => self.elements,
        }
    }

    /// Modes by rising frequency, scaled by their displacement at the contact end; mode 0 is the rigid-body mode.
    pub fn modes(&self) -> impl Iterator<Item = Mode> + '_ {
        (0..self.mode_count()).map(|j| self.mode(j))
    }

    /// Stiffness of an element, EA/h.
    pub fn element_stiffness(&self) -> f64 {
        let n = f64::from(self.elements);
        // EA/h = (EA/C0) (C0/h) with EA/C0 = mass C0/L.
        self.mass / n * (2.0 * n / self.travel_time) * (2.0 * n / self.travel_time)
    }

    /// Compliance between the modes and the contact: of the element with the contact node if that node has no mass, else zero.
    pub fn contact_compliance(&self) -> f64 {
        match self.kind {
            Mass::Lumped | Mass::Consistent => 0.0,
            Mass::MasslessContact => 1.0 / self.element_stiffness(),
        }
    }

    /// Mode `j`, scaled by its displacement at the contact end. This is the displacement without a contact force, to which
    /// [`Bar::contact_compliance`] adds.
    pub fn mode(&self, j: u32) -> Mode {
        let (omega2, mass) = self.modal(j);
        Mode::new(omega2, 1.0 / mass)
    }

    /// omega^2 and modal mass of mode `j`, its shape being 1 at the contact end.
    fn modal(&self, j: u32) -> (f64, f64) {
        let n = f64::from(self.elements);
        let rate = 2.0 * n / self.travel_time; // C0/h
        if self.kind == Mass::MasslessContact {
            let mode = MasslessMode::new(j, self.elements);
            let omega2 = 4.0 * mode.sine_squared() * rate * rate;
            return (omega2, self.mass / n * mode.mass());
        }
        let s = sin(f64::from(j) * PI / (2.0 * n));
        let ends = if j == 0 || j == self.elements {
            1.0
        } else {
            0.5
        };
        let lumped = (4.0 * s * s * rate * rate, self.mass * ends);
        if self.kind == Mass::Lumped {
            return lumped;
        }
        let spread = (3.0 - 2.0 * s * s) / 3.0;
        (lumped.0 / spread, lumped.1 * spread)
    }

    /// Shape of mode `j` at node `i`, counted from the contact.
    pub fn shape(&self, j: u32, i: u32) -> f64 {
        if self.kind == Mass::MasslessContact {
            return MasslessMode::new(j, self.elements).shape(i);
        }
        // The remainder of whole periods: j i may be large.
        let turn = (u64::from(j) * u64::from(i)) % (2 * u64::from(self.elements));
        cos(turn as f64 * PI / f64::from(self.elements))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::Modal;
    use nalgebra::DMatrix;

    /// M and K of a bar element by element, the contact at node 0. A node without mass is condensed.
    fn assembled(bar: &Bar) -> (DMatrix<f64>, DMatrix<f64>) {
        let n = bar.elements as usize;
        let (mut m, mut k) = (DMatrix::zeros(n + 1, n + 1), DMatrix::zeros(n + 1, n + 1));
        let element = bar.mass / n as f64;
        // EA/h = (EA/C0) (C0/h) with EA/C0 = mass C0/L = 2 mass/travel_time.
        let stiffness = 2.0 * bar.mass / bar.travel_time * (2.0 * n as f64 / bar.travel_time);
        let (diagonal, other) = match bar.kind {
            Mass::Lumped | Mass::MasslessContact => (element / 2.0, 0.0),
            Mass::Consistent => (element / 3.0, element / 6.0),
        };
        for i in 0..n {
            for (row, column, sign) in [
                (i, i, 1.0),
                (i + 1, i + 1, 1.0),
                (i, i + 1, -1.0),
                (i + 1, i, -1.0),
            ] {
                m[(row, column)] += if row == column { diagonal } else { other };
                k[(row, column)] += sign * stiffness;
            }
        }
        if bar.kind == Mass::MasslessContact {
            m[(1, 1)] += m[(0, 0)];
            let (to_end, from_end) = (k.view((1, 0), (n, 1)), k.view((0, 1), (1, n)));
            let condensed = k.view((1, 1), (n, n)) - to_end * (from_end / k[(0, 0)]);
            return (m.view((1, 1), (n, n)).into(), condensed);
        }
        (m, k)
    }

    fn each(check: impl Fn(&Bar, DMatrix<f64>, DMatrix<f64>)) {
        for kind in [Mass::Lumped, Mass::Consistent, Mass::MasslessContact] {
            for elements in [1, 2, 3, 7] {
                let bar = Bar {
                    elements,
                    mass: 3.0,
                    travel_time: 0.7,
                    kind,
                };
                let (m, k) = assembled(&bar);
                check(&bar, m, k);
            }
        }
    }

    /// Sums over up to 8 nodes and an eigensolver, relative to the largest number there is. One mass alone has no stiffness.
    const ROUND_OFF: f64 = 1e-13;

    #[test]
    fn modes_are_those_of_the_assembled_bar() {
        each(|bar, m, k| {
            let size = m.nrows();
            let mut contact = DMatrix::zeros(size, 1);
            contact[(0, 0)] = 1.0;
            let modal = Modal::new(&m, &k, &contact).unwrap();
            let highest = modal.omega2[size - 1];
            assert_eq!(bar.modes().count(), size);
            for (ours, theirs) in bar.modes().zip(&modal.modes(0)) {
                assert!(
                    (ours.omega2 - theirs.omega2).abs() <= ROUND_OFF * highest,
                    "{bar:?}"
                );
                assert!((ours.phi2 - theirs.phi2).abs() < ROUND_OFF, "{bar:?}");
            }
        });
    }

    #[test]
    fn shapes_are_orthogonal_in_mass_and_stiffness() {
        each(|bar, m, k| {
            let size = m.nrows();
            let first = bar.elements as usize + 1 - size;
            let shapes =
                DMatrix::from_fn(size, size, |i, j| bar.shape(j as u32, (first + i) as u32));
            let (masses, stiffnesses) = (
                shapes.transpose() * m * &shapes,
                shapes.transpose() * k * &shapes,
            );
            let highest = stiffnesses.amax();
            for (i, mode) in bar.modes().enumerate() {
                assert!((shapes[(0, i)] - 1.0).abs() < ROUND_OFF);
                for j in 0..size {
                    let (mass, stiffness) = if i == j {
                        (1.0 / mode.phi2, mode.omega2 / mode.phi2)
                    } else {
                        (0.0, 0.0)
                    };
                    assert!(
                        (masses[(i, j)] - mass).abs() < ROUND_OFF * bar.mass,
                        "{bar:?} {i} {j}"
                    );
                    assert!(
                        (stiffnesses[(i, j)] - stiffness).abs() <= ROUND_OFF * highest,
                        "{bar:?} {i} {j}"
                    );
                }
            }
        });
    }
}
