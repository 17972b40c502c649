//! Elastic response spectra of an acceleration, and its Arias intensity.
//!
//! The acceleration is straight between its points, so the motion of an oscillator is known exactly (see `part` and `piece`).
//!
//! The peak is the exact one, also between the points. The largest value at the points, which many programs print, is below it by
//! up to about omega^2 dt^2/8 of the peak.

mod part;
mod piece;
mod turned;

pub use turned::ANGLES;
pub(super) use turned::{StraightPiece, directions, turned_responses};

use crate::system::structure::Table;
use part::{Oscillator, Part, Transitions};
use std::f64::consts::PI;

/// The largest response of one oscillator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ordinate {
    /// Period of the oscillator without damping.
    pub period: f64,
    /// Largest |u|, u relative to the ground: the spectral displacement.
    pub displacement: f64,
    /// When it is reached first.
    pub time: f64,
}

impl Ordinate {
    /// 2 pi/period times the displacement.
    pub fn pseudo_velocity(&self) -> f64 {
        2.0 * PI / self.period * self.displacement
    }

    /// (2 pi/period)^2 times the displacement.
    pub fn pseudo_acceleration(&self) -> f64 {
        2.0 * PI / self.period * self.pseudo_velocity()
    }
}

/// Radians of the oscillators in the whole acceleration up to which a spectrum is computed.
const MOST: f64 = 1e8;

/// The response spectrum of a ground acceleration for a damping ratio: an ordinate for each period.
///
/// The oscillator is at rest at the first point. The response after the last point counts, too.
///
/// `None` unless 0 <= ratio < 1, the periods are > 0 and none is so short that the acceleration has more than 1e8/(2 pi) of them.
pub fn spectrum(acceleration: &Table, periods: &[f64], ratio: f64) -> Option<Vec<Ordinate>> {
    let ordinate = |period: &f64| {
        let times = acceleration.times();
        let valid = is_valid(*period, ratio, times[times.len() - 1] - times[0]);
        valid.then(|| ordinate(acceleration, *period, ratio))
    };
    periods.iter().map(ordinate).collect()
}

/// Whether an oscillator is one, and its motion for so long not too many turns.
fn is_valid(period: f64, ratio: f64, length: f64) -> bool {
    let turns = 2.0 * PI / period * length;
    period > 0.0 && period.is_finite() && turns <= MOST && (0.0..1.0).contains(&ratio)
}

/// Radians after the last point in which the largest later response is reached.
///
/// Extremes follow one another by pi/omega_d on alternate sides of the rest position and fall, so the largest one after the last point
/// is one of the first two. If they are far apart, the motion dies before: exp(-80) of it is left.
fn free_turn(ratio: f64) -> f64 {
    (2.0 * PI / (1.0 - ratio * ratio).sqrt()).min(80.0)
}

/// The response of one oscillator.
fn ordinate(acceleration: &Table, period: f64, ratio: f64) -> Ordinate {
    let (times, values) = (acceleration.times(), acceleration.values());
    let omega = 2.0 * PI / period;
    let mut walk = Walk {
        transitions: Transitions::new(Oscillator { omega, ratio }),
        time: times[0],
        state: [0.0; 2],
        peak: [0.0, times[0]],
    };
    for i in 1..times.len() {
        walk.advance(times[i], values[i - 1], values[i]);
    }
    let (last, value) = (times[times.len() - 1], values[values.len() - 1]);
    walk.advance(last + free_turn(ratio) / omega, value, value);
    let [displacement, time] = walk.peak;
    Ordinate {
        period,
        displacement,
        time,
    }
}

/// An oscillator under way.
struct Walk {
    transitions: Transitions,
    time: f64,
    /// u and u'.
    state: [f64; 2],
    /// Largest |u| so far and its time.
    peak: [f64; 2],
}

impl Walk {
    /// Goes on to the time `to` under an acceleration that is straight from `a0` to `a1`.
    fn advance(&mut self, to: f64, a0: f64, a1: f64) {
        let (from, length) = (self.time, to - self.time);
        let parts = (self.transitions.oscillator().omega * length).ceil();
        for part in 0..parts as usize {
            let at = |part: usize| a0 + (a1 - a0) * (part as f64 / parts);
            let h = length / parts;
            let accelerations = [at(part), at(part + 1)];
            let motion = self.transitions.part(self.state, h, accelerations);
            self.time = from + length * (part as f64 / parts);
            self.reach(&motion, h);
            self.state = motion.end();
        }
        self.time = to;
    }

    /// Takes the extremes of a part into the peak.
    fn reach(&mut self, part: &Part, h: f64) {
        if part.bound() <= self.peak[0] {
            return;
        }
        let piece = part.piece();
        let [first, second] = piece.extremes();
        for tau in [first, second, Some(1.0)].into_iter().flatten() {
            let u = piece.u(tau).abs();
            if u > self.peak[0] {
                self.peak = [u, self.time + tau * h];
            }
        }
    }
}

/// The Arias intensity pi/(2 g) times the integral of a^2 over the points `[Arias 1970]`; `gravity` in the unit of length of a.
///
/// The integral is the trapezium rule of a^2, as the programs of the field have it. For a record sampled finely enough it is the
/// intensity of the motion; the integral of the squared straight lines is smaller, because chords cut the peaks off.
pub fn arias(acceleration: &Table, gravity: f64) -> f64 {
    let (t, a) = (acceleration.times(), acceleration.values());
    let area = |i: usize| (t[i] - t[i - 1]) * (a[i - 1] * a[i - 1] + a[i] * a[i]) / 2.0;
    PI / (2.0 * gravity) * (1..t.len()).map(area).sum::<f64>()
}

#[cfg(test)]
mod tests;
