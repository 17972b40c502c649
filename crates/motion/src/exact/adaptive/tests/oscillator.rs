//! One mass.

use super::*;

fn friction(law: ContactLaw) -> Structure {
    let limit = Limit::constant(1.0);
    let mut structure = one(1.0, StructureLaw::new(law, limit).from_its_answer(), 0.0);
    structure.displacement = vec![12.0];
    structure.preload.forces = vec![Some(0.0)];
    structure
}

#[test]
fn the_laws_of_the_papers_move_as_their_closed_forms() {
    let times = times(8.0 * std::f64::consts::PI, 160);
    for width in [0.01, 0.1, 1.0, 5.0] {
        let law = DisplacementControl {
            compliance: width,
            limit: 1.0,
        };
        let computed = at(
            &friction(ContactLaw::DisplacementControl(law)),
            &times,
            TOLERANCE,
        );
        let mut closed_form = Regularised::displacement(12.0, width, 0.0);
        let exact: Vec<[f64; 3]> = times.iter().map(|t| closed_form.at(*t).values()).collect();
        // 1e-12 of x0 in a step, of some hundred steps.
        assert!(
            distance(&computed, &exact, 0) < 1.2e-11,
            "{width} {}",
            distance(&computed, &exact, 0)
        );
        let law = VelocityControl {
            compliance: width,
            limit: 1.0,
        };
        let computed = at(
            &friction(ContactLaw::VelocityControl(law)),
            &times,
            TOLERANCE,
        );
        let mut closed_form = Regularised::velocity(12.0, width);
        let exact: Vec<[f64; 3]> = times.iter().map(|t| closed_form.at(*t).values()).collect();
        assert!(
            distance(&computed, &exact, 0) < 1.2e-11,
            "{width} {}",
            distance(&computed, &exact, 0)
        );
    }
}

fn laws() -> Vec<ContactLaw> {
    let [compliance, limit] = [0.1, 1.0];
    let lugre = Lugre {
        sigma0: 10.0,
        sigma1: 0.5,
        sigma2: 0.1,
        limit,
        static_limit: 1.2,
        stribeck_velocity: 0.5,
    };
    let mut laws = vec![ContactLaw::Lugre(lugre)];
    for exponent in [0.0, 0.5, 1.0, 2.0] {
        laws.push(ContactLaw::Dahl(Dahl {
            compliance,
            limit,
            exponent,
        }));
    }
    for exponent in [0.5, 1.0, 2.0, 5.0] {
        laws.push(ContactLaw::BoucWen(BoucWen {
            compliance,
            limit,
            exponent,
            beta: 0.5,
        }));
    }
    for compliance in [1e-3, 1e-2, 0.1] {
        laws.push(ContactLaw::Tanh(Tanh {
            compliance,
            limit,
            ratio: 1.0,
            rate: 0.0,
        }));
    }
    laws
}

#[test]
fn the_difference_of_two_tolerances_bounds_the_error_of_the_finer_one() {
    let times = times(8.0 * std::f64::consts::PI, 80);
    for law in laws() {
        let structure = friction(law);
        let best = at(&structure, &times, 1e-14);
        let fine = at(&structure, &times, TOLERANCE);
        let error = distance(&fine, &best, 0);
        // The estimate of a study, and the same at a coarser pair.
        for [fine, coarse] in [[TOLERANCE, COARSE], [1e-9, 1e-7]] {
            let some = coarse_times(&times);
            let computed = at(&structure, &some, fine);
            let estimate = distance(&computed, &at(&structure, &some, coarse), 0);
            let chosen: Vec<[f64; 3]> = best
                .iter()
                .zip(&times)
                .filter(|(_, t)| some.contains(t))
                .map(|(state, _)| *state)
                .collect();
            let own_error = distance(&computed, &chosen, 0);
            assert!(
                own_error <= estimate,
                "{law:?} {fine}: {own_error} {estimate}"
            );
        }
        assert!(error < 5e-10, "{law:?}: {error}");
    }
}

#[test]
fn elastoplastic_laws_are_one() {
    // Dahl's model with n = 0 is displacement-control.
    let times = times(8.0 * std::f64::consts::PI, 80);
    let [compliance, limit] = [0.1, 1.0];
    let dahl = ContactLaw::Dahl(Dahl {
        compliance,
        limit,
        exponent: 0.0,
    });
    let mut closed_form = Regularised::displacement(12.0, compliance, 0.0);
    let exact: Vec<[f64; 3]> = times.iter().map(|t| closed_form.at(*t).values()).collect();
    let computed = at(&friction(dahl), &times, TOLERANCE);
    assert!(distance(&computed, &exact, 0) < 1.2e-11);
}

