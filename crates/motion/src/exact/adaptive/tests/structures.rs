//! Structures, against the motions by events of laws of straight lines.

use super::*;
use crate::contact::ClippedLine;
use std::sync::Arc;

/// A chain of three masses under a table and a sine, an impact between the first two, friction with a limit that changes in time at
/// the last one.
fn chain(law: impl Fn(Limit) -> StructureLaw) -> Structure {
    let mut chain = one(3.0, law(limit()), 0.0);
    let node = chain.nodes[0].clone();
    chain.nodes = vec![node.clone(), node.clone(), node];
    chain.stiffness = Symmetric::zeros(3);
    chain.damping = Symmetric::zeros(3);
    chain.coupled_mass = Symmetric::zeros(3);
    for (i, j, k) in [(0, 0, 5.0), (1, 1, 7.0), (2, 2, 4.0), (1, 2, -3.0)] {
        let (row, column) = (i.max(j), i.min(j));
        chain.stiffness.add(row, column, k);
        chain.damping.add(row, column, 0.01 * k);
    }
    chain.contacts[0].along = vec![(2, 1.0)];
    chain.contacts.push(Contact {
        name: "gap".into(),
        along: vec![(0, -1.0), (1, 1.0)],
        gap: 0.2,
        law: StructureLaw::new(ClippedLine::Spring { stiffness: 400.0 }, None),
    });
    let table = Table::new(
        vec![0.0, 0.7, 1.9, 1.9, 3.3, 8.0],
        vec![0.0, 2.5, -3.0, 1.0, 2.0, 0.0],
    );
    let sine = Signal::Sine {
        amplitude: 2.0,
        omega: 1.7,
        phase: 0.3,
    };
    for (node, signal) in [(0, Signal::Table(table.unwrap())), (2, sine)] {
        chain.loads.push(Load {
            pattern: vec![(node, 1.0)],
            signal: Arc::new(signal),
        });
    }
    chain.displacement = vec![0.1, 0.0, 0.4];
    chain.velocity = vec![0.0, -0.5, 0.0];
    chain
}

/// 0.6 and a table, which makes it 0 for some time.
fn limit() -> Limit {
    let table = Table::new(
        vec![0.0, 2.0, 3.0, 5.0, 6.0],
        vec![0.0, 0.5, -1.0, -0.9, 0.3],
    );
    Limit {
        varying: Some((1.0, Arc::new(Signal::Table(table.unwrap())))),
        ..Limit::constant(0.6)
    }
}

#[test]
fn laws_of_lines_move_as_by_events() {
    let times = times(10.0, 250);
    let elastic = |limit| StructureLaw::new(ClippedLine::Elastic { stiffness: 20.0 }, limit);
    let viscous = |limit| StructureLaw::new(ClippedLine::Viscous { viscosity: 5.0 }, limit);
    for structure in [chain(elastic), chain(viscous)] {
        let [computed, exact] = [
            at(&structure, &times, TOLERANCE),
            by_events(&structure, &times),
        ];
        // Events err by 1e-12 of the largest value, too; impacts make errors grow.
        for component in 0..3 {
            let error = distance(&computed, &exact, component);
            println!("{component} {error:e}");
            assert!(error < 1e-9, "{component}: {error}");
        }
    }
}

#[test]
fn laws_with_a_state_follow_a_limit_that_changes() {
    // Dahl's model with n = 0 is displacement-control, and a pendulum of a very large radius, too.
    let times = times(10.0, 250);
    let elastic = |limit| StructureLaw::new(ClippedLine::Elastic { stiffness: 20.0 }, limit);
    let exact = by_events(&chain(elastic), &times);
    let [compliance, constant] = [0.05, 0.6];
    let dahl = ContactLaw::Dahl(Dahl {
        compliance,
        limit: constant,
        exponent: 0.0,
    });
    let pendulum = ContactLaw::Pendulum(Pendulum {
        compliance,
        limit: constant,
        restoring: 1e-14,
        at_rest: [constant, 1.0],
        rising: [1.0, 0.0],
    });
    for law in [dahl, pendulum] {
        let structure = chain(|limit| StructureLaw::new(law, limit).from_its_answer());
        let computed = at(&structure, &times, TOLERANCE);
        let error = distance(&computed, &exact, 0);
        println!("{error:e}");
        assert!(error < 1e-9, "{law:?}: {error}");
    }
}

