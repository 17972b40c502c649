//! Coulomb friction with a static limit above the kinetic one, beside the exact motion by events.

mod in_plane;

use super::*;
use crate::contact::{ClippedLine, ContactLaw, Tanh};
use crate::exact::events;
use crate::lane::Lane;
use crate::methods::{AverageAcceleration, Method, MoreauJean};
use crate::solve::structure::{Books, Prepared, run};

const AVERAGE: Method = Method::AverageAcceleration(AverageAcceleration);
const IMPULSES: Method = Method::MoreauJean(MoreauJean { theta: 0.5 });

fn two_limits(limit: Limit, ratio: f64) -> StructureLaw {
    StructureLaw::new(
        ClippedLine::Coulomb,
        Limit {
            static_ratio: ratio,
            ..limit
        },
    )
}

/// Blocks on springs that a frame pulls: each sticks and slips, and its springs load its neighbours.
fn blocks(ratios: &[f64], limit: impl Fn(usize) -> Limit) -> Structure {
    let n = ratios.len();
    let mut blocks = masses(&(0..n).map(|i| 1.0 + 0.1 * i as f64).collect::<Vec<_>>());
    for (i, ratio) in ratios.iter().enumerate() {
        let next = (i + 1 < n).then_some(i + 1);
        if next.is_some() {
            blocks.stiffness.add_spring([Some(i), next], 30.0);
        }
        blocks.stiffness.add_spring([None, Some(i)], 20.0);
        let law = two_limits(limit(i), *ratio);
        blocks.contacts.push(contact([None, Some(i)], 0.0, law));
    }
    let pull = Table::new(vec![0.0, 6.0, 12.0], vec![0.0, 12.0, -5.0]).unwrap();
    blocks.loads = vec![Load {
        pattern: (0..n).map(|i| (i, 1.0 + 0.03 * i as f64)).collect(),
        signal: Arc::new(Signal::Table(pull)),
    }];
    blocks
}

