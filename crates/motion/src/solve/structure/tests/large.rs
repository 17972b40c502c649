//! Structures whose factor has much fill-in, so that steps go through it by panels.

use super::*;
use crate::contact::ClippedLine;
use crate::lane::Lane;
use crate::methods::{AverageAcceleration, Coefficients, Method};
use crate::solve::structure::{Books, Prepared, run};

const DT: f64 = 0.02;
const WIDTH: usize = 24;

/// A square truss with diagonals, held on the left, that meets stops and friction on the right; x and y of each joint.
fn truss(scale: f64) -> Structure {
    let joint = |i: usize, j: usize| 2 * (i * WIDTH + j);
    let mut truss = masses(&vec![1.0; 2 * WIDTH * WIDTH]);
    for i in 0..WIDTH {
        for j in 0..WIDTH {
            let at = joint(i, j);
            if i == 0 {
                truss.stiffness.add_spring([None, Some(at)], 900.0);
                truss.stiffness.add_spring([None, Some(at + 1)], 700.0);
                continue;
            }
            let bar = |matrix: &mut Symmetric, of: usize, [x, y]: [f64; 2], k: f64| {
                let along: Vec<_> = [(at, x), (at + 1, y), (of, -x), (of + 1, -y)]
                    .into_iter()
                    .filter(|(_, c)| *c != 0.0)
                    .collect();
                matrix.add_along(&along, k);
            };
            let k = 300.0 + ((5 * i + 3 * j) % 7) as f64;
            bar(&mut truss.stiffness, joint(i - 1, j), [1.0, 0.0], k);
            truss.coupled_mass.add(at, joint(i - 1, j), 0.1);
            if j > 0 {
                bar(&mut truss.stiffness, joint(i, j - 1), [0.0, 1.0], k);
                let below = joint(i - 1, j - 1);
                bar(&mut truss.stiffness, below, [0.8, 0.6], 0.5 * k);
            }
            if j + 1 < WIDTH {
                let above = joint(i - 1, j + 1);
                bar(&mut truss.stiffness, above, [0.6, -0.8], 0.4 * k);
            }
            truss.velocity[at] = scale * (1.0 + 0.02 * j as f64);
            truss.velocity[at + 1] = 0.1 * scale;
        }
    }
    truss.damping.add_matrix(&truss.stiffness.clone(), 1e-3);
    for j in (0..WIDTH).step_by(3) {
        let face = joint(WIDTH - 1, j);
        let law = StructureLaw::new(ClippedLine::Spring { stiffness: 5e3 }, None);
        let mut stop = contact([Some(face), None], 0.02, law);
        stop.along.push((face + 1, 0.1));
        truss.contacts.push(stop);
    }
    let slider = displacement_control(400.0, 2.0);
    let last = joint(WIDTH - 1, 4) + 1;
    truss
        .contacts
        .push(contact([None, Some(last)], 0.0, slider));
    truss
}

fn product(matrix: &Symmetric, x: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; x.len()];
    matrix.add_product(x, &mut product);
    product
}

/// u and v of the nodes, r and S of the contacts after each step.
type Steps = Vec<[Vec<f64>; 4]>;

