//! The description of every method.

use super::*;
use crate::methods::METHODS;

/// Every method with the default of each parameter, and with both ends of its range as far as they are finite.
fn described() -> Vec<(&'static str, Method)> {
    let mut methods = Vec::new();
    for description in METHODS {
        let defaults: Vec<f64> = description.parameters.iter().map(|p| p.default).collect();
        methods.push((description.name, (description.method)(&defaults).unwrap()));
        for (i, parameter) in description.parameters.iter().enumerate() {
            let ends = [-1.0 / 3.0, 0.0, 0.5, 1.0];
            for end in ends.into_iter().filter(|x| parameter.range.contains(*x)) {
                let mut numbers = defaults.clone();
                numbers[i] = end;
                methods.push((description.name, (description.method)(&numbers).unwrap()));
            }
        }
    }
    methods
}

#[test]
fn names_are_distinct_and_defaults_are_in_their_ranges() {
    let mut names: Vec<&str> = METHODS.iter().map(|description| description.name).collect();
    for description in METHODS {
        let parameters = description.parameters;
        names.extend(parameters.iter().map(|parameter| parameter.name));
        assert!(!description.meaning.is_empty(), "{}", description.name);
        for parameter in parameters {
            assert!(
                parameter.range.contains(parameter.default),
                "{}",
                parameter.name
            );
            // The values of a search are tried together.
            assert_eq!(parameter.tried.len(), parameters[0].tried.len());
            assert!(!parameter.tried.is_empty(), "{}", parameter.name);
            let allowed = |x: &f64| parameter.range.contains(*x);
            assert!(parameter.tried.iter().all(allowed), "{}", parameter.name);
        }
        // Another count of numbers gives no method.
        if !parameters.is_empty() {
            assert_eq!((description.method)(&[]), None, "{}", description.name);
            assert_eq!(
                (description.method)(&[0.5; 9]),
                None,
                "{}",
                description.name
            );
        }
    }
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count);
}

/// One step of a free mode with dt = 1 by the sub-steps, from u, v and a.
fn step(method: &Method, omega2: f64, first: [f64; 3]) -> [f64; 3] {
    let [u0, v0, _] = first;
    let mut state = first;
    for part in method.sub_steps(1.0) {
        let [u, v, a] = state;
        let [by_u, by_v] = part.u_before.unwrap_or_default();
        let moved = [u - u0, v - v0];
        let du = part.u_v * v + part.u_a * a + by_u * moved[0] + by_v * moved[1];
        let dv = part.v_a * a + part.v_d * moved[1];
        let ([m0, m1], w1) = (part.inertia, part.weights[1]);
        let matrix = m1 + w1 * part.d2 * omega2;
        let next = (-m0 * a - omega2 * (u + w1 * du)) / matrix;
        state = [u + du + part.d2 * next, v + dv + part.d1 * next, next];
    }
    state
}

#[test]
fn the_sub_steps_have_the_spectral_radius_of_the_amplification_matrix() {
    for (name, method) in described() {
        let parts = method.sub_steps(1.0);
        assert_eq!(parts.len() as u64, method.count_of_sub_steps(), "{name}");
        assert_eq!(parts.iter().map(|part| part.length).sum::<f64>(), 1.0);
        for w in [0.1, 0.7, 1.5, 1.9] {
            // The growth over many steps is that of the largest eigenvalue; its norm changes within a period by a factor.
            let steps = 4000;
            let mut state = [0.8, 0.6 * w, -w * w * 0.8];
            let mut logarithm = 0.0;
            for _ in 0..steps {
                state = step(&method, w * w, state);
                let [u, v, a] = state;
                let size = libm::sqrt(u * u + v * v / (w * w) + a * a / (w * w * w * w));
                logarithm += libm::log(size);
                state = state.map(|x| x / size);
            }
            let growth = libm::log(method.amplification(w).spectral_radius);
            // The factor is at most 30, for double roots it grows with the steps: log(4000)/4000.
            let tolerance = libm::log(30.0 * f64::from(steps)) / f64::from(steps);
            let observed = logarithm / f64::from(steps);
            assert!(
                (observed - growth).abs() < tolerance,
                "{name} {method:?} {w}: {observed} {growth}"
            );
        }
    }
}

#[test]
fn the_order_is_that_of_the_period_and_the_amplitude() {
    for (name, method) in described() {
        // Errors of the angle of a step: dt^(order + 1), of its amplitude, too.
        let error = |w: f64| {
            let step = method.amplification(w);
            let phase = step.principal.unwrap().phase;
            libm::hypot(phase - w, libm::log(step.spectral_radius))
        };
        let order = libm::log2(error(0.02) / error(0.01)) - 1.0;
        // Terms of the next order are w times smaller.
        assert!(
            (order - f64::from(method.order())).abs() < 0.05,
            "{name} {method:?}: {order}"
        );
    }
}
