//! Bars: the modal form compared with the textbook form, up to the time from which the problem amplifies round-off too much.

use nalgebra::DVector;
use slipgap::contact::element::ImpactElement;
use slipgap::contact::{ContactLaw, ImpactSpring};
use slipgap::exact::wave::Bars;
use slipgap::lane::Lane;
use slipgap::methods::{AverageAcceleration, Recursion};
use slipgap::problem::impact::case::system;
use slipgap::problem::impact::scaled::{CLOSING, Scaled};
use slipgap::solve::{start, visited::Stepper};
use slipgap::system::BarPair;
use slipgap::system::bar::{Bar, Mass};
use slipgap::textbook::{Assembly, Iteration, Newmark, assemble_bars};

/// Equal bars, gamma and n as given.
fn equal(gamma: f64, n: u32, kind: Mass) -> Scaled {
    let bar = Bar {
        elements: n,
        mass: 0.5,
        travel_time: 1.0,
        kind,
    };
    Scaled {
        pair: BarPair {
            left: bar,
            right: Some(bar),
            velocity: CLOSING,
        },
        bars: Bars {
            impedance_ratio: 1.0,
            time_ratio: 1.0,
            gap: 0.0,
        },
        spring: 2.0 * gamma * f64::from(n),
        law: ContactLaw::ImpactSpring(ImpactSpring {
            stiffness: 2.0 * gamma * f64::from(n),
        }),
        method: AverageAcceleration.into(),
        length_ratio: 1.0,
    }
}

fn textbook(scaled: &Scaled, dt: f64) -> Newmark<ImpactElement> {
    let assembly: Assembly = assemble_bars(scaled.pair.left, scaled.pair.right, scaled.bars.gap);
    let size = assembly.mass.nrows();
    let first = scaled.pair.left.elements as usize + 1;
    let [left, right] = match scaled.pair.right {
        Some(_) => [1.0, -1.0],
        None => [2.0, 0.0],
    };
    let v = DVector::from_fn(size, |i, _| if i < first { left } else { right });
    let element = ImpactElement::new(scaled.spring);
    Newmark::new(assembly, element, dt, DVector::zeros(size), v).unwrap()
}

/// The last time of the comparison in T_I, and the largest difference over the round-off allowed at that time.
fn compare(scaled: &Scaled, dt: f64, duration: f64) -> (f64, f64) {
    let steps = (duration / dt).round() as usize;
    let (mut modal, mut law) = start::<1, Stepper, _>(&[system(scaled, dt, 0)]).unwrap();
    // The same with a gap that is 1e-13 larger: the amplification of a disturbance by the problem.
    let mut moved = *scaled;
    moved.bars.gap += 1e-13;
    let (mut disturbed, mut other_law) = start::<1, Stepper, _>(&[system(&moved, dt, 0)]).unwrap();
    let mut book = textbook(scaled, dt);
    let (mut growth, mut largest): (f64, f64) = (1.0, 0.0);
    for step in 1..=steps {
        let (a, b) = (modal.step(&mut law), disturbed.step(&mut other_law));
        book.step(Iteration::Converged).unwrap();
        let rows = |c: slipgap::methods::ContactState<1>| [c.displacement, c.velocity, c.force];
        for ((Lane([x]), Lane([y])), z) in rows(a).into_iter().zip(rows(b)).zip(book.contact()) {
            growth = growth.max((x - y).abs() / 1e-13);
            largest = largest.max((x - z).abs() / growth);
        }
        // From here on a disturbance in the 13th digit is in the 4th.
        if growth > 1e9 {
            return (step as f64 * dt, largest);
        }
    }
    (duration, largest)
}

/// Round-off per unit of growth: the textbook form takes velocity from displacements of order 1 over dt/2.
fn round_off(dt: f64) -> f64 {
    16.0 * f64::EPSILON / dt
}

#[test]
fn both_forms_agree_as_far_as_the_problem_allows() {
    // [I] Fig. 3: k_I = 10 .. 1e5 is gamma = 0.1 .. 1000.
    for gamma in [0.1, 1.0, 10.0, 100.0, 1000.0] {
        let (until, difference) = compare(&equal(gamma, 10, Mass::Lumped), 0.001, 1.5);
        assert!(
            difference < round_off(0.001),
            "gamma = {gamma}: {difference:e}"
        );
        if gamma <= 100.0 {
            assert_eq!(until, 1.5, "gamma = {gamma}");
        }
        if gamma == 1000.0 {
            // Measured: 0.374 T_I; the exact time depends on round-off.
            assert!((0.2..0.6).contains(&until), "the limit lies at {until}");
        }
    }
}

#[test]
fn both_forms_agree_for_other_meshes_steps_and_bars() {
    for (n, dt) in [(2, 0.01), (40, 0.01), (10, 0.5), (10, 0.05)] {
        for kind in [Mass::Lumped, Mass::Consistent] {
            let scaled = equal(10.0 / f64::from(n), n, kind);
            let (until, difference) = compare(&scaled, dt, 1.5);
            assert_eq!(until, 1.5);
            assert!(
                difference < round_off(dt),
                "n = {n}, dt = {dt}: {difference:e}"
            );
        }
    }
    let mut unlike = equal(1.0, 10, Mass::Lumped);
    unlike.bars.gap = 0.3;
    unlike.pair.right = Some(Bar {
        elements: 7,
        mass: 0.9,
        travel_time: 1.7,
        kind: Mass::Lumped,
    });
    assert!(compare(&unlike, 0.01, 3.0).1 < round_off(0.01));
    unlike.pair.right = None;
    assert!(compare(&unlike, 0.01, 3.0).1 < round_off(0.01));
}

#[test]
fn without_iteration_contact_is_much_too_long_at_a_coarse_step() {
    // reference: at dt = 0.5 T_I and gap 0 contact lasts 0.72 T_I converged, 3.6 to 3.9 T_I without iteration.
    let scaled = equal(1.0, 10, Mass::Lumped);
    let last_contact = |iteration| {
        let mut book = textbook(&scaled, 0.5);
        let mut last = 0.0;
        let mut before = book.contact()[0];
        for step in 1..=20 {
            book.step(iteration).unwrap();
            let r = book.contact()[0];
            if before < 0.0 && r >= 0.0 {
                // The zero of r, linear between two steps.
                last = 0.5 * (f64::from(step) - r / (r - before));
            }
            before = r;
        }
        last
    };
    let converged = last_contact(Iteration::Converged);
    let once = last_contact(Iteration::Once);
    assert!((converged - 0.72).abs() < 0.005, "{converged}");
    assert!((3.6..3.9).contains(&once), "{once}");
}
