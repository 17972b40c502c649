//! The second impact of bars in a row: each bar meets first one neighbour, then the other.
//!
//! Equal bars at equal distances move alternately to the right and to the left, so they meet in pairs that are mirror images of
//! each other. A bar at a wall moves as one of such a pair. After the first impact every bar flies to its other neighbour. Their
//! far ends meet there. For the far end mode j has (-1)^j times its coordinate, and a displacement that opens the first contact
//! closes the second one. So the modes and the spring are the same.

use super::case::system;
use super::scaled::Scaled;
use crate::lane::Lane;
use crate::methods::{Method, ModeStart, Recursion, Start};
use crate::solve;
use crate::solve::visited::Stepper;
use crate::system::bar::Mass;

/// T_I, the exact contact's duration in both impacts.
const CONTACT: f64 = 1.0;

/// From the exact end of the second contact to the end of the run, in T_I.
const REST: f64 = 0.25;

/// The speed over c at which the ends meet in the second impact, and the mass centres' speed over c after it.
///
/// `flight` is the time in T_I between the exact contacts. Undefined for bars that are not mirror images, for other methods than
/// constant average acceleration, and if the far ends meet before half of the flight, do not meet, meet while the first contact is
/// closed, or touch at the end. Also undefined if contact nodes have no mass, because then both ends of a bar differ.
pub fn second(scaled: &Scaled, dt: f64, flight: f64) -> [Option<f64>; 2] {
    if scaled.pair.right.is_some() && !scaled.pair.equal()
        || !matches!(scaled.method, Method::AverageAcceleration(_))
    {
        return [None; 2];
    }
    if scaled.pair.left.kind == Mass::MasslessContact {
        return [None; 2];
    }
    let Some((mut stepper, mut law)) = solve::start::<1, Stepper, _>(&[system(scaled, dt, 0)])
    else {
        return [None; 2];
    };
    let separation = 0.5 * scaled.bars.gap + CONTACT;
    let first = ((separation + 0.5 * flight) / dt).round() as u64;
    for _ in 0..first {
        stepper.step(&mut law);
    }
    if stepper.contact().displacement.0[0] < 0.0 {
        return [None; 2];
    }
    let Some(mut stepper) = far_ends(scaled, dt, flight, &stepper) else {
        return [None; 2];
    };
    let end = separation + flight + CONTACT + REST - first as f64 * dt;
    let mut closing = None;
    for _ in 0..(end / dt).round() as u64 {
        let before = stepper.contact();
        if closing.is_none() && (before.displacement.0[0] < 0.0 || first_gap(&stepper) < 0.0) {
            return [None; 2];
        }
        let now = stepper.step(&mut law);
        let [r, next] = [before.displacement.0[0], now.displacement.0[0]];
        if closing.is_none() && next < 0.0 {
            // rdot at r = 0, both linear between the steps; in c/2, and negative in closing.
            let part = r / (r - next);
            let [v, then] = [before.velocity.0[0], now.velocity.0[0]];
            closing = Some(-0.5 * (v + part * (then - v)));
        }
    }
    let open = stepper.contact().displacement.0[0] >= 0.0;
    let rebound = stepper.modes().next().map(|(_, rigid)| 0.5 * rigid.0[0]);
    [closing, rebound.filter(|_| open && closing.is_some())]
}

/// The same motion in coordinates of the far ends. Their distance is `2 flight` when the contact ends touch.
fn far_ends(scaled: &Scaled, dt: f64, flight: f64, stepper: &Stepper) -> Option<Stepper> {
    let mut sign = 1.0;
    let modes = (0..).map(|j| scaled.pair.mode(j)).zip(stepper.modes());
    let mut start: Vec<ModeStart<1>> = modes
        .map(|(mode, (x, v))| {
            sign = -sign;
            ModeStart {
                mode: [mode],
                displacement: Lane([sign * x.0[0]]),
                velocity: Lane([sign * v.0[0]]),
            }
        })
        .collect();
    if let Some(rigid) = start.first_mut() {
        rigid.displacement.0[0] -= scaled.bars.gap;
    }
    let at = Start {
        method: [scaled.method],
        dt: Lane([dt]),
        gap: Lane([2.0 * flight]),
        force: Lane([0.0]),
    };
    Stepper::new(&at, start.into_iter())
}

