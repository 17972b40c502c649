//! The method of Moreau and Jean with rigid stops and Coulomb friction.

use super::*;
use crate::contact::ClippedLine;
use crate::exact::events::{self, EventKind};
use proptest::prelude::*;

const THETA: Method = Method::MoreauJean(MoreauJean { theta: 0.5 });

fn stop(between: [Option<usize>; 2], gap: f64, restitution: f64) -> Contact {
    contact(
        between,
        gap,
        StructureLaw::new(ClippedLine::Stop { restitution }, None),
    )
}

/// Constant forces, mass times -9.81.
fn weight(structure: &mut Structure) {
    let masses = structure.nodes.iter().enumerate();
    structure.loads.push(Load {
        pattern: masses.map(|(i, node)| (i, -9.81 * node.mass)).collect(),
        signal: Arc::new(Signal::Table(Table::new(vec![0.0], vec![1.0]).unwrap())),
    });
}

/// A ball that falls by 1.
fn ball(restitution: f64) -> Structure {
    let mut ball = masses(&[0.7]);
    ball.displacement[0] = 1.0;
    weight(&mut ball);
    ball.contacts = vec![stop([None, Some(0)], 0.0, restitution)];
    ball
}

#[test]
fn round_off_does_not_open_a_stop_that_stays_shut() {
    // Two masses of 1, the first on a spring of 100, the second pressed on it by 10: both move as one mass on the spring, so that
    // u'' = -5 cos(omega t) and the force between them is 10 + u'', from 5 to 15.
    for (gap, restitution) in [(0.0, 0.0), (0.0, 0.5), (0.0, 1.0), (0.3, 0.0)] {
        let mut pair = masses(&[1.0, 1.0]);
        pair.displacement[1] = -gap;
        pair.stiffness.add_spring([None, Some(0)], 100.0);
        pair.loads.push(Load {
            pattern: vec![(1, -10.0)],
            signal: Arc::new(Signal::Table(Table::new(vec![0.0], vec![1.0]).unwrap())),
        });
        pair.contacts = vec![stop([Some(0), Some(1)], gap, restitution)];
        let omega = 50f64.sqrt();
        for dt in [0.01, 0.001] {
            books(&THETA, &pair, dt, (20.0 / dt) as usize, |step, state| {
                let [r, rdot, s] = contact_of(state, 0);
                assert!(
                    r.abs() < 1e-12 && rdot.abs() < 1e-12,
                    "{gap} {restitution} {step}: {r} {rdot}"
                );
                if step > 0 {
                    // The period is wrong by (omega dt)^2/12, for 141 rad; the mean of both ends is cos(omega dt/2) times the middle.
                    let t = (step as f64 - 0.5) * dt;
                    let exact = -10.0 + 5.0 * (omega * t).cos();
                    let most = 5.0 * (omega * dt).powi(2) * (omega * t / 12.0 + 0.13) + 1e-9;
                    assert!(
                        (s - exact).abs() < most,
                        "{gap} {restitution} {dt} {step}: {s} {exact}"
                    );
                }
            });
        }
    }
}

#[test]
fn a_ball_bounces_at_the_times_and_speeds_of_the_exact_motion_within_first_order() {
    let ball = ball(0.8);
    let summary = events::run(&ball, &[0.0, 2.5], |_, _| ()).unwrap();
    let impacts = summary.events.iter().filter_map(|event| match event.kind {
        EventKind::Impact { rate } => Some((event.time, rate)),
        EventKind::Phase(_) => None,
    });
    let exact: Vec<(f64, f64)> = impacts.collect();
    assert_eq!(exact.len(), 4);
    for dt in [2e-3, 1e-3, 5e-4, 2.5e-4] {
        let mut impacts = Vec::new();
        let mut before = 0.0;
        books(&THETA, &ball, dt, (2.4 / dt) as usize, |step, state| {
            let [r, rdot, s] = contact_of(state, 0);
            // It falls with less than 4.5.
            assert!(r > -4.5 * dt);
            if s < 0.0 {
                impacts.push((step as f64 * dt, before));
            }
            before = rdot;
        });
        for (k, ((t, v), (te, ve))) in impacts.iter().zip(&exact).enumerate().take(4) {
            // A step for each impact so far; a flight is as much longer as twice a speed that is too high by g dt.
            let most = 3.0 * (k as f64 + 1.0) * dt;
            assert!((t - te).abs() < most, "{dt} {k} {t} {te}");
            assert!((v - ve).abs() < 9.81 * most, "{dt} {k} {v} {ve}");
        }
    }
}

