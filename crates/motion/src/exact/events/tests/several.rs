//! Several contacts at once.

use super::random::softened;
use super::restarts::restarts;
use super::*;
use crate::contact::ClippedLine;

/// Three masses with dampers, loads with a jump, and all softened laws, with limits that become 0.
fn three() -> Structure {
    let pulse = [[0.5, 0.0], [1.5, 3.0], [2.0, -1.0], [2.0, 0.5], [5.0, 0.0]];
    let pressure = [[0.0, 0.0], [1.0, 1.0], [2.5, -1.0], [3.5, 0.5]];
    masses(&[1.0, 2.0, 0.5])
        .spring([None, Some(0)], 4.0)
        .spring([Some(0), Some(1)], 9.0)
        .spring([None, Some(2)], 1.0)
        .dashpot([None, Some(0)], 0.1)
        .dashpot([Some(1), Some(2)], 0.05)
        .load(&[(0, -1.0), (1, -2.0), (2, -0.5)], sine(2.0, 1.7, 0.3))
        .load(&[(1, 1.0)], table(&pulse))
        .moving(&[0.1, 0.0, -0.2], &[0.5, -1.0, 0.3])
        .contact(
            [Some(0), Some(1)],
            0.0,
            StructureLaw::new(
                ClippedLine::Elastic { stiffness: 40.0 },
                varying(0.3, 0.6, sine(1.0, 2.3, 0.1)),
            ),
        )
        .contact(
            [Some(1), Some(2)],
            0.1,
            StructureLaw::new(ClippedLine::Spring { stiffness: 50.0 }, None),
        )
        .contact(
            [None, Some(2)],
            0.0,
            StructureLaw::new(
                ClippedLine::Viscous { viscosity: 5.0 },
                varying(0.5, 1.0, table(&pressure)),
            ),
        )
        .contact(
            [None, Some(1)],
            0.0,
            StructureLaw::new(
                ClippedLine::Elastic { stiffness: 30.0 },
                Limit::constant(0.4),
            ),
        )
}

#[test]
fn softened_contacts_move_as_by_runge_kutta() {
    let (exact, summary) = last(&three(), 6.0);
    assert_eq!(summary.events.len(), 32);
    assert!(summary.book.residual < 1e-14 * summary.book.largest);
    let other = restarts(&three(), 6.0, 12_000);
    for (other, exact) in other.iter().zip(&exact) {
        // 4e-8 with half the steps: order 4.
        assert!((other - exact).abs() < 5e-9, "{other} {exact}");
    }
}

#[test]
fn a_damper_and_a_sine_have_the_closed_form() {
    // u'' + 2 z u' + u = sin t from rest: u = (-cos t + e^(-z t) (cos w t + z/w sin w t))/(2 z), w^2 = 1 - z^2.
    let z: f64 = 0.05;
    let w = f64::sqrt(1.0 - z * z);
    let s = one()
        .spring([None, Some(0)], 1.0)
        .dashpot([None, Some(0)], 2.0 * z)
        .load(&[(0, 1.0)], sine(1.0, 1.0, 0.0));
    let times = steps(0.37, 300);
    let (states, summary) = first(&s, &times);
    for (t, state) in times.iter().zip(&states) {
        let free = libm::exp(-z * t) * (libm::cos(w * t) + z / w * libm::sin(w * t));
        let expected = (free - libm::cos(*t)) / (2.0 * z);
        // Round-off of 10 and of the phase 100.
        assert!(
            (state.u - expected).abs() < 1e-13,
            "{t} {}",
            state.u - expected
        );
    }
    assert!(summary.book.residual < 1e-14 * summary.book.largest);
}

#[test]
fn the_motion_does_not_depend_on_the_times() {
    let s = softened();
    let mut displacements = Vec::new();
    run(&s, &steps(0.01, 1000), |i, state| {
        if i % 100 == 0 {
            displacements.push(state.u.to_vec());
        }
    })
    .unwrap();
    let mut few = Vec::new();
    run(
        &s,
        &steps(0.01, 1000)[..]
            .iter()
            .copied()
            .step_by(100)
            .collect::<Vec<_>>(),
        |_, state| {
            few.push(state.u.to_vec());
        },
    )
    .unwrap();
    assert_eq!(displacements, few);
}

/// Three bars of 11 elements on friction bearings, with dampers and a record: 36 nodes and 5 contacts.
fn bridge() -> Structure {
    let points: Vec<[f64; 2]> = (0..500)
        .map(|i| {
            let t = 0.01 * f64::from(i);
            [
                t,
                libm::sin(1.7 * t) + libm::cos(5.1 * t) + 0.3 * libm::sin(23.0 * t),
            ]
        })
        .collect();
    let ground: Vec<(usize, f64)> = (0..36).map(|i| (i, -1.0)).collect();
    let mut s = masses(&[1.0; 36]).load(&ground, table(&points));
    for i in 0..36 {
        s = match i % 12 {
            0 => s.spring([None, Some(i)], 5.0),
            _ => s
                .spring([Some(i - 1), Some(i)], 100.0)
                .dashpot([Some(i - 1), Some(i)], 0.1),
        };
        s.velocity[i] = libm::sin(i as f64);
    }
    for i in [12, 24] {
        s = s.contact(
            [Some(i - 1), Some(i)],
            0.1,
            StructureLaw::new(ClippedLine::Spring { stiffness: 1000.0 }, None),
        );
    }
    for i in [0, 12, 24] {
        let limit = Limit::constant(1.0);
        let law = StructureLaw::new(ClippedLine::Elastic { stiffness: 100.0 }, limit);
        s = s.contact([None, Some(i)], 0.0, law);
    }
    s
}

#[test]
fn a_bridge_moves_as_by_runge_kutta() {
    let (exact, summary) = last(&bridge(), 3.0);
    assert!(summary.events.len() > 20);
    assert!(summary.book.residual < 1e-13 * summary.book.largest);
    for (other, exact) in restarts(&bridge(), 3.0, 6000).iter().zip(&exact) {
        // 3.6e-9, 2.2e-10 and 1.4e-11 for 3000, 6000 and 12000 steps.
        assert!((other - exact).abs() < 5e-10, "{other} {exact}");
    }
}

#[test]
fn what_has_no_exact_motion_is_a_fault() {
    let rigid = one().contact([None, None], 0.0, coulomb(1.0));
    let fault = run(&rigid, &[1.0], |_, _| ()).unwrap_err();
    let message = "a rigid contact has no force at t = 0; it must be between two nodes, or a node and the ground";
    assert_eq!(fault.to_string(), message);
    let stiff = one().spring([None, Some(0)], 1e200);
    let fault = run(&stiff, &[1.0], |_, _| ()).unwrap_err();
    let most = MOST_PIECES;
    // Counted before any piece is made.
    assert_eq!(fault, EventsFault::TooManyPieces { most, time: 1.0 });
}

#[test]
fn nodes_that_the_ground_moves_alike_do_not_touch() {
    // From rest and with a gap of 0, r is round-off of the accelerations.
    let ground = [(0, -0.3), (1, -0.7), (2, -1.1)];
    let law = || StructureLaw::new(ClippedLine::Spring { stiffness: 1e6 }, None);
    let s = masses(&[0.3, 0.7, 1.1])
        .load(&ground, table(&[[0.0, 0.1], [1.0, 0.7], [2.0, -0.9]]))
        .contact([Some(0), Some(1)], 0.0, law())
        .contact([Some(1), Some(2)], 0.0, law());
    assert_eq!(last(&s, 3.0).1.events, []);
}
