//! Observed orders.

use super::*;
use crate::exact::events;

/// Largest error of node 0 against the exact motion.
fn error(method: &MethodChoice, structure: &Structure, duration: f64, steps: usize) -> f64 {
    let dt = duration / steps as f64;
    let times: Vec<f64> = (0..=steps).map(|i| i as f64 * dt).collect();
    let mut exact = Vec::new();
    events::run(structure, &times, |_, state| exact.push(state.u[0])).unwrap();
    let mut largest = 0.0_f64;
    books(method, structure, dt, steps, |step, state| {
        largest = largest.max((state.displacement(0).0[0] - exact[step]).abs());
    });
    largest
}

/// Masses in a row with damping under a sine; with contacts that are always closed and stick.
fn row(contacts: bool) -> Structure {
    let mut structure = masses(&[1.0, 2.0, 1.5]);
    for (i, k) in [(0, 20.0), (1, 30.0)] {
        structure.stiffness.add_spring([Some(i), Some(i + 1)], k);
        structure.damping.add_spring([Some(i), Some(i + 1)], 0.2);
    }
    structure.stiffness.add(0, 0, 10.0);
    structure.damping.add(0, 0, 0.3);
    structure.velocity = vec![0.1, -0.2, 0.3];
    structure.loads = vec![Load {
        pattern: vec![(0, 1.0), (2, -0.5)],
        signal: Arc::new(Signal::Sine {
            amplitude: 1.0,
            omega: 3.0,
            phase: 0.4,
        }),
    }];
    if contacts {
        structure.contacts = vec![
            contact(
                [Some(2), None],
                -5.0,
                Relation::ImpactSpring { stiffness: 8.0 },
            ),
            contact([Some(0), Some(1)], 0.0, displacement_control(6.0, 1e3)),
            contact([None, Some(1)], 0.0, velocity_control(0.7, 1e3)),
        ];
        // Near rest at t = 0: the spring pushes with 40.
        structure.stiffness.add(2, 2, 200.0);
        structure.displacement[2] = -0.17;
    }
    structure
}

#[test]
fn smooth_motions_have_the_order_of_the_method() {
    for (name, method) in methods() {
        for contacts in [false, true] {
            let structure = row(contacts);
            let [coarse, fine] = [800, 1600].map(|steps| error(&method, &structure, 4.0, steps));
            // Forces of contacts act at the end of a step in the method of Moreau and Jean; newmark has gamma = 0.6 here.
            let order = match name {
                "newmark" | "moreau-jean 0.7" => 1.0,
                "moreau-jean" if contacts => 1.0,
                _ => 2.0,
            };
            let observed = (coarse / fine).log2();
            assert!(
                (observed - order).abs() < 0.05,
                "{name} {contacts} {observed}"
            );
        }
    }
}

#[test]
fn a_jump_of_a_load_between_steps_costs_no_order() {
    let times = vec![0.0, 0.5, 0.5, 1.0, 1.0, 4.0];
    let table = Table::new(times, vec![1.0, 2.0, -3.0, -1.0, 0.5, 0.0]).unwrap();
    let mut structure = row(false);
    structure.loads[0].signal = Arc::new(Signal::Table(table));
    for (name, method) in methods() {
        if ["newmark", "moreau-jean 0.7"].contains(&name) {
            continue;
        }
        let [coarse, fine] = [800, 1600].map(|steps| error(&method, &structure, 4.0, steps));
        let observed = (coarse / fine).log2();
        assert!((observed - 2.0).abs() < 0.1, "{name} {observed}");
    }
}

#[test]
fn softened_impacts_and_friction_converge() {
    let mut structure = row(false);
    structure.contacts = vec![
        contact(
            [Some(2), None],
            0.05,
            Relation::ImpactSpring { stiffness: 400.0 },
        ),
        contact([Some(0), Some(1)], 0.0, displacement_control(60.0, 0.3)),
        contact([None, Some(1)], 0.0, velocity_control(5.0, 0.2)),
    ];
    for (name, method) in methods() {
        let [coarse, fine] = [1000, 8000].map(|steps| error(&method, &structure, 6.0, steps));
        // At least first order; kinks of the laws make the constant uneven.
        assert!(fine < coarse / 6.0 && fine < 5e-3, "{name} {coarse} {fine}");
    }
}
