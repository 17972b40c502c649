//! Amplification factors of a free mode against closed forms, and the steppers against powers of the matrices.

use super::*;
use nalgebra::{DMatrix, DVector, Matrix2, Vector2, Vector4};

/// omega dt from 0.01 to 100.
fn ladder() -> impl Iterator<Item = f64> {
    (0..=80).map(|i| 0.01 * libm::pow(10.0, f64::from(i) / 20.0))
}

/// Round-off of phases: the matrices have numbers up to W2/D and errors relative to them.
const ROUND_OFF: f64 = 1e-13;

/// The three eigenvalues of a generalised-alpha method approach each other as 1/W, which multiplies round-off by W2.
fn round_off(choice: Method, w: f64) -> f64 {
    match choice {
        Method::Family(family) if family.alpha_f > 0.0 => ROUND_OFF * (1.0 + w * w),
        Method::AverageAcceleration(_)
        | Method::Family(_)
        | Method::Bathe(_)
        | Method::MoreauJean(_)
        | Method::ContactStabilized(_) => ROUND_OFF,
    }
}

fn trapezoidal_phase(choice: Method) {
    for w in ladder() {
        let tolerance = round_off(choice, w);
        let step = choice.amplification(w);
        let principal = step.principal.unwrap();
        let phase = 2.0 * libm::atan(0.5 * w);
        assert!(
            (step.spectral_radius - 1.0).abs() < tolerance,
            "{choice:?} {w}"
        );
        assert!(
            (principal.phase / phase - 1.0).abs() < tolerance,
            "{choice:?} {w}"
        );
        assert!(principal.damping_ratio.abs() < tolerance, "{choice:?} {w}");
        let elongation = 0.5 * w / libm::atan(0.5 * w) - 1.0;
        assert!((principal.period_elongation - elongation).abs() < tolerance * (1.0 + w));
    }
}

#[test]
fn trapezoidal_rules_keep_the_amplitude() {
    // Newmark's rule, the theta method with theta = 1/2, and generalised-alpha with rho_inf = 1, which has it between the
    // ends of a step: z = (1 + iW/2)/(1 - iW/2).
    trapezoidal_phase(Method::AverageAcceleration(AverageAcceleration));
    trapezoidal_phase(Method::MoreauJean(MoreauJean { theta: 0.5 }));
    trapezoidal_phase(Method::Family(Coefficients::generalized_alpha(1.0)));
}

#[test]
fn central_differences_have_their_phase_and_their_limit() {
    let choice = Method::Family(Coefficients::central_difference());
    for w in ladder() {
        let step = choice.amplification(w);
        // z^2 - 2 (1 - W2/2) z + 1 = 0
        let cos = 1.0 - 0.5 * w * w;
        if w < 2.0 {
            assert!((step.spectral_radius - 1.0).abs() < ROUND_OFF, "{w}");
            // sin(phase/2) = W/2
            let phase = 2.0 * libm::asin(0.5 * w);
            let error = step.principal.unwrap().phase / phase - 1.0;
            assert!(error.abs() < ROUND_OFF, "{w}");
        } else {
            let radius = -cos + (cos * cos - 1.0).sqrt();
            assert!(
                (step.spectral_radius / radius - 1.0).abs() < ROUND_OFF,
                "{w}"
            );
            assert_eq!(step.principal, None);
        }
    }
    assert!(choice.amplification(2.0 + 1e-9).spectral_radius > 1.0);
}

#[test]
fn undamped_newmark_has_the_closed_form_of_the_textbook() {
    // Hughes: gamma = 1/2: |z| = 1 and cos(phase) = 1 - W2/(2 (1 + beta W2)), sin(phase/2)^2 = W2/(4 (1 + beta W2)).
    for beta in [0.0, 1.0 / 12.0, 1.0 / 6.0, 0.25, 0.5] {
        let choice = Method::Family(Coefficients::newmark(beta, 0.5));
        for w in ladder().filter(|w| 4.0 * (1.0 + beta * w * w) > 1.01 * w * w) {
            let sin = 0.5 * w / (1.0 + beta * w * w).sqrt();
            let principal = choice.amplification(w).principal.unwrap();
            // asin is steep near 1.
            let tolerance = ROUND_OFF / (1.0 - sin * sin);
            assert!(
                (principal.phase - 2.0 * libm::asin(sin)).abs() < tolerance,
                "{beta} {w}"
            );
            assert!(principal.damping_ratio.abs() < ROUND_OFF, "{beta} {w}");
        }
    }
}