/// u of all nodes at the steps, S of all contacts, and the energy error.
fn steps(method: &Method, s: &Structure, dt: f64, end: f64) -> (Vec<Vec<f64>>, Vec<Vec<f64>>, f64) {
    let prepared = Prepared::by(method, s, dt).unwrap();
    let (mut u, mut forces, mut books) = (Vec::new(), Vec::new(), None::<Books<1>>);
    let count = (end / dt).round() as usize;
    let [done] = run::<1>(&[s], &prepared, count, |_, state| {
        u.push((0..s.len()).map(|i| state.displacement(i).0[0]).collect());
        let of = |c| state.contact(c);
        forces.push((0..s.contacts.len()).map(|c| of(c).force.0[0]).collect());
        for c in 0..s.contacts.len() {
            let limit = s.contacts[c].law.static_ratio() * of(c).limit.0[0];
            assert!(of(c).force.0[0].abs() <= limit * (1.0 + 1e-12), "{c}");
        }
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.unwrap();
    (u, forces, books.unwrap().energy_error().0[0])
}

/// The largest distance from the exact motion.
fn error(method: &Method, s: &Structure, dt: f64, end: f64) -> f64 {
    let (u, _, energy) = steps(method, s, dt, end);
    if *method == AVERAGE {
        assert!(energy < 1e-12, "{energy}");
    }
    let times: Vec<f64> = (0..u.len()).map(|i| i as f64 * dt).collect();
    let mut error: f64 = 0.0;
    let summary = events::run(s, &times, |i, state| {
        for (computed, exact) in u[i].iter().zip(state.u) {
            error = error.max((computed - exact).abs());
        }
    });
    assert!(summary.unwrap().events.len() > 10);
    error
}

/// A contact breaks loose and stops within a step, so that the order is 1: the error of a step ten times shorter is some ten times smaller.
#[test]
fn steps_tend_to_the_exact_motion_with_order_one() {
    let varying = |i: usize| Limit {
        varying: Some((0.3, Arc::new(sine(1.3 + 0.2 * i as f64)))),
        ..Limit::constant(1.0 + 0.13 * i as f64)
    };
    let constant = |i: usize| Limit::constant(1.0 + 0.13 * i as f64);
    for s in [
        blocks(&[1.5, 1.2, 2.0], constant),
        blocks(&[1.5, 1.0, 1.3], varying),
    ] {
        for method in [AVERAGE, IMPULSES] {
            let errors = [1e-2, 1e-3, 1e-4].map(|dt| error(&method, &s, dt, 9.0));
            // Of displacements of about 1; the place in the step at which contacts break loose scatters.
            assert!(
                errors[0] < 0.1 && errors[1] < 1e-2 && errors[2] < 1e-3,
                "{method:?} {errors:?}"
            );
            assert!(errors[2] < 0.05 * errors[0], "{method:?} {errors:?}");
        }
    }
}

fn sine(omega: f64) -> Signal {
    Signal::Sine {
        amplitude: 1.0,
        omega,
        phase: 0.2,
    }
}

/// A contact that sticks below its static limit does not break loose, whatever it had when it stopped.
#[test]
fn a_force_that_holds_does_not_alternate() {
    // It slides with 1, stops under a load of -1.5, and holds it for ever: the static limit is 2, twice 1.5 less 1 is beyond it.
    for method in [AVERAGE, IMPULSES] {
        let mut s = masses(&[1.0]);
        s.velocity[0] = 1.0;
        s.contacts = vec![contact(
            [None, Some(0)],
            0.0,
            two_limits(Limit::constant(1.0), 2.0),
        )];
        s.loads = vec![Load {
            pattern: vec![(0, -1.5)],
            signal: Arc::new(Signal::Table(Table::new(vec![0.0], vec![1.0]).unwrap())),
        }];
        let (u, forces, _) = steps(&method, &s, 0.01, 2.0);
        // v^2/(2 (1 + 1.5)).
        assert!((u[200][0] - 0.2).abs() < 1e-3, "{}", u[200][0]);
        for force in &forces[60..] {
            assert!((force[0] + 1.5).abs() < 1e-9, "{method:?} {force:?}");
        }
    }
}

/// The result does not depend on the order of contacts and bodies, and has the mirrored signs.
#[test]
fn order_and_signs_do_not_matter() {
    let limit = |i: usize| Limit::constant(1.0 + 0.13 * i as f64);
    let ratios = [1.5, 1.2, 2.0];
    let s = blocks(&ratios, limit);
    let mut other = s.clone();
    other.contacts.reverse();
    let mut mirrored = s.clone();
    for (_, factor) in &mut mirrored.loads[0].pattern {
        *factor = -*factor;
    }
    for method in [AVERAGE, IMPULSES] {
        let [given, reversed, minus] =
            [&s, &other, &mirrored].map(|s| steps(&method, s, 0.003, 9.0).0);
        for ((given, reversed), minus) in given.iter().zip(&reversed).zip(&minus) {
            for i in 0..3 {
                // Other sums have other round-off, of some thousand steps.
                assert!((given[i] - reversed[i]).abs() < 1e-11, "{method:?}");
                assert!((given[i] + minus[i]).abs() < 1e-11, "{method:?}");
            }
        }
    }
}

/// A law that is not a clipped line beside it, which has no force, leaves the motion as it is but for round-off.
#[test]
fn an_idle_contact_with_a_curved_law_changes_nothing() {
    let s = blocks(&[1.5, 1.2, 2.0], |i| Limit::constant(1.0 + 0.13 * i as f64));
    let mut beside = s.clone();
    let idle = ContactLaw::Tanh(Tanh {
        compliance: 1.0,
        limit: 0.0,
        ratio: 1.0,
        rate: 0.0,
    });
    let law = StructureLaw::new(idle, Limit::constant(0.0)).from_its_answer();
    beside.contacts.push(contact([Some(0), Some(1)], 0.0, law));
    let [alone, other] = [&s, &beside].map(|s| steps(&AVERAGE, s, 0.003, 9.0).0);
    for (alone, other) in alone.iter().zip(&other) {
        for (a, b) in alone.iter().zip(other) {
            assert!((a - b).abs() < 1e-10, "{a} {b}");
        }
    }
}

/// Lanes with a ratio of 1 and of 2 have the bits that they have alone.
#[test]
fn lanes_with_other_ratios_do_not_meet() {
    let limit = |i: usize| Limit::constant(1.0 + 0.13 * i as f64);
    let cases =
        [[1.5, 1.0, 2.0], [1.0; 3], [1.1, 1.7, 1.0], [3.0; 3]].map(|ratios| blocks(&ratios, limit));
    for method in [AVERAGE, IMPULSES] {
        let prepared = Prepared::by(&method, &cases[0], 0.003).unwrap();
        let [a, b, c, d] = &cases;
        let mut together = Vec::new();
        let done = run::<4>(&[a, b, c, d], &prepared, 3000, |_, state| {
            together.push([0, 1, 2].map(|i| state.displacement(i)));
        });
        assert!(done.iter().all(Result::is_ok));
        for (l, case) in cases.iter().enumerate() {
            let mut step = 0;
            let [done] = run::<1>(&[case], &prepared, 3000, |_, state| {
                for (i, both) in together[step].iter().enumerate() {
                    let Lane([u]) = state.displacement(i);
                    assert!(u.to_bits() == both.0[l].to_bits(), "{method:?} {l} {step}");
                }
                step += 1;
            });
            done.unwrap();
        }
    }
}
