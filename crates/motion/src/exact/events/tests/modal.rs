//! Modes as coordinates: against nodes, closed forms, and structures with small masses in place of none.

use super::*;
use crate::contact::ClippedLine;
use crate::exact::events::coordinates::modal;
use crate::exact::events::coordinates::model::Model;

/// u and v of all nodes, r, rdot, S and slip of all contacts, at all times, and the summary.
fn all(model: Model, times: &[f64]) -> (Vec<Vec<f64>>, Summary) {
    let nodes: Vec<usize> = (0..model.structure.len()).collect();
    let mut states = Vec::new();
    let summary = run_model(model, (&nodes, true), times, |_, state| {
        states.push(
            [
                state.u,
                state.v,
                state.r,
                state.rate,
                state.force,
                state.slip,
            ]
            .concat(),
        );
    });
    (states, summary.unwrap())
}

fn both(structure: &Structure, times: &[f64]) -> [(Vec<Vec<f64>>, Summary); 2] {
    [
        all(Model::of_nodes(structure), times),
        all(modal::model(structure).unwrap(), times),
    ]
}

/// The largest difference of two lists of states, over the largest value of each number, and not less than 1e-3.
fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..a[0].len() {
        let largest = a.iter().fold(1e-3, |most: f64, row| most.max(row[i].abs()));
        for (a, b) in a.iter().zip(b) {
            worst = worst.max((a[i] - b[i]).abs() / largest);
        }
    }
    worst
}

fn chain(n: usize, damped: bool) -> Structure {
    let mut s = masses(&vec![1.0; n]);
    for i in 0..n {
        let between = [i.checked_sub(1), Some(i)];
        s = s.spring(between, 40.0);
        if damped {
            s = s.dashpot(between, 0.2);
        }
    }
    let pattern: Vec<(usize, f64)> = (0..n).map(|i| (i, -1.0)).collect();
    let points: Vec<[f64; 2]> = (0..60)
        .map(|i| {
            [
                0.35 * f64::from(i),
                0.8 * libm::sin(0.9 * f64::from(i)) * libm::cos(0.31 * f64::from(i * i)),
            ]
        })
        .collect();
    s.load(&pattern, table(&points))
}

/// A chain with an elastic and a rigid stop, a bearing, viscous and rigid friction, with ground acceleration and a moving limit.
fn with_contacts(damped: bool) -> Structure {
    let bearing = StructureLaw::new(
        ClippedLine::Elastic { stiffness: 30.0 },
        varying(0.6, 0.3, sine(1.0, 2.0, 0.3)),
    );
    let viscous = StructureLaw::new(
        ClippedLine::Viscous { viscosity: 2.0 },
        Limit::constant(0.3),
    );
    chain(30, damped)
        .contact(
            [None, Some(29)],
            0.9,
            StructureLaw::new(ClippedLine::Spring { stiffness: 60.0 }, None),
        )
        .contact(
            [Some(25), None],
            1.1,
            StructureLaw::new(ClippedLine::Stop { restitution: 0.6 }, None),
        )
        .contact([None, Some(20)], 0.0, bearing)
        .contact([Some(8), Some(12)], 0.0, viscous)
        .contact([None, Some(15)], 0.0, coulomb(0.5))
}

/// The events by contacts and times, without phases that end at once: which of them a motion has is decided by round-off.
fn lasting(summary: &Summary) -> Vec<Event> {
    let contacts = summary
        .events
        .iter()
        .map(|event| event.contact)
        .max()
        .unwrap_or(0);
    let mut events: Vec<Event> = Vec::new();
    for contact in 0..=contacts {
        let mut of_contact: Vec<Event> = Vec::new();
        for event in summary
            .events
            .iter()
            .filter(|event| event.contact == contact)
        {
            let at_once = |before: &Event| event.time - before.time < 1e-7;
            if matches!(event.kind, EventKind::Phase(_)) {
                of_contact
                    .pop_if(|before| at_once(before) && matches!(before.kind, EventKind::Phase(_)));
            }
            if of_contact
                .last()
                .is_none_or(|before| before.kind != event.kind)
            {
                of_contact.push(*event);
            }
        }
        events.extend(of_contact);
    }
    events.sort_by(|a, b| a.time.total_cmp(&b.time));
    events
}

