//! Friction whose normal force other contacts and springs give.

use super::*;
use crate::contact::ClippedLine;
use crate::system::structure::{PressedBy, PressingSpring, Spring};

/// A limit of nu times the forces of contacts and of springs (along, k, c).
fn by(nu: f64, contacts: &[usize], springs: &[(&[(usize, f64)], f64, f64)]) -> Limit {
    let springs = springs.iter().map(|(along, k, c)| PressingSpring {
        spring: Spring {
            along: along.to_vec(),
            k: *k,
            c: *c,
        },
        at_start: 0.0,
    });
    Limit {
        pressed_by: Some(PressedBy {
            nu,
            contacts: contacts.to_vec(),
            springs: springs.collect(),
        }),
        ..Limit::constant(0.0)
    }
}

fn impact(stiffness: f64) -> StructureLaw {
    StructureLaw::new(ClippedLine::Spring { stiffness }, None)
}

/// The second mass is on springs and, if it presses, on the ground; the first one slides under it.
fn pressed_mass(law: ClippedLine, ratio: f64, floors: &[f64], springs: &[[f64; 2]]) -> Structure {
    let along: &[(usize, f64)] = &[(1, 1.0)];
    let named: Vec<_> = springs.iter().map(|[k, c]| (along, *k, *c)).collect();
    let contacts: Vec<usize> = (0..floors.len()).collect();
    let limit = Limit {
        static_ratio: ratio,
        ..by(0.3, &contacts, &named)
    };
    let mut s = masses(&[2.0, 1.5])
        .spring([None, Some(0)], 50.0)
        .load(&[(0, 1.0)], sine(10.0, 7.0, 0.0))
        .load(&[(1, 1.0)], sine(6.0, 11.0, 0.0))
        .moving(&[0.0, 0.0], &[0.4, -0.5]);
    for [k, c] in springs {
        s = s.spring([None, Some(1)], *k).dashpot([None, Some(1)], *c);
    }
    for k in floors {
        s = s.contact([None, Some(1)], 0.0, impact(*k));
    }
    s.contact([None, Some(0)], 0.0, StructureLaw::new(law, limit))
}

const LAWS: [ClippedLine; 3] = [
    ClippedLine::Elastic { stiffness: 2000.0 },
    ClippedLine::Viscous { viscosity: 100.0 },
    ClippedLine::Coulomb,
];

/// The numbers are those of a program of its own: Runge-Kutta of order 4 from event to event, steps of 2e-5.
#[test]
fn three_parts_press_as_in_another_program() {
    let s = pressed_mass(LAWS[0], 1.0, &[1e4], &[[3e3, 0.0], [2e3, 5.0]]);
    for (time, known) in NUMBERS {
        let (exact, summary) = last(&s, time);
        for (exact, known) in exact.iter().zip(known) {
            // 16 times as much with twice the steps.
            assert!((exact - known).abs() < 1e-10, "{time}: {exact} {known}");
        }
        assert!(summary.book.residual < 1e-13 * summary.book.largest);
    }
}

/// u and u' of both masses.
const NUMBERS: [(f64, [f64; 4]); 3] = [
    (
        0.25,
        [
            0.10115970419649,
            0.00494089386059,
            0.58786140894778,
            -0.21910853438688,
        ],
    ),
    (
        0.5,
        [
            0.18460432067847,
            0.00194530923581,
            -0.24004865394849,
            -0.16928643999370,
        ],
    ),
    (
        1.0,
        [
            -0.36905510688774,
            0.00085742527164,
            -0.08387288275840,
            0.02141003080034,
        ],
    ),
];

#[test]
fn two_halves_press_as_one_part() {
    for law in LAWS {
        for ratio in [1.0, 1.3] {
            if ratio > 1.0 && law != ClippedLine::Coulomb {
                continue;
            }
            let one = pressed_mass(law, ratio, &[1e4], &[[3e3, 5.0]]);
            let two = pressed_mass(law, ratio, &[5e3, 5e3], &[[1.5e3, 2.5], [1.5e3, 2.5]]);
            let [(one, summary), (two, _)] = [one, two].map(|s| last(&s, 2.0));
            assert!(summary.book.residual < 1e-13 * summary.book.largest);
            for (one, two) in one.iter().zip(&two) {
                assert!((one - two).abs() < 1e-12, "{law:?} {ratio}: {one} {two}");
            }
        }
    }
}

