//! Several contacts at once.

use super::random::softened;
use super::restarts::restarts;
use super::*;

/// A limit constant + factor signal.
pub fn varying(constant: f64, factor: f64, signal: Signal) -> Limit {
    Limit {
        constant,
        varying: Some((factor, Arc::new(signal))),
    }
}

/// u, v and all events of a motion up to `end`.
fn last(structure: &Structure, end: f64) -> (Vec<f64>, Summary) {
    let mut last = Vec::new();
    let summary = run(structure, &[end], |_, state| {
        last = [state.u, state.v].concat()
    });
    (last, summary.unwrap())
}

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
            Relation::DisplacementControl {
                stiffness: 40.0,
                limit: varying(0.3, 0.6, sine(1.0, 2.3, 0.1)),
            },
        )
        .contact(
            [Some(1), Some(2)],
            0.1,
            Relation::ImpactSpring { stiffness: 50.0 },
        )
        .contact(
            [None, Some(2)],
            0.0,
            Relation::VelocityControl {
                viscosity: 5.0,
                limit: varying(0.5, 1.0, table(&pressure)),
            },
        )
        .contact(
            [None, Some(1)],
            0.0,
            Relation::DisplacementControl {
                stiffness: 30.0,
                limit: Limit::constant(0.4),
            },
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
fn rigid_contacts_are_the_limit_of_softened_ones() {
    // Friction with the order of the widths, impacts with the root of the compliance.
    let structure = |rigid: bool, narrow: f64| {
        let limit = |l| varying(l, 0.3, sine(1.0, 1.3, 0.4));
        let friction = |l| match rigid {
            true => Relation::Coulomb { limit: limit(l) },
            false => Relation::VelocityControl {
                viscosity: 1.0 / narrow,
                limit: limit(l),
            },
        };
        masses(&[1.0, 2.0, 0.5])
            .spring([None, Some(0)], 4.0)
            .spring([Some(0), Some(1)], 9.0)
            .spring([None, Some(2)], 1.0)
            .load(&[(0, -1.0), (1, -2.0), (2, -0.5)], sine(1.5, 1.7, 0.3))
            .moving(&[0.1, 0.0, -0.2], &[0.5, -1.0, 0.3])
            .contact([Some(0), Some(1)], 0.0, friction(0.8))
            .contact([Some(1), Some(2)], 0.0, friction(0.5))
            .contact([None, Some(2)], 0.0, friction(0.4))
    };
    let (rigid, summary) = last(&structure(true, 0.0), 8.0);
    assert!(summary.events.len() > 10, "{}", summary.events.len());
    assert!(summary.book.residual < 1e-14 * summary.book.largest);
    let error = |narrow| {
        let (soft, _) = last(&structure(false, narrow), 8.0);
        let errors = rigid.iter().zip(&soft).map(|(a, b)| (a - b).abs());
        errors.fold(0.0, f64::max)
    };
    let [wide, narrow] = [error(1e-3), error(1e-4)];
    assert!(
        narrow < 1e-3 && (wide / narrow - 10.0).abs() < 1.0,
        "{wide} {narrow}"
    );
}

#[test]
fn a_slab_drags_a_block_until_both_move_as_one() {
    // The slab (2) moves with 3, the block (1) rests on it: rdot falls by L (1/1 + 1/2), and the momentum stays.
    let slab = masses(&[1.0, 2.0])
        .moving(&[0.0, 0.0], &[0.0, 3.0])
        .contact([Some(0), Some(1)], 0.0, coulomb(0.5));
    let (state, summary) = last(&slab, 10.0);
    assert_eq!(summary.events.len(), 2);
    // 3/(0.5 1.5) = 4; slip 3 4/2 = 6, work 0.5 6.
    assert!((summary.events[1].time - 4.0).abs() < 1e-13);
    assert!((state[1] - state[0] - 6.0).abs() < 1e-13);
    assert!((state[2] - 2.0).abs() < 1e-14 && (state[3] - 2.0).abs() < 1e-14);
    assert!((summary.book.dissipated - 3.0).abs() < 1e-13);
}

#[test]
fn balls_of_equal_mass_exchange_their_velocities() {
    let stop = |e| Relation::RigidStop { restitution: e };
    let balls = |masses_of: &[f64], e: f64| {
        masses(masses_of)
            .moving(&[0.0; 3], &[1.0, 0.0, 0.0])
            .contact([Some(0), Some(1)], 0.1, stop(e))
            .contact([Some(1), Some(2)], 0.1, stop(e))
    };
    let (state, summary) = last(&balls(&[1.0; 3], 1.0), 1.0);
    for (v, expected) in state[3..].iter().zip([0.0, 0.0, 1.0]) {
        assert!((v - expected).abs() < 2e-16);
    }
    assert!((summary.least_impact_rate.unwrap() - 1.0).abs() < 2e-16);
    // Ball i gets (1 + e) m/(m + m') of the velocity before it.
    let (state, _) = last(&balls(&[3.0, 2.0, 1.0], 0.5), 0.3);
    assert!((state[5] - 1.5 * 0.6 * 1.5 * 2.0 / 3.0).abs() < 1e-15);
}

#[test]
fn a_block_that_sticks_takes_an_impact_and_slides() {
    // Friction has no impulse: the block starts with (1 + e) m/(m + M) v and slides v^2/2L.
    let block = masses(&[1.0, 2.0])
        .moving(&[0.0, 0.0], &[1.0, 0.0])
        .contact(
            [Some(0), Some(1)],
            0.5,
            Relation::RigidStop { restitution: 0.8 },
        )
        .contact([None, Some(1)], 0.0, coulomb(0.3));
    let (state, summary) = last(&block, 20.0);
    let v = 1.8 / 3.0;
    assert!((state[1] - 2.0 * v * v / (2.0 * 0.3)).abs() < 1e-14);
    assert_eq!(state[3], 0.0);
    assert!(summary.book.residual < 1e-15);
}

#[test]
fn friction_ends_where_the_limit_falls_below_the_load() {
    // Pulled by 0.5 with the limit 1 - t/10 from t = 0 to 10: it slides from t = 5 on, u'' = (t - 5)/10, and is free from 10 on.
    let limit = varying(0.0, 1.0, table(&[[0.0, 1.0], [12.0, -0.2]]));
    let block = one().load(&[(0, 1.0)], table(&[[0.0, 0.5]])).contact(
        [None, Some(0)],
        0.0,
        Relation::Coulomb { limit },
    );
    let (states, summary) = first(&block, &[5.0, 8.0, 12.0]);
    let times: Vec<f64> = summary.events.iter().map(|event| event.time).collect();
    // The first event is the start of sticking.
    assert!((times[1] - 5.0).abs() < 1e-12 && (times[2] - 10.0).abs() < 1e-12);
    assert_eq!(states[0].u, 0.0);
    assert!((states[1].u - 27.0 / 60.0).abs() < 1e-12);
    let free = 125.0 / 60.0 + 1.25 * 2.0 + 0.25 * 4.0;
    assert!((states[2].u - free).abs() < 1e-12, "{}", states[2].u);
}

#[test]
fn equal_blocks_that_slide_at_one_time_move_as_one() {
    let pair = |count: usize| {
        let mut s = masses(&vec![1.0; count]);
        for i in 0..count {
            s = s.load(&[(i, 1.0)], sine(1.0, 1.0, 0.0));
            s = s.contact([None, Some(i)], 0.0, coulomb(0.7));
            s = s.spring([None, Some(i)], 0.2);
        }
        for i in 1..count {
            s = s.spring([Some(i - 1), Some(i)], 3.0);
        }
        last(&s, 50.0).0
    };
    let (alone, three) = (pair(1), pair(3));
    for i in 0..3 {
        assert!((three[i] - alone[0]).abs() < 1e-12 && (three[3 + i] - alone[1]).abs() < 1e-12);
    }
}

#[test]
fn contacts_in_parallel_hold_what_both_can() {
    // The limits add up to 1.0: the block slides where sin t = 1.
    let block = |limits: &[f64], most: f64| {
        let mut s = one().load(&[(0, 1.0)], sine(most, 1.0, 0.0));
        for limit in limits {
            s = s.contact([None, Some(0)], 0.0, coulomb(*limit));
        }
        last(&s, 20.0).0
    };
    assert!(block(&[0.7, 0.3], 0.99).iter().all(|x| x.abs() < 1e-16));
    for (a, b) in block(&[0.7, 0.3], 1.6).iter().zip(block(&[1.0], 1.6)) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
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
    let mut all = Vec::new();
    run(&s, &steps(0.01, 1000), |i, state| {
        if i % 100 == 0 {
            all.push(state.u.to_vec());
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
    assert_eq!(all, few);
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
            Relation::ImpactSpring { stiffness: 1000.0 },
        );
    }
    for i in [0, 12, 24] {
        let limit = Limit::constant(1.0);
        let law = Relation::DisplacementControl {
            stiffness: 100.0,
            limit,
        };
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
    assert_eq!(fault, EventsFault::TooManyPieces { most, time: 0.0 });
}
