//! Two equal bars of finite elements with the impact spring between them, in continuous time: the limit of a computed case
//! for a time step that goes to zero.
//!
//! With the contact closed or open the structure is linear and moves in its modes, in closed form. The contact closes and
//! opens where r passes zero; `crossing` computes these events and proves that it misses none. Equal bars mirror each other,
//! so that one set of modes is enough for both. If the contact nodes have no mass, their elements are in series with the spring.
//!
//! Time is in T_I, r in c T_I/2, rdot in c, force in F0. The time of an event has an error of 1e-13. The motion after it is as
//! sensitive to this error as the problem itself. For stiff springs with many separations the sensitivity is large
//! (docs/findings.md).

mod crossing;
mod modes;

use super::State;
use crate::system::Mode;
use crate::system::bar::Bar;
use crossing::{Crossing, CrossingSearch};
use modes::{ContactModes, ModalBasis};

/// Largest gamma n^2. The period of the spring falls with its root; for larger values the resolution of events is no longer a
/// small part of this period.
const STIFFEST: f64 = 1e20;

/// Most events of a run: the times of a contact with more of them have no significant digits.
const MOST_EVENTS: usize = 10_000;

/// The motion, from event to event.
///
/// At gamma = 1 and n = 40 the contact force has its peak at 1.445 F0, 44 % above that of continuous bars:
///
/// ```
/// use slipgap_motion::exact::mesh::Mesh;
/// use slipgap_system::system::bar::{Bar, Mass};
///
/// let bar = Bar { elements: 40, mass: 0.5, travel_time: 1.0, kind: Mass::Lumped };
/// let mut mesh = Mesh::new(&bar, 2.0 * 1.0 * 40.0, 0.0).expect("gamma n^2 is at most 1e20");
/// let forces = (0..1000).filter_map(|i| mesh.at(1e-3 * f64::from(i)));
/// let peak = forces.map(|state| state.force).fold(0.0, f64::max);
/// assert!((peak - 1.445).abs() < 1e-3);
/// ```
#[derive(Debug, Clone)]
pub struct Mesh {
    free: ModalBasis,
    contact: ContactModes,
    /// Stiffness of the spring and of the elements without mass in series, which the modes meet.
    stiffness: f64,
    /// Motion of the contact over that of the modes while it is closed; 1 if all nodes have mass.
    share: f64,
    /// Time of the first touch.
    touch: f64,
    /// Whether the contact is closed.
    closed: bool,
    /// Start of the present piece, from the first touch on.
    start: f64,
    search: CrossingSearch,
    events: Vec<f64>,
}

impl Mesh {
    /// Two equal bars, each `bar`, that close over a gap.
    ///
    /// The mass of `bar` is in 2 F0 T_I/c, its travel time in T_I. `spring` is the stiffness in F0 over c T_I/2, which is
    /// 2 gamma n. `gap` is in c T_I/2.
    ///
    /// `None` for gamma n^2 > 10^20. Time and memory grow with the square of the number of elements.
    pub fn new(bar: &Bar, spring: f64, gap: f64) -> Option<Mesh> {
        let n = f64::from(bar.elements);
        // Both bars have an element in series if their contact nodes have no mass.
        let compliance = 2.0 * bar.contact_compliance();
        let stiffness = if compliance > 0.0 {
            1.0 / (1.0 / spring + compliance)
        } else {
            spring
        };
        // The stiffness of the spring is 2 gamma n.
        if 0.5 * stiffness * n > STIFFEST {
            return None;
        }
        let pair = |mode: Mode| Mode {
            phi2: 2.0 * mode.phi2,
            ..mode
        };
        let modes: Vec<Mode> = bar.modes().map(pair).collect();
        let free = ModalBasis::free(&modes);
        let contact = ContactModes::new(&modes, stiffness);
        let mut rates = vec![0.0; modes.len()];
        // r' = -2 in c T_I/2 over T_I, all of it in the rigid-body mode.
        rates[0] = -2.0 / free.phi[0];
        let rest = vec![0.0; modes.len()];
        let start = contact.contact_coordinates(&rest, &rates);
        let search = CrossingSearch::new(&contact.basis, start, -1.0);
        Some(Mesh {
            free,
            contact,
            stiffness,
            share: stiffness / spring,
            touch: 0.5 * gap,
            closed: true,
            start: 0.0,
            search,
            events: Vec::new(),
        })
    }

