//! Each law in a plane beside its scalar form, and in any direction.

use super::scalar::running;
use super::*;
use crate::contact::coupled::tests::Random;
use crate::contact::offer::Offered;
use crate::contact::{
    Bearing, Bilinear, BoucWen, ContactResponse, Decay, DisplacementControl, GivenLaw,
    GivenNumbers, Lugre, Pendulum, Stribeck, Tanh, Trial, VelocityControl, pair,
};
use crate::lane::Lane;

/// The laws, with a limit of 1 and the displacement and velocity 0.1 up to it; and each that studies have, with other numbers.
fn laws() -> Vec<ContactLaw> {
    let offered = LAWS.iter().filter(|law| law.in_plane);
    offered.filter_map(made).chain(chosen()).collect()
}

/// A law of structures with numbers within their ranges.
fn made(law: &Offered) -> Option<ContactLaw> {
    let offered = law.offer.structure?;
    // A study gives one of two numbers that take each other's place.
    let values = offered.numbers.iter().enumerate().map(|(i, number)| {
        let first = number.instead_of.is_none_or(|other| !law.has(other));
        let inside = |value: &f64| number.range.contains(*value);
        // No two alike.
        let values = [1.5 / (1.0 + 0.1 * i as f64), 0.6, 2.0];
        values.into_iter().find(inside).filter(|_| first)
    });
    let given = GivenNumbers {
        law: law.offer.name,
        numbers: offered.numbers,
        values: &values.collect::<Vec<_>>(),
        table: &[],
        others: &[("limit", 1.0), ("nu", 2.0)],
    };
    match (law.offer.form)(&given).unwrap().given {
        GivenLaw::Law(law) => Some(law),
        GivenLaw::Line(_) => None,
    }
}

fn chosen() -> Vec<ContactLaw> {
    let compliance = 0.1;
    let bouc_wen = |exponent, beta| {
        ContactLaw::BoucWen(BoucWen {
            compliance,
            limit: 1.0,
            exponent,
            beta,
        })
    };
    let lugre = |static_limit, sigma1| {
        ContactLaw::Lugre(Lugre {
            sigma0: 10.0,
            sigma1,
            sigma2: 0.1,
            limit: 1.0,
            static_limit,
            stribeck_velocity: 2.0,
        })
    };
    vec![
        ContactLaw::VelocityControl(VelocityControl {
            compliance: 0.0,
            limit: 1.0,
        }),
        ContactLaw::VelocityControl(VelocityControl {
            compliance,
            limit: 1.0,
        }),
        ContactLaw::Bearing(Bearing {
            compliance,
            limit: 1.0,
            ratio: 0.4,
            rate: 3.0,
        }),
        ContactLaw::Tanh(Tanh {
            compliance,
            limit: 1.0,
            ratio: 0.4,
            rate: 3.0,
        }),
        ContactLaw::Stribeck(Stribeck {
            compliance,
            limit: 1.0,
            static_limit: 1.2,
            stribeck_velocity: 40.0,
            decay: Decay::Exponential,
        }),
        ContactLaw::DisplacementControl(DisplacementControl {
            compliance,
            limit: 1.0,
        }),
        ContactLaw::Pendulum(Pendulum {
            compliance,
            limit: 1.0,
            restoring: 2.0,
            at_rest: [1.0, 1.0],
            rising: [1.0, 0.0],
        }),
        ContactLaw::Pendulum(Pendulum {
            compliance,
            limit: 1.0,
            restoring: 2.0,
            at_rest: [0.5, 1.0],
            rising: [0.5, 0.2],
        }),
        ContactLaw::Bilinear(Bilinear {
            stiffness: 10.0,
            yield_force: 1.0,
            hardening: 1.0,
        }),
        bouc_wen(1.0, 0.5),
        bouc_wen(2.0, 0.5),
        bouc_wen(5.0, 0.5),
        bouc_wen(2.0, 0.2),
        bouc_wen(3.0, 0.9),
        lugre(1.0, 0.0),
        lugre(1.3, 0.3),
    ]
}

const ON: PlaneStep = PlaneStep {
    h: 0.02,
    h_rate: 0.4,
    dt: 0.1,
};

fn turned(angle: f64) -> impl Fn(Pair) -> Pair {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    move |[x, y]| [cos * x - sin * y, sin * x + cos * y]
}

