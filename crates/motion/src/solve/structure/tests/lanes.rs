//! The bits of a case do not depend on its lane. One number of lanes stands for all: each further one takes seconds to compile.

use super::*;
use crate::contact::ClippedLine;
use crate::lane::Lane;
use crate::methods::{AverageAcceleration, Bathe, Coefficients, Method, MoreauJean};
use crate::solve::Unsolvable;
use crate::solve::structure::{Books, Prepared, run};

const STEPS: usize = 1500;

/// Bits of every node and contact at each step, and of the books, for each lane.
fn bits<const L: usize>(cases: &[&Structure; L]) -> [Vec<u64>; L] {
    bits_by(
        &Method::AverageAcceleration(AverageAcceleration),
        STEPS,
        cases,
    )
}

fn bits_by<const L: usize>(
    method: &Method,
    steps: usize,
    cases: &[&Structure; L],
) -> [Vec<u64>; L] {
    let prepared = Prepared::by(method, cases[0], 0.002).unwrap();
    assert!(cases.iter().all(|case| prepared.fits(method, case, 0.002)));
    let mut bits = [const { Vec::new() }; L];
    let mut books: Option<Books<L>> = None;
    let mut put = |lane: Lane<L>| {
        for (bits, x) in bits.iter_mut().zip(lane.0) {
            bits.push(x.to_bits());
        }
    };
    let done = run::<L>(cases, &prepared, steps, |_, state| {
        for node in 0..state.nodes() {
            put(state.displacement(node));
            put(state.velocity(node));
        }
        for c in 0..state.contacts() {
            let now = state.contact(c);
            let channels = [
                now.displacement,
                now.velocity,
                now.force,
                now.limit,
                now.slip,
            ];
            channels.into_iter().for_each(&mut put);
        }
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
        put(books.iter().next().unwrap().energy_error());
    });
    assert!(done.iter().all(Result::is_ok));
    bits
}

#[test]
fn a_case_has_the_same_bits_in_every_lane() {
    let (ground, other) = (ground(), ground());
    let mut cases = Vec::new();
    for i in 0..4 {
        let scale = 0.3 + 0.4 * f64::from(i);
        let signal = if i == 2 { &other } else { &ground };
        cases.push(girders(4, 0.2 * scale, scale, signal));
    }
    for i in [1, 2] {
        // Other laws, and limits that change, in some lanes only.
        let laws = mixed(4, 1.3, &ground).contacts;
        for (contact, other) in cases[i].contacts.iter_mut().zip(laws) {
            contact.law = other.law;
        }
    }
    let cases: Vec<&Structure> = cases.iter().collect();
    let alone: Vec<Vec<u64>> = cases.iter().flat_map(|case| bits::<1>(&[case])).collect();
    let together = bits::<4>(cases[..].try_into().unwrap());
    for l in 0..4 {
        assert!(alone[l] == together[l], "lane {l}");
    }
    // In other lanes, beside others, and twice.
    for order in [[3, 2, 1, 0], [2, 0, 3, 2]] {
        let together = bits::<4>(&order.map(|i| cases[i]));
        assert!(together == order.map(|i| alone[i].clone()), "{order:?}");
    }
}

#[test]
fn a_case_has_the_same_bits_in_every_lane_by_every_method() {
    let ground = ground();
    let mut cases = [
        girders(4, 0.1, 1.0, &ground),
        mixed(4, 1.3, &ground),
        girders(4, 0.2, 1.7, &ground),
    ];
    cases[1].contacts.truncate(5);
    for method in [
        Method::Family(Coefficients::hht(-0.1)),
        Method::Bathe(Bathe),
        Method::MoreauJean(MoreauJean { theta: 0.5 }),
    ] {
        cases[2].contacts[2].gap = 0.01;
        for c in 0..3 {
            // Rigid impacts in one lane only; the last is friction with a limit that changes in another.
            cases[2].contacts[c].law =
                StructureLaw::new(ClippedLine::Stop { restitution: 0.6 }, None);
        }
        let alone = cases.each_ref().map(|case| {
            let [bits] = bits_by::<1>(&method, 600, &[case]);
            bits
        });
        for order in [[0, 1, 2, 0], [2, 2, 1, 0]] {
            let together = bits_by::<4>(&method, 600, &order.map(|i| &cases[i]));
            let alone = order.map(|i| alone[i].clone());
            assert!(together == alone, "{method:?}, {order:?}");
        }
    }
}

