//! Central differences at Courant 1 on a lumped bar: exact at the nodes (d'Alembert).

use super::*;
use crate::system::bar::{Bar, Mass};

/// u at each node and step, of a bar of `elements` with these velocities of its nodes and a constant end force S.
fn nodes(elements: u32, velocity: &dyn Fn(u32) -> f64, force: f64, steps: u32) -> Vec<Vec<f64>> {
    // Mass 1 and length 1 an element, wave speed 1: dt = 1 is Courant 1.
    let bar = Bar {
        elements,
        mass: f64::from(elements),
        travel_time: 2.0 * f64::from(elements),
        kind: Mass::Lumped,
    };
    let mass = |i: u32| if i == 0 || i == elements { 0.5 } else { 1.0 };
    let modes: Vec<_> = (0..=elements)
        .map(|j| {
            let mode_of_bar = bar.mode(j);
            let momentum: f64 = (0..=elements)
                .map(|i| mass(i) * bar.shape(j, i) * velocity(i))
                .sum();
            mode(
                mode_of_bar.omega2,
                mode_of_bar.phi2,
                0.0,
                momentum * mode_of_bar.phi2,
            )
        })
        .collect();
    let choice = Method::Family(Coefficients::central_difference());
    let at = start(choice, 1.0, 0.0, force);
    let mut method = Lanes::<Coefficients, 1>::new(&at, modes.into_iter()).unwrap();
    let state = |method: &Lanes<Coefficients, 1>| {
        let mut u = vec![0.0; elements as usize + 1];
        for (j, (x, _)) in (0..).zip(method.modes()) {
            for (i, u) in (0..).zip(&mut u) {
                *u += bar.shape(j, i) * x.0[0];
            }
        }
        u
    };
    let mut states = vec![state(&method)];
    for _ in 0..steps {
        method.step(&mut Prescribed([force; 2]));
        states.push(state(&method));
    }
    states
}

/// Round-off: the highest mode has a double root at Courant 1, so that errors of a few eps grow with the steps.
const ROUND_OFF: f64 = 1e-11;

#[test]
fn two_bars_tied_together_are_exact_at_the_nodes() {
    // Two equal bars that meet with velocities 1 and -1 and stay tied: one bar of 2n elements, its middle node at rest.
    // u(x, t) is half of the integral of the initial velocity from x - t to x + t, the bar being mirrored at its free ends.
    let n = 12_i64;
    let elements = 2 * n as u32;
    let velocity = |i: u32| f64::from((n as i32 - i as i32).signum());
    let computed = nodes(elements, &velocity, 0.0, 120);
    // The velocity of the element after a node, the line being continued by mirrors.
    let mirrored = |i: i64| {
        let turn = i.rem_euclid(4 * n);
        if turn < n || turn >= 3 * n { 1.0 } else { -1.0 }
    };
    for (t, u) in (0_i64..).zip(&computed) {
        for (i, u) in (0_i64..).zip(u) {
            let exact: f64 = 0.5 * (i - t..i + t).map(mirrored).sum::<f64>();
            assert!((u - exact).abs() < ROUND_OFF, "{t} {i}: {u} {exact}");
        }
        // Until the wave returns the interface rests, and so does the node beside it once the first wave has passed.
        if t < 2 * n {
            assert!(u[n as usize].abs() < ROUND_OFF);
            assert!((u[n as usize - 1] - if t > 0 { 1.0 } else { 0.0 }).abs() < ROUND_OFF);
        }
    }
}

#[test]
fn a_bar_under_an_end_force_is_exact_at_the_nodes() {
    // v = -S/Z behind the front, Z = 1; each reflection at the free far end and at the loaded end adds the same.
    let n = 10_i64;
    let computed = nodes(n as u32, &|_| 0.0, 0.3, 100);
    for (t, u) in (0_i64..).zip(&computed) {
        for (i, u) in (0_i64..).zip(u) {
            // Fronts arrive at i, 2 n - i, 2 n + i, ...
            let mut exact = 0.0;
            for turn in 0..=t / (2 * n) {
                for path in [2 * n * turn + i, 2 * n * (turn + 1) - i] {
                    exact -= 0.3 * (t - path).max(0) as f64;
                }
            }
            assert!((u - exact).abs() < ROUND_OFF, "{t} {i}: {u} {exact}");
        }
    }
}