#[test]
fn an_impact_keeps_its_restitution_and_the_books() {
    for e in [0.0, 0.3, 0.8, 1.0] {
        let mut pair = masses(&[2.0, 3.0]);
        pair.velocity = vec![1.0, -0.5];
        pair.contacts = vec![stop([Some(0), Some(1)], 0.2, e)];
        let mut end = [0.0; 2];
        let books = books(&THETA, &pair, 0.013, 60, |_, state| {
            end = [0, 1].map(|i| state.velocity(i).0[0]);
        });
        // Momentum 0.5 and rdot' = 1.5 e.
        let expected = [(0.5 - 3.0 * 1.5 * e) / 5.0, (0.5 + 2.0 * 1.5 * e) / 5.0];
        for (v, expected) in end.iter().zip(expected) {
            assert!((v - expected).abs() < 1e-15, "{e} {end:?}");
        }
        // 1/2 m (1 - e^2) v^2 with m = 6/5.
        let lost = 0.5 * 1.2 * (1.0 - e * e) * 1.5 * 1.5;
        assert!((books.work(0).0[0] - lost).abs() < 1e-15);
        assert!(books.numerical_dissipation().0[0].abs() < 1e-15);
    }
}

#[test]
fn balls_in_a_row_move_like_the_exact_motion() {
    // In touch at the start, or not: then one impact follows the other.
    for gap in [0.0, 0.05] {
        let mut row = masses(&[1.0, 1.0, 1.0, 2.0]);
        row.velocity[0] = 1.0;
        row.contacts = (0..3)
            .map(|i| stop([Some(i), Some(i + 1)], if i == 0 { 0.1 } else { gap }, 0.9))
            .collect();
        let mut exact = Vec::new();
        events::run(&row, &[1.0], |_, state| exact = state.v.to_vec()).unwrap();
        books(&THETA, &row, 0.001, 1000, |step, state| {
            if step == 1000 {
                for (i, exact) in exact.iter().enumerate() {
                    let v = state.velocity(i).0[0];
                    // No forces act: impacts are exact but for their instants.
                    assert!((v - exact).abs() < 1e-13, "{gap} {i} {v} {exact}");
                }
            }
        });
    }
}

#[test]
fn a_pile_at_rest_stays_at_rest() {
    let mut pile = masses(&[1.0, 3.0, 0.2]);
    weight(&mut pile);
    pile.displacement = vec![0.1, 0.3, 0.7];
    pile.contacts = vec![
        stop([None, Some(0)], -0.1, 0.5),
        stop([Some(0), Some(1)], -(0.3 - 0.1), 0.5),
        stop([Some(1), Some(2)], -(0.7 - 0.3), 0.0),
    ];
    books(&THETA, &pile, 0.01, 1000, |_, state| {
        for i in 0..3 {
            assert_eq!(state.velocity(i).0[0], 0.0);
            assert_eq!(state.displacement(i).0[0], pile.displacement[i]);
        }
        let [_, _, s] = contact_of(state, 0);
        assert!((s + 9.81 * 4.2).abs() < 1e-12, "{s}");
    });
}

#[test]
fn a_dropped_pile_comes_to_rest() {
    let mut pile = masses(&[1.0, 3.0, 0.2]);
    weight(&mut pile);
    pile.displacement = vec![0.1, 0.3, 0.7];
    pile.velocity[2] = -3.0;
    pile.contacts = vec![
        stop([None, Some(0)], 0.0, 0.5),
        stop([Some(0), Some(1)], -0.1, 0.2),
        stop([Some(1), Some(2)], -0.2, 0.0),
    ];
    let mut last = [[1.0; 3]; 3];
    books(&THETA, &pile, 0.002, 3000, |_, state| {
        for (c, last) in last.iter_mut().enumerate() {
            *last = contact_of(state, c);
            // An impact leaves an overlap of up to dt times its speed, at most 5 here.
            assert!(last[0] > -5.0 * 0.002, "{last:?}");
        }
    });
    for (c, [r, rdot, s]) in last.into_iter().enumerate() {
        let above: f64 = [4.2, 3.2, 0.2][c];
        // A stop without a velocity is active only where it is shut.
        assert!(r <= 0.0 && rdot.abs() < 1e-12, "{c} {r} {rdot}");
        assert!((s + 9.81 * above).abs() < 1e-11, "{c} {s}");
    }
}