#[test]
fn alpha_methods_have_their_radius_at_infinite_frequency() {
    for i in 0..=10 {
        let rho = f64::from(i) / 10.0;
        // All three eigenvalues tend to -rho. Their product and sum are analytic in 1/W2, the radius in W^(-2/3) only.
        let method = Coefficients::generalized_alpha(rho);
        let matrix = method.change(1e7) + nalgebra::Matrix3::identity();
        assert!((matrix.trace() + 3.0 * rho).abs() < 1e-12, "{rho}");
        assert!(
            (matrix.determinant() + rho * rho * rho).abs() < 1e-12,
            "{rho}"
        );
        for w in [1e3, 1e5] {
            let radius = Method::Family(method).amplification(w).spectral_radius;
            let tolerance = 10.0 * libm::pow(w, -2.0 / 3.0);
            assert!((radius - rho).abs() < tolerance, "{rho} {w}: {radius}");
        }
        // Hilber, Hughes and Taylor: two at -(1 + alpha)/(1 - alpha), the third at alpha/(1 + alpha), never larger.
        let alpha = -rho / 3.0;
        let method = Coefficients::hht(alpha);
        let [two, third] = [-(1.0 + alpha) / (1.0 - alpha), alpha / (1.0 + alpha)];
        let matrix = method.change(1e7) + nalgebra::Matrix3::identity();
        assert!(
            (matrix.trace() - 2.0 * two - third).abs() < 1e-12,
            "{alpha}"
        );
        assert!(
            (matrix.determinant() - two * two * third).abs() < 1e-12,
            "{alpha}"
        );
        for w in [1e3, 1e5] {
            let radius = Method::Family(method).amplification(w).spectral_radius;
            // At alpha = -1/3 all three are of one size.
            let tolerance = 10.0 * libm::pow(w, -2.0 / 3.0);
            assert!((radius + two).abs() < tolerance, "{alpha} {w}: {radius}");
        }
    }
}

#[test]
fn damped_methods_never_amplify_and_damp_high_frequencies_most() {
    for (choice, limit) in all() {
        let mut last = f64::INFINITY;
        for w in ladder().filter(|w| *w < limit) {
            let step = choice.amplification(w);
            let tolerance = round_off(choice, w);
            assert!(step.spectral_radius < 1.0 + tolerance, "{choice:?} {w}");
            if let Some(principal) = step.principal {
                assert!(principal.damping_ratio > -tolerance, "{choice:?} {w}");
            }
            // The radius of Bathe's method and of Moreau and Jean's falls all the way.
            if !matches!(choice, Method::Family(_)) {
                assert!(step.spectral_radius < last + ROUND_OFF, "{choice:?} {w}");
                last = step.spectral_radius;
            }
        }
    }
}

#[test]
fn backward_euler_has_its_closed_form() {
    // theta = 1: z = 1/(1 - iW).
    for w in ladder() {
        let step = Method::MoreauJean(MoreauJean { theta: 1.0 }).amplification(w);
        let radius = 1.0 / (1.0 + w * w).sqrt();
        assert!(
            (step.spectral_radius / radius - 1.0).abs() < ROUND_OFF * (1.0 + w * w),
            "{w}"
        );
        let phase = step.principal.unwrap().phase;
        assert!(
            (phase / libm::atan(w) - 1.0).abs() < ROUND_OFF * (1.0 + w),
            "{w}"
        );
    }
}

#[test]
fn bathes_matrix_is_that_of_its_two_rules() {
    for w in ladder() {
        let w2 = w * w;
        // Trapezoidal rule over dt/2 for (u, V): (u1 - u0) = (V0 + V1)/4, (V1 - V0) = -W2 (u0 + u1)/4.
        let left = Matrix2::new(1.0, -0.25, 0.25 * w2, 1.0);
        let right = Matrix2::new(1.0, 0.25, -0.25 * w2, 1.0);
        let middle = left.lu().solve(&right).unwrap();
        // Backward difference: V2 = u0 - 4 u1 + 3 u2, -W2 u2 = V0 - 4 V1 + 3 V2.
        let left = Matrix2::new(3.0, -1.0, w2, 3.0);
        let old = Matrix2::identity() - middle * 4.0;
        let end = left.lu().solve(&-old).unwrap();
        let matrix = Bathe::change(w) + Matrix2::identity();
        // Unknowns of size 1 and W.
        let error = (end - matrix).component_div(&Matrix2::new(1.0, 1.0 / w, w, 1.0));
        assert!(error.amax() < 1e-13, "{w}: {error}");
        // rho^2 = ((144 - 47 W2)^2 + W2 (144 - 5 W2)^2)/((9 + W2) (16 + W2))^2
        let (same, other) = (144.0 - 47.0 * w2, w * (144.0 - 5.0 * w2));
        let d = (9.0 + w2) * (16.0 + w2);
        let radius = (same * same + other * other).sqrt() / d;
        let step = Method::Bathe(Bathe).amplification(w);
        assert!(
            (step.spectral_radius / radius - 1.0).abs() < 1e-12 * (1.0 + w),
            "{w}"
        );
    }
}

