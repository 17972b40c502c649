//! Loads and supports that change between the steps, by all methods.

use super::*;
use crate::methods::METHODS;
use crate::system::structure::Motion;

/// All methods with their default numbers; central-difference, which needs no K, too.
fn methods() -> impl Iterator<Item = Method> {
    METHODS
        .iter()
        .filter_map(|description| description.with_defaults())
}

/// u and v of the first node after each step.
fn motion(structure: &Structure, method: &Method, dt: f64, steps: usize) -> Vec<[f64; 2]> {
    let prepared = Prepared::by(method, structure, dt).unwrap();
    let mut totals = Vec::new();
    let [done] = run::<1>(&[structure], &prepared, steps, |step, state| {
        let w = [state.displacement(0), state.velocity(0)].map(|lanes| vec![lanes.0[0]]);
        let t = step as f64 * dt;
        totals.push([0, 1].map(|which| structure.total(0, t, which, &w[which])));
    });
    done.unwrap();
    totals
}

#[test]
fn a_blow_within_a_step_has_its_impulse_by_every_method() {
    // 1000 from 2.1 to 2.9 ms, then 500 from 5 to 5.3 ms, on a free mass of 2: v = 0.95/2.
    let times = vec![0.0021, 0.0021, 0.0029, 0.0029, 0.005, 0.005, 0.0053, 0.0053];
    let values = vec![0.0, 1e3, 1e3, 0.0, 0.0, 500.0, 500.0, 0.0];
    for method in methods() {
        for dt in [0.02, 0.01, 0.004, 0.0007] {
            let mut structure = masses(&[2.0]);
            structure.stiffness = Symmetric::zeros(1);
            structure.damping = Symmetric::zeros(1);
            structure.coupled_mass = Symmetric::zeros(1);
            let table = Table::new(times.clone(), values.clone()).unwrap();
            structure.loads = vec![Load {
                pattern: vec![(0, 1.0)],
                signal: Arc::new(Signal::Table(table)),
            }];
            let steps = f64::max(0.4 / dt, 60.0) as usize;
            let [_, v] = motion(&structure, &method, dt, steps)[steps];
            // Round-off; a method with alpha_m settles by a factor of at most 1/2 in each of 60 steps.
            assert!((v - 0.475).abs() < 1e-12, "{method:?} {dt}: {v}");
        }
    }
}

/// A mass on a spring of omega = 9 and a dashpot of 5 % of critical to a support that moves by 0.1 within `ramp`.
fn pulled(ramp: f64) -> Structure {
    let mut structure = masses(&[1.0]);
    let both = || Symmetric::zeros(2);
    (
        structure.coupled_mass,
        structure.stiffness,
        structure.damping,
    ) = (both(), both(), both());
    structure.stiffness.add_spring([Some(0), Some(1)], 81.0);
    structure.damping.add_spring([Some(0), Some(1)], 0.9);
    let motion = Motion::through(&[0.0, ramp], &[0.0, 0.1], 0.0031).unwrap();
    structure.prescribe(vec![("s".into(), Arc::new(motion))]);
    structure
}

/// u of the mass after a sudden motion by 0.1 at `start`, by the textbook: relative to the support it vibrates freely from -0.1, and
/// the dashpot gives it the velocity 0.9 * 0.1.
fn exact(t: f64, start: f64) -> f64 {
    let (t, omega, zeta) = (t - start, 9.0, 0.05);
    let damped = omega * libm::sqrt(1.0 - zeta * zeta);
    let [u0, v0] = [-0.1, 0.09];
    let sine = (v0 + zeta * omega * u0) / damped * libm::sin(damped * t);
    0.1 + libm::exp(-zeta * omega * t) * (u0 * libm::cos(damped * t) + sine)
}

#[test]
fn a_support_that_jumps_within_a_step_leaves_the_mass_where_it_is() {
    for method in methods() {
        let of = |dt: f64| {
            let steps = (2.0 / dt) as usize;
            let totals = motion(&pulled(1e-5), &method, dt, steps);
            let error = totals.iter().enumerate().skip(2).map(|(i, [u, _])| {
                let t = i as f64 * dt;
                if t < 0.02 {
                    0.0
                } else {
                    (u - exact(t, 0.003_105)).abs()
                }
            });
            error.fold(0.0, f64::max)
        };
        // Steps find the jump up to half a step too early or late: 0.1 omega dt/2, and less than a step of the method.
        let [long, short] = [0.01, 0.00125].map(of);
        assert!(long < 0.012 && short < 0.0015, "{method:?}: {long} {short}");
    }
}

#[test]
fn a_ramp_that_the_steps_have_is_of_second_order() {
    for method in methods().filter(|method| method.order() == 2) {
        let at_end = |dt: f64| motion(&pulled(0.05), &method, dt, (1.0 / dt).round() as usize);
        let last = |dt: f64| at_end(dt).last().copied().unwrap()[0];
        let fine = last(0.05 / 512.0);
        let errors = [16.0, 32.0, 64.0].map(|parts| (last(0.05 / parts) - fine).abs());
        // The ramp begins between steps, so that the ratio is not quite 4; 1/512 is 1/64 of the last.
        let ratio = (errors[0] / errors[2]).sqrt();
        assert!(ratio > 3.0 || errors[0] < 1e-9, "{method:?}: {errors:?}");
    }
}
