//! Motions with printed numbers or closed forms.

use super::*;
use crate::contact::ClippedLine;
use crate::solve::structure::{Prepared, run};

/// Displacements of node 0 at all steps.
fn displacements(structure: &Structure, dt: f64, steps: usize) -> Vec<f64> {
    let prepared = Prepared::new(structure, dt).unwrap();
    let mut u = Vec::new();
    let [done] = run::<1>(&[structure], &prepared, steps, |_, state| {
        u.push(state.displacement(0).0[0]);
    });
    done.unwrap();
    u
}

/// Chopra, Dynamics of Structures, examples of the constant average acceleration method: a half cycle of a sine.
fn chopra() -> Structure {
    let mut structure = masses(&[0.2533]);
    structure.damping.add(0, 0, 0.1592);
    let times: Vec<f64> = (0..=10).map(|i| 0.1 * f64::from(i)).collect();
    let pulse = |t: &f64| {
        if *t < 0.6 {
            10.0 * libm::sin(PI * t / 0.6)
        } else {
            0.0
        }
    };
    let values = times.iter().map(pulse).collect();
    structure.loads = vec![Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(Signal::Table(Table::new(times, values).unwrap())),
    }];
    structure
}

#[test]
fn the_linear_hand_table_of_chopra_is_met() {
    let printed = [
        0.0437, 0.2326, 0.6121, 1.0825, 1.4309, 1.4231, 0.9622, 0.1908, -0.6044, -1.1442,
    ];
    let mut structure = chopra();
    structure.stiffness.add(0, 0, 10.0);
    for (u, printed) in displacements(&structure, 0.1, 10)[1..].iter().zip(printed) {
        // Four printed decimals, of a calculation by hand.
        assert!((u - printed).abs() < 1e-4, "{u} {printed}");
    }
}

#[test]
fn the_yielding_hand_table_of_chopra_is_met() {
    let printed = [
        0.0437, 0.2326, 0.6121, 1.1143, 1.6214, 1.9891, 2.0951, 1.9240, 1.5602, 1.1415,
    ];
    let mut structure = chopra();
    structure.contacts = vec![contact(
        [None, Some(0)],
        0.0,
        displacement_control(10.0, 7.5),
    )];
    for (u, printed) in displacements(&structure, 0.1, 10)[1..].iter().zip(printed) {
        assert!((u - printed).abs() < 1e-4, "{u} {printed}");
    }
}

/// Masses 1 in a row between walls, k = 100, with damping C = 0.02 K + 0.1 M; node i moves as sin(theta (i + 1)) sin(5 t).
fn forced_row(n: usize) -> (Structure, impl Fn(f64) -> f64) {
    let mut structure = masses(&vec![1.0; n]);
    for i in 0..=n {
        let node = |i: usize| (1..=n).contains(&i).then(|| i - 1);
        structure
            .stiffness
            .add_spring([node(i), node(i + 1)], 100.0);
    }
    let k = structure.stiffness.clone();
    structure.damping.add_matrix(&k, 0.02);
    for i in 0..n {
        structure.damping.add(i, i, 0.1);
    }
    // Mode 2: K has the eigenvalue 4 k sin(theta/2)^2.
    let theta = 2.0 * PI / (n + 1) as f64;
    let shape = move |i: usize| libm::sin(theta * (i + 1) as f64);
    let omega2 = 400.0 * libm::sin(0.5 * theta) * libm::sin(0.5 * theta);
    let (rate, c) = (5.0, 0.02 * omega2 + 0.1);
    // q = sin(rate t): q'' + c q' + omega2 q = (omega2 - rate^2) sin + c rate cos.
    for (amplitude, phase) in [(omega2 - rate * rate, 0.0), (c * rate, 0.5 * PI)] {
        structure.loads.push(Load {
            pattern: (0..n).map(|i| (i, shape(i) * amplitude)).collect(),
            signal: Arc::new(Signal::Sine {
                amplitude: 1.0,
                omega: rate,
                phase,
            }),
        });
    }
    structure.velocity = (0..n).map(|i| rate * shape(i)).collect();
    (structure, move |t| shape(0) * libm::sin(rate * t))
}

#[test]
fn the_error_of_a_smooth_motion_has_order_two() {
    let (structure, exact) = forced_row(9);
    let error = |steps: usize| {
        let dt = 2.0 / steps as f64;
        let u = displacements(&structure, dt, steps);
        let errors = u.iter().enumerate().map(|(i, u)| u - exact(i as f64 * dt));
        errors.fold(0.0, |a: f64, b| a.max(b.abs()))
    };
    let [coarse, fine, finest] = [400, 800, 1600].map(error);
    // The next order is 4, so that the ratio of the errors differs from 4 by a part of the order of (omega dt)^2.
    for ratio in [coarse / fine, fine / finest] {
        assert!((ratio - 4.0).abs() < 0.01, "{ratio}");
    }
    // The first term of the error is about (5 dt)^2/12.
    assert!(finest < 1e-5);
}

