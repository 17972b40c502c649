//! Each law in a plane beside its scalar form, and in any direction.

use super::*;
use crate::contact::DisplacementControl;
use crate::contact::coupled::tests::Random;
use crate::contact::{
    Bearing, Bilinear, BoucWen, ContactResponse, Pendulum, Stribeck, Tanh, Trial, VelocityControl,
};
use crate::lane::Lane;

/// The laws, with a limit of 1 and the displacement and velocity 0.1 up to it.
fn laws() -> Vec<ContactLaw> {
    let compliance = 0.1;
    let bouc_wen = |exponent| {
        ContactLaw::BoucWen(BoucWen {
            compliance,
            limit: 1.0,
            exponent,
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
        bouc_wen(1.0),
        bouc_wen(2.0),
        bouc_wen(5.0),
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
fn run(law: &ContactLaw, turn: &dyn Fn(Pair) -> Pair, flat: bool) -> Vec<Pair> {
    let plane = PlaneLaw::new(law, ON).unwrap();
    let mut random = Random(7);
    let mut memory = PlaneMemory::default();
    let mut trial = PlaneTrial::default();
    let mut next = || [random.even(), if flat { 0.0 } else { random.even() }];
    let mut forces = Vec::new();
    for _ in 0..40 {
        trial.change = turn(next()).map(|x| 0.3 * x);
        trial.rate = pair::map(trial.change, trial.velocity, |c, v| 2.0 / ON.dt * c - v);
        let (force, after) = plane.answer(&trial, &memory);
        let moved = PlaneTrial {
            change: pair::map(trial.change, force, |c, s| c - ON.h * s),
            rate: pair::map(trial.rate, force, |v, s| v - ON.h_rate * s),
            ..trial
        };
        // The force of the motion that it leaves; without compliance it does not follow.
        let follows = plane.follow(&moved, &memory);
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
        let own = run(&law, &|x| x, false);
        let turn = turned(0.7);
        for (own, turned) in own.into_iter().zip(run(&law, &turn, false)) {
            let difference = length(pair::map(turn(own), turned, |a, b| a - b));
            assert!(difference < 1e-9, "{law:?} {difference}");
        }
    }
}

#[test]
fn along_an_axis_a_law_is_its_scalar_form() {
    for law in laws() {
        let plane = run(&law, &|x| x, true);
        let mut step = running(&law, ON.h, &ON);
        let mut random = Random(7);
        let (mut r, mut v, mut s) = (0.0, 0.0, 0.0);
        for force in plane {
            let change = 0.3 * random.even();
            let rate = 2.0 / ON.dt * change - v;
            let trial = Trial {
                displacement: Lane([r]),
                velocity: Lane([v]),
                force: Lane([s]),
                change: Lane([change]),
                rate: Lane([rate]),
            };
            let Lane([scalar]) = step.force(0, &trial);
            // In a plane Bouc-Wen has implicit stages, in a line a closed form: a step is up to 10 u_y here.
            let is_bouc_wen = matches!(law, ContactLaw::BoucWen(_));
            let tolerance = if is_bouc_wen { 0.5 } else { 1e-9 };
            assert!(
                (force[0] - scalar).abs() < tolerance,
                "{law:?} {force:?} {scalar}"
            );
            assert_eq!(force[1], 0.0);
            s = force[0];
            r += change - ON.h * s;
            v = rate - ON.h_rate * s;
        }
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
        let plane = PlaneLaw::new(&law, on).unwrap();
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

fn law_of(find: impl Fn(&ContactLaw) -> bool) -> PlaneLaw {
    let law = laws().into_iter().find(find).unwrap();
    PlaneLaw::new(&law, ON).unwrap()
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
        let plane = PlaneLaw::new(&law, ON).unwrap();
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
    for law in laws() {
        let plane = PlaneLaw::new(&law, ON).unwrap();
        if !matches!(plane.form, Form::Elastic(_)) {
            continue;
        }
        for size in [0.02, 0.4] {
            let trial = PlaneTrial {
                change: [0.6 * size, 0.8 * size],
                ..PlaneTrial::default()
            };
            let memory = PlaneMemory {
                begun: true,
                ..PlaneMemory::default()
            };
            let (force, _) = plane.answer(&trial, &memory);
            let directions = plane.directions(&trial, &memory, force, 2.0 / ON.dt);
            let at = |change: Pair| plane.follow(&PlaneTrial { change, ..trial }, &memory);
            let moved = pair::map(trial.change, force, |c, s| c - ON.h * s);
            let slopes = pair::jacobian(at, moved, 1e-7);
            let [a, b] = directions.along;
            for (direction, slope) in [[a, b], [-b, a]].into_iter().zip(directions.slopes) {
                let rise = slopes.map(|row| dot(row, direction));
                let found = dot(rise, direction);
                assert!(
                    (found * slope - 1.0).abs() < 1e-6 || slope.is_infinite() && found < 1e-6,
                    "{law:?} {size} {found} {slope}"
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
        assert!(corner(&law, 0.99 * at) < 0.0 && corner(&law, 1.01 * at) > 0.0);
    }
}
