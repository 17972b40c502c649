//! The time at which r passes zero, with a proof that there is no earlier one.
//!
//! Over an interval of length h, r differs from the cubic through its end values and slopes by at most
//! M s^2 (h - s)^2/24, where s is the time from the start of the interval and M = sum omega_k^4 (amplitude of mode k in r) is
//! an upper bound of |r''''|. A cubic is between its smallest and largest Bezier ordinate. So an interval has no zero if all
//! ordinates have the sign of the piece and are larger than M h^4/384, for any length of a touch. Any other interval is halved.
//! r = 0 at the start of a piece. In the first interval the same holds for r/s, with M h^4/162 and the ordinates of the
//! quadratic.

use super::modes::{Coordinates, ModalBasis};
use libm::{cos, hypot, sin};

/// Length of an interval below which r passed zero or touched it.
const RESOLUTION: f64 = 1e-13;

/// Most intervals of a piece.
const MOST_INTERVALS: u32 = 1_000_000;

/// r from the start of a piece on, as a sum of modes.
#[derive(Debug, Clone)]
pub(super) struct ModalMotion {
    basis: ModalBasis,
    q: Vec<f64>,
    rate: Vec<f64>,
}

impl ModalMotion {
    /// r and r' at `time` from the start of the piece.
    pub fn at(&self, time: f64) -> [f64; 2] {
        let (q, rate) = self.coordinates(time);
        let sum =
            |q: &[f64]| -> f64 { q.iter().zip(&self.basis.phi).map(|(q, phi)| q * phi).sum() };
        [sum(&q), sum(&rate)]
    }

    /// The modal coordinates and their rates at that time.
    pub fn coordinates(&self, time: f64) -> Coordinates {
        let starts = self.q.iter().zip(&self.rate).zip(&self.basis.omega);
        starts
            .map(|((&q, &p), &omega)| {
                if omega == 0.0 {
                    return (q + p * time, p);
                }
                let (c, s) = (cos(omega * time), sin(omega * time));
                (q * c + p / omega * s, p * c - q * omega * s)
            })
            .unzip()
    }

    /// The time after which r > 0 always: the rigid-body distance grows and is larger than the sum of all amplitudes.
    fn separation_time(&self) -> f64 {
        let mut amplitude = 0.0;
        let (mut gap, mut speed) = (0.0, 0.0);
        let starts = self.q.iter().zip(&self.rate);
        for ((q, p), (omega, phi)) in starts.zip(self.basis.omega.iter().zip(&self.basis.phi)) {
            if *omega == 0.0 {
                (gap, speed) = (gap + phi * q, speed + phi * p);
            } else {
                amplitude += phi * hypot(*q, p / omega);
            }
        }
        if speed > 0.0 {
            (amplitude - gap) / speed
        } else {
            f64::INFINITY
        }
    }

    /// An upper bound of |r''''|.
    fn fourth_derivative_bound(&self) -> f64 {
        let starts = self.q.iter().zip(&self.rate);
        let modes = self.basis.omega.iter().zip(&self.basis.phi);
        starts
            .zip(modes)
            .map(|((q, p), (omega, phi))| phi * omega * omega * omega * hypot(q * omega, *p))
            .sum()
    }
}

/// The result of a search up to a time.
pub(super) enum Crossing {
    /// There is no zero.
    None,
    /// The first zero, at this time from the start of the piece.
    At(f64),
    /// The search needs more than [`MOST_INTERVALS`].
    TooManyIntervals,
}

/// The search for the first zero of a piece.
#[derive(Debug, Clone)]
pub(super) struct CrossingSearch {
    pub motion: ModalMotion,
    /// Sign of r in this piece.
    sign: f64,
    fourth: f64,
    /// There is no zero up to this time.
    clear: f64,
    /// r and r' at `clear`.
    reached: [f64; 2],
    /// Length of the next interval.
    length: f64,
    /// Number of intervals tried.
    tried: u32,
    /// There is no zero after this time.
    separated: f64,
}

impl CrossingSearch {
    /// A piece that starts with r = 0 and has the sign `sign`.
    pub fn new(basis: &ModalBasis, (q, rate): Coordinates, sign: f64) -> CrossingSearch {
        let highest = basis.omega.iter().copied().fold(1.0, f64::max);
        let motion = ModalMotion {
            basis: basis.clone(),
            q,
            rate,
        };
        CrossingSearch {
            sign,
            fourth: motion.fourth_derivative_bound(),
            clear: 0.0,
            reached: [0.0, motion.at(0.0)[1]],
            length: 1.0 / highest,
            tried: 0,
            separated: motion.separation_time(),
            motion,
        }
    }

    /// Searches up to `time`, or to the first zero.
    pub fn advance(&mut self, time: f64) -> Crossing {
        while self.clear < time && self.clear <= self.separated {
            self.tried += 1;
            if self.tried > MOST_INTERVALS {
                return Crossing::TooManyIntervals;
            }
            let h = self.length;
            let end = self.motion.at(self.clear + h);
            if self.has_no_zero(h, end) {
                self.length *= 2.0;
            } else if h > RESOLUTION {
                self.length *= 0.5;
                continue;
            } else if self.sign * end[0] < 0.0 {
                // One step of Newton's method reduces r to round-off.
                let back = (end[0] / end[1]).clamp(0.0, h);
                return Crossing::At(self.clear + h - back);
            }
            self.clear += h;
            self.reached = end;
        }
        Crossing::None
    }

    /// Whether the interval of length `h` after `clear` is proven to have no zero; `end` is r and r' at its end.
    fn has_no_zero(&self, h: f64, end: [f64; 2]) -> bool {
        let [r, rate] = self.reached.map(|x| self.sign * x);
        let [r_end, rate_end] = end.map(|x| self.sign * x);
        let (second, third) = (r + rate * h / 3.0, r_end - rate_end * h / 3.0);
        let bound = self.fourth * h * h * h * h;
        if self.clear == 0.0 {
            (3.0 * second).min(1.5 * third).min(r_end) > bound / 162.0
        } else {
            r.min(second).min(third).min(r_end) > bound / 384.0
        }
    }
}
