//! The peaks of an oscillator under two accelerations, turned by angles.

use super::piece::{Oscillator, Piece};
use super::{free_turn, is_valid};
use libm::{cos, sin};
use std::f64::consts::PI;

/// Number of angles, 1 degree apart.
pub const ANGLES: usize = 180;

/// Cosine and sine of each angle.
pub fn directions() -> impl Iterator<Item = [f64; 2]> {
    (0..ANGLES).map(|degrees| {
        let angle = degrees as f64 * (PI / ANGLES as f64);
        [cos(angle), sin(angle)]
    })
}

/// A time in which both accelerations are straight.
pub struct StraightPiece {
    /// Start and end.
    pub times: [f64; 2],
    /// Both accelerations at the start and at the end.
    pub accelerations: [[f64; 2]; 2],
}

/// The pseudo-acceleration of the sum of both accelerations times cosine and sine, for each angle; the exact peaks as of `spectrum`,
/// for accelerations that are `rest` after the pieces. `None` as of `spectrum`.
pub fn turned_responses(
    pieces: &[StraightPiece],
    rest: [f64; 2],
    [period, ratio]: [f64; 2],
) -> Option<Vec<f64>> {
    let (first, last) = (pieces.first()?, pieces.last()?);
    if !is_valid(period, ratio, last.times[1] - first.times[0]) {
        return None;
    }
    let omega = 2.0 * PI / period;
    let directions: Vec<[f64; 2]> = directions().collect();
    let mut walk = Walk {
        oscillator: Oscillator { omega, ratio },
        states: [[0.0; 2]; 2],
        peaks: vec![0.0; directions.len()],
        directions,
        least: 0.0,
    };
    for piece in pieces {
        walk.advance(piece.times[1] - piece.times[0], piece.accelerations);
    }
    walk.advance(free_turn(ratio) / omega, [rest, rest]);
    let scale = omega * omega;
    Some(walk.peaks.into_iter().map(|peak| scale * peak).collect())
}

/// An oscillator under way in two directions.
struct Walk {
    oscillator: Oscillator,
    /// u and u' under each acceleration.
    states: [[f64; 2]; 2],
    /// Cosine and sine of each angle.
    directions: Vec<[f64; 2]>,
    /// Largest |u| so far for each angle.
    peaks: Vec<f64>,
    /// The least of them.
    least: f64,
}

impl Walk {
    /// Goes on by `length` under accelerations that are straight from the first to the second ones.
    fn advance(&mut self, length: f64, [from, to]: [[f64; 2]; 2]) {
        let parts = (self.oscillator.omega * length).ceil();
        let h = length / parts;
        for part in 0..parts as usize {
            let pieces = [0, 1].map(|i| {
                let at = |part: usize| from[i] + (to[i] - from[i]) * (part as f64 / parts);
                let ends = [at(part), at(part + 1)];
                Piece::new(self.oscillator, self.states[i], h, ends)
            });
            self.reach(&pieces, self.oscillator.omega * h);
            self.states = pieces.map(|piece| [piece.u(1.0), piece.v(1.0) / h]);
        }
    }

    /// Takes the extremes of a piece into the peaks.
    fn reach(&mut self, [one, other]: &[Piece; 2], turn: f64) {
        let (ends, sags) = ([one.ends(), other.ends()], [one.sag(turn), other.sag(turn)]);
        let size = |end: usize| ends[0][end].hypot(ends[1][end]);
        if size(0).max(size(1)) + sags[0].hypot(sags[1]) <= self.least {
            return;
        }
        for (peak, [c, s]) in self.peaks.iter_mut().zip(&self.directions) {
            let end = |end: usize| (c * ends[0][end] + s * ends[1][end]).abs();
            if end(0).max(end(1)) + (c.abs() * sags[0] + s * sags[1]) > *peak {
                *peak = peak.max(one.plus(*c, other, *s).peak());
            }
        }
        let least = self.peaks.iter().copied();
        self.least = least.fold(f64::INFINITY, f64::min);
    }
}
