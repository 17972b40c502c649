//! Laws of straight lines with yielding.

use super::*;
use crate::contact::{
    Bilinear, ClippedLine, ContactLaw, GapYield, ImpactYield, Multilinear, Pendulum, Restrainer,
};
use crate::methods::{AverageAcceleration, Method};
use crate::solve::structure::{Prepared, run as run_steps};

fn link(law: ContactLaw) -> StructureLaw {
    StructureLaw::new(law, None)
}

fn impact(law: ContactLaw) -> StructureLaw {
    StructureLaw::new(law, None).from_its_answer()
}

fn bilinear() -> StructureLaw {
    link(ContactLaw::Bilinear(Bilinear {
        stiffness: 40.0,
        yield_force: 3.0,
        hardening: 4.0,
    }))
}

fn softening() -> StructureLaw {
    link(ContactLaw::Bilinear(Bilinear {
        stiffness: 40.0,
        yield_force: 3.0,
        hardening: -4.0,
    }))
}

fn gap_yield(damage: bool, hardening: f64) -> StructureLaw {
    impact(ContactLaw::GapYield(GapYield {
        stiffness: 50.0,
        yield_force: 4.0,
        hardening,
        damage,
    }))
}

fn restrainer() -> StructureLaw {
    link(ContactLaw::Restrainer(Restrainer {
        slack: 0.05,
        stiffness: 50.0,
        yield_force: 4.0,
        hardening: 0.1,
    }))
}

fn multilinear(table: &[[f64; 2]]) -> StructureLaw {
    let law = Multilinear::new(table).unwrap();
    link(ContactLaw::Multilinear(law))
}

fn impact_yield() -> StructureLaw {
    impact(ContactLaw::ImpactYield(ImpactYield {
        stiffness: 60.0,
        hardening: 20.0,
        yield_overlap: 0.03,
    }))
}

fn pendulum() -> StructureLaw {
    let limit = 1.5;
    StructureLaw::new(
        ContactLaw::Pendulum(Pendulum {
            compliance: 0.01,
            limit,
            restoring: 2.0,
            at_rest: [limit, 1.0],
            rising: [1.0, 0.0],
        }),
        Limit::constant(limit),
    )
    .from_its_answer()
}

/// Two masses that a sine drives, with this law twice.
fn driven(law: &StructureLaw) -> Structure {
    let push = Signal::Sine {
        amplitude: 12.0,
        omega: 5.0,
        phase: 0.3,
    };
    masses(&[1.0, 0.6])
        .spring([None, Some(0)], 9.0)
        .spring([Some(0), Some(1)], 30.0)
        .dashpot([None, Some(1)], 0.2)
        .contact([None, Some(0)], 0.02, law.clone())
        .contact([Some(0), Some(1)], 0.01, law.clone())
        .load(&[(0, 1.0), (1, -0.7)], push)
        .moving(&[0.1, 0.05], &[2.0, -1.0])
}

fn every() -> Vec<StructureLaw> {
    vec![
        bilinear(),
        softening(),
        gap_yield(true, 0.1),
        gap_yield(false, 0.1),
        gap_yield(false, 0.0),
        restrainer(),
        multilinear(&[[0.03, 1.2], [0.1, 3.0], [0.3, 4.0]]),
        multilinear(&[
            [-0.2, -2.5],
            [-0.1, -2.5],
            [-0.0625, -2.5],
            [0.03, 1.2],
            [0.1, 3.0],
            [0.3, 4.0],
        ]),
        impact_yield(),
        pendulum(),
    ]
}

/// u, u', r and S of both at these times, and the summary.
fn exact(structure: &Structure, times: &[f64]) -> (Vec<[f64; 8]>, Summary) {
    let mut rows = Vec::new();
    let summary = run(structure, times, |_, state| {
        let [u, v] = [state.u, state.v].map(|x| [x[0], x[1]]);
        let [r, s] = [state.r, state.force].map(|x| [x[0], x[1]]);
        rows.push([u[0], u[1], v[0], v[1], r[0], r[1], s[0], s[1]]);
    });
    (rows, summary.unwrap())
}

fn times(end: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|i| end * i as f64 / count as f64).collect()
}

