//! Laws of velocity behind springs, against the rule of Runge and Kutta and a closed form.

use super::*;
use crate::contact::ClippedLine;
use std::f64::consts::PI;
use std::sync::Arc;

/// A mass of 2 with a damper to a node without mass behind a spring of 8: m u'' = -3 u - S, S' = 8 (u' - (S/c)^(1/a)), by the rule of Runge
/// and Kutta in the test. The node is at S/8.
#[test]
fn a_damper_behind_a_spring_has_its_force_as_a_state() {
    let (m, k, brace, c) = (2.0, 3.0, 8.0, 0.9);
    for exponent in [0.3, 0.7, 1.0] {
        let law = ContactLaw::Viscous(Viscous {
            viscosity: c,
            exponent,
        });
        let mut structure = one(0.0, StructureLaw::new(law, None), 0.0);
        structure.nodes.push(structure.nodes[0].clone());
        structure.nodes[0].mass = m;
        structure.nodes[1].mass = 0.0;
        [
            structure.stiffness,
            structure.damping,
            structure.coupled_mass,
        ] = [(); 3].map(|()| Symmetric::zeros(2));
        structure.stiffness.add(0, 0, k);
        structure.stiffness.add(1, 1, brace);
        structure.contacts[0].along = vec![(1, -1.0), (0, 1.0)];
        (structure.displacement, structure.velocity) = (vec![0.3, 0.05], vec![-1.0, 0.0]);
        // As the assembly of a study finds it.
        structure.preload.forces = vec![Some(brace * 0.05)];
        let g = |s: f64| libm::pow(s.abs() / c, 1.0 / exponent).copysign(s);
        let rate = |[u, v, s]: [f64; 3]| [v, (-k * u - s) / m, brace * (v - g(s))];
        let mut z = [0.3, -1.0, brace * 0.05];
        let (h, count) = (1e-4, 40_000);
        let moved = |z: [f64; 3], r: [f64; 3], h: f64| std::array::from_fn(|i| z[i] + h * r[i]);
        for _ in 0..count {
            let r1 = rate(z);
            let r2 = rate(moved(z, r1, 0.5 * h));
            let r3 = rate(moved(z, r2, 0.5 * h));
            let r4 = rate(moved(z, r3, h));
            z = std::array::from_fn(|i| {
                z[i] + h / 6.0 * (r1[i] + 2.0 * r2[i] + 2.0 * r3[i] + r4[i])
            });
        }
        let end = h * f64::from(count);
        let mut found = [0.0; 6];
        run_of(&structure, &[0, 1], &[end], TOLERANCE, |_, state| {
            found = [
                state.u[0],
                state.v[0],
                state.force[0],
                state.u[1],
                state.r[0],
                state.rate[0],
            ];
        })
        .unwrap();
        let known = [z[0], z[1], z[2], z[2] / brace, z[0] - z[2] / brace, g(z[2])];
        for (a, b) in found.iter().zip(known) {
            // The rule of the test has steps over S = 0, where g has a corner for a = 0.7.
            assert!((a - b).abs() < 1e-10, "{exponent}: {found:?} {known:?}");
        }
    }
}

/// S of velocity-control friction c with the limit l behind a spring k, whose other end moves as sin w t, at a time after one and a half
/// turns: exponential functions and sines between the bounds, which it reaches and leaves three times.
fn behind_a_spring([k, c, l, w]: [f64; 4], end: f64) -> f64 {
    let q = k / c;
    // S = a cos w t + b sin w t + free exp(-q (t - from)).
    let [a, b] = [q, w].map(|x| k * w * x / (q * q + w * w));
    let steady = |t: f64| a * (w * t).cos() + b * (w * t).sin();
    let (mut from, mut s, mut side) = (0.0, 0.0, 1.0);
    loop {
        let free = |t: f64| steady(t) + (s - steady(from)) * (-q * (t - from)).exp();
        // The time at which it is at the bound, between its start and the fastest motion that way.
        let turn = (w * from / PI).round() * PI / w;
        let fastest = if turn > from || from == 0.0 {
            turn
        } else {
            turn + PI / w
        };
        let leaves = fastest + (l / (c * w)).acos() / w;
        let [mut low, mut high] = [from, leaves];
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            *(if side * free(middle) < l {
                &mut low
            } else {
                &mut high
            }) = middle;
        }
        match end {
            end if end < low => return free(end),
            end if end < leaves => return side * l,
            _ => (from, s, side) = (leaves, side * l, -side),
        }
    }
}

