//! Laws that are elastic between two parallel lines: bilinear, the pendulum, the impact that yields.

use super::{End, Line};
use crate::exact::events::phases::contact_phase::Phase;

/// A spring k1 between the lines k2 r + low and k2 r + high; a stop has it for r < 0 alone.
#[derive(Debug, Clone, Copy)]
pub struct Band {
    pub stiffness: [f64; 2],
    pub bounds: [f64; 2],
    /// Whether its elastic part has no force at t = 0, whatever r is.
    pub unbent: bool,
    pub is_stop: bool,
}

impl Band {
    /// Elastic, through this point.
    fn elastic(&self, [r, s]: [f64; 2]) -> Line {
        let [k1, k2] = self.stiffness;
        let way = |bound: f64, never: f64| match k1 > k2 {
            true => r + (k2 * r + bound - s) / (k1 - k2),
            false => never,
        };
        let [low, high] = self.bounds;
        let never = if self.is_stop { 0.0 } else { f64::INFINITY };
        Line {
            slope: k1,
            point: [r, s],
            ends: [way(low, f64::NEG_INFINITY), way(high, never)],
            phase: Phase::Closed,
            ..Line::open([0.0; 2])
        }
    }

    /// On a line, in this direction.
    fn yielding(&self, direction: f64) -> Line {
        let bound = self.bounds[usize::from(direction > 0.0)];
        let ends = match self.is_stop {
            true => [f64::NEG_INFINITY, 0.0],
            false => [f64::NEG_INFINITY, f64::INFINITY],
        };
        Line {
            slope: self.stiffness[1],
            point: [0.0, bound],
            direction,
            loss: [bound, 0.0],
            phase: Phase::Sliding(direction),
            ..Line::open(ends)
        }
    }

    pub fn start(&self, r: f64, force: Option<f64>) -> Line {
        if self.is_stop && r >= 0.0 {
            return Line::open([0.0, f64::INFINITY]);
        }
        if let Some(force) = force {
            return self.elastic([r, force]);
        }
        if self.unbent {
            return self.elastic([r, self.stiffness[1] * r]);
        }
        let elastic = self.elastic([0.0; 2]);
        let [low, high] = elastic.ends;
        match r {
            _ if r < low => self.yielding(-1.0),
            _ if r > high => self.yielding(1.0),
            _ => elastic,
        }
    }

    pub fn next(&self, line: &Line, end: End, r: f64) -> Line {
        match (line.phase, end) {
            (Phase::Open, _) => self.elastic([0.0; 2]),
            // The force of a stop ends.
            (_, End::High) if self.is_stop && line.ends[1] == 0.0 => {
                Line::open([0.0, f64::INFINITY])
            }
            (_, End::Low) => self.yielding(-1.0),
            (_, End::High) => self.yielding(1.0),
            (_, End::Turn) => {
                // It left the line here, without the round-off of the quotient.
                let elastic = self.elastic([r, line.force(r)]);
                let [low, high] = elastic.ends;
                let ends = if line.direction > 0.0 {
                    [low, r]
                } else {
                    [r, high]
                };
                Line { ends, ..elastic }
            }
        }
    }

    pub fn stored(&self, line: &Line, r: f64) -> f64 {
        if line.phase == Phase::Open {
            return 0.0;
        }
        let [k1, k2] = self.stiffness;
        let elastic_force = line.force(r) - k2 * r;
        let elastic = if k1 > k2 {
            elastic_force * elastic_force / (k1 - k2)
        } else {
            0.0
        };
        0.5 * (k2 * r * r + elastic)
    }
}