/// Distance of the ends that met first, in coordinates of the far ends.
fn first_gap(stepper: &Stepper) -> f64 {
    let mut sign = 1.0;
    let parts = stepper.modes().map(|(x, _)| {
        sign = -sign;
        sign * x.0[0]
    });
    parts.sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{ContactLaw, ImpactSpring};
    use crate::exact::wave::Bars;
    use crate::methods::AverageAcceleration;
    use crate::problem::impact::scaled::CLOSING;
    use crate::system::BarPair;
    use crate::system::bar::Bar;

    /// Two equal bars, or a bar and a wall.
    fn scaled(n: u32, gamma: f64, gap: f64, kind: Mass, wall: bool) -> Scaled {
        let mass = if wall { 0.25 } else { 0.5 };
        let left = Bar {
            elements: n,
            mass,
            travel_time: 1.0,
            kind,
        };
        Scaled {
            pair: BarPair {
                left,
                right: (!wall).then_some(left),
                velocity: CLOSING,
            },
            bars: Bars {
                impedance_ratio: if wall { 0.0 } else { 1.0 },
                time_ratio: 1.0,
                gap,
            },
            spring: gamma * f64::from(n) * 4.0 * mass,
            law: ContactLaw::ImpactSpring(ImpactSpring {
                stiffness: gamma * f64::from(n) * 4.0 * mass,
            }),
            method: AverageAcceleration.into(),
            length_ratio: 1.0,
        }
    }

    #[test]
    fn a_bar_between_two_walls_agrees_with_full_matrices() {
        // tests/reference/claims.py, second_impact: full matrices of one bar with both contacts. A
        // difference of 1e-14 in r grows 2e8 times within one impact at k_I = 10^4 (tests/data/impact.json), and 1e2
        // times at the others.
        let (lumped, consistent) = (Mass::Lumped, Mass::Consistent);
        for (n, gamma, gap, kind, dt, flight, expected, tolerance) in [
            (
                10,
                1.0,
                0.0,
                lumped,
                0.001,
                0.83,
                [0.7579969058394754, 0.9721543214812469],
                1e-10,
            ),
            (
                10,
                100.0,
                0.0,
                lumped,
                0.001,
                0.83,
                [0.7999729542725773, 0.9472655824435392],
                1e-4,
            ),
            (
                7,
                0.5,
                0.22,
                consistent,
                0.004,
                0.6,
                [1.0012052059085945, 0.9542148388144919],
                1e-10,
            ),
        ] {
            // A pair on k_I is two bars on walls with 2 k_I each.
            for (wall, gamma) in [(false, gamma), (true, 2.0 * gamma)] {
                let speeds = second(&scaled(n, gamma, gap, kind, wall), dt, flight);
                for (speed, expected) in speeds.into_iter().zip(expected) {
                    let difference = (speed.unwrap() - expected).abs();
                    assert!(
                        difference < tolerance,
                        "n {n}, gamma {gamma}, wall {wall}: {difference:e}"
                    );
                }
            }
        }
    }

    #[test]
    fn second_impact_is_undefined_without_symmetry_or_flight() {
        let equal = scaled(10, 1.0, 0.0, Mass::Lumped, false);
        let different = Scaled {
            pair: BarPair {
                right: Some(Bar {
                    travel_time: 1.1,
                    ..equal.pair.left
                }),
                ..equal.pair
            },
            ..equal
        };
        assert_eq!(second(&different, 0.01, 0.8), [None; 2]);
        // Only one end of a bar has a node without mass.
        let massless = scaled(10, 1.0, 0.0, Mass::MasslessContact, false);
        assert_eq!(second(&massless, 0.01, 0.8), [None; 2]);
        // k_I = 10: contact lasts 1.42 T_I, longer than half of a flight of 0.5 T_I.
        assert_eq!(
            second(&scaled(10, 0.1, 0.0, Mass::Lumped, false), 0.001, 0.5),
            [None; 2]
        );
    }
}