#[test]
fn modes_and_nodes_move_alike_through_many_events() {
    for damped in [false, true] {
        let s = with_contacts(damped);
        let [nodes, modes] = both(&s, &steps(0.05, 160));
        let [of_nodes, of_modes] = [&nodes, &modes].map(|(_, summary)| lasting(summary));
        assert!(of_nodes.len() > 20, "{}", of_nodes.len());
        for (a, b) in of_nodes.iter().zip(&of_modes) {
            // Round-off grows through impacts and reversals.
            let same = a.contact == b.contact && (a.time - b.time).abs() < 1e-8;
            assert!(same, "{damped}: {a:?} {b:?}");
        }
        assert_eq!(of_nodes.len(), of_modes.len());
        let off = difference(&nodes.0, &modes.0);
        assert!(off < 1e-8, "{off:e}");
        assert!(modes.1.book.residual < 1e-12 * modes.1.book.largest);
    }
}

#[test]
fn random_structures_move_alike_in_modes() {
    for seed in 0..60 {
        let s = random::structure(&mut random::Random(seed), seed % 3 > 0);
        let [nodes, modes] = both(&s, &steps(0.05, 40));
        let off = difference(&nodes.0, &modes.0);
        // As above; rdot may differ where an impact is at a time of the list.
        assert!(off < 1e-8, "{seed}: {off:e}");
        assert!(
            modes.1.book.residual < 1e-12 * modes.1.book.largest.max(1e-3),
            "{seed}"
        );
    }
}

#[test]
fn a_bar_with_a_consistent_mass_vibrates_in_its_modes() {
    // Fixed at the left, n elements: w^2 = 6 k/m (1 - cos p)/(2 + cos p), p = (2 j - 1) pi/2n, shape sin(p i).
    let (n, m, k) = (24, 0.5, 9.0);
    let end = |i: usize| if i + 1 == n { m / 3.0 } else { 2.0 * m / 3.0 };
    let mut s = masses(&(0..n).map(end).collect::<Vec<f64>>());
    for i in 0..n {
        s = s.spring([i.checked_sub(1), Some(i)], k);
        if i > 0 {
            s.coupled_mass.add(i, i - 1, m / 6.0);
        }
    }
    for j in [1, 5, n] {
        let p = (2 * j - 1) as f64 * std::f64::consts::PI / (2 * n) as f64;
        let w = f64::sqrt(6.0 * k / m * (1.0 - libm::cos(p)) / (2.0 + libm::cos(p)));
        let shape: Vec<f64> = (1..=n).map(|i| libm::sin(p * i as f64)).collect();
        let s = s.clone().moving(&shape, &vec![0.0; n]);
        let times = steps(0.37, 20);
        let (states, summary) = all(Model::new(&s).unwrap(), &times);
        for (t, state) in times.iter().zip(&states) {
            for (u, shape) in state.iter().zip(&shape) {
                assert!((u - shape * libm::cos(w * t)).abs() < 1e-12, "{j} {t} {u}");
            }
            assert!((state[n] + w * shape[0] * libm::sin(w * t)).abs() < 1e-11);
        }
        assert!(summary.book.residual < 1e-13 * summary.book.largest);
    }
}

#[test]
fn the_lowest_mode_of_many_masses_keeps_its_period() {
    // Fixed at one end: w = 2 sqrt(k/m) sin(p/2), p = pi/(2 n + 1), shape sin(p i); (w_max/w)^2 = 1.5e5.
    let n = 300;
    let mut s = masses(&vec![1.0; n]);
    for i in 0..n {
        s = s.spring([i.checked_sub(1), Some(i)], 1.0);
    }
    let p = std::f64::consts::PI / (2 * n + 1) as f64;
    let w = 2.0 * libm::sin(0.5 * p);
    let shape: Vec<f64> = (1..=n).map(|i| libm::sin(p * i as f64)).collect();
    let s = s.moving(&shape, &vec![0.0; n]);
    assert!(modal::uses_modes(&s));
    // Some 50 periods, without any event: one piece after another.
    let end = 100.0 * std::f64::consts::PI / w;
    let (state, summary) = last(&s, end);
    for (u, shape) in state.iter().zip(&shape) {
        assert!(
            (u - shape * libm::cos(w * end)).abs() < 1e-10,
            "{u} {shape}"
        );
    }
    // Round-off of some 20 000 pieces.
    let residual = summary.book.residual / summary.book.largest;
    assert!(residual < 1e-11, "{residual:e}");
}