/// A run of random steps, in which the contact is at `place` turned by an angle at the end of each.
fn run(law: &ContactLaw, turn: &dyn Fn(Pair) -> Pair, flat: bool, size: f64) -> Vec<Pair> {
    let [plane, given] = [ON, ON.given()].map(|on| law.in_plane(&on).unwrap());
    let mut random = Random(7);
    let mut memory = PlaneMemory::default();
    let mut trial = PlaneTrial::default();
    let mut next = || [random.even(), if flat { 0.0 } else { random.even() }];
    let mut forces = Vec::new();
    for _ in 0..40 {
        trial.change = turn(next()).map(|x| size * x);
        trial.rate = pair::map(trial.change, trial.velocity, |c, v| 2.0 / ON.dt * c - v);
        let (force, after) = plane.answer(&trial, &memory);
        let moved = PlaneTrial {
            change: pair::map(trial.change, force, |c, s| c - ON.h * s),
            rate: pair::map(trial.rate, force, |v, s| v - ON.h_rate * s),
            ..trial
        };
        // The force of the motion that it leaves; without compliance it does not follow.
        let (follows, _) = given.answer(&moved, &memory);
        let is_rigid = matches!(law, ContactLaw::VelocityControl(own) if own.compliance == 0.0);
        let difference = length(pair::map(force, follows, |a, b| a - b));
        assert!(
            is_rigid || difference < 1e-9,
            "{law:?} {force:?} {follows:?}"
        );
        memory = after;
        trial.displacement = pair::map(trial.displacement, moved.change, |r, c| r + c);
        trial.velocity = moved.rate;
        trial.force = force;
        forces.push(force);
    }
    forces
}

#[test]
fn a_law_is_the_same_in_every_direction() {
    for law in laws() {
        let unturned = run(&law, &|x| x, false, 0.3);
        let turn = turned(0.7);
        for (vector, turned) in unturned.into_iter().zip(run(&law, &turn, false, 0.3)) {
            let difference = length(pair::map(turn(vector), turned, |a, b| a - b));
            assert!(difference < 1e-9, "{law:?} {difference}");
        }
    }
}

/// The largest difference between a law along an axis and its scalar form, of steps up to `size`.
fn difference_along_an_axis(law: &ContactLaw, size: f64) -> f64 {
    let plane = run(law, &|x| x, true, size);
    let mut step = running(law, ON.h, &ON);
    let mut random = Random(7);
    let (mut r, mut v, mut s) = (0.0, 0.0, 0.0);
    let mut largest = 0.0_f64;
    for force in plane {
        let change = size * random.even();
        let rate = 2.0 / ON.dt * change - v;
        let trial = Trial {
            displacement: Lane([r]),
            velocity: Lane([v]),
            force: Lane([s]),
            change: Lane([change]),
            rate: Lane([rate]),
        };
        let Lane([scalar]) = step.force(0, &trial);
        largest = largest.max((force[0] - scalar).abs());
        assert_eq!(force[1], 0.0);
        s = force[0];
        r += change - ON.h * s;
        v = rate - ON.h_rate * s;
    }
    largest
}

/// The step of a law may be another one in a plane, as that of Bouc-Wen, which has a closed form in a line. Then both are of second
/// order, so that a tenth of the steps differs by nearly a hundredth; one of first order by a tenth.
#[test]
fn along_an_axis_a_law_is_its_scalar_form() {
    for law in laws() {
        let difference = difference_along_an_axis(&law, 0.3);
        let [coarse, fine] = [0.03, 0.003].map(|size| difference_along_an_axis(&law, size));
        assert!(
            difference < 1e-9 || coarse < 1e-2 && (fine < 1e-9 || fine < 0.02 * coarse),
            "{law:?} {difference:e} {coarse:e} {fine:e}"
        );
    }
}

/// The angle of the force of the elastic law from a straight path of 2 r_E in so many steps, from 80 degrees. Every second step may be
/// shorter.
fn angle_after(steps: u32, remembers: bool, shorter: f64) -> f64 {
    let law = ContactLaw::DisplacementControl(DisplacementControl {
        compliance: 1.0,
        limit: 1.0,
    });
    let start = 80.0_f64.to_radians();
    let mut trial = PlaneTrial {
        force: [libm::cos(start), libm::sin(start)],
        ..PlaneTrial::default()
    };
    let mut memory = PlaneMemory::default();
    for step in 0..steps {
        let dt = if step % 2 == 1 { shorter } else { 1.0 };
        trial.change[0] = 4.0 * dt / (1.0 + shorter) / f64::from(steps);
        let on = PlaneStep {
            h: 0.0,
            h_rate: 0.0,
            dt,
        };
        let plane = law.in_plane(&on).unwrap();
        let (force, after) = plane.answer(&trial, &memory);
        trial.force = force;
        // A contact that slides stays at its limit.
        assert!((length(force) - 1.0).abs() < 1e-15);
        memory = if remembers { after } else { memory };
    }
    libm::atan2(trial.force[1], trial.force[0])
}

/// The elastic law on a straight path: tan(psi/2) = tan(psi0/2) exp(-s/r_E), psi the angle of the force from the path. Backward radial
/// return is of first order in the step; with the turn of the last step it is of second order.
#[test]
fn the_force_turns_towards_a_straight_path() {
    for (steps, known) in [(10, 0.25714), (100, 0.22945), (1000, 0.22648)] {
        let angle = angle_after(steps, false, 1.0);
        // Published to five digits.
        assert!((angle - known).abs() < 6e-6, "{steps} {angle}");
    }
    let known = 2.0 * libm::atan(libm::tan(40.0_f64.to_radians()) * libm::exp(-2.0));
    for shorter in [1.0, 0.2] {
        let error = |steps: u32| (angle_after(steps, true, shorter) - known).abs();
        let [coarse, fine] = [error(100), error(1000)];
        assert!(
            fine < 4e-7 && (80.0..120.0).contains(&(coarse / fine)),
            "{shorter} {coarse:e} {fine:e}"
        );
    }
}