#[test]
fn energy_is_kept_and_steps_tend_to_the_motion() {
    for law in every() {
        let structure = driven(&law);
        let (rows, summary) = exact(&structure, &times(4.0, 400));
        let book = summary.book;
        assert!(book.residual < 1e-12 * book.largest, "{law:?} {book:?}");
        let yields = |event: &&Event| matches!(event.kind, EventKind::Phase(Phase::Sliding(_)));
        let count = summary.events.iter().filter(yields).count();
        assert!(count > 2 && summary.events.len() > 8, "{law:?} {count}");
        let average = Method::AverageAcceleration(AverageAcceleration);
        let errors = [16, 64].map(|parts| {
            let dt = 0.01 / parts as f64;
            let prepared = Prepared::by(&average, &structure, dt).unwrap();
            let mut worst = 0.0_f64;
            let [done] = run_steps::<1>(&[&structure], &prepared, 400 * parts, |step, state| {
                if step % parts == 0 {
                    let row = rows[step / parts];
                    for i in 0..2 {
                        let found = [state.displacement(i), state.contact(i).displacement];
                        for (found, k) in found.into_iter().zip([i, 4 + i]) {
                            worst = worst.max((found.0[0] - row[k]).abs());
                        }
                    }
                }
            });
            done.unwrap();
            worst
        });
        // The second order: a corner within a step costs that much, too.
        assert!(
            errors[0] < 2e-4 && errors[1] < 0.12 * errors[0],
            "{law:?} {errors:?}"
        );
    }
}

#[test]
fn yielding_parts_are_springs_with_friction_beside_them() {
    let friction = |k: f64, limit: f64| {
        StructureLaw::new(
            ClippedLine::Elastic { stiffness: k },
            Limit::constant(limit),
        )
    };
    let at_rest = |structure: Structure| {
        let mut structure = structure.moving(&[0.0, 0.0], &[2.0, -1.0]);
        structure
            .contacts
            .iter_mut()
            .for_each(|contact| contact.gap = 0.0);
        structure
    };
    // The slopes of the table are 40, 25 and 5.
    let table = multilinear(&[[0.03, 1.2], [0.1, 2.95], [0.3, 3.95]]);
    for (law, spring, parts) in [
        (bilinear(), 4.0, vec![(36.0, 36.0 * 0.075)]),
        (table, 5.0, vec![(15.0, 15.0 * 0.03), (20.0, 20.0 * 0.1)]),
    ] {
        let structure = at_rest(driven(&law));
        let mut other = structure.clone();
        other.contacts.clear();
        for nodes in [[None, Some(0)], [Some(0), Some(1)]] {
            other = other.spring(nodes, spring);
            for (k, limit) in &parts {
                other = other.contact(nodes, 0.0, friction(*k, *limit));
            }
        }
        let times = times(4.0, 200);
        let (rows, _) = exact(&structure, &times);
        let (expected, _) = exact(&other, &times);
        for (row, expected) in rows.iter().zip(&expected) {
            for k in 0..4 {
                // Round-off that some 100 events enlarge.
                assert!(
                    (row[k] - expected[k]).abs() < 1e-10,
                    "{law:?} {row:?} {expected:?}"
                );
            }
        }
    }
}

#[test]
fn a_restrainer_is_a_gap_that_yields_in_tension() {
    let pulled = driven(&restrainer());
    let mut pushed = driven(&gap_yield(true, 0.1));
    for (contact, other) in pushed.contacts.iter_mut().zip(&pulled.contacts) {
        for (_, factor) in &mut contact.along {
            *factor = -*factor;
        }
        contact.gap = 0.05 - other.gap;
    }
    let times = times(4.0, 200);
    let ((rows, _), (expected, _)) = (exact(&pulled, &times), exact(&pushed, &times));
    for (row, expected) in rows.iter().zip(&expected) {
        for k in 0..4 {
            assert!((row[k] - expected[k]).abs() < 1e-11);
        }
        assert!((row[6] + expected[6]).abs() < 1e-9);
    }
}