#[test]
fn a_mass_bounces_on_springs_as_the_closed_forms_of_the_laws_say() {
    // The restitution of two free masses, m = 1, with a closing speed of 2.
    let [stiffness, damping] = [50.0, 0.8];
    let laws = [
        ContactLaw::Hertz(Hertz { stiffness }),
        ContactLaw::KelvinVoigt(KelvinVoigt {
            stiffness,
            damping: 3.0,
        }),
        ContactLaw::HuntCrossley(HuntCrossley { stiffness, damping }),
        ContactLaw::Jankowski(Jankowski {
            stiffness,
            damping: 3.0,
        }),
    ];
    for law in laws {
        let mut structure = one(0.0, StructureLaw::new(law, None).from_its_answer(), 1.0);
        structure.velocity = vec![-2.0];
        let end = at(&structure, &[3.0], TOLERANCE)[0];
        let expected = law.collision(1.0, 2.0).unwrap();
        let restitution = end[1] / 2.0;
        println!("{law:?} {restitution} {expected:?}");
        assert!(
            (restitution - expected.restitution).abs() < 1e-10,
            "{law:?}: {restitution}"
        );
    }
}

/// v' = p/m - (c/m) v^a from v0: without p it rests at m v0^(1 - a)/(c (1 - a)); under p = beta t, it creeps with v = (beta t/c)^(1/a) but
/// for m v', which is far smaller.
#[test]
fn a_damper_that_is_steep_at_rest_stops_a_mass_and_lets_it_creep() {
    for exponent in [0.1, 0.2, 0.35, 0.5, 0.8] {
        let (c, v0) = (2.0, 1.5);
        let law = ContactLaw::Viscous(Viscous {
            viscosity: c,
            exponent,
        });
        let mut mass = one(0.0, StructureLaw::new(law, None), 0.0);
        mass.velocity = vec![v0];
        let left = 1.0 - exponent;
        let stop = libm::pow(v0, left) / (c * left);
        let times = times(2.0 * stop, 40);
        for (time, [u, v, s]) in times.iter().zip(at(&mass, &times, TOLERANCE)) {
            let rest = (libm::pow(v0, left) - left * c * time).max(0.0);
            let known = libm::pow(rest, 1.0 / left);
            // From v v'/(c v^a) = -u'.
            let power = 2.0 - exponent;
            let way = (libm::pow(v0, power) - libm::pow(known, power)) / (c * power);
            assert!((v - known).abs() < 1e-11, "{exponent} {time}: {v} {known}");
            assert!((u - way).abs() < 1e-11, "{exponent} {time}: {u} {way}");
            // A velocity of 1e-12 has the force of its power.
            let force = c * libm::pow(known, exponent);
            let error = c * libm::pow(1e-11, exponent);
            assert!((s - force).abs() < error, "{exponent} {time}: {s} {force}");
        }
        let mut creeping = one(0.0, StructureLaw::new(law, None), 0.0);
        let (slope, end) = (0.05, 4.0);
        creeping.loads = vec![Load {
            pattern: vec![(0, 1.0)],
            signal: Table::new(vec![0.0, end], vec![0.0, slope * end])
                .map(|table| std::sync::Arc::new(Signal::Table(table)))
                .unwrap(),
        }];
        for [_, v, s] in at(&creeping, &[end], TOLERANCE) {
            // m v' = beta (1/a) (beta t/c)^(1/a)/(beta t), once more put into the law.
            let inverse = 1.0 / exponent;
            let inertia = inverse * libm::pow(slope * end / c, inverse) / end;
            let force = slope * end - inertia;
            let [of_force, of_law] = [force, slope * end].map(|s| libm::pow(s / c, inverse));
            let next = (of_force - of_law).abs();
            assert!(
                (v - of_force).abs() < 2.0 * next,
                "{exponent}: {v} {of_force}"
            );
            assert!(
                (s - force).abs() < 2.0 * c * inertia.max(1e-11),
                "{exponent}: {s} {force}"
            );
        }
    }
}