    /// The state at `time` >= 0; times must not decrease from call to call.
    ///
    /// `None` after more than 10^4 events, or if the next event is not reached in 10^6 intervals.
    pub fn at(&mut self, time: f64) -> Option<State> {
        let t = time - self.touch;
        if t < 0.0 {
            return Some(State::flight(-2.0 * t));
        }
        loop {
            match self.search.advance(t - self.start) {
                Crossing::None => break,
                Crossing::At(at) if self.events.len() < MOST_EVENTS => self.switch(at),
                Crossing::At(_) | Crossing::TooManyIntervals => return None,
            }
        }
        let [r, rate] = self.search.motion.at(t - self.start);
        let [displacement, velocity, force] = if self.closed {
            [self.share * r, self.share * rate, -self.stiffness * r]
        } else {
            [r, rate, 0.0]
        };
        Some(State {
            displacement,
            velocity: 0.5 * velocity,
            force,
        })
    }

    /// Times of the events up to the last time of [`Mesh::at`]: the contact opens, closes again, and so on.
    pub fn events(&self) -> Vec<f64> {
        self.events.iter().map(|t| t + self.touch).collect()
    }

    /// Opens or closes the contact at the time `at` of the present piece.
    fn switch(&mut self, at: f64) {
        let (q, rate) = self.search.motion.coordinates(at);
        self.start += at;
        self.events.push(self.start);
        self.closed = !self.closed;
        self.search = if self.closed {
            CrossingSearch::new(
                &self.contact.basis,
                self.contact.contact_coordinates(&q, &rate),
                -1.0,
            )
        } else {
            CrossingSearch::new(&self.free, self.contact.free_coordinates(&q, &rate), 1.0)
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::bar::Mass;
    use std::f64::consts::PI;

    fn bar(n: u32) -> Bar {
        Bar {
            elements: n,
            mass: 0.5,
            travel_time: 1.0,
            kind: Mass::Lumped,
        }
    }

    /// Energy in F0 c T_I/2: half of the squares of the rates, and the strain energy of the modes.
    fn energy(mesh: &Mesh, at: f64) -> f64 {
        let basis = if mesh.closed {
            &mesh.contact.basis
        } else {
            &mesh.free
        };
        let (q, rate) = mesh.search.motion.coordinates(at - mesh.start);
        let terms = q.iter().zip(&rate).zip(&basis.omega);
        terms.map(|((q, p), w)| 0.5 * (p * p + w * w * q * q)).sum()
    }

    #[test]
    fn energy_is_constant_through_all_events() {
        for (gamma, n) in [(0.25, 20), (2.12, 20), (10.0, 10), (100.0, 5)] {
            let mut mesh = Mesh::new(&bar(n), 2.0 * gamma * f64::from(n), 0.0).unwrap();
            let start = energy(&mesh, 0.0);
            mesh.at(1.5).unwrap();
            // Round-off of modes and of each change between them; the energy of the spring at an event is that of r = 1e-16.
            let tolerance = 1e-14 * (10.0 + mesh.events.len() as f64);
            let end = energy(&mesh, 1.5);
            assert!(
                (end / start - 1.0).abs() < tolerance,
                "{gamma}: {end} {start}"
            );
        }
    }

    #[test]
    fn modes_in_contact_are_those_of_a_bar_on_a_wall() {
        // Shapes cos(kappa j) from the free end; at the end on a spring of 2 k_I, tan(kappa n) sin(kappa) = 2 gamma, and
        // for the one above the cut-off, kappa = pi + i eta, tanh(eta n) sinh(eta) = 2 gamma. omega = 4 n sin(kappa/2).
        for (gamma, n) in [(1e-4, 6), (0.25, 7), (1.0, 40), (300.0, 12)] {
            let mesh = Mesh::new(&bar(n), 2.0 * gamma * f64::from(n), 0.0).unwrap();
            let n = f64::from(n);
            let (last, below) = mesh.contact.basis.omega.split_last().unwrap();
            for (i, omega) in (0..).zip(below) {
                let sine = omega / (4.0 * n);
                let kappa = 2.0 * sine.asin();
                let phase = kappa * n - f64::from(i) * PI;
                let expected = (2.0 * gamma / kappa.sin()).atan();
                // arcsin near the cut-off loses half the digits.
                assert!(
                    (phase - expected).abs() < 1e-13 * n / (PI - kappa),
                    "{gamma} mode {i}: {phase} {expected}"
                );
            }
            let eta = 2.0 * (last / (4.0 * n)).acosh();
            let product = (eta * n).tanh() * eta.sinh();
            assert!(
                (product / (2.0 * gamma) - 1.0).abs() < 1e-9,
                "{gamma}: {product}"
            );
        }
        // In a long bar it is the contact mode: Omega C0/h, Omega^2 = 2 + 2 sqrt(1 + 4 gamma^2).
        let last = *Mesh::new(&bar(40), 80.0, 0.0)
            .unwrap()
            .contact
            .basis
            .omega
            .last()
            .unwrap();
        let omega = 80.0 * (2.0 + 2.0 * 5.0_f64.sqrt()).sqrt();
        assert!((last / omega - 1.0).abs() < 1e-14, "{last} {omega}");
    }
}
