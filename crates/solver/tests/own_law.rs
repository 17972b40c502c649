//! A law of a user's program moves a structure as the same law of slipgap does.

#[path = "../examples/own_law.rs"]
mod own_law;

use own_law::{LAW, RATIO, mass_on};
use slipgap_solver::laws::Bilinear;
use slipgap_solver::{
    AverageAcceleration, Bathe, ContactLaw, Method, Own, Solution, Unsolvable, exact, run,
};

fn own() -> ContactLaw {
    ContactLaw::Own(Own(&LAW))
}

fn bilinear() -> ContactLaw {
    ContactLaw::Bilinear(Bilinear {
        stiffness: LAW.stiffness,
        yield_force: LAW.limit,
        hardening: RATIO * LAW.stiffness,
    })
}

fn moved(law: ContactLaw, method: Method, dt: f64, steps: usize) -> Solution {
    run(&mass_on(law), &method, dt, steps).unwrap()
}

/// The largest difference of two lists.
fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let both = a.iter().flatten().zip(b.iter().flatten());
    both.fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}

#[test]
fn an_own_law_steps_as_the_same_law_of_the_list() {
    for method in [AverageAcceleration.into(), Bathe.into()] {
        let [a, b] = [own(), bilinear()].map(|law| moved(law, method, 0.01, 1000));
        // The root of the own law is found to its last bits, and 1000 steps carry their round-off on.
        assert!(difference(&a.displacement, &b.displacement) < 1e-12);
        assert!(difference(&a.force, &b.force) < 1e-11);
        // It yields: after some cycles the mass swings about another place.
        assert!(a.force.iter().any(|s| s[0] > 1.1));
    }
}

#[test]
fn the_steps_of_an_own_law_converge_to_the_exact_motion_of_the_same_law() {
    let error = |steps: usize| {
        let dt = 4.0 / steps as f64;
        let motion = moved(own(), AverageAcceleration.into(), dt, steps);
        let exact = exact(&mass_on(bilinear()), &motion.time).unwrap();
        difference(&motion.displacement, &exact.displacement)
    };
    let errors = [400, 800, 1600].map(error);
    // Second order but for the steps in which the spring begins to yield, which are between 3 and 5 times better for half the step.
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((2.5..6.0).contains(&ratio), "{errors:?}");
    }
    assert!(errors[2] < 1e-5, "{errors:?}");
}

#[test]
fn an_own_law_has_no_exact_motion_and_says_so() {
    let why = exact(&mass_on(own()), &[1.0]).unwrap_err();
    assert!(matches!(why, Unsolvable::Reference(_)));
    let text = why.to_string();
    assert!(
        text.contains("spring") && text.contains("user's program"),
        "{text}"
    );
}
