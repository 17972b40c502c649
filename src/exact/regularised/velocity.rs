//! Velocity-control: a damper of ratio zeta = 1/(2 beta) below the velocity beta, a force that stands still above it.

use crate::exact::coulomb::State;
use libm::{atan2, copysign, cos, exp, expm1, log1p, sin, sqrt};

/// Within the zone of the damper, or outside it; lengths and velocities count positive in the direction `d` = +-1.
#[derive(Debug, Clone)]
pub(super) enum Piece {
    /// From `x` with the velocity `v` and the acceleration `a` >= 0: from rest, or in through -beta.
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
    rings: bool,
}

impl Zone {
    fn new(beta: f64) -> Zone {
        Zone {
            beta,
            zeta: 0.5 / beta,
            // 1 - zeta^2 in factors, of which 2 beta - 1 has no round-off near critical damping.
            root: sqrt((2.0 * beta - 1.0).abs()) * sqrt(2.0 * beta + 1.0) / (2.0 * beta),
            rings: 2.0 * beta > 1.0,
        }
    }

    /// The lesser of the two rates of decay where it does not ring; the other is its inverse.
    fn slow(&self) -> f64 {
        1.0 / (self.zeta + self.root)
    }

    /// (f, g, -f'): the motions from X = 1, V = 0 and from X = 0, V = 1, then g' = f - 2 zeta g.
    ///
    /// Where it does not ring they are sums of positive terms: at critical damping as for the least beta.
    fn motions(&self, t: f64) -> (f64, f64, f64) {
        if self.rings {
            let fade = exp(-self.zeta * t);
            let (c, s) = (cos(self.root * t), sin(self.root * t) / self.root);
            let (f, rate) = (c + self.zeta * s, c - self.zeta * s);
            (fade * f, fade * s, fade * rate)
        } else {
            let (slow, gap) = (self.slow(), 2.0 * self.root);
            let late = exp(-slow * t);
            let g = match gap {
                0.0 => t * late,
                _ => late * (-expm1(-gap * t) / gap),
            };
            (late + slow * g, g, exp(-(slow + gap) * t) - slow * g)
        }
    }

    /// When the velocity is largest, from velocity `v` <= 0 and acceleration `a` >= 0; infinite if it only decays.
    fn crest(&self, v: f64, a: f64) -> f64 {
        if self.rings {
            return atan2(self.root * a, v + self.zeta * a) / self.root;
        }
        let (left, gap) = (v + self.slow() * a, 2.0 * self.root);
        if left <= 0.0 {
            f64::INFINITY
        } else if gap == 0.0 {
            a / left
        } else {
            log1p(gap * a / left) / gap
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
                    // Round-off at the zone's edge must not show as a force beyond the limit.
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
            // No event is missed: the velocity rises to one crest, and if that stays within the zone so do all after
            // it, each less than the one before.
            Piece::Inside { zone, d, v, a, .. } => {
                let velocity = |t: f64| d * self.at(t).velocity;
                let crest = zone.crest(v, a);
                if crest.is_infinite() || velocity(crest) <= zone.beta {
                    return f64::INFINITY;
                }
                let (mut before, mut after) = (0.0, crest);
                loop {
                    let middle = before + 0.5 * (after - before);
                    if !(before < middle && middle < after) {
                        return after;
                    }
                    if velocity(middle) > zone.beta {
                        after = middle;
                    } else {
                        before = middle;
                    }
                }
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
                // From the displacement, which must not jump; at a graze round-off could make it negative.
                p: (-(1.0 + d * self.at(length).displacement)).max(0.0),
            },
            // The sliding motion is symmetric in time: out at d X = p - 1. Inside it is seen from the other side.
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
