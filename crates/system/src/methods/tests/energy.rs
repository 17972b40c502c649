//! Energy over steps: what a method dissipates, and the work of the contact.

use super::*;

/// A free mode with W2 = (omega dt)^2 and dt = 1: u and V after each step.
struct Free(u32);

impl WithMethod for Free {
    type Output = Vec<[f64; 2]>;
    fn run<N: Recursion<1>>(self, mut method: N) -> Self::Output {
        let of = |method: &N| {
            let (x, v) = method.modes().next().unwrap();
            [x.0[0], v.0[0]]
        };
        let mut states = vec![of(&method)];
        for _ in 0..self.0 {
            method.step(&mut Prescribed([0.0; 2]));
            states.push(of(&method));
        }
        states
    }
}

fn free(choice: Method, w: f64) -> Vec<[f64; 2]> {
    with(
        &start(choice, 1.0, 0.0, 0.0),
        &[mode(w * w, 1.0, 0.8, 0.6 * w)],
        Free(300),
    )
}

const SIZES: [f64; 6] = [0.01, 0.1, 0.5, 1.5, 10.0, 100.0];

/// Round-off of energies: squares of numbers with errors of eps W2 in u and v/omega a step, over 300 steps.
fn round_off(w: f64) -> f64 {
    1e-13 * (1.0 + w * w)
}

#[test]
fn methods_with_the_mean_of_both_ends_dissipate_nothing() {
    for choice in [
        Method::Family(Coefficients::newmark(0.25, 0.5)),
        Method::Family(Coefficients::generalized_alpha(1.0)),
        Method::MoreauJean(MoreauJean { theta: 0.5 }),
        Method::ContactStabilized(ContactStabilized),
    ] {
        for w in SIZES {
            let energy = |[u, v]: [f64; 2]| v * v / (w * w) + u * u;
            for state in free(choice, w) {
                assert!((energy(state) - 1.0).abs() < round_off(w), "{choice:?} {w}");
            }
        }
    }
}

#[test]
fn newmarks_methods_dissipate_by_their_identity() {
    // With E = (V^2 + W2 u^2 + (beta - gamma/2) A^2)/2, A = -W2 u: E' - E = -(gamma - 1/2) (W2 (u' - u)^2 + (beta - gamma/2)
    // (A' - A)^2) (Hughes, section 9.2, from the rule's definition).
    for (beta, gamma, limit) in [
        (0.25, 0.5, f64::INFINITY),
        (1.0 / 6.0, 0.5, 3.4),
        (0.0, 0.5, 2.0),
        (0.3025, 0.6, f64::INFINITY),
        (0.5, 0.75, f64::INFINITY),
    ] {
        let choice = Method::Family(Coefficients::newmark(beta, gamma));
        for w in SIZES.into_iter().filter(|w| *w < limit) {
            let (w2, rest) = (w * w, beta - 0.5 * gamma);
            let energy = |[u, v]: [f64; 2]| (v * v / w2 + u * u + rest * w2 * u * u) * 0.5;
            for pair in free(choice, w).windows(2) {
                let change = pair[1][0] - pair[0][0];
                let loss = (gamma - 0.5) * (1.0 + rest * w2) * change * change;
                let error = energy(pair[0]) - energy(pair[1]) - loss;
                assert!(
                    error.abs() < round_off(w) * (1.0 + w2),
                    "{beta} {gamma} {w}: {error}"
                );
            }
        }
    }
}

#[test]
fn moreau_and_jeans_method_dissipates_by_its_identity() {
    // E - E' = (theta - 1/2) ((V' - V)^2 + W2 (u' - u)^2) with E = (V^2 + W2 u^2)/2.
    for theta in [0.5, 0.6, 1.0] {
        for w in SIZES {
            let energy = |[u, v]: [f64; 2]| (v * v / (w * w) + u * u) * 0.5;
            for pair in free(Method::MoreauJean(MoreauJean { theta }), w).windows(2) {
                let [du, dv] = [pair[1][0] - pair[0][0], (pair[1][1] - pair[0][1]) / w];
                let error = energy(pair[0]) - energy(pair[1]) - (theta - 0.5) * (du * du + dv * dv);
                assert!(error.abs() < round_off(w), "{theta} {w}: {error}");
            }
        }
    }
}

#[test]
fn damped_methods_dissipate_what_their_damping_ratio_says() {
    // Of the free motion rho^n cos(n phase + ...): after n steps the energy is rho^(2n) times the first one, up to the
    // spurious root and the shape of the orbit, which do not grow with n.
    for (choice, limit) in all() {
        for w in SIZES.into_iter().filter(|w| *w < limit.min(2.0)) {
            let states = free(choice, w);
            let energy = |[u, v]: [f64; 2]| v * v / (w * w) + u * u;
            let last = energy(states[300]);
            let Some(principal) = choice.amplification(w).principal else {
                panic!("{choice:?} {w}");
            };
            let decay = libm::exp(-600.0 * principal.damping_ratio * principal.phase);
            assert!(
                last < 1.0 + round_off(w) || decay > 0.999_999,
                "{choice:?} {w}: {last}"
            );
            let orbit = 1.0 + w + w * w;
            assert!(
                last < decay * orbit * orbit && last > decay / (orbit * orbit),
                "{choice:?} {w}: {last} {decay}"
            );
        }
    }
}

/// Work of the contact and energy, for prescribed forces on two modes.
struct Work<'a>(&'a [ModeStart<1>]);

impl WithMethod for Work<'_> {
    type Output = ();
    fn run<N: Recursion<1>>(self, mut method: N) {
        let energy = |method: &N| -> f64 {
            let states = method.modes().zip(self.0);
            states
                .map(|((x, v), mode_start)| mode_start.mode[0].energy(x.0[0], v.0[0]))
                .sum()
        };
        let (first, form) = (
            energy(&method),
            ContactWork::new(N::Scheme::FORCE_AT_END, Lane([0.1])),
        );
        let (mut work, mut most) = (0.0, 0.0_f64);
        for i in 0..1000 {
            let was = method.contact();
            let now = method.step(&mut Prescribed([libm::sin(0.1 * f64::from(i)); 2]));
            let force = form.force([was.force, now.force]);
            let r = [was.displacement, now.displacement];
            work += (force * form.displacement(r, [was.velocity, now.velocity])).0[0];
            most = most.max(f64::abs(work));
            // Sums of 1000 terms of size up to 10.
            assert!((first - energy(&method) - work).abs() < 1e-11, "{i}");
        }
        assert!(most > 0.1);
    }
}

#[test]
fn without_dissipation_the_modes_lose_the_work_of_the_contact() {
    let modes = [mode(4.0, 0.7, 0.3, 1.0), mode(0.0, 0.2, 0.5, -0.4)];
    for choice in [
        Method::Family(Coefficients::newmark(0.25, 0.5)),
        Method::Family(Coefficients::generalized_alpha(1.0)),
        Method::MoreauJean(MoreauJean { theta: 0.5 }),
        Method::ContactStabilized(ContactStabilized),
    ] {
        with(&start(choice, 0.1, 0.0, 0.0), &modes, Work(&modes));
    }
}
