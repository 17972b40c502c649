//! Laws that act on one side of a gap: the gap that yields, the restrainer.

use super::{End, KEPT, Line};
use crate::contact::OneSided as Spring;
use crate::exact::events::phases::contact_phase::Phase;

/// F = sign S over d = sign r + shift: k (d - s) up to Fy (1 - eta) + eta k d. What it keeps is s.
#[derive(Debug, Clone, Copy)]
pub struct OneSided(pub Spring);

impl OneSided {
    /// d at r, and r at d.
    fn deflection(&self, r: f64) -> f64 {
        self.0.sign * r + self.0.shift
    }

    fn r(&self, d: f64) -> f64 {
        self.0.sign * (d - self.0.shift)
    }

    /// A line through d and F, between these d, in this direction of d.
    fn line(&self, slope: f64, [d, force]: [f64; 2], ends: [f64; 2], direction: f64) -> Line {
        let ends_in_r = ends.map(|d| self.r(d));
        let ends = if self.0.sign > 0.0 {
            ends_in_r
        } else {
            [ends_in_r[1], ends_in_r[0]]
        };
        Line {
            slope,
            point: [self.r(d), self.0.sign * force],
            // No negative zero.
            direction: if direction == 0.0 {
                0.0
            } else {
                self.0.sign * direction
            },
            ..Line::open(ends)
        }
    }

    fn open(&self, set: f64) -> Line {
        let ends = [f64::NEG_INFINITY, set];
        self.line(0.0, [0.0; 2], ends, 0.0).keeping(set)
    }

    /// Without a force, while s comes back with d.
    fn following(&self, d: f64) -> Line {
        self.line(0.0, [0.0; 2], [0.0, f64::INFINITY], -1.0)
            .keeping(d)
    }

    fn elastic(&self, set: f64) -> Line {
        let (k, eta) = (self.0.stiffness, self.0.hardening);
        let end = match eta < 1.0 {
            true => self.0.yield_force / k + set / (1.0 - eta),
            false => f64::INFINITY,
        };
        let line = self.line(k, [set, 0.0], [set, end], 0.0).keeping(set);
        Line {
            phase: Phase::Closed,
            ..line
        }
    }

    fn yielding(&self) -> Line {
        let (k, eta) = (self.0.stiffness, self.0.hardening);
        let ends = [f64::NEG_INFINITY, f64::INFINITY];
        let start = self.0.yield_force * (1.0 - eta);
        Line {
            loss: [0.0, 1.0 - eta],
            phase: Phase::Sliding(self.0.sign),
            ..self.line(eta * k, [0.0, start], ends, 1.0)
        }
    }

    pub fn start(&self, r: f64, force: Option<f64>) -> Line {
        let d = self.deflection(r);
        if let Some(force) = force.filter(|force| *force != 0.0) {
            return self.elastic(d - self.0.sign * force / self.0.stiffness);
        }
        match d {
            _ if d <= 0.0 => self.open(0.0),
            _ if self.0.hardening < 1.0 && self.0.stiffness * d > self.0.yield_force => {
                self.yielding()
            }
            _ => self.elastic(0.0),
        }
    }

    pub fn next(&self, line: &Line, end: End, r: f64) -> Line {
        let d = self.deflection(r);
        let outwards = (end == End::Low) == (self.0.sign > 0.0);
        let [set, ..] = line.kept;
        match (line.phase, end) {
            (Phase::Open, End::Turn) => self.elastic(d),
            (Phase::Open, _) if outwards => self.open(0.0),
            (Phase::Open, _) => self.elastic(set),
            (Phase::Closed, _) if !outwards => self.yielding(),
            (Phase::Closed, _) if self.0.returns && set > 0.0 => self.following(set),
            (Phase::Closed, _) => self.open(set),
            (Phase::Sliding(_), _) => {
                self.elastic(d - self.0.sign * line.force(r) / self.0.stiffness)
            }
        }
    }

    pub fn stored(&self, line: &Line, r: f64) -> f64 {
        let force = line.force(r);
        0.5 * force * force / self.0.stiffness
    }
}

impl Line {
    fn keeping(self, set: f64) -> Line {
        let mut kept = [0.0; KEPT];
        kept[0] = set;
        Line { kept, ..self }
    }
}
