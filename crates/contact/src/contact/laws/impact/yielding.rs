//! Two rigid masses that collide with a spring that yields: closed forms.

use super::RigidImpact;
use super::rigid_impact::Duration;
use libm::{acos, asin, atan, sqrt};
use std::f64::consts::FRAC_PI_2;

/// A spring k up to Fy, then with another stiffness.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct Yielding {
    pub(in crate::contact) stiffness: f64,
    pub(in crate::contact) yield_force: f64,
    /// The stiffness after yielding, >= 0.
    pub(in crate::contact) after: f64,
}

/// The masses where they turn.
struct Turn {
    overlap: f64,
    force: f64,
    time: f64,
    /// Whether the spring has yielded.
    yielded: bool,
}

impl Yielding {
    /// From first touch with the speed v to the largest overlap: m v^2/2 is the work of the spring.
    fn turn(&self, mass: f64, speed: f64) -> Turn {
        let (k, soft, limit) = (self.stiffness, self.after, self.yield_force);
        let omega = sqrt(k / mass);
        if mass * speed * speed <= limit * limit / k {
            return Turn {
                overlap: speed / omega,
                force: k * speed / omega,
                time: FRAC_PI_2 / omega,
                yielded: false,
            };
        }
        // Twice the energy left at Fy; x beyond it: soft x^2 + 2 Fy x = rest.
        let rest = mass * speed * speed - limit * limit / k;
        let beyond = rest / (limit + sqrt(limit * limit + soft * rest));
        let momentum = sqrt(mass * rest);
        let time = match soft > 0.0 {
            true => atan(momentum * sqrt(soft / mass) / limit) / sqrt(soft / mass),
            false => momentum / limit,
        };
        Turn {
            overlap: limit / k + beyond,
            force: limit + soft * beyond,
            time: asin(limit / (k * speed / omega)) / omega + time,
            yielded: true,
        }
    }

    /// Where it unloads with k to a gap that stays.
    pub(in crate::contact) fn permanent(&self, mass: f64, speed: f64) -> RigidImpact {
        let turn = self.turn(mass, speed);
        let omega = sqrt(self.stiffness / mass);
        let restitution = match turn.yielded {
            true => turn.force / (omega * mass * speed),
            false => 1.0,
        };
        RigidImpact {
            restitution,
            duration: Duration::Known(turn.time + FRAC_PI_2 / omega),
            overlap: turn.overlap,
        }
    }

    /// Where it unloads with k to the line of the second stiffness through 0, and along it.
    pub(in crate::contact) fn returning(&self, mass: f64, speed: f64) -> RigidImpact {
        let turn = self.turn(mass, speed);
        let omega = sqrt(self.stiffness / mass);
        if !turn.yielded {
            return RigidImpact {
                restitution: 1.0,
                duration: Duration::Known(2.0 * turn.time),
                overlap: turn.overlap,
            };
        }
        // With k over the width Fy/k, from rest.
        let width = self.yield_force / self.stiffness;
        let length = turn.force / self.stiffness;
        let first = acos((length - width) / length) / omega;
        let parting = omega * sqrt(width * (2.0 * length - width));
        // Along the line from the overlap left to 0.
        let soft = sqrt(self.after / mass);
        let left = turn.overlap - width;
        let second = atan(left * soft / parting) / soft;
        let end = sqrt(parting * parting + soft * soft * left * left);
        RigidImpact {
            restitution: end / speed,
            duration: Duration::Known(turn.time + first + second),
            overlap: turn.overlap,
        }
    }
}