fn steps(method: &Method, structure: &Structure, count: usize) -> (Steps, f64) {
    let prepared = Prepared::by(method, structure, DT).unwrap();
    let mut rows = Vec::new();
    let mut books: Option<Books<1>> = None;
    let [done] = run::<1>(&[structure], &prepared, count, |_, state| {
        let nodes = 0..state.nodes();
        let contacts = 0..state.contacts();
        rows.push([
            nodes.clone().map(|i| state.displacement(i).0[0]).collect(),
            nodes.map(|i| state.velocity(i).0[0]).collect(),
            contacts
                .clone()
                .map(|c| state.contact(c).displacement.0[0])
                .collect(),
            contacts.map(|c| state.contact(c).force.0[0]).collect(),
        ]);
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.unwrap();
    (rows, books.unwrap().energy_error().0[0])
}

#[test]
fn steps_fulfil_the_equations_of_motion() {
    let truss = truss(1.0);
    let method = Method::AverageAcceleration(AverageAcceleration);
    let (steps, energy_error) = steps(&method, &truss, 60);
    let mass = truss.mass();
    let (mut closed, mut slides) = (0, 0);
    for [before, after] in steps.array_windows() {
        let ([u0, v0, _, s0], [u1, v1, r1, s1]) = (before, after);
        let sums = |a: &[f64], b: &[f64]| -> Vec<f64> {
            a.iter().zip(b).map(|(a, b)| 0.5 * (a + b)).collect()
        };
        let (u, v, s) = (sums(u0, u1), sums(v0, v1), sums(s0, s1));
        let change: Vec<f64> = v0.iter().zip(v1).map(|(a, b)| (b - a) / DT).collect();
        let mut forces = vec![0.0; u.len()];
        for (c, s) in s.iter().enumerate() {
            for (node, factor) in truss.column(c) {
                forces[node] += factor * s;
            }
        }
        let terms = [
            product(&mass, &change),
            product(&truss.damping, &v),
            product(&truss.stiffness, &u),
            forces,
        ];
        for i in 0..u.len() {
            // Sums of terms up to 1000, rounded in u and in the solution.
            let sum: f64 = terms.iter().map(|term| term[i]).sum();
            assert!(sum.abs() < 1e-9, "{i} {sum}");
            assert!((u1[i] - u0[i] - DT * v[i]).abs() < 1e-14);
        }
        for (c, (r, s)) in r1.iter().zip(s1).enumerate() {
            let moved = truss.relative(c, u1) + truss.contacts[c].gap;
            assert!((r - moved).abs() < 1e-14);
            if c + 1 < truss.contacts.len() {
                // Round-off of r times the stiffness.
                assert!((s - 5e3 * r.min(0.0)).abs() < 1e-9, "{c} {s} {r}");
                closed += usize::from(*s < 0.0);
            } else {
                slides += usize::from(s.abs() == 2.0);
            }
        }
    }
    assert!(closed > 20 && slides > 5, "{closed} {slides}");
    assert!(energy_error < 1e-13, "{energy_error}");
}

#[test]
fn both_forms_of_one_method_agree() {
    let truss = truss(1.0);
    let average = Method::AverageAcceleration(AverageAcceleration);
    let newmark = Method::Family(Coefficients::newmark(0.25, 0.5));
    let (computed, _) = steps(&average, &truss, 60);
    let (other, energy_error) = steps(&newmark, &truss, 60);
    for (computed, other) in computed.iter().zip(&other) {
        for (of, [a, b]) in computed.iter().zip(other).map(|(a, b)| [a, b]).enumerate() {
            // Stiffness of the contacts times that of u.
            let most = if of == 3 { 1e-8 } else { 1e-10 };
            for (a, b) in a.iter().zip(b) {
                assert!((a - b).abs() < most, "{of}: {a} {b}");
            }
        }
    }
    assert!(energy_error < 1e-12, "{energy_error}");
}

#[test]
fn lanes_have_the_bits_of_single_cases() {
    let scales = [1.0, 0.3, 0.7, 0.5];
    let cases = scales.map(truss);
    for method in [
        Method::AverageAcceleration(AverageAcceleration),
        Method::Family(Coefficients::hht(-0.2)),
    ] {
        let prepared = Prepared::by(&method, &cases[0], DT).unwrap();
        let mut last = vec![Lane::splat(0.0); 2 * cases[0].len()];
        let done = run::<4>(&cases.each_ref(), &prepared, 30, |_, state| {
            let nodes = 0..state.nodes();
            let both = nodes.flat_map(|i| [state.displacement(i), state.velocity(i)]);
            last = both.collect();
        });
        assert!(done.iter().all(Result::is_ok));
        for (l, case) in cases.iter().enumerate() {
            let (alone, _) = steps(&method, case, 30);
            let [u, v, ..] = &alone[30];
            for (i, both) in last.chunks(2).enumerate() {
                assert_eq!([u[i], v[i]], [both[0].0[l], both[1].0[l]], "{l} {i}");
            }
        }
    }
}
