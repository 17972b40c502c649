//! The peaks of an oscillator under two accelerations, turned by angles.

use super::part::{Oscillator, Part, Transitions};
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
    let oscillator = Oscillator {
        omega: 2.0 * PI / period,
        ratio,
    };
    let free = free_turn(ratio) / oscillator.omega;
    let each = |visit: &mut dyn FnMut(&[Part; 2])| {
        let mut walk = Walk {
            transitions: Transitions::new(oscillator),
            states: [[0.0; 2]; 2],
        };
        for piece in pieces {
            let length = piece.times[1] - piece.times[0];
            walk.advance(length, piece.accelerations, visit);
        }
        walk.advance(free, [rest, rest], visit);
    };
    // Few pieces are larger anywhere than the ends of all of them are.
    let mut peaks = Peaks::new();
    each(&mut |parts| peaks.see_end(parts));
    peaks.lower();
    each(&mut |parts| peaks.reach(parts));
    let scale = oscillator.omega * oscillator.omega;
    Some(peaks.peaks.into_iter().map(|peak| scale * peak).collect())
}

/// An oscillator under way in two directions.
struct Walk {
    transitions: Transitions,
    /// u and u' under each acceleration.
    states: [[f64; 2]; 2],
}

impl Walk {
    /// Goes on by `length` under accelerations that are straight from the first to the second ones, and shows each part of at most
    /// a radian.
    fn advance(
        &mut self,
        length: f64,
        [from, to]: [[f64; 2]; 2],
        visit: &mut dyn FnMut(&[Part; 2]),
    ) {
        let parts = (self.transitions.oscillator().omega * length).ceil();
        let h = length / parts;
        for part in 0..parts as usize {
            let motions = [0, 1].map(|i| {
                let at = |part: usize| from[i] + (to[i] - from[i]) * (part as f64 / parts);
                let ends = [at(part), at(part + 1)];
                self.transitions.part(self.states[i], h, ends)
            });
            visit(&motions);
            self.states = motions.map(|motion| motion.end());
        }
    }
}

/// The part of an end that is below its exact value, by round-off, for sure.
const BELOW: f64 = 1.0 - 1e-12;

/// The peaks for each angle.
struct Peaks {
    /// Cosine and sine of each angle.
    directions: Vec<[f64; 2]>,
    /// Largest |u| so far, or a value below it.
    peaks: Vec<f64>,
    /// The least of them.
    least: f64,
}

impl Peaks {
    fn new() -> Peaks {
        let directions: Vec<[f64; 2]> = directions().collect();
        Peaks {
            peaks: vec![0.0; directions.len()],
            directions,
            least: 0.0,
        }
    }

    /// Takes the end of a part into the peaks.
    fn see_end(&mut self, [one, other]: &[Part; 2]) {
        let [x, y] = [one, other].map(|part| part.end()[0]);
        if x.hypot(y) <= self.least {
            return;
        }
        for (peak, [c, s]) in self.peaks.iter_mut().zip(&self.directions) {
            *peak = peak.max((c * x + s * y).abs());
        }
        self.find_least();
    }

    /// Makes the peaks so far values below them.
    fn lower(&mut self) {
        self.peaks.iter_mut().for_each(|peak| *peak *= BELOW);
        self.find_least();
    }

    /// Takes the extremes of a part into the peaks.
    fn reach(&mut self, [one, other]: &[Part; 2]) {
        let (ends, sags) = ([one.ends(), other.ends()], [one.sag(), other.sag()]);
        let size = |end: usize| ends[0][end].hypot(ends[1][end]);
        if size(0).max(size(1)) + sags[0].hypot(sags[1]) <= self.least {
            return;
        }
        let pieces = [one.piece(), other.piece()];
        for (peak, [c, s]) in self.peaks.iter_mut().zip(&self.directions) {
            let end = |end: usize| (c * ends[0][end] + s * ends[1][end]).abs();
            if end(0).max(end(1)) + (c.abs() * sags[0] + s * sags[1]) > *peak {
                *peak = peak.max(pieces[0].plus(*c, &pieces[1], *s).peak());
            }
        }
        self.find_least();
    }

    fn find_least(&mut self) {
        self.least = self.peaks.iter().copied().fold(f64::INFINITY, f64::min);
    }
}
