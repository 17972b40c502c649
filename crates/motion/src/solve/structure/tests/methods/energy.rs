//! Energy books.

use super::*;
use crate::contact::ClippedLine;

#[test]
fn the_equations_leave_no_work_unbalanced() {
    let ground = ground();
    for (name, method) in methods() {
        let dt = if name == "central-difference" {
            2e-4
        } else {
            1e-3
        };
        for mut structure in [girders(2, 0.25, 0.5, &ground), mixed(2, 0.5, &ground)] {
            if name == "central-difference" {
                // Its Coulomb friction acts on velocities; its dashpots are implicit.
                structure.contacts.truncate(5);
            }
            let error = books(&method, &structure, dt, 3000, |_, _| ()).energy_error();
            assert!(error.0[0] < 1e-12, "{name} {error:?}");
        }
    }
}

#[test]
fn without_a_load_the_energy_that_is_lost_is_the_numerical_dissipation() {
    // A free vibration of a mass and a stiff one on it: alpha methods and Bathe's damp the stiff one.
    let mut structure = masses(&[1.0, 0.1]);
    structure.stiffness.add(0, 0, 1.0);
    structure.stiffness.add_spring([Some(0), Some(1)], 1e4);
    structure.displacement = vec![1.0, 1.001];
    let start = 0.5 + 0.5 * 1e4 * 1e-6;
    for (name, method) in methods() {
        let mut last = f64::NAN;
        // Two methods have a critical step.
        let short = ["linear-acceleration", "central-difference"].contains(&name);
        let [dt, steps] = if short {
            [0.005, 4000.0]
        } else {
            [0.05, 2000.0]
        };
        let steps = steps as usize;
        let books = books(&method, &structure, dt, steps, |_, state| {
            last = state.energy().0[0];
        });
        let lost = books.numerical_dissipation().0[0];
        assert!(
            (lost - (start - last)).abs() < 1e-12,
            "{name} {lost} {last}"
        );
        if ["hht", "generalized-alpha", "bathe"].contains(&name) {
            // All of the energy of the stiff mode, 0.005, and little of the other.
            assert!(lost > 0.004 && lost < 0.1, "{name} {lost}");
        }
        if ["moreau-jean", "contact-stabilized-newmark"].contains(&name) {
            assert!(lost.abs() < 1e-12, "{lost}");
        }
    }
}

#[test]
fn an_elastic_contact_gives_back_what_it_took() {
    // A mass flies against a spring and back; without numerical damping the contact took nothing.
    let mut structure = masses(&[1.0]);
    structure.velocity[0] = -1.0;
    structure.contacts = vec![contact(
        [None, Some(0)],
        0.1,
        StructureLaw::new(ClippedLine::Spring { stiffness: 1e4 }, None),
    )];
    for (name, method) in methods() {
        let mut end = 0.0;
        let books = books(&method, &structure, 1e-4, 3000, |_, state| {
            end = state.velocity(0).0[0];
        });
        let (work, lost) = (books.work(0).0[0], books.numerical_dissipation().0[0]);
        // Trapezoids give zero for the closed spring; the two steps in which it closes and opens, 0.5 k (dt v)^2 each.
        assert!(work.abs() < 2.0 * 0.5 * 1e4 * 1e-8, "{name} {work}");
        let kinetic = 0.5 - 0.5 * end * end;
        assert!((kinetic - work - lost).abs() < 1e-12, "{name}");
    }
}