#[test]
fn a_lane_that_fails_leaves_the_others_alone() {
    let ground = ground();
    let good = girders(2, 1.0, 1.0, &ground);
    let mut bad = good.clone();
    // Two rigid contacts between the same nodes: their forces are not unique.
    for c in [2, 3] {
        bad.contacts[c].along = bad.contacts[4].along.clone();
    }
    let mut good = good;
    for c in [2, 3] {
        good.contacts[c].along = good.contacts[4].along.clone();
    }
    for c in [2, 3] {
        bad.contacts[c].law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1e3));
    }
    let prepared = Prepared::new(&good, 0.002).unwrap();
    let mut last = [0.0; 2];
    let done = run::<4>(&[&bad, &good, &bad, &good], &prepared, 500, |_, state| {
        last[0] = state.displacement(3).0[1];
    });
    let words = done[0].as_ref().unwrap_err().to_string();
    assert!(
        words.starts_with("step 0: the contact forces are not unique"),
        "{words}"
    );
    assert_eq!([&done[1], &done[3]], [&Ok(()), &Ok(())]);
    let [alone] = run::<1>(&[&good], &prepared, 500, |_, state| {
        last[1] = state.displacement(3).0[0];
    });
    alone.unwrap();
    assert_eq!(last[0].to_bits(), last[1].to_bits());
}

#[test]
fn a_lane_fails_at_the_step_from_which_its_forces_are_not_unique() {
    // Both contacts are open until t = 0.5 and stick from then on.
    let signal = Signal::Table(Table::new(vec![0.0, 0.5, 0.5], vec![0.0, 0.0, 1.0]).unwrap());
    let limit = Limit {
        constant: 0.0,
        varying: Some((1e3, Arc::new(signal))),
        ..Limit::constant(0.0)
    };
    let mut stuck = masses(&[1.0]);
    let law = StructureLaw::new(ClippedLine::Coulomb, limit);
    stuck.contacts = vec![contact([None, Some(0)], 0.0, law); 2];
    let mut free = stuck.clone();
    for contact in &mut free.contacts {
        contact.law = displacement_control(1.0, 1.0);
    }
    let prepared = Prepared::new(&stuck, 0.25).unwrap();
    let done = run::<4>(&[&stuck, &free, &free, &stuck], &prepared, 10, |_, _| ());
    let why = crate::contact::Unsolved::Singular;
    let no_forces = Err(Unsolvable::NoForces { step: 2, why });
    assert_eq!(done, [no_forces.clone(), Ok(()), Ok(()), no_forces]);
}

#[test]
fn a_motion_that_grows_without_bound_is_out_of_range() {
    // C < 0: v grows by (1 + 1/2)/(1 - 1/2) = 3 in a step.
    let mut moving = masses(&[1.0]);
    moving.damping.add(0, 0, -10.0);
    moving.contacts = vec![contact(
        [None, Some(0)],
        0.0,
        displacement_control(1.0, 1.0),
    )];
    let rest = moving.clone();
    moving.velocity[0] = 1.0;
    let prepared = Prepared::new(&moving, 0.1).unwrap();
    let run = |steps| run::<4>(&[&moving, &rest, &rest, &rest], &prepared, steps, |_, _| ());
    assert_eq!(run(600), [Ok(()), Ok(()), Ok(()), Ok(())]);
    let out_of_range = Err(Unsolvable::OutOfRange);
    assert_eq!(run(700), [out_of_range, Ok(()), Ok(()), Ok(())]);
}