#[test]
fn friction_holds_a_block_with_zero_velocity_until_its_limit() {
    let mut block = masses(&[2.0]);
    let limit = Limit::constant(3.0);
    block.contacts = vec![contact(
        [None, Some(0)],
        0.0,
        StructureLaw::new(ClippedLine::Coulomb, limit),
    )];
    let table = Table::new(vec![0.0, 4.0], vec![0.0, 4.0]).unwrap();
    block.loads = vec![Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(Signal::Table(table)),
    }];
    let dt = 0.01;
    books(&THETA, &block, dt, 400, |step, state| {
        let ([_, rdot, s], t) = (contact_of(state, 0), step as f64 * dt);
        if t < 3.0 {
            assert_eq!(rdot, 0.0);
        }
        if t > 3.0 + dt {
            // v = (t - 3)^2/4: the load of a step is the mean of its ends.
            assert!((rdot - 0.25 * (t - 3.0) * (t - 3.0)).abs() < 1e-3);
            assert_eq!(s, 3.0);
        }
    });
    // And stops at t = 2 if it slides freely from v = 3.
    block.loads.clear();
    block.velocity[0] = 3.0;
    let books = books(&THETA, &block, dt, 300, |step, state| {
        let [r, rdot, _] = contact_of(state, 0);
        if step > 200 {
            assert_eq!(rdot, 0.0);
            assert!((r - 3.0).abs() < 1e-12, "{r}");
        }
    });
    assert!((books.work(0).0[0] - 9.0).abs() < 1e-12);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 40, ..ProptestConfig::default() })]

    /// Masses in a row between springs, stops between all, a wall or friction, and a shaking ground.
    #[test]
    fn stops_of_random_structures_obey_newtons_rule(
        mass in prop::collection::vec(0.1..5.0_f64, 6),
        stiffness in prop::collection::vec(0.0..300.0_f64, 7),
        gaps in prop::collection::vec(0.0..0.2_f64, 7),
        restitution in prop::collection::vec(0.0..=1.0_f64, 7),
        limit in 0.0..5.0_f64,
        wall in any::<bool>(),
        theta in 0.5..=1.0_f64,
        dt in prop::sample::select(vec![0.001, 0.01, 0.05]),
    ) {
        let mut row = masses(&mass);
        let n = mass.len();
        let node = |i: usize| (1..=n).contains(&i).then(|| i - 1);
        for i in 0..=n {
            let between = [node(i), node(i + 1)];
            row.stiffness.add_spring(between, stiffness[i]);
            row.damping.add_spring(between, 1e-3 * stiffness[i]);
            // A wall, or friction on the ground: with both, or with a second wall, the forces of a jammed row are not unique.
            if i > 0 && i < n || i == 0 && wall {
                row.contacts.push(stop(between, gaps[i], restitution[i]));
            }
        }
        if !wall {
            let law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(limit));
            row.contacts.push(contact([None, Some(3)], 0.0, law));
        }
        row.contacts.push(contact([Some(1), Some(4)], 0.0, displacement_control(50.0, 2.0)));
        row.loads = vec![Load {
            pattern: mass.iter().enumerate().map(|(i, m)| (i, -m * 5.0)).collect(),
            signal: ground(),
        }];
        let method = Method::MoreauJean(MoreauJean { theta });
        let stops: Vec<(usize, f64)> = row.contacts.iter().enumerate().filter_map(|(c, contact)| match contact.law.line() {
            Some(ClippedLine::Stop { restitution }) => Some((c, restitution)),
            _ => None,
        }).collect();
        let mut before: Vec<[f64; 3]> = Vec::new();
        let mut wrong = None;
        let books = books(&method, &row, dt, 400, |step, state| {
            let now: Vec<_> = (0..row.contacts.len()).map(|c| contact_of(state, c)).collect();
            let fastest = (0..n).fold(1.0, |most: f64, i| most.max(state.velocity(i).0[0].abs()));
            for (c, e) in stops.iter().filter(|_| step > 0) {
                let ([r, rdot, _], [_, after, s]) = (before[*c], now[*c]);
                // Newton's rule of a stop whose predicted gap is not positive: 0 <= rdot' + e rdot, S' <= 0, one of both is 0.
                let missing = after + e * rdot;
                let near = 1e-10 * fastest;
                let holds = match r + 0.5 * dt * rdot <= 0.0 {
                    true => s <= 0.0 && missing > -near && (s == 0.0 || missing < near),
                    false => s == 0.0,
                };
                if !holds {
                    wrong = Some((step, *c, r, rdot, after, s));
                }
            }
            before = now;
        });
        prop_assert!(wrong.is_none(), "{:?}", wrong);
        prop_assert!(books.energy_error().0[0] < 1e-11, "{:?}", books.energy_error());
    }
}