/// Steps of a free mode, as u and dt v.
struct Steps(u32);

impl WithMethod for Steps {
    type Output = Vec<Vector2<f64>>;
    fn run<N: Recursion<1>>(self, mut method: N) -> Self::Output {
        let mut states = Vec::new();
        for _ in 0..self.0 {
            method.step(&mut Prescribed([0.0; 2]));
            let (x, v) = method.modes().next().unwrap();
            let contact = method.contact();
            assert!((contact.displacement.0[0] - x.0[0]).abs() < 1e-10);
            assert_eq!(v, method.first_velocity().unwrap());
            assert!((contact.velocity.0[0] - v.0[0]).abs() < 1e-10);
            states.push(Vector2::new(x.0[0], v.0[0]));
        }
        states
    }
}

/// A - I of a method.
fn change(choice: Method, w: f64) -> DMatrix<f64> {
    let three =
        |family: Coefficients| DMatrix::from_column_slice(3, 3, family.change(w).as_slice());
    match choice {
        Method::Bathe(Bathe) => DMatrix::from_column_slice(2, 2, Bathe::change(w).as_slice()),
        Method::MoreauJean(moreau_jean) => {
            DMatrix::from_column_slice(2, 2, moreau_jean.change(w).as_slice())
        }
        Method::ContactStabilized(ContactStabilized) => {
            change(Method::MoreauJean(MoreauJean { theta: 0.5 }), w)
        }
        Method::Family(family) => three(family),
        Method::AverageAcceleration(AverageAcceleration) => three(Coefficients::newmark(0.25, 0.5)),
    }
}

#[test]
fn free_modes_follow_the_powers_of_the_matrices() {
    for (choice, limit) in all() {
        for w in ladder().filter(|w| *w < limit) {
            // dt = 1, so that dt v = v. Sizes 1 and W of u and v.
            let (u, v) = (0.8, 0.6 * w);
            let change = change(choice, w);
            let matrix = DMatrix::identity(change.nrows(), change.nrows()) + change;
            let whole = Vector4::new(u, v, -w * w * u, 0.0);
            let mut state = DVector::from_column_slice(&whole.as_slice()[..matrix.nrows()]);
            let steps = with(
                &start(choice, 1.0, 0.0, 0.0),
                &[mode(w * w, 0.7, u, v)],
                Steps(40),
            );
            for (i, computed) in steps.iter().enumerate() {
                state = &matrix * state;
                // Each step rounds numbers of size W2 (the accelerations); the powers do, too. In the unstable neighbourhood of
                // a limit errors grow with the steps.
                let tolerance = 1e-15 * (i + 2) as f64 * (1.0 + w * w) * 4.0;
                let error = Vector2::new(computed[0] - state[0], (computed[1] - state[1]) / w);
                assert!(error.amax() < tolerance, "{choice:?} {w} {i}: {error}");
            }
        }
    }
}

#[test]
fn round_off_stays_small_for_small_steps() {
    // 2^15 steps of omega dt = 4e-4. A^(2n) - I = 2 N + N^2 with N = A^n - I, which keeps small changes exact.
    let w = 4e-4;
    for (choice, _) in all() {
        let mut power = change(choice, w);
        for _ in 0..15 {
            power = &power * 2.0 + &power * &power;
        }
        let whole = Vector4::new(0.8, 0.6 * w, -w * w * 0.8, 0.0);
        let first = DVector::from_column_slice(&whole.as_slice()[..power.nrows()]);
        let last = &first + &power * &first;
        let steps = with(
            &start(choice, 1.0, 0.0, 0.0),
            &[mode(w * w, 0.7, 0.8, 0.6 * w)],
            Steps(1 << 15),
        );
        let computed = steps[steps.len() - 1];
        let error = Vector2::new(computed[0] - last[0], (computed[1] - last[1]) / w);
        // Each step rounds u and v once: 1e-16 sqrt(2^15) if the signs are random. Recursions without increments lose 1/w more.
        assert!(error.amax() < 5e-13, "{choice:?}: {error}");
    }
}
