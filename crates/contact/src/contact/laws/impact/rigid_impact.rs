//! Two rigid masses that collide with a law of impact, from first touch to the end of the force.
//!
//! They are free but for the law: m dv/dt = -F with m = m1 m2/(m1 + m2), v = ddelta/dt, from delta = 0, v = v0. The restitution
//! that a law achieves is not the target from which its damping is computed.

use super::collision::{DampedHertz, HertzDashpot, Linear};
use libm::{cosh, exp, pow, sinh, sqrt};
use std::f64::consts::{FRAC_PI_2, PI};

/// What a collision gives.
///
/// On the spring it lasts half a period and gives all back; with Hunt and Crossley's law and the target 1/2, more than the
/// target remains:
///
/// ```
/// use slipgap_contact::contact::impact::HuntCrossley;
/// use slipgap_contact::contact::{ContactLaw, ImpactSpring};
///
/// let spring = ContactLaw::ImpactSpring(ImpactSpring { stiffness: 4.0 });
/// let impact = spring.collision(1.0, 3.0).expect("a law of impact");
/// assert_eq!((impact.restitution, impact.overlap), (1.0, 1.5));
/// assert_eq!(impact.duration(), std::f64::consts::FRAC_PI_2);
///
/// let law = ContactLaw::HuntCrossley(HuntCrossley::new(4.0, 0.5));
/// let impact = law.collision(1.0, 3.0).expect("a law of impact");
/// assert!((impact.restitution - 0.662).abs() < 1e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidImpact {
    /// Speed after the collision over that before it.
    pub restitution: f64,
    /// The largest overlap.
    pub overlap: f64,
    pub(in crate::contact) duration: Duration,
}

/// Time during which there is a force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::contact) enum Duration {
    Known(f64),
    /// In a unit of time; an integral, which takes thousands of times as long as the rest.
    DampedHertz(DampedHertz, f64),
    /// The same.
    HertzDashpot(HertzDashpot, f64),
}

/// Time in which the law of Hertz without damping brings x from 0 to 1, or back, at the speed 2/sqrt 5:
/// the integral of (1 - x^2.5)^(-1/2) over 0..1, sqrt(pi)/2.5 gamma(0.4)/gamma(0.9).
const QUARTER: f64 = 1.471_637_592_162_352;

impl RigidImpact {
    /// With the spring k and a dashpot of this damping ratio, for m = m1 m2/(m1 + m2) of the bodies and the closing speed v0.
    pub(in crate::contact) fn linear(k: f64, ratio: f64, mass: f64, speed: f64) -> RigidImpact {
        of_linear(ratio).in_scales(speed * sqrt(mass / k), speed)
    }

    /// With k_h delta^1.5 (1 + damping ddelta/v0).
    pub(in crate::contact) fn hertz(k_h: f64, damping: f64, mass: f64, speed: f64) -> RigidImpact {
        of_damped_hertz(damping).in_scales(power_length(k_h, mass, speed), speed)
    }

    /// With k_h delta^1.5 and, while approaching, a dashpot of this damping ratio.
    pub(in crate::contact) fn dashpot(k_h: f64, ratio: f64, mass: f64, speed: f64) -> RigidImpact {
        of_dashpot(ratio).in_scales(power_length(k_h, mass, speed), speed)
    }

    /// Time during which there is a force.
    pub fn duration(&self) -> f64 {
        match self.duration {
            Duration::Known(time) => time,
            Duration::DampedHertz(collision, unit) => collision.duration() * unit,
            Duration::HertzDashpot(collision, unit) => collision.duration() * unit,
        }
    }

    /// From scales of this length and the closing speed.
    fn in_scales(self, length: f64, speed: f64) -> RigidImpact {
        let unit = length / speed;
        RigidImpact {
            restitution: self.restitution,
            overlap: self.overlap * length,
            duration: match self.duration {
                Duration::Known(time) => Duration::Known(time * unit),
                Duration::DampedHertz(collision, _) => Duration::DampedHertz(collision, unit),
                Duration::HertzDashpot(collision, _) => Duration::HertzDashpot(collision, unit),
            },
        }
    }
}

/// The scale of length of the laws of the power 1.5.
fn power_length(k_h: f64, mass: f64, speed: f64) -> f64 {
    pow(mass / k_h * (speed * speed), 0.4)
}

fn of_linear(ratio: f64) -> RigidImpact {
    let collision = Linear { ratio };
    RigidImpact {
        restitution: collision.restitution(),
        overlap: collision.overlap(),
        duration: Duration::Known(collision.duration()),
    }
}

fn of_damped_hertz(damping: f64) -> RigidImpact {
    let collision = DampedHertz { damping };
    RigidImpact {
        restitution: collision.restitution(),
        overlap: collision.overlap(),
        duration: Duration::DampedHertz(collision, 1.0),
    }
}