/// A mass on a spring of 4 meets a plate without mass on a spring of `support` at 0.1, by a contact with this law.
fn plate(mass: f64, support: f64, law: StructureLaw) -> Structure {
    masses(&[1.0, mass])
        .spring([None, Some(0)], 4.0)
        .spring([None, Some(1)], support)
        .moving(&[0.0, 0.0], &[-1.0, 0.0])
        .contact([Some(1), Some(0)], 0.1, law)
}

#[test]
fn a_stop_on_a_spring_without_mass_is_a_spring() {
    // Springs in series are a spring; a rigid stop without mass before a spring has no impact.
    let spring = |stiffness| StructureLaw::new(ClippedLine::Spring { stiffness }, None);
    for (law, stiffness) in [
        (spring(60.0), 1.0 / (1.0 / 60.0 + 1.0 / 30.0)),
        (
            StructureLaw::new(ClippedLine::Stop { restitution: 0.5 }, None),
            30.0,
        ),
    ] {
        let expected = masses(&[1.0])
            .spring([None, Some(0)], 4.0)
            .moving(&[0.0], &[-1.0])
            .contact([None, Some(0)], 0.1, spring(stiffness));
        let times = steps(0.02, 300);
        let (expected, of_spring) = all(Model::of_nodes(&expected), &times);
        let (states, summary) = all(Model::new(&plate(0.0, 30.0, law)).unwrap(), &times);
        assert_eq!(summary.events.len(), of_spring.events.len());
        for (state, expected) in states.iter().zip(&expected) {
            let ([u, v, force], [plate, rate]) = (
                [expected[0], expected[1], expected[4]],
                [state[1], state[3]],
            );
            assert!((state[0] - u).abs() < 1e-13 && (state[2] - v).abs() < 1e-13);
            assert!((state[6] - force).abs() < 1e-12, "{} {force}", state[6]);
            // S on the plate, and r between both.
            assert!(
                (plate - force / 30.0).abs() < 1e-13
                    && (state[4] - (u - plate + 0.1)).abs() < 1e-13
            );
            assert!(force == 0.0 || (rate - stiffness / 30.0 * v).abs() < 1e-12);
        }
        assert!(summary.book.residual < 1e-13 * summary.book.largest);
    }
}

#[test]
fn coulomb_friction_behind_a_spring_without_mass_is_displacement_control() {
    let limit = || Limit::constant(0.4);
    let behind = masses(&[1.0, 0.0])
        .spring([None, Some(0)], 2.0)
        .spring([Some(0), Some(1)], 25.0)
        .moving(&[0.5, 0.5], &[1.0, 0.0])
        .contact(
            [None, Some(1)],
            0.0,
            StructureLaw::new(ClippedLine::Coulomb, limit()),
        );
    let law = StructureLaw::new(ClippedLine::Elastic { stiffness: 25.0 }, limit());
    let expected = masses(&[1.0])
        .spring([None, Some(0)], 2.0)
        .moving(&[0.5], &[1.0])
        .contact([None, Some(0)], 0.0, law);
    let times = steps(0.05, 200);
    let (expected, of_spring) = all(Model::of_nodes(&expected), &times);
    let (states, summary) = all(Model::new(&behind).unwrap(), &times);
    assert!(of_spring.events.len() > 3);
    assert_eq!(summary.events.len(), of_spring.events.len());
    for (state, expected) in states.iter().zip(&expected) {
        assert!((state[0] - expected[0]).abs() < 1e-13 && (state[6] - expected[4]).abs() < 1e-12);
        // The slip is u of the node without mass.
        assert!((state[7] - expected[5]).abs() < 1e-12 && (state[1] - expected[5]).abs() < 1e-12);
    }
    assert!((summary.book.dissipated - of_spring.book.dissipated).abs() < 1e-12);
    assert!(summary.book.residual < 1e-13 * summary.book.largest);
}

