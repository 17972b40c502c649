//! Observed orders.

use super::*;
use crate::contact::ClippedLine;
use crate::exact::events;

/// Largest error of node 0 against the exact motion.
fn error(method: &Method, structure: &Structure, duration: f64, steps: usize) -> f64 {
    let dt = duration / steps as f64;
    let times: Vec<f64> = (0..=steps).map(|i| i as f64 * dt).collect();
    let mut exact = Vec::new();
    events::run(structure, &times, |_, state| exact.push(state.u[0])).unwrap();
    let mut largest = 0.0_f64;
    books(method, structure, dt, steps, |step, state| {
        largest = largest.max((state.displacement(0).0[0] - exact[step]).abs());
    });
    largest
}

/// Masses in a row with damping under a sine; with contacts that are always closed and stick.
fn row(contacts: bool) -> Structure {
    let mut structure = masses(&[1.0, 2.0, 1.5]);
    for (i, k) in [(0, 20.0), (1, 30.0)] {
        structure.stiffness.add_spring([Some(i), Some(i + 1)], k);
        structure.damping.add_spring([Some(i), Some(i + 1)], 0.2);
    }
    structure.stiffness.add(0, 0, 10.0);
    structure.damping.add(0, 0, 0.3);
    structure.velocity = vec![0.1, -0.2, 0.3];
    structure.loads = vec![Load {
        pattern: vec![(0, 1.0), (2, -0.5)],
        signal: Arc::new(Signal::Sine {
            amplitude: 1.0,
            omega: 3.0,
            phase: 0.4,
        }),
    }];
    if contacts {
        structure.contacts = vec![
            contact(
                [Some(2), None],
                -5.0,
                StructureLaw::new(ClippedLine::Spring { stiffness: 8.0 }, None),
            ),
            contact([Some(0), Some(1)], 0.0, displacement_control(6.0, 1e3)),
            contact([None, Some(1)], 0.0, velocity_control(0.7, 1e3)),
        ];
        // Near rest at t = 0: the spring pushes with 40.
        structure.stiffness.add(2, 2, 200.0);
        structure.displacement[2] = -0.17;
    }
    structure
}

#[test]
fn smooth_motions_have_the_order_of_the_method() {
    for (name, method) in methods() {
        for contacts in [false, true] {
            let structure = row(contacts);
            let [coarse, fine] = [800, 1600].map(|steps| error(&method, &structure, 4.0, steps));
            // Forces of contacts act at the end of a step in the method of Moreau and Jean; newmark has gamma = 0.6 here.
            let order = match name {
                "newmark" | "moreau-jean 0.7" => 1.0,
                "moreau-jean" | "contact-stabilized-newmark" if contacts => 1.0,
                _ => 2.0,
            };
            let observed = (coarse / fine).log2();
            assert!(
                (observed - order).abs() < 0.05,
                "{name} {contacts} {observed}"
            );
        }
    }
}

#[test]
fn a_jump_of_a_load_between_steps_costs_no_order() {
    let times = vec![0.0, 0.5, 0.5, 1.0, 1.0, 4.0];
    let table = Table::new(times, vec![1.0, 2.0, -3.0, -1.0, 0.5, 0.0]).unwrap();
    let mut structure = row(false);
    structure.loads[0].signal = Arc::new(Signal::Table(table));
    for (name, method) in methods() {
        if ["newmark", "moreau-jean 0.7"].contains(&name) {
            continue;
        }
        let [coarse, fine] = [800, 1600].map(|steps| error(&method, &structure, 4.0, steps));
        let observed = (coarse / fine).log2();
        assert!((observed - 2.0).abs() < 0.1, "{name} {observed}");
    }
}

#[test]
fn softened_impacts_and_friction_converge() {
    let mut structure = row(false);
    structure.contacts = vec![
        contact(
            [Some(2), None],
            0.05,
            StructureLaw::new(ClippedLine::Spring { stiffness: 400.0 }, None),
        ),
        contact([Some(0), Some(1)], 0.0, displacement_control(60.0, 0.3)),
        contact([None, Some(1)], 0.0, velocity_control(5.0, 0.2)),
    ];
    for (name, method) in methods() {
        let [coarse, fine] = [1000, 8000].map(|steps| error(&method, &structure, 6.0, steps));
        // At least first order; kinks of the laws make the constant uneven.
        assert!(fine < coarse / 6.0 && fine < 5e-3, "{name} {coarse} {fine}");
    }
}