#[test]
fn friction_without_compliance_moves_as_by_events() {
    let coulomb = |limit| StructureLaw::new(ClippedLine::Coulomb, limit);
    let mut between = chain(coulomb);
    between.contacts.push(Contact {
        name: "between".into(),
        along: vec![(1, -1.0), (2, 1.0)],
        gap: 0.0,
        law: coulomb(Limit::constant(0.7)),
    });
    let mut beside = between.clone();
    beside.contacts.push(Contact {
        name: "beside".into(),
        along: vec![(2, 1.0)],
        gap: 0.0,
        law: coulomb(Limit::constant(0.4)),
    });
    let mut moved = chain(coulomb);
    moved.displacement = vec![0.1, -0.3, 0.8];
    moved.velocity = vec![1.0, 0.0, -2.0];
    let mut reversed = moved.clone();
    reversed.contacts.reverse();
    for structure in [chain(coulomb), between, beside, moved, reversed] {
        let times = times(8.0, 80);
        let nodes = [0, 1, 2];
        let mut histories: [Vec<[Vec<f64>; 4]>; 2] = Default::default();
        let keep = |state: &State| [state.u, state.v, state.r, state.force].map(<[f64]>::to_vec);
        let visit = |_: usize, state: &State| histories[0].push(keep(state));
        run_of(&structure, &nodes, &times, TOLERANCE, visit).unwrap();
        let visit = |_: usize, state: &State| histories[1].push(keep(state));
        events::run_of(&structure, &nodes, &times, visit).unwrap();
        let [computed, exact] = histories;
        for (computed, exact) in computed.iter().zip(&exact) {
            let sum = |force: &[f64]| force.iter().sum::<f64>();
            for which in 0..3 {
                for (a, b) in computed[which].iter().zip(&exact[which]) {
                    // The tolerance of a step, which collisions make larger.
                    assert!((a - b).abs() < 1e-9, "{a} {b}");
                }
            }
            // How contacts beside each other share a force is not determined. The impact has 400 times an error of r.
            let [a, b] = [sum(&computed[3]), sum(&exact[3])];
            assert!((a - b).abs() < 4e-9, "{a} {b}");
        }
    }
}

#[test]
fn friction_at_its_limit_stays_without_an_acceleration() {
    let law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(0.3));
    let mut held = one(1.0, law.clone(), 0.0);
    held.displacement = vec![0.3];
    assert_eq!(at(&held, &[5.0], TOLERANCE), [[0.3, 0.0, -0.3]]);
    // A load that rises to the limit and stays there, in a plane, too.
    let table = Table::new(vec![0.0, 1.0, 5.0], vec![0.0, 0.3, 0.3]).unwrap();
    let mut loaded = one(0.0, law.clone(), 0.0);
    loaded.loads.push(Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(Signal::Table(table)),
    });
    let [u, v, s] = at(&loaded, &[5.0], TOLERANCE)[0];
    // Round-off of the load is all that moves it.
    assert!(
        u.abs() < 1e-13 && v.abs() < 1e-13 && (s - 0.3).abs() < 1e-13,
        "{u} {v} {s}"
    );
}

#[test]
fn what_the_integration_does_not_know_is_said() {
    let of = |law| run_of(&one(1.0, law, 0.0), &[0], &[1.0], TOLERANCE, |_, _| {});
    let rigid = of(StructureLaw::new(
        ClippedLine::Stop { restitution: 0.5 },
        None,
    ));
    let text = rigid.unwrap_err().to_string();
    assert!(text.starts_with("contact floor is rigid, which"), "{text}");
    // A law that is nearly vertical: steps of its width would take too long.
    let mut stiff = one(
        1.0,
        StructureLaw::new(
            ClippedLine::Viscous { viscosity: 1e12 },
            Limit::constant(1.0),
        ),
        0.0,
    );
    stiff.displacement = vec![12.0];
    let model = Model::new(&stiff).unwrap();
    let text = run_model(model, &[0], &[20.0], [TOLERANCE, 1e5], |_, _| {})
        .unwrap_err()
        .to_string();
    assert!(text.contains("needs too many steps from t = "), "{text}");
}

/// A load moves a contact that is three masses away: u there grows as the seventh power of time, the load from rest as time.
#[test]
fn a_contact_far_from_the_load_leaves_rest() {
    let elastic = |_| {
        let line = ClippedLine::Elastic { stiffness: 20.0 };
        StructureLaw::new(line, Limit::constant(0.05))
    };
    let mut far = chain(elastic);
    far.stiffness.add(1, 0, -2.0);
    far.damping = Symmetric::zeros(3);
    far.contacts.truncate(1);
    let sine = Signal::Sine {
        amplitude: 2.0,
        omega: 1.7,
        phase: 0.0,
    };
    far.loads = vec![Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(sine),
    }];
    (far.displacement, far.velocity) = (vec![0.0; 3], vec![0.0; 3]);
    let times = times(8.0, 100);
    let [computed, exact] = [at(&far, &times, TOLERANCE), by_events(&far, &times)];
    assert!(exact.iter().any(|[_, _, force]| *force == 0.05));
    for component in 0..3 {
        let error = distance(&computed, &exact, component);
        assert!(error < 1e-9, "{component}: {error}");
    }
}
