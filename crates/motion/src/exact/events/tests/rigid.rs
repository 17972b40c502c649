//! Rigid contacts, several at once.

use super::*;
use crate::contact::ClippedLine;

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
    let stop = |e| StructureLaw::new(ClippedLine::Stop { restitution: e }, None);
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
            StructureLaw::new(ClippedLine::Stop { restitution: 0.8 }, None),
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
        StructureLaw::new(ClippedLine::Coulomb, limit),
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
fn rigid_contacts_are_the_limit_of_softened_ones() {
    // Friction with the order of the widths, impacts with the root of the compliance.
    let structure = |rigid: bool, narrow: f64| {
        let limit = |l| varying(l, 0.3, sine(1.0, 1.3, 0.4));
        let friction = |l| match rigid {
            true => StructureLaw::new(ClippedLine::Coulomb, limit(l)),
            false => StructureLaw::new(
                ClippedLine::Viscous {
                    viscosity: 1.0 / narrow,
                },
                limit(l),
            ),
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
fn two_masses_that_are_pushed_against_a_wall_leave_one_after_the_other() {
    // A is pulled by 0.2, B pushes it with cos t. The wall's force is 0.2 - cos t, so that both leave at cos t1 = 0.2 with
    // (0.2 - cos t)/2; the force between them is -(0.2 + cos t)/2, so that they part at cos t2 = -0.2.
    let stop = || StructureLaw::new(ClippedLine::Stop { restitution: 0.7 }, None);
    let pair = masses(&[1.0, 1.0])
        .load(&[(0, 1.0)], table(&[[0.0, 0.2]]))
        .load(&[(1, -1.0)], sine(1.0, 1.0, 0.5 * std::f64::consts::PI))
        .contact([None, Some(0)], 0.0, stop())
        .contact([Some(0), Some(1)], 0.0, stop());
    let [t1, t2] = [0.2, -0.2].map(libm::acos);
    let (state, summary) = last(&pair, 2.5);
    let open: Vec<&Event> = (summary.events.iter())
        .filter(|event| event.kind == EventKind::Phase(Phase::Open))
        .collect();
    assert_eq!((open.len(), open[0].contact, open[1].contact), (2, 0, 1));
    assert!((open[0].time - t1).abs() < 1e-14 && (open[1].time - t2).abs() < 1e-14);
    let both = 0.5 * (0.2 * (t2 - t1) - libm::sin(t2) + libm::sin(t1));
    let a = both + 0.2 * (2.5 - t2);
    let b = both - libm::sin(2.5) + libm::sin(t2);
    assert!((state[2] - a).abs() < 1e-14 && (state[3] - b).abs() < 1e-14);
}
