//! Displacement-control: sticking, the friction spring adds 1/alpha to the stiffness; sliding, the force stands still.

use crate::exact::coulomb::State;
use libm::{atan, atan2, copysign, cos, hypot, sin, sqrt};

/// Sticks from rest, or slides.
#[derive(Debug, Clone)]
pub(super) enum Piece {
    /// From rest at `x` with the force `s`. With q = x + s the unbalanced force and omega^2 = 1 + 1/alpha,
    /// X = x - alpha q/(1 + alpha) (1 - cos(omega t)), S = s - q/(1 + alpha) (1 - cos(omega t)).
    Stick { alpha: f64, x: f64, s: f64 },
    /// In the direction `d` = +-1, with d X = -1 - p cos t + v sin t.
    Slip { alpha: f64, d: f64, p: f64, v: f64 },
}

impl Piece {
    pub fn release(x0: f64, alpha: f64, force: f64) -> Piece {
        Piece::Stick {
            alpha,
            x: x0,
            s: force,
        }
    }
}

/// Roots apart, so that neither the least nor the largest alpha leaves the range.
fn omega(alpha: f64) -> f64 {
    sqrt(1.0 + alpha) / sqrt(alpha)
}

/// How far the force from rest would pass the limit on its way in the direction `d`, and how far it has to go there.
///
/// It turns half a period later, at s - 2 q/(1 + alpha): just reaching the limit it does not slide.
fn excess(alpha: f64, x: f64, s: f64) -> (f64, f64, f64) {
    let q = x + s;
    let d = copysign(1.0, -q);
    let way = 1.0 - d * s;
    (d, way, 2.0 * (q.abs() / (1.0 + alpha)) - way)
}

impl super::Piece for Piece {
    fn at(&self, time: f64) -> State {
        match *self {
            Piece::Stick { alpha, x, s } => {
                let (half, q) = (sin(0.5 * omega(alpha) * time), (x + s) / (1.0 + alpha));
                let fall = q * 2.0 * half * half;
                State {
                    displacement: x - alpha * fall,
                    velocity: -sqrt(alpha) * sqrt(1.0 + alpha) * q * sin(omega(alpha) * time),
                    force: s - fall,
                }
            }
            Piece::Slip { d, p, v, .. } => {
                let (cos, sin) = (cos(time), sin(time));
                State {
                    displacement: d * (v * sin - p * cos - 1.0),
                    velocity: d * (p * sin + v * cos),
                    force: d,
                }
            }
        }
    }

    fn length(&self) -> f64 {
        match *self {
            // tan^2 of half the phase at S = d: (1 - cos)/(1 + cos) without a difference near a graze.
            Piece::Stick { alpha, x, s } => match excess(alpha, x, s) {
                (_, way, excess) if excess > 0.0 => {
                    2.0 * atan(sqrt(way) / sqrt(excess)) / omega(alpha)
                }
                _ => f64::INFINITY,
            },
            // The velocity ends at zero, after less than half a period or just that.
            Piece::Slip { p, v, .. } => atan2(v, -p),
        }
    }

    fn next(&self, _length: f64) -> Piece {
        match *self {
            Piece::Stick { alpha, x, s } => {
                let (d, way, excess) = excess(alpha, x, s);
                let x = x + alpha * (d - s);
                Piece::Slip {
                    alpha,
                    d,
                    p: -(1.0 + d * x),
                    v: sqrt(alpha) * sqrt(1.0 + alpha) * sqrt(way) * sqrt(excess),
                }
            }
            Piece::Slip { alpha, d, p, v } => Piece::Stick {
                alpha,
                x: d * (hypot(p, v) - 1.0),
                s: d,
            },
        }
    }
}
