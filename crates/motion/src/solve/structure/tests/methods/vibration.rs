//! Free vibrations of a mass: closed forms.

use super::*;
use nalgebra::{Matrix3, Vector3};

/// u and v of a mass on a spring of omega^2 and a dashpot 2 xi omega, from u = 1, v = 0.
fn vibration(method: &Method, omega: f64, xi: f64, dt: f64, steps: usize) -> Vec<[f64; 2]> {
    let mut structure = masses(&[2.0]);
    structure.stiffness.add(0, 0, 2.0 * omega * omega);
    structure.damping.add(0, 0, 4.0 * xi * omega);
    structure.displacement[0] = 1.0;
    let mut track = Vec::new();
    books(method, &structure, dt, steps, |_, state| {
        track.push([state.displacement(0).0[0], state.velocity(0).0[0]]);
    });
    track
}

/// Hughes, The Finite Element Method, section 9.1: for gamma = 1/2 without damping u_n = cos(n phi) with
/// cos phi = 1 - (omega dt)^2/(2 (1 + beta (omega dt)^2)).
#[test]
fn newmark_with_gamma_one_half_turns_by_its_angle() {
    for beta in [0.0, 1.0 / 12.0, 1.0 / 6.0, 0.25, 0.4] {
        let method = Method::Family(Coefficients::newmark(beta, 0.5));
        for x in [0.01, 0.3, 1.2, 1.9] {
            let angle = libm::acos(1.0 - 0.5 * x * x / (1.0 + beta * x * x));
            let track = vibration(&method, x / 0.1, 0.0, 0.1, 200);
            for (n, [u, _]) in track.into_iter().enumerate() {
                let expected = libm::cos(n as f64 * angle);
                // acos of a number near 1: (1e-16)/x each step.
                assert!((u - expected).abs() < 1e-11, "{beta} {x} {n} {u}");
            }
        }
    }
}

/// Chung and Hulbert (1993): the recursion of (u, dt v, dt^2 a) by its own three equations.
#[test]
fn alpha_methods_follow_their_amplification_matrix() {
    let methods = [
        Coefficients::newmark(0.3025, 0.6),
        Coefficients::hht(-0.05),
        Coefficients::hht(-1.0 / 3.0),
        Coefficients::generalized_alpha(0.0),
        Coefficients::generalized_alpha(0.5),
        Coefficients::generalized_alpha(1.0),
    ];
    for of in methods {
        for (x, xi) in [(0.05, 0.0), (1.0, 0.02), (7.0, 0.3), (1e3, 0.1)] {
            let [k, c] = [x * x, 2.0 * xi * x];
            let Coefficients {
                alpha_m,
                alpha_f,
                beta,
                gamma,
            } = of;
            let (m, f) = (1.0 - alpha_m, 1.0 - alpha_f);
            let after = Matrix3::new(f * k, f * c, m, 1.0, 0.0, -beta, 0.0, 1.0, -gamma);
            let [mk, mc, mm] = [-alpha_f * k, -alpha_f * c, -alpha_m];
            let before = Matrix3::new(mk, mc, mm, 1.0, 1.0, 0.5 - beta, 0.0, 1.0, 1.0 - gamma);
            let step = after.try_inverse().unwrap() * before;
            let mut y = Vector3::new(1.0, 0.0, -k);
            let track = vibration(&Method::Family(of), x / 0.1, xi, 0.1, 100);
            let largest = track.iter().fold(0.0_f64, |a, b| a.max(b[0].abs()));
            for [u, v] in track {
                // dt^2 a is up to x^2 times u, so that the inverse loses that much.
                let size = 1e-12 * largest * (1.0 + x * x);
                let errors = [u - y[0], 0.1 * v - y[1]].map(f64::abs);
                assert!(
                    errors[0] < size && errors[1] < size,
                    "{of:?} {x} {errors:?}"
                );
                y = step * y;
            }
        }
    }
}

/// u + v/(i omega) is turned by (4 z - 1)/(3 - i omega dt), z = (1 + i omega dt/4)/(1 - i omega dt/4).
#[test]
fn bathe_follows_its_amplification_factor() {
    type Complex = nalgebra::Complex<f64>;
    for x in [0.01, 0.5, 2.0, 30.0] {
        let z = Complex::new(1.0, 0.25 * x) / Complex::new(1.0, -0.25 * x);
        let factor = (z * 4.0 - 1.0) / Complex::new(3.0, -x);
        let mut y = Complex::new(1.0, 0.0);
        let omega = x / 0.1;
        for [u, v] in vibration(&Method::Bathe(Bathe), omega, 0.0, 0.1, 100) {
            assert!((u - y.re).abs() < 1e-13 && (-v / omega - y.im).abs() < 1e-13);
            y *= factor;
        }
    }
}

/// The theta rule: y' = i omega y by (1 + i (1 - theta) omega dt)/(1 - i theta omega dt).
#[test]
fn moreau_jean_follows_the_theta_rule() {
    type Complex = nalgebra::Complex<f64>;
    for theta in [0.5, 0.6, 1.0] {
        for x in [0.01, 0.5, 2.0, 30.0] {
            let factor = Complex::new(1.0, (1.0 - theta) * x) / Complex::new(1.0, -theta * x);
            let mut y = Complex::new(1.0, 0.0);
            let omega = x / 0.1;
            let method = Method::MoreauJean(MoreauJean { theta });
            for [u, v] in vibration(&method, omega, 0.0, 0.1, 100) {
                assert!((u - y.re).abs() < 1e-12 && (-v / omega - y.im).abs() < 1e-12);
                y *= factor;
            }
        }
    }
}
