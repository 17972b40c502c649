//! Velocity-control: a damper of ratio zeta = 1/(2 beta) below the velocity beta, a constant force above it.

use crate::exact::{State, bisect};
use libm::{atan2, copysign, cos, exp, expm1, log1p, sin, sqrt};

/// The motion in the zone of the damper, or outside it; displacements and velocities are positive in the direction `d` = +-1.
#[derive(Debug, Clone)]
pub(super) enum Piece {
    /// From `x` with the velocity `v` and the acceleration `a` >= 0: from rest, or from the edge of the zone at -beta.
    Inside {
        zone: Zone,
        d: f64,
        x: f64,
        v: f64,
        a: f64,
    },
    /// From the velocity beta with the acceleration p: d X = -1 - p cos t + beta sin t.
    Outside { zone: Zone, d: f64, p: f64 },
}

impl Piece {
    pub fn release(x0: f64, beta: f64) -> Piece {
        Piece::Inside {
            zone: Zone::new(beta),
            d: copysign(1.0, -x0),
            x: -x0.abs(),
            v: 0.0,
            a: x0.abs(),
        }
    }
}

/// The damped oscillator X'' + 2 zeta X' + X = 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zone {
    beta: f64,
    zeta: f64,
    /// sqrt(abs(1 - zeta^2)).
    root: f64,
    underdamped: bool,
}

impl Zone {
    fn new(beta: f64) -> Zone {
        Zone {
            beta,
            zeta: 0.5 / beta,
            // 1 - zeta^2 in factors; 2 beta - 1 has no round-off near critical damping.
            root: sqrt((2.0 * beta - 1.0).abs()) * sqrt(2.0 * beta + 1.0) / (2.0 * beta),
            underdamped: 2.0 * beta > 1.0,
        }
    }

    /// The smaller of the two rates of decay of an overdamped zone; the other one is its inverse.
    fn slow(&self) -> f64 {
        1.0 / (self.zeta + self.root)
    }

    /// (f, g, g'), with the motions f from X = 1, V = 0 and g from X = 0, V = 1.
    ///
    /// For overdamped zones f and g are sums of positive terms, from critical damping to the smallest beta.
    fn motions(&self, t: f64) -> (f64, f64, f64) {
        if self.underdamped {
            let fade = exp(-self.zeta * t);
            let (c, s) = (cos(self.root * t), sin(self.root * t) / self.root);
            let (f, rate) = (c + self.zeta * s, c - self.zeta * s);
            (fade * f, fade * s, fade * rate)
        } else {
            let (slow, difference) = (self.slow(), 2.0 * self.root);
            let late = exp(-slow * t);
            let g = if difference == 0.0 {
                t * late
            } else {
                late * (-expm1(-difference * t) / difference)
            };
            (late + slow * g, g, exp(-(slow + difference) * t) - slow * g)
        }
    }

    /// Time of the largest velocity, from velocity `v` <= 0 and acceleration `a` >= 0; infinite if the velocity has no maximum.
    fn velocity_peak(&self, v: f64, a: f64) -> f64 {
        if self.underdamped {
            return atan2(self.root * a, v + self.zeta * a) / self.root;
        }
        let (slow_part, difference) = (v + self.slow() * a, 2.0 * self.root);
        if slow_part <= 0.0 {
            f64::INFINITY
        } else if difference == 0.0 {
            a / slow_part
        } else {
            log1p(difference * a / slow_part) / difference
        }
    }
}

impl super::Piece for Piece {
    fn at(&self, time: f64) -> State {
        match *self {
            Piece::Inside { zone, d, x, v, .. } => {
                let (f, g, rate) = zone.motions(time);
                let velocity = v * rate - x * g;
                State {
                    displacement: d * (x * f + v * g),
                    velocity: d * velocity,
                    // Without the clamp, round-off at the edge of the zone would give a force beyond the limit.
                    force: d * (velocity / zone.beta).clamp(-1.0, 1.0),
                }
            }
            Piece::Outside { zone, d, p } => {
                let (cos, sin) = (cos(time), sin(time));
                State {
                    displacement: d * (zone.beta * sin - p * cos - 1.0),
                    velocity: d * (p * sin + zone.beta * cos),
                    force: d,
                }
            }
        }
    }

    fn length(&self) -> f64 {
        match *self {
            // No event is missed: the first maximum of the velocity is the largest.
            Piece::Inside { zone, d, v, a, .. } => {
                let velocity = |t: f64| d * self.at(t).velocity;
                let peak = zone.velocity_peak(v, a);
                if peak.is_infinite() || velocity(peak) <= zone.beta {
                    return f64::INFINITY;
                }
                let [_, end] = bisect([0.0, peak], |t| velocity(t) > zone.beta);
                end
            }
            // p sin t + beta cos t = beta.
            Piece::Outside { zone, p, .. } => 2.0 * atan2(p, zone.beta),
        }
    }

    fn next(&self, length: f64) -> Piece {
        match *self {
            Piece::Inside { zone, d, .. } => Piece::Outside {
                zone,
                d,
                // From the displacement, which must not jump; round-off could make it negative.
                p: (-(1.0 + d * self.at(length).displacement)).max(0.0),
            },
            // The sliding motion is symmetric in time and ends at d X = p - 1. The direction of the next piece is the opposite one.
            Piece::Outside { zone, d, p } => Piece::Inside {
                zone,
                d: -d,
                x: 1.0 - p,
                v: -zone.beta,
                a: p,
            },
        }
    }
}