fn of_dashpot(ratio: f64) -> RigidImpact {
    let collision = HertzDashpot { ratio };
    RigidImpact {
        restitution: collision.restitution(),
        overlap: collision.overlap(),
        duration: Duration::HertzDashpot(collision, 1.0),
    }
}

impl DampedHertz {
    fn duration(&self) -> f64 {
        let overlap = self.overlap();
        // dtau = dx/u with x = overlap (1 - p^2).
        let branch = |closing| integral(|p| 2.0 * overlap * p / self.speed(p, closing).abs());
        branch(true) + branch(false)
    }
}

impl HertzDashpot {
    fn duration(&self) -> f64 {
        let overlap = self.overlap();
        let length = self.approach_length();
        let approach = integral(|p| length / (1.25 * pow(self.approach(p)[0], 0.25)));
        approach + QUARTER * sqrt(1.25) / pow(overlap, 0.25)
    }
}

/// The integral over 0..1 by the double exponential rule, which needs no smoothness at the ends.
pub(in crate::contact) fn integral(f: impl Fn(f64) -> f64) -> f64 {
    let step = 1.0 / 64.0;
    let mut sum = 0.0;
    for k in -256..=256 {
        let t = step * f64::from(k);
        // p = (1 + tanh z)/2, without a difference at either end.
        let z = FRAC_PI_2 * sinh(t);
        let share = |z: f64| 1.0 / (1.0 + exp(-2.0 * z));
        let (p, rest) = (share(z), share(-z));
        let weight = PI * cosh(t) * p * rest;
        if weight > 0.0 {
            sum += weight * f(p);
        }
    }
    sum * step
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::impact::*;
    use crate::contact::{
        ContactLaw, ContactResponse, Flexibility, StepFlexibility, StoredEnergy, Trial,
    };
    use crate::lane::Lane;

    fn law(name: &str, k: f64, e: f64, m: f64) -> ContactLaw {
        match name {
            "kelvin-voigt" => ContactLaw::KelvinVoigt(KelvinVoigt::new(k, e, m)),
            "hertz" => ContactLaw::Hertz(Hertz { stiffness: k }),
            "hertz-damp" => ContactLaw::HertzDamp(HertzDamp::new(k, e)),
            "hunt-crossley" => ContactLaw::HuntCrossley(HuntCrossley::new(k, e)),
            "ye" => ContactLaw::Ye(Ye::new(k, e)),
            "jankowski" => ContactLaw::Jankowski(Jankowski::new(k, e, m)),
            _ => panic!("{name}"),
        }
    }

    const NAMES: [&str; 6] = [
        "kelvin-voigt",
        "hertz",
        "hertz-damp",
        "hunt-crossley",
        "ye",
        "jankowski",
    ];

    #[test]
    fn collisions_are_those_of_the_independent_program() {
        let text = include_str!("../../../../../../tests/data/laws.json");
        let rows: Vec<serde_json::Value> = serde_json::from_str(text).unwrap();
        assert_eq!(rows.len(), 72);
        for row in rows {
            let number = |key: &str| row[key].as_f64().unwrap();
            let name = row["law"].as_str().unwrap();
            let law = law(name, number("k"), number("target"), number("m"));
            let found = law.collision(number("m"), number("v0")).unwrap();
            for (key, value) in [
                ("restitution", found.restitution),
                ("duration", found.duration()),
                ("overlap", found.overlap),
            ] {
                // Of the program: that of its two tolerances at most.
                assert!(
                    (value / number(key) - 1.0).abs() < number("difference") + 1e-14,
                    "{row} {key} {value}"
                );
            }
        }
    }

    #[test]
    fn damping_that_vanishes_leaves_the_elastic_collision() {
        for damping in [0.0, 1e-300, 1e-12, 1e-9] {
            let hertz = of_damped_hertz(damping);
            // e = 1 - 2/3 kappa + ...; T and the overlap change by the order of kappa, too.
            assert!(
                (hertz.restitution - 1.0 + 2.0 / 3.0 * damping).abs() < 1e-15,
                "{damping} {hertz:?}"
            );
            assert!((hertz.overlap - pow(1.25, 0.4)).abs() < 1e-15 + damping);
            assert!((hertz.duration() - 2.0 * QUARTER * pow(1.25, 0.4)).abs() < 1e-14 + damping);
        }
        // Over the whole range of kappa: W(-e) = W(1).
        for exponent in -12..=12 {
            let kappa = pow(10.0, f64::from(exponent) / 2.0);
            let e = of_damped_hertz(kappa).restitution;
            assert!(e < 1.0 && e * kappa <= 1.0);
            if kappa * e < 0.9 {
                let both = kappa * (1.0 + e) - libm::log1p(kappa) + libm::log1p(-kappa * e);
                assert!(both.abs() < 4.0 * f64::EPSILON * kappa, "{kappa} {both}");
            }
        }
        // An overdamped dashpot has no other branch at the critical damping.
        let [below, at, above] =
            [1.0 - 1e-9, 1.0, 1.0 + 1e-9].map(|ratio| of_linear(ratio).restitution);
        assert!((at - libm::exp(-2.0)).abs() < 1e-15);
        assert!((below - at).abs() < 1e-8 && (above - at).abs() < 1e-8 && below > at && at > above);
        let law = ContactLaw::Rigid(Rigid {
            restitution: 0.7,
            impulses: true,
        });
        let rigid = law.collision(2.0, 3.0).unwrap();
        assert_eq!(
            rigid,
            RigidImpact {
                restitution: 0.7,
                overlap: 0.0,
                duration: Duration::Known(0.0)
            }
        );
    }

    #[test]
    fn loops_of_figures_enclose_the_energy_lost() {
        for name in NAMES {
            for target in [0.3, 0.7, 1.0] {
                let law = law(name, 20.0, target, 1.0);
                let (points, _) = law.cycle(0.3);
                // The speed with the largest overlap 0.3, m = 1.
                let unit = law.collision(1.0, 1.0).unwrap();
                let speed = if name == "kelvin-voigt" {
                    0.3 / unit.overlap
                } else {
                    pow(0.3 / unit.overlap, 1.25)
                };
                let lost = 0.5 * speed * speed * (1.0 - unit.restitution * unit.restitution);
                let area: f64 = points
                    .windows(2)
                    .map(|w| 0.5 * (w[0][1] + w[1][1]) * (w[1][0] - w[0][0]))
                    .sum();
                assert!(
                    (area - lost).abs() < 2e-3 * 0.5 * speed * speed,
                    "{name} {target} {area} {lost}"
                );
                assert!(points.iter().all(|[_, s]| *s <= 0.0));
                let least = points.iter().map(|[r, _]| *r).fold(0.0, f64::min);
                assert!((least + 0.3).abs() < 1e-3, "{name} {least}");
                assert_eq!(law.stored_energy(0.1, 0.0), 0.0);
            }
        }
    }

    /// A collision by the constant average acceleration method for one rigid mode, from a gap: speed after it over that before
    /// it, time with a force, largest overlap, and the energy that the law dissipates less that lost.
    fn stepped(law: &ContactLaw, [mass, speed, gap]: [f64; 3], dt: f64) -> [f64; 4] {
        let end = Flexibility {
            h: Lane([0.25 * dt * dt / mass]),
            h_rate: Lane([0.5 * dt / mass]),
        };
        let on = StepFlexibility {
            start: end,
            end,
            dt: Lane([dt]),
            by_impulse: false,
        };
        let mut running = ContactLaw::running(&[*law], &[on; 2]);
        let [mut r, mut v, mut s] = [gap, -speed, 0.0];
        let (mut time, mut least, mut lost) = (0.0, 0.0_f64, 0.0);
        for _ in 0..100_000 {
            let trial = Trial {
                displacement: Lane([r]),
                velocity: Lane([v]),
                force: Lane([s]),
                change: Lane([dt * v]),
                rate: Lane([v]),
            };
            let Lane([next]) = running.force(0, &trial);
            let before = r;
            r += dt * v - end.h.0[0] * (s + next);
            v -= end.h_rate.0[0] * (s + next);
            lost += 0.5 * (s + next) * (r - before)
                - (law.stored_energy(r, next) - law.stored_energy(before, s));
            s = next;
            least = least.min(r);
            if s < 0.0 {
                time += dt;
            } else if v > 0.0 && r > 0.0 {
                return [
                    v / speed,
                    time,
                    -least,
                    lost - 0.5 * mass * (speed * speed - v * v),
                ];
            }
        }
        panic!("{law:?} does not separate")
    }

    #[test]
    fn steps_converge_to_the_collision() {
        for name in NAMES {
            for target in [0.2, 0.6, 0.9] {
                let law = law(name, 300.0, target, 0.7);
                let exact = law.collision(0.7, 2.5).unwrap();
                for n in [100.0, 400.0, 1600.0, 6400.0] {
                    let dt = exact.duration() / n;
                    let [restitution, duration, overlap, energy] =
                        stepped(&law, [0.7, 2.5, 0.0123], dt);
                    // The force jumps at first touch, or rises as steeply as the fourth root: order 1. The others have
                    // continuous slopes: order 2.
                    let error = match name {
                        "kelvin-voigt" | "jankowski" => 2.0 / n,
                        _ => 5.0 / (n * n),
                    };
                    let close = |a: f64, b: f64| (a / b - 1.0).abs() < error;
                    assert!(close(restitution, exact.restitution), "{name} {target} {n}");
                    assert!(close(overlap, exact.overlap), "{name} {target} {n}");
                    // The force begins and ends within a step.
                    assert!(
                        (duration - exact.duration()).abs() < 1.01 * dt,
                        "{name} {target} {n}"
                    );
                    // Round-off of n steps of an energy of 2.
                    assert!(energy.abs() < 1e-15 * n, "{name} {target} {n} {energy}");
                }
            }
        }
    }
}