#[test]
fn a_mass_meets_a_part_that_yields_as_two_bodies_do() {
    let (mass, speed, gap) = (1.3, 1.7, 0.2);
    for law in [gap_yield(true, 0.0), gap_yield(false, 0.3), impact_yield()] {
        let expected = law.as_given().collision(mass, speed).unwrap();
        let structure = masses(&[mass])
            .contact([None, Some(0)], gap, law)
            .moving(&[0.0], &[-speed]);
        let touch = gap / speed;
        let end = touch + expected.duration();
        let mut rows = Vec::new();
        let summary = run(&structure, &[touch, end, end + 1.0], |_, state| {
            rows.push([state.r[0], state.rate[0], state.force[0]]);
        })
        .unwrap();
        assert!(
            (rows[2][1] - expected.restitution * speed).abs() < 1e-13,
            "{rows:?}"
        );
        let last = summary.events.last().unwrap();
        assert!((last.time - end).abs() < 1e-13, "{last:?} {end}");
        assert_eq!(
            (last.kind, rows[2][2]),
            (EventKind::Phase(Phase::Open), 0.0)
        );
        let kinetic = 0.5 * mass * speed * speed;
        let lost = kinetic * (1.0 - expected.restitution * expected.restitution);
        assert!((summary.book.dissipated - lost).abs() < 1e-13 * kinetic);
        assert!((summary.least_impact_rate.unwrap() - speed).abs() < 1e-14);
    }
}

#[test]
fn laws_without_lines_are_refused() {
    let viscous = link(ContactLaw::Viscous(crate::contact::Viscous {
        viscosity: 1.0,
        exponent: 0.5,
    }));
    let refused = run(&driven(&viscous), &[1.0], |_, _| ());
    assert!(matches!(refused, Err(EventsFault::Law { .. })));
    let mut varying = pendulum();
    if let Some(limit) = varying.limit_mut() {
        let table = Table::new(vec![0.0, 1.0], vec![1.0, 2.0]).unwrap();
        limit.varying = Some((1.0, Arc::new(Signal::Table(table))));
    }
    let refused = run(&driven(&varying), &[1.0], |_, _| ());
    assert!(matches!(refused, Err(EventsFault::Law { .. })));
}

#[test]
fn a_mass_on_a_link_that_softens_turns_or_falls() {
    // From the yield point on u'' = 4 u - q until u' turns: with w = 2, u = q/4 + (uy - q/4) cosh w t + (v/w) sinh w t.
    let (w, uy, q) = (2.0, 0.075, 3.3);
    let rest = q / 4.0 - uy;
    // Slower than w times the way to the top of the potential it turns.
    for (v, turns) in [
        (0.8, true),
        (0.999 * w * rest, true),
        (1.001 * w * rest, false),
        (3.0, false),
    ] {
        let structure = masses(&[1.0])
            .contact([None, Some(0)], 0.0, softening())
            .moving(&[uy], &[v]);
        let way = |t: f64| q / 4.0 - rest * libm::cosh(w * t) + v / w * libm::sinh(w * t);
        let end: f64 = if turns {
            0.5 * libm::log((w * rest + v) / (w * rest - v)) / w
        } else {
            2.5
        };
        // After the turn it unloads with 40, from the force there.
        let top = way(end);
        let expected = |t: f64| match turns && t > end {
            true => {
                let middle = top - (q - 4.0 * top) / 40.0;
                middle + (top - middle) * libm::cos(40_f64.sqrt() * (t - end))
            }
            false => way(t),
        };
        let last = if turns { end + 0.2 } else { end };
        let mut largest = 0.0_f64;
        let mut worst = 0.0_f64;
        let at = times(last, 50);
        let mut index = 0;
        let summary = run(&structure, &at, |_, state| {
            let exact = expected(at[index]);
            largest = largest.max(exact.abs());
            worst = worst.max((state.u[0] - exact).abs());
            index += 1;
        });
        let book = summary.unwrap().book;
        // Round-off of v grows as e^(2 t), 150 times until it falls; near the top the turn amplifies it by 1/(1 - 0.999).
        assert!(worst < 1e-12 * (1.0 + largest), "{v} {worst} {largest}");
        assert!(book.residual < 1e-12 * book.largest, "{v} {book:?}");
    }
}
