//! Contacts that are decided by later derivatives of their forces, and after impacts.

use super::*;
use crate::contact::ClippedLine;

/// The phases of a contact, without their times.
fn phases(summary: &Summary, contact: usize) -> Vec<EventKind> {
    let of_pair = summary
        .events
        .iter()
        .filter(|event| event.contact == contact);
    of_pair.map(|event| event.kind).collect()
}

/// Node 0 with a load at its limit of 1, and `more` nodes on springs behind it, the last one with a load.
fn at_the_limit(more: usize, last_load: f64) -> Structure {
    let mut s = masses(&vec![1.0; 1 + more])
        .load(&[(0, 1.0)], table(&[[0.0, 1.0]]))
        .load(&[(more, last_load)], table(&[[0.0, 1.0]]))
        .contact([None, Some(0)], 0.0, coulomb(1.0));
    for i in 0..more {
        s = s.spring([Some(i), Some(i + 1)], 1.0);
    }
    s
}

#[test]
fn a_block_at_its_limit_is_decided_by_the_first_derivative_of_its_load_that_is_not_0() {
    // One node behind: the load on the block is 1 - F (1 - cos t), which falls with t^2. It sticks up to t = 2 pi if F < 1.
    let (state, summary) = last(&at_the_limit(1, -0.7), 6.0);
    assert_eq!(state[0], 0.0);
    assert!((state[1] + 0.7 * (1.0 - libm::cos(6.0))).abs() < 1e-14);
    assert_eq!(phases(&summary, 0), [EventKind::Phase(Phase::Closed)]);
    assert_eq!(summary.book.dissipated, 0.0);
    // Two nodes behind: it falls with t^4. u2'' = u1 - u2 - F, u1'' = u2 - 2 u1 with u0 = 0.
    let (state, summary) = last(&at_the_limit(2, -0.2), 2.0);
    assert_eq!((state[0], summary.book.dissipated), (0.0, 0.0));
    assert_eq!(phases(&summary, 0), [EventKind::Phase(Phase::Closed)]);
    // The other way it slides from t = 0 on: both move as a free pair under F and 1 - 1.
    let (state, summary) = last(&at_the_limit(1, 0.7), 3.0);
    let centre = 0.7 * 9.0 / 4.0;
    let apart = 0.35 * (1.0 - libm::cos(3.0 * f64::sqrt(2.0)));
    assert!(
        (state[0] - (centre - 0.5 * apart)).abs() < 1e-13,
        "{state:?}"
    );
    assert!(
        (state[1] - (centre + 0.5 * apart)).abs() < 1e-13,
        "{state:?}"
    );
    assert_eq!(phases(&summary, 0), [EventKind::Phase(Phase::Sliding(1.0))]);
}

#[test]
fn a_body_between_two_stops_on_one_side_stays_there_while_it_is_pushed_harder() {
    // The forces of both stops are not unique. Without any force at t = 0, the load -t decides: nothing ever moves.
    let stop = || StructureLaw::new(ClippedLine::Stop { restitution: 0.5 }, None);
    let s = one()
        .load(&[(0, -1.0)], table(&[[0.0, 0.0], [5.0, 5.0]]))
        .contact([None, Some(0)], 0.0, stop())
        .contact([None, Some(0)], 0.0, stop());
    let (state, summary) = last(&s, 4.0);
    // Round-off of the load of 4.
    assert!(state.iter().all(|x| x.abs() < 1e-14), "{state:?}");
    let impacts = summary
        .events
        .iter()
        .filter(|event| matches!(event.kind, EventKind::Impact { .. }));
    assert_eq!(impacts.count(), 0);
}

#[test]
fn viscous_friction_is_at_its_limit_after_an_impact() {
    // A body with 2 strikes another of the same mass at t = 1/2, which then slides with 2 - t up to 1/2 = limit/c, 1.5 later.
    let law = StructureLaw::new(
        ClippedLine::Viscous { viscosity: 2.0 },
        Limit::constant(1.0),
    );
    let s = masses(&[1.0, 1.0])
        .moving(&[0.0, 0.0], &[2.0, 0.0])
        .contact(
            [Some(0), Some(1)],
            1.0,
            StructureLaw::new(ClippedLine::Stop { restitution: 1.0 }, None),
        )
        .contact([None, Some(1)], 0.0, law);
    let (state, summary) = last(&s, 3.0);
    let slow = 0.5 * libm::exp(-2.0);
    assert!((state[1] - (2.0 * 1.5 - 0.5 * 1.5 * 1.5 + 0.25 - 0.5 * slow)).abs() < 1e-13);
    assert!((state[3] - slow).abs() < 1e-13);
    assert_eq!(
        phases(&summary, 1),
        [Phase::Closed, Phase::Sliding(1.0), Phase::Closed].map(EventKind::Phase)
    );
}

#[test]
fn friction_that_an_impact_turns_round_keeps_the_stop_shut() {
    // Body 0 slides with 2 - t, body 1 comes with -5: 7 t - t^2/2 = 1 at t = 7 - sqrt(47). Then both have w = (2 - t - 5)/2, and
    // friction, which now pushes body 0 to body 1, slows both down by 1/2. In its former direction it would part them.
    let law = StructureLaw::new(
        ClippedLine::Viscous { viscosity: 2.0 },
        Limit::constant(1.0),
    );
    let s = masses(&[1.0, 1.0])
        .moving(&[0.0, 1.0], &[2.0, -5.0])
        .contact(
            [Some(0), Some(1)],
            0.0,
            StructureLaw::new(ClippedLine::Stop { restitution: 0.0 }, None),
        )
        .contact([None, Some(0)], 0.0, law);
    let (state, summary) = last(&s, 1.0);
    let before = 7.0 - f64::sqrt(47.0);
    let (after, w) = (1.0 - before, -0.5 * (3.0 + before));
    let u = 2.0 * before - 0.5 * before * before + w * after + 0.25 * after * after;
    let v = w + 0.5 * after;
    for (x, expected) in state.iter().zip([u, u, v, v]) {
        assert!((x - expected).abs() < 1e-13, "{state:?} {expected}");
    }
    let slides = [1.0, -1.0].map(|direction| EventKind::Phase(Phase::Sliding(direction)));
    assert_eq!(phases(&summary, 1), slides);
    let [EventKind::Impact { rate }, EventKind::Phase(Phase::Closed)] = phases(&summary, 0)[..]
    else {
        panic!("{:?}", summary.events);
    };
    assert!((rate + 7.0 - before).abs() < 1e-13);
}

#[test]
fn the_least_rate_of_impacts_need_not_be_the_last_or_the_first() {
    let stop = || StructureLaw::new(ClippedLine::Stop { restitution: 1.0 }, None);
    let s = masses(&[1.0; 3])
        .moving(&[0.0; 3], &[-1.0, -0.5, -2.0])
        .contact([None, Some(0)], 0.1, stop())
        .contact([None, Some(1)], 0.1, stop())
        .contact([None, Some(2)], 1.0, stop());
    // At 0.1, 0.2 and 0.5.
    let (_, summary) = last(&s, 1.0);
    let rates: Vec<EventKind> = summary
        .events
        .iter()
        .map(|event| event.kind)
        .filter(|kind| matches!(kind, EventKind::Impact { .. }))
        .collect();
    assert_eq!(
        rates,
        [-1.0, -0.5, -2.0].map(|rate| EventKind::Impact { rate })
    );
    assert_eq!(summary.least_impact_rate, Some(0.5));
}
