//! The motion of an oscillator over at most one radian by its two ends.
//!
//! The end is linear in the start and in the load, by a matrix that only the length decides. Points of a record are equally far apart but
//! for round-off, so few matrices serve all of it, and only what may hold the peak needs the polynomial of `piece`.

use super::piece::Piece;
use std::collections::HashMap;

/// An oscillator.
#[derive(Clone, Copy)]
pub(super) struct Oscillator {
    /// Circular frequency without damping.
    pub omega: f64,
    /// Damping ratio.
    pub ratio: f64,
}

/// u and h u' at the end for 1 of u, h u', h^2 a_0 and h^2 (a_1 - a_0) at the start.
type Transition = [[f64; 2]; 4];

/// The transitions of an oscillator over the lengths that it has met.
pub(super) struct Transitions {
    oscillator: Oscillator,
    /// By the bits of the length.
    known: HashMap<u64, Transition>,
    last: (u64, Transition),
}

impl Transitions {
    pub fn new(oscillator: Oscillator) -> Transitions {
        Transitions {
            oscillator,
            known: HashMap::new(),
            // No length has these bits.
            last: (f64::NAN.to_bits(), [[0.0; 2]; 4]),
        }
    }

    pub fn oscillator(&self) -> Oscillator {
        self.oscillator
    }

    /// The motion from the state u, u' on, for the time h, under an acceleration that is straight from `a0` to `a1`.
    pub fn part(&mut self, [u, v]: [f64; 2], h: f64, [a0, a1]: [f64; 2]) -> Part {
        let Oscillator { omega, ratio } = self.oscillator;
        let turn = omega * h;
        if self.last.0 != h.to_bits() {
            let transition = || {
                let end = |start, load| Piece::new([turn, ratio], start, load).end();
                [
                    end([1.0, 0.0], [0.0; 2]),
                    end([0.0, 1.0], [0.0; 2]),
                    end([0.0; 2], [1.0, 0.0]),
                    end([0.0; 2], [0.0, 1.0]),
                ]
            };
            let known = self.known.entry(h.to_bits()).or_insert_with(transition);
            self.last = (h.to_bits(), *known);
        }
        let (start, load) = ([u, v * h], [h * h * a0, h * h * (a1 - a0)]);
        let [of_u, of_v, of_load, of_slope] = self.last.1;
        let end = |i: usize| {
            of_u[i] * start[0] + of_v[i] * start[1] + (of_load[i] * load[0] + of_slope[i] * load[1])
        };
        Part {
            constants: [turn, ratio],
            start,
            load,
            end: [end(0), end(1) / h],
        }
    }
}

/// A motion over at most one radian.
pub(super) struct Part {
    /// omega h and the damping ratio.
    constants: [f64; 2],
    /// u and h u' at the start.
    start: [f64; 2],
    load: [f64; 2],
    /// u and u'.
    end: [f64; 2],
}

impl Part {
    /// u and u' at the end.
    pub fn end(&self) -> [f64; 2] {
        self.end
    }

    /// u at the start and at the end.
    pub fn ends(&self) -> [f64; 2] {
        [self.start[0], self.end[0]]
    }

    /// A bound of |u|: the larger end and the sag.
    pub fn bound(&self) -> f64 {
        let [start, end] = self.ends();
        start.abs().max(end.abs()) + self.sag()
    }

    /// A bound of the distance of u from its chord, |y|/8, y = d2u/dtau2.
    ///
    /// The load is straight, so y is a free vibration and y^2 + (y'/(omega h))^2 never rises.
    pub fn sag(&self) -> f64 {
        let ([turn, ratio], [u, v]) = (self.constants, self.start);
        let y = self.load[0] + 2.0 * ratio * turn * v + turn * turn * u;
        let slope = (self.load[1] - 2.0 * ratio * turn * y + turn * turn * v) / turn;
        (y * y + slope * slope).sqrt() / 8.0
    }

    /// The motion as a polynomial.
    pub fn piece(&self) -> Piece {
        Piece::new(self.constants, self.start, self.load)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bound_holds_where_only_the_slope_of_y_is_not_zero() {
        // omega = h = 1: u = sin tau - 0.85 tau under the acceleration 0.85 tau, with its extreme at cos tau = 0.85.
        let mut transitions = Transitions::new(Oscillator {
            omega: 1.0,
            ratio: 0.0,
        });
        let part = transitions.part([0.0, 0.15], 1.0, [0.0, 0.85]);
        let [first, second] = part.piece().extremes();
        let tau = 0.85f64.acos();
        // Round-off of v, whose slope is 0.53 there.
        assert!((first.unwrap() - tau).abs() < 1e-15 && second.is_none());
        assert!(part.bound() >= tau.sin() - 0.85 * tau);
        // The end is that of the closed form, by the matrix.
        let [u, v] = part.end();
        assert!((u - (1f64.sin() - 0.85)).abs() < 1e-15 && (v - (1f64.cos() - 0.85)).abs() < 1e-15);
    }

    #[test]
    fn the_sag_is_that_of_the_polynomial() {
        let mut transitions = Transitions::new(Oscillator {
            omega: 2.0,
            ratio: 0.3,
        });
        for h in [0.5, 0.1, 0.5] {
            let part = transitions.part([0.7, -1.3], h, [0.4, 2.1]);
            let [y, slope] = part.piece().bend();
            let sag = y.hypot(slope / (2.0 * h)) / 8.0;
            assert!((part.sag() - sag).abs() < 1e-15);
            let [u, v] = part.piece().end();
            assert!((part.end()[0] - u).abs() < 1e-15 && (part.end()[1] - v / h).abs() < 1e-14);
        }
    }
}
