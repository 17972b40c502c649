//! Two rigid masses that collide with each law, from first touch to the end of the force: closed forms.
//!
//! Overlaps x are in the length l for which the elastic force at l is m v0^2/l: l = v0 sqrt(m/k) for the linear law and
//! l = (m v0^2/k_h)^(2/5) for those of the power 1.5. Speeds u are in v0, times in l/v0. At first touch x = 0, u = 1.

use libm::{acosh, atan2, exp, expm1, log1p, pow, sin, sinh, sqrt};

/// x'' = -(x + 2 xi x'), until the force is 0.
#[derive(Debug, Clone, Copy)]
pub struct Linear {
    /// xi.
    pub ratio: f64,
}

/// Time of the largest x of x'' + 2 xi x' + x = 0 from x = 0, x' = 1; the largest x is exp(-xi time).
fn peak_time(ratio: f64) -> f64 {
    let root = sqrt((1.0 - ratio).abs()) * sqrt(1.0 + ratio);
    if root == 0.0 {
        1.0
    } else if ratio < 1.0 {
        atan2(root, ratio) / root
    } else {
        acosh(ratio) / root
    }
}

/// [x, x'] of x'' + 2 xi x' + x = 0 from x = 0, x' = 1.
fn oscillation(ratio: f64, time: f64) -> [f64; 2] {
    let root = sqrt((1.0 - ratio).abs()) * sqrt(1.0 + ratio);
    let (angle, fade) = (root * time, exp(-ratio * time));
    let (sine, cosine) = if root == 0.0 {
        (time, 1.0)
    } else if ratio < 1.0 {
        (sin(angle) / root, libm::cos(angle))
    } else {
        (sinh(angle) / root, libm::cosh(angle))
    };
    [fade * sine, fade * (cosine - ratio * sine)]
}

impl Linear {
    /// u at the end over -1. The acceleration is 0 at twice the time of the peak.
    pub fn restitution(&self) -> f64 {
        exp(-self.ratio * self.duration())
    }

    /// Time of the end of the force; the overlap ends later if there is damping.
    pub fn duration(&self) -> f64 {
        2.0 * peak_time(self.ratio)
    }

    /// The largest x.
    pub fn overlap(&self) -> f64 {
        exp(-self.ratio * peak_time(self.ratio))
    }

    /// [x, u] at a time up to the end.
    pub fn state(&self, time: f64) -> [f64; 2] {
        oscillation(self.ratio, time)
    }
}

/// u' = -x^1.5 (1 + kappa u).
///
/// With the time out of it, u du/(1 + kappa u) = -x^1.5 dx: 2/5 x^2.5 + W(u) is constant,
/// W(u) = u/kappa - ln(1 + kappa u)/kappa^2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DampedHertz {
    /// kappa.
    pub damping: f64,
}

/// (z - ln(1 + z))/z^2, without a difference near z = 0.
pub(in crate::contact) fn lag(z: f64) -> f64 {
    if z.abs() > 0.25 {
        return (z - log1p(z)) / (z * z);
    }
    // 1/2 - z/3 + z^2/4 - ...; 0.25^26 is below round-off.
    (2..28)
        .rev()
        .fold(0.0, |sum, n| 1.0 / f64::from(n) - z * sum)
}

impl DampedHertz {
    /// u at the end over -1: W(-e) = W(1).
    pub fn restitution(&self) -> f64 {
        -self.speed(1.0, false)
    }

    /// The largest x.
    pub fn overlap(&self) -> f64 {
        pow(2.5 * lag(self.damping), 0.4)
    }

    /// u at the overlap (1 - p^2) times the largest, before it or after it.
    ///
    /// W(u) = W(1) (1 - (1 - p^2)^2.5). In |u| W is convex and rises from 0, so Newton's iteration from an upper bound falls to
    /// the root without passing it.
    pub fn speed(&self, p: f64, closing: bool) -> f64 {
        let part = -expm1(2.5 * log1p(-p * p));
        let (sign, level) = (if closing { 1.0 } else { -1.0 }, lag(self.damping) * part);
        let kappa = sign * self.damping;
        // W >= u^2/2 while parting. There 1 + kappa u > exp(-1 - kappa^2 W), too.
        let mut speed = if closing {
            1.0
        } else {
            let asymptote = -expm1(-1.0 - kappa * kappa * level) / -kappa;
            sqrt(2.0 * level).min(if kappa < 0.0 {
                asymptote
            } else {
                f64::INFINITY
            })
        };
        while speed > 0.0 {
            let excess = speed * speed * lag(kappa * speed) - level;
            let next = speed - excess * (1.0 + kappa * speed) / speed;
            // Not below: round-off ends the iteration.
            if !(next < speed && next > 0.0) {
                break;
            }
            speed = next;
        }
        sign * speed
    }
}

/// u' = -(x^1.5 + 2 xi x^0.25 u) for u > 0, u' = -x^1.5 for u < 0.
///
/// In y = x^1.25 and the time s with dtau = ds/(1.25 x^0.25) the approach is a linear oscillator, dy/ds = u,
/// du/ds = -(0.8 y + 1.6 xi u). The elastic energy 2/5 y^2 of the largest overlap comes back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzDashpot {
    /// xi.
    pub ratio: f64,
}

impl HertzDashpot {
    /// Damping ratio and frequency of the linear oscillator.
    fn oscillator(&self) -> [f64; 2] {
        let frequency = sqrt(0.8);
        [frequency * self.ratio, frequency]
    }

    /// u at the end over -1.
    pub fn restitution(&self) -> f64 {
        let [ratio, _] = self.oscillator();
        exp(-ratio * peak_time(ratio))
    }

    /// The largest x.
    pub fn overlap(&self) -> f64 {
        pow(self.restitution() / sqrt(0.8), 0.8)
    }

    /// s of the largest overlap.
    pub(in crate::contact) fn approach_length(&self) -> f64 {
        let [ratio, frequency] = self.oscillator();
        peak_time(ratio) / frequency
    }

    /// [x, u] at the part `p` of the approach, in s.
    pub fn approach(&self, p: f64) -> [f64; 2] {
        let [ratio, frequency] = self.oscillator();
        let [y, speed] = oscillation(ratio, p * peak_time(ratio));
        [pow((y / frequency).max(0.0), 0.8), speed]
    }
}
