//! Two equal bars of finite elements on the impact spring, in continuous time: what is left of a computed case when
//! its step goes to zero.
//!
//! Touching or apart, the structure is linear and moves in its modes, in closed form. The ends touch and part where r
//! passes zero; `search` finds these events and proves that it leaves none out. Equal bars mirror each other, so that
//! a mode of the pair stands for a like mode of each.
//!
//! Time is in T_I, r in c T_I/2, rdot in c, force in F0. An event's time is right to 1e-13; what follows is as
//! sensitive to that as the problem itself, which for stiff springs that rattle is much (docs/findings.md).

mod modes;
mod search;

use super::wave::State;
use crate::system::Mode;
use crate::system::bar::Bar;
use modes::{Basis, Contact};
use search::{Found, Search};

/// Largest gamma n^2. The spring's period falls with the root of it; beyond, the resolution of events is no longer a small
/// part of that.
const STIFFEST: f64 = 1e20;

/// Most events of a run: a contact that chatters more says nothing by its times.
const MOST_EVENTS: usize = 10_000;

/// The motion, from event to event.
#[derive(Debug, Clone)]
pub struct Chain {
    free: Basis,
    contact: Contact,
    spring: f64,
    touch: f64,
    /// Whether the ends touch.
    pressed: bool,
    /// Start of the present piece, from the first touch on.
    start: f64,
    search: Search,
    events: Vec<f64>,
}

impl Chain {
    /// Two of `bar`, with its mass in 2 F0 T_I/c and its trip in T_I, that close over a gap in c T_I/2; the stiffness
    /// `spring` is in F0 over c T_I/2.
    ///
    /// `None` for gamma n^2 > 10^20. Time and memory grow with the square of the number of elements.
    pub fn new(bar: &Bar, spring: f64, gap: f64) -> Option<Chain> {
        let n = f64::from(bar.elements);
        // spring is 2 gamma n.
        if 0.5 * spring * n > STIFFEST {
            return None;
        }
        let pair = |mode: Mode| Mode {
            phi2: 2.0 * mode.phi2,
            ..mode
        };
        let modes: Vec<Mode> = bar.modes().map(pair).collect();
        let free = Basis::free(&modes);
        let contact = Contact::new(&modes, spring);
        let mut rates = vec![0.0; modes.len()];
        // r' = -2 in c T_I/2 over T_I, all of it in the rigid-body mode.
        rates[0] = -2.0 / free.share[0];
        let rest = vec![0.0; modes.len()];
        let search = Search::new(&contact.basis, contact.enter(&rest, &rates), -1.0);
        Some(Chain {
            free,
            contact,
            spring,
            touch: 0.5 * gap,
            pressed: true,
            start: 0.0,
            search,
            events: Vec::new(),
        })
    }

    /// The state at `time` >= 0, no less than any asked for before; `None` once there were more than 10^4 events, or
    /// where the next is not found in 10^6 stretches.
    pub fn at(&mut self, time: f64) -> Option<State> {
        let t = time - self.touch;
        if t < 0.0 {
            return Some(State {
                displacement: -2.0 * t,
                velocity: -1.0,
                force: 0.0,
            });
        }
        loop {
            match self.search.reach(t - self.start) {
                Found::Clear => break,
                Found::Event(at) if self.events.len() < MOST_EVENTS => self.pass(at),
                Found::Event(_) | Found::Lost => return None,
            }
        }
        let [r, rate] = self.search.wave.at(t - self.start);
        Some(State {
            displacement: r,
            velocity: 0.5 * rate,
            force: if self.pressed { -self.spring * r } else { 0.0 },
        })
    }

    /// Times of the events passed so far: parting, touching again, and so on.
    pub fn events(&self) -> Vec<f64> {
        self.events.iter().map(|t| t + self.touch).collect()
    }

    /// From one state of the contact to the other.
    fn pass(&mut self, at: f64) {
        let (place, rate) = self.search.wave.coordinates(at);
        self.start += at;
        self.events.push(self.start);
        self.pressed = !self.pressed;
        self.search = if self.pressed {
            Search::new(&self.contact.basis, self.contact.enter(&place, &rate), -1.0)
        } else {
            Search::new(&self.free, self.contact.leave(&place, &rate), 1.0)
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
            trip: 1.0,
            kind: Mass::Lumped,
        }
    }

    /// Energy in F0 c T_I/2: half the normal rates squared, and the strain of modes with their frequency.
    fn energy(chain: &Chain, at: f64) -> f64 {
        let basis = if chain.pressed {
            &chain.contact.basis
        } else {
            &chain.free
        };
        let (place, rate) = chain.search.wave.coordinates(at - chain.start);
        let terms = place.iter().zip(&rate).zip(&basis.omega);
        terms.map(|((q, p), w)| 0.5 * (p * p + w * w * q * q)).sum()
    }

    #[test]
    fn energy_stays_through_all_events() {
        for (gamma, n) in [(0.25, 20), (2.12, 20), (10.0, 10), (100.0, 5)] {
            let mut chain = Chain::new(&bar(n), 2.0 * gamma * f64::from(n), 0.0).unwrap();
            let start = energy(&chain, 0.0);
            chain.at(1.5).unwrap();
            // Round-off of modes and of each change between them; the spring's energy at an event is that of 1e-16.
            let tolerance = 1e-14 * (10.0 + chain.events.len() as f64);
            let end = energy(&chain, 1.5);
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
            let chain = Chain::new(&bar(n), 2.0 * gamma * f64::from(n), 0.0).unwrap();
            let n = f64::from(n);
            let (last, below) = chain.contact.basis.omega.split_last().unwrap();
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
        let last = *Chain::new(&bar(40), 80.0, 0.0)
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
