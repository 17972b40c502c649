//! Bodies on supports that move from t = 0 on.

use super::*;
use crate::contact::ClippedLine;
use crate::solve::structure::{Prepared, run};
use crate::system::structure::{Baseline, Motion};

/// S of a contact between a support and a body of mass 2 at t = 0 and after a step, with the acceleration 3 cos(4 t) of the support.
fn forces(law: StructureLaw, dt: f64) -> [f64; 2] {
    let mut structure = masses(&[2.0]);
    let both = || Symmetric::zeros(2);
    (
        structure.coupled_mass,
        structure.stiffness,
        structure.damping,
    ) = (both(), both(), both());
    structure.contacts = vec![contact([Some(1), Some(0)], 0.0, law)];
    let cosine = Signal::Sine {
        amplitude: 3.0,
        omega: 4.0,
        phase: 0.5 * PI,
    };
    let motion = Motion::new(&cosine, 1.0, 0.0, Baseline::None).unwrap();
    structure.prescribe(vec![("s".into(), Arc::new(motion))]);
    let prepared = Prepared::new(&structure, dt).unwrap();
    let mut forces = [0.0; 2];
    let [done] = run::<1>(&[&structure], &prepared, 1, |step, state| {
        forces[step] = state.contact(0).force.0[0];
    });
    done.unwrap();
    forces
}

#[test]
fn a_body_that_sticks_to_its_support_has_its_acceleration_from_the_start() {
    let friction = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(9.0));
    let stop = StructureLaw::new(ClippedLine::Stop { restitution: 0.0 }, None);
    for law in [friction, stop] {
        // m a = -S. Round-off of sin(pi/2) and of products.
        assert!((forces(law.clone(), 0.05)[0] + 6.0).abs() < 1e-14);
        // The mean force of the first step moves the body as far as the support: of second order in dt.
        let error = [0.02, 0.01].map(|dt| {
            let [first, second] = forces(law.clone(), dt);
            let exact = -6.0 * libm::cos(4.0 * dt);
            assert!((first + 6.0).abs() < 1e-14);
            (second - exact).abs()
        });
        assert!(error[1] < 0.3 * error[0] && error[0] < 0.01, "{error:?}");
    }
    // Friction that cannot hold the body slides from the start.
    let weak = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(4.0));
    assert_eq!(forces(weak, 0.05), [-4.0; 2]);
}
