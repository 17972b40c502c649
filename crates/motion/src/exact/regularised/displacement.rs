//! Displacement-control: in sticking, the friction spring adds 1/alpha to the stiffness; in sliding, the force is constant.

use crate::exact::State;
use libm::{atan, atan2, copysign, cos, hypot, sin, sqrt};

/// Sticking or sliding between two events.
#[derive(Debug, Clone)]
pub(super) enum Piece {
    /// Sticking from rest at `x` with the force `s`. With the unbalanced force q = x + s and omega^2 = 1 + 1/alpha,
    /// X = x - alpha q/(1 + alpha) (1 - cos(omega t)), S = s - q/(1 + alpha) (1 - cos(omega t)).
    Stick { alpha: f64, x: f64, s: f64 },
    /// Sliding in the direction `d` = +-1, with d X = -1 - p cos t + v sin t.
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

/// Two roots, so that neither the smallest nor the largest alpha leaves the range of double precision.
fn omega(alpha: f64) -> f64 {
    sqrt(1.0 + alpha) / sqrt(alpha)
}

/// The direction d of the force after rest at `x` under `s`, its distance from the limit in this direction, and the excess over
/// the limit without sliding.
///
/// The force turns half a period later, at s - 2 q/(1 + alpha). If it only reaches the limit, there is no sliding.
fn excess(alpha: f64, x: f64, s: f64) -> (f64, f64, f64) {
    let q = x + s;
    let d = copysign(1.0, -q);
    let distance = 1.0 - d * s;
    (d, distance, 2.0 * (q.abs() / (1.0 + alpha)) - distance)
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
            Piece::Stick { alpha, x, s } => {
                let (_, distance, excess) = excess(alpha, x, s);
                if excess > 0.0 {
                    // tan^2 of half the phase at S = d is (1 - cos)/(1 + cos), here without a difference for a small excess.
                    2.0 * atan(sqrt(distance) / sqrt(excess)) / omega(alpha)
                } else {
                    f64::INFINITY
                }
            }
            // The velocity becomes zero after at most half a period.
            Piece::Slip { p, v, .. } => atan2(v, -p),
        }
    }

    fn next(&self, _length: f64) -> Piece {
        match *self {
            Piece::Stick { alpha, x, s } => {
                let (d, distance, excess) = excess(alpha, x, s);
                let x = x + alpha * (d - s);
                Piece::Slip {
                    alpha,
                    d,
                    p: -(1.0 + d * x),
                    v: sqrt(alpha) * sqrt(1.0 + alpha) * sqrt(distance) * sqrt(excess),
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