/// A mass in compression between two springs, y = -a cos wt, until they stretch; the other one slides: x' = v - nu K a/(w m) sin wt.
#[test]
fn a_mass_between_two_springs_presses_as_its_cosine() {
    let (k, a, nu, v): ([f64; 2], _, _, _) = ([30.0, 50.0], 0.02, 0.3, 1.0);
    let mut s = masses(&[2.0, 0.5]).moving(&[0.0, -a], &[v, 0.0]);
    let along: &[(usize, f64)] = &[(1, 1.0)];
    for k in k {
        s = s.spring([None, Some(1)], k);
    }
    let limit = by(nu, &[], &k.map(|k| (along, k, 0.0)));
    let s = s.contact(
        [None, Some(0)],
        0.0,
        StructureLaw::new(ClippedLine::Coulomb, limit),
    );
    let stiffness = k[0] + k[1];
    let omega = (stiffness / 0.5_f64).sqrt();
    let quarter = 0.5 * std::f64::consts::PI / omega;
    // Then nothing presses for half a period.
    for time in [0.3 * quarter, quarter, 2.5 * quarter] {
        let (exact, summary) = last(&s, time);
        let angle = omega * time.min(quarter);
        let slower = nu * stiffness * a / (omega * 2.0);
        let known = v - slower * angle.sin();
        assert!(
            (exact[2] - known).abs() < 1e-14,
            "{time}: {} {known}",
            exact[2]
        );
        let way =
            v * time - slower / omega * (1.0 - angle.cos()) - slower * (time - time.min(quarter));
        assert!((exact[0] - way).abs() < 1e-14);
        let opens = summary
            .events
            .iter()
            .filter(|event| event.kind == EventKind::Phase(Phase::Open));
        assert_eq!(opens.count(), usize::from(time > quarter));
    }
}

/// A block of mass m on a rigid floor: N = m g - p, whatever the number of floors.
#[test]
fn a_rigid_floor_presses_with_the_load() {
    let stop = |restitution| StructureLaw::new(ClippedLine::Stop { restitution }, None);
    for floors in [1, 2] {
        let contacts: Vec<usize> = (0..floors).collect();
        let mut s = masses(&[2.0, 2.0])
            .load(
                &[(1, 1.0)],
                table(&[[0.0, -20.0], [1.0, -10.0], [2.0, -10.0]]),
            )
            .moving(&[0.0, 0.0], &[3.0, 0.0]);
        for _ in 0..floors {
            s = s.contact([None, Some(1)], 0.0, stop(0.0));
        }
        let law = StructureLaw::new(ClippedLine::Coulomb, by(0.25, &contacts, &[]));
        let s = s.contact([None, Some(0)], 0.0, law);
        let (exact, summary) = last(&s, 1.0);
        // v - nu (20 - 10/2)/m.
        assert!(
            (exact[2] - (3.0 - 0.25 * 15.0 / 2.0)).abs() < 1e-14,
            "{exact:?}"
        );
        assert!(summary.book.residual < 1e-14 * summary.book.largest);
        let (exact, summary) = last(&s, 2.0);
        let stops = 1.0 + (3.0 - 1.875) / 1.25;
        assert_eq!(exact[2], 0.0);
        let end = summary.events.last().unwrap();
        assert_eq!(end.kind, EventKind::Phase(Phase::Closed));
        assert!((end.time - stops).abs() < 1e-13);
    }
}

/// The tangential speed changes by nu (1 + e) v_n, or the body stops.
#[test]
fn an_oblique_impact_takes_tangential_speed() {
    for (speed, after) in [(3.0, 3.0 - 0.25 * 1.6 * 2.0), (-3.0, -2.2), (0.5, 0.0)] {
        let stop = StructureLaw::new(ClippedLine::Stop { restitution: 0.6 }, None);
        let law = StructureLaw::new(ClippedLine::Coulomb, by(0.25, &[0], &[]));
        let s = masses(&[2.0, 2.0])
            .contact([None, Some(1)], 1.0, stop)
            .contact([None, Some(0)], 0.0, law)
            .moving(&[0.0, 0.0], &[speed, -2.0]);
        let (exact, summary) = last(&s, 1.0);
        assert!(
            (exact[2] - after).abs() < 1e-15 && (exact[3] - 1.2).abs() < 1e-15,
            "{exact:?}"
        );
        assert!(summary.book.residual < 1e-15 * summary.book.largest);
    }
}

/// A rod that leans on a rigid floor slides with friction at its foot. Its normal force depends on the friction: with u = x, y and the
/// angle, the foot is at x - h theta, y + b theta, and N = m g/(1 + (m/I) b (b + s nu h)) for the direction s of sliding.
#[test]
fn normal_forces_may_depend_on_the_friction_that_they_cause() {
    let (m, inertia, b, h, nu, g) = (2.0, 0.5, 0.3, 0.8, 0.2, 9.81);
    for s in [1.0, -1.0] {
        let mut rod = masses(&[m, m, inertia])
            .load(&[(1, -m * g)], table(&[[0.0, 1.0], [1.0, 1.0]]))
            .moving(&[0.0; 3], &[s, 0.0, 0.0]);
        let contact = |name: &str, along: &[(usize, f64)], law| Contact {
            name: name.into(),
            along: along.to_vec(),
            gap: 0.0,
            law,
        };
        let stop = StructureLaw::new(ClippedLine::Stop { restitution: 0.0 }, None);
        let law = StructureLaw::new(ClippedLine::Coulomb, by(nu, &[0], &[]));
        rod.contacts = vec![
            contact("floor", &[(1, 1.0), (2, b)], stop),
            contact("foot", &[(0, 1.0), (2, -h)], law),
        ];
        let mut normal = 0.0;
        run(&rod, &[0.01], |_, state| normal = -state.force[0]).unwrap();
        // y'' + b theta'' = 0, m y'' = N - m g, I theta'' = b N + s nu h N.
        let known = m * g / (1.0 + m / inertia * b * (b + s * nu * h));
        assert!((normal - known).abs() < 1e-13 * known, "{normal} {known}");
    }
}
