//! Dampers at nodes without mass: Maxwell's element between a mass and the ground, by a node and in series.

use super::*;
use crate::contact::ClippedLine;
use crate::solve::structure::balance;

const BRACE: f64 = 400.0;
const VISCOSITY: f64 = 10.0;
const SPRING: f64 = 40.0;

/// A mass of 1 with the velocity 1 on a spring to the ground, beside a brace and a damper in series; the damper is a contact, or a
/// dashpot.
fn maxwell(is_contact: bool, dt: f64) -> Structure {
    let mut structure = masses(&[1.0, 0.0]);
    structure.velocity[0] = 1.0;
    structure.stiffness.add_spring([Some(0), None], SPRING);
    structure.stiffness.add_spring([Some(1), None], BRACE);
    match is_contact {
        true => {
            let line = ClippedLine::Viscous {
                viscosity: VISCOSITY,
            };
            let law = StructureLaw::new(line, Limit::constant(1e9));
            structure.contacts = vec![contact([Some(1), Some(0)], 0.0, law)];
        }
        false => structure.damping.add_spring([Some(0), Some(1)], VISCOSITY),
    }
    balance(&mut structure, dt).unwrap();
    structure
}

/// u of the mass, and S of the element, by Runge and Kutta's method: u'' = -40 u - S, S' = 400 (u' - S/10).
fn reference(end: f64) -> [f64; 2] {
    let steps = 40_000;
    let h = end / f64::from(steps);
    let rate = |[u, v, s]: [f64; 3]| [v, -SPRING * u - s, BRACE * (v - s / VISCOSITY)];
    let add = |x: [f64; 3], k: [f64; 3], h: f64| [0, 1, 2].map(|i| x[i] + h * k[i]);
    let mut x = [0.0, 1.0, 0.0];
    for _ in 0..steps {
        let k1 = rate(x);
        let k2 = rate(add(x, k1, 0.5 * h));
        let k3 = rate(add(x, k2, 0.5 * h));
        let k4 = rate(add(x, k3, h));
        let mean = [0, 1, 2].map(|i| (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) / 6.0);
        x = add(x, mean, h);
    }
    [x[0], x[2]]
}

/// u of the mass, and the force of the brace, at the end.
fn last(method: &Method, is_contact: bool, dt: f64, steps: usize) -> [f64; 2] {
    let structure = maxwell(is_contact, dt);
    let prepared = Prepared::by(method, &structure, dt).unwrap();
    let mut last = [0.0; 2];
    let [done] = run::<1>(&[&structure], &prepared, steps, |_, state| {
        last = [
            state.displacement(0).0[0],
            BRACE * state.displacement(1).0[0],
        ];
    });
    done.unwrap();
    last
}

#[test]
fn a_damper_at_a_node_without_mass_is_of_second_order() {
    let exact = reference(1.0);
    for (name, method) in methods() {
        if method.order() < 2
            || method.has_impulses()
            || method.corrects()
            || method.has_critical_step()
        {
            continue;
        }
        for is_contact in [true, false] {
            let errors = [100, 200, 400].map(|steps| {
                let found = last(&method, is_contact, 1.0 / f64::from(steps), steps as usize);
                [0, 1].map(|i| (found[i] - exact[i]).abs())
            });
            for i in 0..2 {
                // 4 for each halving, less terms of third order.
                let ratio = errors[0][i] / errors[2][i];
                assert!(ratio > 12.0, "{name} {is_contact}: {errors:?}");
            }
        }
    }
}

#[test]
fn a_dashpot_at_a_node_without_mass_has_the_force_of_its_spring_from_the_start() {
    let dt = 0.01;
    let structure = maxwell(false, dt);
    // Its spring has no force, so that it moves with the mass.
    assert_eq!(structure.velocity, [1.0, 1.0]);
    let prepared = Prepared::new(&structure, dt).unwrap();
    let [done] = run::<1>(&[&structure], &prepared, 1000, |step, state| {
        let [m, n] = [0, 1].map(|node| state.velocity(node).0[0]);
        let [dashpot, spring] = [VISCOSITY * (m - n), BRACE * state.displacement(1).0[0]];
        // Round-off, of which a part grows with the steps.
        assert!(
            (dashpot - spring).abs() < 1e-11,
            "{step}: {dashpot} {spring}"
        );
    });
    done.unwrap();
}