fn law_of(find: impl Fn(&ContactLaw) -> bool) -> AnyPlaneLaw {
    let law = chosen().into_iter().find(find).unwrap();
    law.in_plane(&ON).unwrap()
}

/// Of the first loading, S = k r up to Fy and Fy + k_h (r - u_y) beyond, along r.
#[test]
fn hardening_has_the_force_of_its_first_loading_from_the_start() {
    let plane = law_of(|law| matches!(law, ContactLaw::Bilinear(_)));
    for (size, force) in [(0.05, 0.5), (0.1, 1.0), (0.5, 1.4)] {
        let along = [0.6, -0.8];
        let (found, _) = plane.at_start(None, along.map(|x| x * size), [0.0; 2]);
        for (found, x) in found.iter().zip(along) {
            assert!((found - force * x).abs() < 1e-15, "{size} {found}");
        }
    }
}

/// What an equilibrium needs is the force from which the motion starts, also of a coefficient that is smaller at rest.
#[test]
fn a_contact_starts_with_the_force_of_its_equilibrium() {
    for law in laws() {
        let plane = law.in_plane(&ON).unwrap();
        if !plane.has_state() {
            continue;
        }
        let (at_rest, r) = ([0.2, -0.1], [0.03, 0.02]);
        let (force, _) = plane.at_start(Some(at_rest), r, [0.0; 2]);
        let difference = length(pair::map(force, at_rest, |a, b| a - b));
        assert!(difference < 1e-15, "{law:?} {force:?}");
    }
}

/// z tends to g(v), which is the static limit for a slow motion, and never beyond it.
#[test]
fn bristles_are_bound_by_the_static_limit() {
    let plane = law_of(|law| matches!(law, ContactLaw::Lugre(own) if own.static_limit > own.limit));
    let (mut z, slow, dt) = ([0.0; 2], [0.003, 0.004], 0.01);
    for _ in 0..60_000 {
        z = pair::map(z, plane.rate(z, slow), |z, rate| z + dt * rate);
    }
    assert!((length(z) - 1.3).abs() < 1e-4, "{z:?}");
    assert_eq!(plane.bound(), 1.3);
}

/// The slope along a direction is the difference quotient of the force that follows a motion.
#[test]
fn slopes_of_a_step_are_those_of_its_force() {
    let pace = 2.0 / ON.dt;
    for law in laws() {
        let [plane, given] = [ON, ON.given()].map(|on| law.in_plane(&on).unwrap());
        if law.properties().is_vertical() {
            continue;
        }
        for size in [0.002, 0.02, 0.4] {
            let trial = PlaneTrial {
                change: [0.6 * size, 0.8 * size],
                rate: [0.6 * pace * size, 0.8 * pace * size],
                ..PlaneTrial::default()
            };
            let (_, memory) = plane.at_start(Some([0.0; 2]), [0.0; 2], [0.0; 2]);
            let (force, _) = plane.answer(&trial, &memory);
            let directions = plane.directions(&trial, &memory, force, pace);
            let moved = pair::map(trial.change, force, |c, s| c - ON.h * s);
            let rate = pair::map(trial.rate, force, |v, s| v - ON.h_rate * s);
            let at = |change: Pair| {
                let more = pair::map(change, moved, |to, from| pace * (to - from));
                let rate = pair::map(rate, more, |v, more| v + more);
                let moved = PlaneTrial {
                    change,
                    rate,
                    ..trial
                };
                given.answer(&moved, &memory).0
            };
            let slopes = pair::jacobian(at, moved, 1e-7);
            let [a, b] = directions.along;
            for (direction, slope) in [[a, b], [-b, a]].into_iter().zip(directions.slopes) {
                let rise = slopes.map(|row| dot(row, direction));
                // Where the force falls, the slope is that of none.
                let (found, known) = (dot(rise, direction).max(0.0), 1.0 / slope);
                // Round-off of forces of 1 over the width.
                assert!(
                    (found - known).abs() < 1e-7 * (1.0 + known),
                    "{law:?} {size} {found} {known}"
                );
            }
        }
    }
}

/// A law that is viscous up to its limit has a corner at rdot = limit/c.
#[test]
fn the_corner_of_viscous_friction_is_at_its_limit() {
    for compliance in [0.05, 0.1] {
        let limit = 1.5;
        let law = ContactLaw::VelocityControl(VelocityControl { compliance, limit });
        let at = compliance * limit;
        let plane = law.in_plane(&ON).unwrap();
        assert!(plane.corner(0.99 * at) < 0.0 && plane.corner(1.01 * at) > 0.0);
    }
}
