//! Where r passes zero, with proof that it does so nowhere before.
//!
//! Over a stretch of length h, r differs from the cubic through its end values and slopes by at most
//! M s^2 (h - s)^2/24, s the way from its beginning and M = sum omega_k^4 (amplitude of mode k in r), which no |r''''|
//! exceeds. A cubic lies within its Bezier ordinates. So a stretch whose ordinates all lie on the expected side, by more
//! than M h^4/384, has no zero, however short a touch between two points might be; any other is halved. At the start
//! of a piece r = 0: there the same holds of r/s, with M h^4/162 and the ordinates of the quadratic.

use super::modes::{Basis, Coordinates};
use libm::{cos, hypot, sin};

/// Length below which r has passed zero or touched it.
const RESOLUTION: f64 = 1e-13;

/// Most stretches of a piece.
const MOST_STRETCHES: u32 = 1_000_000;

/// r from the start of a piece on.
#[derive(Debug, Clone)]
pub(super) struct Wave {
    basis: Basis,
    place: Vec<f64>,
    rate: Vec<f64>,
}

impl Wave {
    /// r and r' at `time` from the start of the piece.
    pub fn at(&self, time: f64) -> [f64; 2] {
        let (place, rate) = self.coordinates(time);
        let sum = |q: &[f64]| -> f64 { q.iter().zip(&self.basis.share).map(|(q, a)| q * a).sum() };
        [sum(&place), sum(&rate)]
    }

    /// Every coordinate and its rate at that time.
    pub fn coordinates(&self, time: f64) -> Coordinates {
        let starts = self.place.iter().zip(&self.rate).zip(&self.basis.omega);
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

    /// From when on r > 0 for good: the bars move apart and are further apart than all vibrations together reach.
    fn apart(&self) -> f64 {
        let mut reach = 0.0;
        let (mut gap, mut rate) = (0.0, 0.0);
        let starts = self.place.iter().zip(&self.rate);
        for ((q, p), (omega, a)) in starts.zip(self.basis.omega.iter().zip(&self.basis.share)) {
            if *omega == 0.0 {
                (gap, rate) = (gap + a * q, rate + a * p);
            } else {
                reach += a * hypot(*q, p / omega);
            }
        }
        if rate > 0.0 {
            (reach - gap) / rate
        } else {
            f64::INFINITY
        }
    }

    /// No |r''''| is larger.
    fn fourth(&self) -> f64 {
        let starts = self.place.iter().zip(&self.rate);
        let modes = self.basis.omega.iter().zip(&self.basis.share);
        starts
            .zip(modes)
            .map(|((q, p), (omega, a))| a * omega * omega * omega * hypot(q * omega, *p))
            .sum()
    }
}

/// What lies before a time asked for.
pub(super) enum Found {
    /// No zero.
    Clear,
    /// The first zero, at this time from the start of the piece.
    Event(f64),
    /// Too much to look through.
    Lost,
}

/// The search through one piece.
#[derive(Debug, Clone)]
pub(super) struct Search {
    pub wave: Wave,
    /// Sign of r in this piece.
    side: f64,
    fourth: f64,
    /// No zero up to here, where r and r' are these.
    clear: f64,
    reached: [f64; 2],
    /// Length of the next stretch to try, and how many were tried.
    stretch: f64,
    tried: u32,
    /// No zero from here on.
    apart: f64,
}

impl Search {
    /// From r = 0 on, to where r has the sign `side`.
    pub fn new(basis: &Basis, (place, rate): Coordinates, side: f64) -> Search {
        let highest = basis.omega.iter().copied().fold(1.0, f64::max);
        let wave = Wave {
            basis: basis.clone(),
            place,
            rate,
        };
        Search {
            side,
            fourth: wave.fourth(),
            clear: 0.0,
            reached: [0.0, wave.at(0.0)[1]],
            stretch: 1.0 / highest,
            tried: 0,
            apart: wave.apart(),
            wave,
        }
    }

    /// Goes on until there is no zero up to `time`, or finds the first.
    pub fn reach(&mut self, time: f64) -> Found {
        while self.clear < time && self.clear <= self.apart {
            self.tried += 1;
            if self.tried > MOST_STRETCHES {
                return Found::Lost;
            }
            let h = self.stretch;
            let ahead = self.wave.at(self.clear + h);
            if self.proven(h, ahead) {
                self.stretch *= 2.0;
            } else if h > RESOLUTION {
                self.stretch *= 0.5;
                continue;
            } else if self.side * ahead[0] < 0.0 {
                // One step of Newton's method, which leaves r at round-off.
                let back = (ahead[0] / ahead[1]).clamp(0.0, h);
                return Found::Event(self.clear + h - back);
            }
            self.clear += h;
            self.reached = ahead;
        }
        Found::Clear
    }

    fn proven(&self, h: f64, ahead: [f64; 2]) -> bool {
        let [r, rate] = self.reached.map(|x| self.side * x);
        let [r_end, rate_end] = ahead.map(|x| self.side * x);
        let (second, third) = (r + rate * h / 3.0, r_end - rate_end * h / 3.0);
        let bound = self.fourth * h * h * h * h;
        if self.clear == 0.0 {
            (3.0 * second).min(1.5 * third).min(r_end) > bound / 162.0
        } else {
            r.min(second).min(third).min(r_end) > bound / 384.0
        }
    }
}