#[test]
fn a_block_that_coulomb_friction_holds_does_not_move() {
    // Load 3 < 4 from t = 0 on: S(0) = 3 follows from the accelerations.
    let mut structure = masses(&[2.0]);
    let limit = Limit::constant(4.0);
    structure.contacts = vec![contact(
        [None, Some(0)],
        0.0,
        StructureLaw::new(ClippedLine::Coulomb, limit),
    )];
    let table = Table::new(vec![0.0], vec![3.0]).unwrap();
    structure.loads = vec![Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(Signal::Table(table)),
    }];
    let prepared = Prepared::new(&structure, 0.01).unwrap();
    let [done] = run::<1>(&[&structure], &prepared, 100, |_, state| {
        let now = state.contact(0);
        // Round-off of the load over the mass times dt.
        assert!(now.velocity.0[0].abs() < 1e-16);
        assert!((now.force.0[0] - 3.0).abs() < 1e-12);
    });
    done.unwrap();
}

#[test]
fn softened_laws_give_the_forces_at_the_start() {
    let mut structure = masses(&[1.0]);
    structure.displacement[0] = -0.3;
    structure.velocity[0] = 2.0;
    let between = [None, Some(0)];
    structure.contacts = vec![
        contact(
            between,
            0.1,
            StructureLaw::new(ClippedLine::Spring { stiffness: 50.0 }, None),
        ),
        contact(between, 0.0, displacement_control(7.0, 1.0)),
        contact(between, 0.0, velocity_control(0.25, 1.0)),
        contact(between, 0.0, velocity_control(5.0, 1.0)),
        contact(
            between,
            0.0,
            StructureLaw::new(ClippedLine::Coulomb, Limit::constant(3.0)),
        ),
    ];
    let prepared = Prepared::new(&structure, 0.01).unwrap();
    let [done] = run::<1>(&[&structure], &prepared, 0, |_, state| {
        for (c, force) in [-10.0, 0.0, 0.5, 1.0, 3.0].into_iter().enumerate() {
            assert!((state.contact(c).force.0[0] - force).abs() < 1e-14);
            assert!((state.contact(c).velocity.0[0] - 2.0).abs() < 1e-15);
        }
        assert!((state.contact(0).displacement.0[0] + 0.2).abs() < 1e-16);
    });
    done.unwrap();
}

#[test]
fn two_equal_contacts_move_like_one_of_twice_the_stiffness_and_limit() {
    let mut structure = masses(&[1.0]);
    structure.stiffness.add(0, 0, 1.0);
    structure.loads = vec![Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(Signal::Sine {
            amplitude: 2.0,
            omega: 0.7,
            phase: 0.3,
        }),
    }];
    for stiffness in [1e2, 1e6, 1e10] {
        let scaled = |factor: f64| {
            let law = displacement_control(factor * stiffness, factor * 0.4);
            contact([None, Some(0)], 0.0, law)
        };
        structure.contacts = vec![scaled(1.0), scaled(1.0)];
        let two = displacements(&structure, 0.01, 3000);
        structure.contacts = vec![scaled(2.0)];
        let one = displacements(&structure, 0.01, 3000);
        for (two, one) in two.iter().zip(one) {
            // A of both has the condition number 2 h k, h = 2.5e-5, but the sum of their forces does not depend on it.
            assert!((two - one).abs() < 1e-11, "{stiffness} {two} {one}");
        }
    }
}

#[test]
fn a_rigid_stop_is_not_passed() {
    // A mass on a spring that a stop at -0.1 cuts off.
    let mut structure = masses(&[1.0]);
    structure.stiffness.add(0, 0, 1.0);
    structure.displacement[0] = 1.0;
    let law = StructureLaw::new(ClippedLine::Stop { restitution: 0.0 }, None);
    structure.contacts = vec![contact([None, Some(0)], 0.1, law)];
    let u = displacements(&structure, 0.01, 3000);
    let smallest = u.iter().fold(0.0, |a: f64, b| a.min(*b));
    assert!((smallest + 0.1).abs() < 1e-14, "{smallest}");
}

#[test]
fn a_matrix_of_a_step_that_is_not_positive_definite_is_a_fault_of_a_node() {
    // 4/dt^2 M + K = 400 - 500.
    let mut structure = masses(&[1.0, 1.0]);
    structure.stiffness.add(1, 1, -500.0);
    let fault = Prepared::new(&structure, 0.1).unwrap_err();
    assert_eq!(
        fault.to_string(),
        // 2/sqrt(500).
        "the matrix of a step, 4/dt^2 M + 2/dt C + K, is not positive definite at node m1: K pulls it away; allowed: dt up to about 0.089"
    );
}