/// A gap, a plate that only contacts hold, and a soil that yields; `mass` of the plate.
fn abutment(mass: f64) -> Structure {
    let soil = StructureLaw::new(
        ClippedLine::Elastic { stiffness: 50.0 },
        Limit::constant(1.5),
    );
    masses(&[1.0, mass])
        .spring([None, Some(0)], 3.0)
        .dashpot([None, Some(0)], 0.1)
        .moving(&[0.0, 0.0], &[-1.0, 0.0])
        .load(&[(0, 1.0)], sine(1.4, 1.1, 0.0))
        .contact(
            [Some(1), Some(0)],
            0.1,
            StructureLaw::new(ClippedLine::Spring { stiffness: 200.0 }, None),
        )
        .contact([None, Some(1)], 0.0, soil)
}

#[test]
fn a_gap_before_a_soil_that_yields_is_the_limit_of_a_light_plate() {
    let times = steps(0.05, 300);
    let (states, summary) = all(Model::new(&abutment(0.0)).unwrap(), &times);
    assert!(summary.book.dissipated > 0.5, "{:?}", summary.book);
    assert!(
        summary.book.residual < 1e-12 * summary.book.largest,
        "{:?} {:?}",
        summary.book,
        summary.events
    );
    // The plate slips for good, and both contacts have one force.
    assert!(states[300][1] < -0.1);
    for state in &states {
        assert!((state[8] - state[9]).abs() < 1e-12 || state[8] == 0.0 && state[9].abs() < 1e-12);
    }
    let off = |mass: f64| {
        let (light, _) = all(Model::new(&abutment(mass)).unwrap(), &times);
        let u = states.iter().zip(&light).map(|(a, b)| (a[0] - b[0]).abs());
        u.fold(0.0, f64::max)
    };
    let [coarse, fine] = [1e-3, 1e-5].map(off);
    // The force of the light plate rings: its effect is of the order of the root of its mass, or better.
    assert!(coarse < 2e-2 && fine < 0.2 * coarse, "{coarse:e} {fine:e}");
}

#[test]
fn loads_and_frames_of_nodes_without_mass_are_condensed() {
    // Node 1 without mass between two masses, with a load of its own: the limit of small masses.
    let structure = |mass: f64| {
        masses(&[1.0, mass, 2.0])
            .spring([None, Some(0)], 5.0)
            .spring([Some(0), Some(1)], 20.0)
            .spring([Some(1), Some(2)], 30.0)
            .moving(&[0.1, 0.0, -0.2], &[0.0, 0.0, 1.0])
            .load(&[(1, 2.0), (2, -1.0)], sine(1.0, 1.3, 0.4))
            .contact(
                [None, Some(1)],
                0.15,
                StructureLaw::new(ClippedLine::Spring { stiffness: 80.0 }, None),
            )
            .contact([Some(1), Some(2)], 0.0, coulomb(0.5))
    };
    let times = steps(0.05, 100);
    let (states, summary) = all(Model::new(&structure(0.0)).unwrap(), &times);
    assert!(summary.events.len() > 4);
    assert!(
        summary.book.residual < 1e-12 * summary.book.largest,
        "{:?}",
        summary.book
    );
    let mut s = structure(0.0);
    for (t, state) in times.iter().zip(&states) {
        // Balance of the node without mass.
        let [u, p] = [&state[..3], &[2.0 * libm::sin(1.3 * t + 0.4)]];
        let force = [state[10], state[11]];
        let rest = p[0] - 20.0 * (u[1] - u[0]) - 30.0 * (u[1] - u[2]) - force[0] + force[1];
        assert!(rest.abs() < 1e-12, "{t}: {rest:e}");
        assert!(
            (state[6] - (u[1] + 0.15)).abs() < 1e-12 && (state[7] - (u[2] - u[1])).abs() < 1e-12
        );
    }
    // What cannot be: viscous friction there, a damper, a node that nothing holds.
    let refused = |s: &Structure| run(s, &[1.0], |_, _| ()).unwrap_err();
    s.damping.add_spring([None, Some(1)], 1.0);
    assert_eq!(
        refused(&s),
        EventsFault::MasslessDamping { node: "n1".into() }
    );
    let viscous = StructureLaw::new(
        ClippedLine::Viscous { viscosity: 1.0 },
        Limit::constant(1.0),
    );
    let s = structure(0.0).contact([None, Some(1)], 0.0, viscous);
    assert_eq!(
        refused(&s),
        EventsFault::Law {
            contact: "c2".into()
        }
    );
    let s = masses(&[1.0, 0.0]).spring([None, Some(0)], 1.0);
    assert_eq!(refused(&s), EventsFault::Unheld { node: "n1".into() });
}