/// A mass on a spring of 4 with LuGre friction, which moves at t = 0.
const SIGMA: [f64; 3] = [50.0, 0.3, 0.2];
const LIMITS: [f64; 2] = [1.0, 1.05];
const STRIBECK: f64 = 0.5;
const START: f64 = 2.3;

/// du/dt, dv/dt and dz/dt of that mass by the equations of the model.
fn rates([u, v, z]: [f64; 3]) -> [f64; 3] {
    let [kinetic, largest] = LIMITS;
    let square = (v / STRIBECK) * (v / STRIBECK);
    let g = kinetic + (largest - kinetic) * libm::exp(-square);
    let bristles = v - SIGMA[0] * v.abs() * z / g;
    let force = SIGMA[0] * z + SIGMA[1] * bristles + SIGMA[2] * v;
    [v, -4.0 * u - force, bristles]
}

/// [u, v, z] at `end` by the classical Runge-Kutta method.
fn runge_kutta(end: f64, steps: u32) -> [f64; 3] {
    let h = end / f64::from(steps);
    let moved = |y: [f64; 3], k: [f64; 3], h: f64| [0, 1, 2].map(|i| y[i] + h * k[i]);
    let mut y = [0.0, START, 0.0];
    for _ in 0..steps {
        let a = rates(y);
        let b = rates(moved(y, a, 0.5 * h));
        let c = rates(moved(y, b, 0.5 * h));
        let d = rates(moved(y, c, h));
        y = [0, 1, 2].map(|i| y[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
    y
}

#[test]
fn lugre_has_the_second_order_from_a_start_in_motion() {
    use crate::contact::{ContactLaw, Lugre};
    let end = 4.0;
    let exact = runge_kutta(end, 80_000);
    // Its own error, of second order at the kinks of |v|, is far below those of the steps, 7e-7 and more.
    let coarse = runge_kutta(end, 40_000);
    assert!((0..2).all(|i| (exact[i] - coarse[i]).abs() < 5e-8));
    let mut structure = masses(&[1.0]);
    structure.stiffness.add_spring([None, Some(0)], 4.0);
    structure.velocity[0] = START;
    let law = ContactLaw::Lugre(Lugre {
        sigma0: SIGMA[0],
        sigma1: SIGMA[1],
        sigma2: SIGMA[2],
        limit: LIMITS[0],
        static_limit: LIMITS[1],
        stribeck_velocity: STRIBECK,
    });
    let limit = Limit::constant(LIMITS[0]);
    let law = StructureLaw::new(law, limit).from_its_answer();
    structure.contacts = vec![contact([None, Some(0)], 0.0, law)];
    for method in [
        Method::AverageAcceleration(AverageAcceleration),
        Method::Family(Coefficients::hht(-0.2)),
        Method::Bathe(Bathe),
    ] {
        // Steps of 0.01, 0.005 .. 0.000625.
        let errors = [400, 800, 1600, 3200, 6400].map(|steps| {
            let mut last = [0.0; 2];
            books(
                &method,
                &structure,
                end / steps as f64,
                steps,
                |_, state| {
                    last = [state.displacement(0).0[0], state.velocity(0).0[0]];
                },
            );
            (0..2).fold(0.0, |most: f64, i| most.max((last[i] - exact[i]).abs()))
        });
        let observed = (errors[0] / errors[4]).log2() / 4.0;
        // The place of a reversal in its step makes the constant uneven: error/dt^2 is between 0.4 and 1.9 down to steps of 0.00002,
        // and log2(1.9/0.8)/4 is 0.31. An error of first order would give 1.
        assert!(
            (observed - 2.0).abs() < 0.35,
            "{method:?} {observed} {errors:?}"
        );
    }
}