#[test]
fn friction_of_velocity_behind_a_spring_stays_within_its_limit() {
    let [k, c, l, w] = [8.0, 2.0, 1.1, 1.3];
    let law = StructureLaw::new(ClippedLine::Viscous { viscosity: c }, Limit::constant(l));
    let mut structure = one(0.0, law, 0.0);
    structure.nodes.push(structure.nodes[0].clone());
    // So heavy that the friction does not move it.
    structure.nodes[0].mass = 1e14;
    structure.nodes[1].mass = 0.0;
    [
        structure.stiffness,
        structure.damping,
        structure.coupled_mass,
    ] = [(); 3].map(|()| Symmetric::zeros(2));
    structure.stiffness.add(0, 0, 1e14 * w * w);
    structure.stiffness.add(1, 1, k);
    structure.contacts[0].along = vec![(1, -1.0), (0, 1.0)];
    (structure.displacement, structure.velocity) = (vec![0.0, 0.0], vec![w, 0.0]);
    let times = times(8.0, 160);
    let mut found = Vec::new();
    run_of(&structure, &[1], &times, TOLERANCE, |_, state| {
        found.push([state.force[0], k * state.u[1]]);
    })
    .unwrap();
    for (time, found) in times.iter().zip(&found) {
        let known = behind_a_spring([k, c, l, w], *time);
        for displacement in found {
            // Some 1e3 steps, each with the tolerance.
            assert!(
                (displacement - known).abs() < 1e-10,
                "{time}: {found:?} {known}"
            );
        }
    }
    assert!(
        found
            .iter()
            .filter(|displacements| displacements[0].abs() == l)
            .count()
            > 20
    );
}

/// Friction in a plane behind equal springs is that of the springs in series: the same motion without the node, whose place is r - S/k.
#[test]
fn friction_in_a_plane_behind_springs_is_elastic() {
    let (spring, own) = (1000.0, 2000.0);
    let rigid = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(5.0));
    let elastic = |stiffness| {
        let line = ClippedLine::Elastic { stiffness };
        StructureLaw::new(line, Limit::constant(5.0))
    };
    let in_series = 1.0 / (1.0 / spring + 1.0 / own);
    for (law, stiffness) in [(rigid, spring), (elastic(own), in_series)] {
        let plane = |law: StructureLaw, node: usize, size: usize| {
            let oscillator = one(0.0, law.clone(), 0.0);
            let mut structure = Structure::new(vec![oscillator.nodes[0].clone(); size]);
            let given = oscillator.contacts[0].clone();
            let rows = law.in_plane().unwrap().into_iter().enumerate();
            let rows = rows.map(|(i, law)| Contact {
                law,
                along: vec![(node + i, 1.0)],
                gap: 0.0,
                ..given.clone()
            });
            structure.contacts = rows.collect();
            for i in 0..2 {
                structure.nodes[i].mass = 2.0;
                structure.stiffness.add(i, i, 50.0);
                let omega = 7.0 + 4.0 * i as f64;
                structure.loads.push(Load {
                    pattern: vec![(i, 10.0 - 4.0 * i as f64)],
                    signal: Arc::new(Signal::Sine {
                        amplitude: 1.0,
                        omega,
                        phase: 0.0,
                    }),
                });
            }
            for i in 2..size {
                structure.nodes[i].mass = 0.0;
                structure
                    .stiffness
                    .add_spring([Some(i - 2), Some(i)], spring);
            }
            structure
        };
        let end = |structure: &Structure, nodes: &[usize]| {
            let mut found = Vec::new();
            run_of(structure, nodes, &[2.0], TOLERANCE, |_, state| {
                found = [state.u, state.force].concat();
            })
            .unwrap();
            found
        };
        let behind = end(&plane(law, 2, 4), &[0, 1, 2, 3]);
        let direct = end(&plane(elastic(stiffness), 0, 2), &[0, 1]);
        for i in 0..2 {
            assert!(
                (behind[i] - direct[i]).abs() < 1e-11,
                "{behind:?} {direct:?}"
            );
            let force = direct[2 + i];
            assert!(
                (behind[4 + i] - force).abs() < 1e-8,
                "{behind:?} {direct:?}"
            );
            assert!((behind[2 + i] - (direct[i] - force / spring)).abs() < 1e-11);
        }
    }
}
