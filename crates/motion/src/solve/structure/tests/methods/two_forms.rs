//! The two forms of each method agree: the sub-steps of structures, and the recursion of the modes in lanes.

use super::super::dense::full;
use super::*;
use crate::contact::offer::Form;
use crate::contact::{
    Bilinear, BoucWen, ClippedLine, ContactLaw, Dahl, GapYield, Hertz, HuntCrossley, HyperbolicGap,
    ImpactYield, KelvinVoigt, Lugre, Multilinear, Pendulum, Restrainer, Tanh, Viscous,
};
use crate::lane::Lane;
use crate::methods::{METHODS, ManyModes, ModeStart, Recursion, Scheme, Start};
use crate::system::Modal;
use nalgebra::{DMatrix, DVector};

const DT: f64 = 0.01;
const STEPS: usize = 600;

/// Of r, rdot and S. r and rdot are of size 1 and are rounded in each of 600 steps, to 1e-16 sqrt(600) = 3e-15 if the signs are random;
/// the highest frequency, about 20 with a contact, multiplies it in rdot, and the stiffness of the contact, 300, in S. Differences of
/// 8e-15, 6e-14 and 2e-12 were seen.
const TOLERANCES: [f64; 3] = [1e-13, 1e-12, 3e-11];

/// Three masses on springs that move against a contact of the last one with the ground.
fn row(law: StructureLaw) -> Structure {
    let mut row = masses(&[1.0, 2.0, 1.5]);
    for (between, k) in [
        ([None, Some(0)], 15.0),
        ([Some(0), Some(1)], 20.0),
        ([Some(1), Some(2)], 30.0),
    ] {
        row.stiffness.add_spring(between, k);
    }
    row.displacement = vec![0.1, -0.2, 0.3];
    row.velocity = vec![-0.4, 0.3, -1.2];
    row.contacts = vec![contact([None, Some(2)], 0.05, law)];
    row
}

/// A law of every form that a step has: clipped lines of r and of rdot, roots in closed form and by iteration, with and without memory.
fn relations() -> Vec<StructureLaw> {
    let impact =
        |law| StructureLaw::new(Form::of(law).with_restitution(0.6), None).from_its_answer();
    let limit = || Limit::constant(0.8);
    let link = |law| StructureLaw::new(law, None);
    let table = Multilinear::new(&[[0.01, 2.0], [0.03, 3.0], [0.2, 4.0]]).unwrap();
    let friction = |law| StructureLaw::new(law, limit()).from_its_answer();
    vec![
        StructureLaw::new(ClippedLine::Spring { stiffness: 300.0 }, None),
        displacement_control(200.0, 0.8),
        velocity_control(6.0, 0.8),
        impact(ContactLaw::Hertz(Hertz { stiffness: 500.0 })),
        impact(ContactLaw::KelvinVoigt(KelvinVoigt::new(300.0, 0.6, 1.2))),
        impact(ContactLaw::HuntCrossley(HuntCrossley::new(500.0, 0.6))),
        friction(ContactLaw::Tanh(Tanh {
            compliance: 0.1,
            limit: 0.8,
            ratio: 1.0,
            rate: 1.0,
        })),
        friction(ContactLaw::BoucWen(BoucWen {
            compliance: 0.01,
            limit: 0.8,
            exponent: 2.0,
            beta: 0.5,
        })),
        friction(ContactLaw::Dahl(Dahl {
            compliance: 0.01,
            limit: 0.8,
            exponent: 1.0,
        })),
        friction(ContactLaw::Lugre(Lugre {
            sigma0: 50.0,
            sigma1: 0.3,
            sigma2: 0.2,
            limit: 0.8,
            static_limit: 1.0,
            stribeck_velocity: 0.5,
        })),
        friction(ContactLaw::Pendulum(Pendulum {
            compliance: 0.01,
            limit: 0.8,
            restoring: 5.0,
            at_rest: [0.8, 1.0],
            rising: [1.0, 0.0],
        })),
        impact(ContactLaw::GapYield(GapYield {
            stiffness: 300.0,
            yield_force: 5.0,
            hardening: 0.1,
            damage: true,
        })),
        impact(ContactLaw::HyperbolicGap(HyperbolicGap {
            stiffness: 200.0,
            ultimate: 8.0,
            failure_ratio: 0.7,
            unloading: 300.0,
        })),
        impact(ContactLaw::ImpactYield(ImpactYield {
            stiffness: 300.0,
            hardening: 100.0,
            yield_overlap: 0.02,
        })),
        link(ContactLaw::Bilinear(Bilinear {
            stiffness: 200.0,
            yield_force: 2.0,
            hardening: 20.0,
        })),
        link(ContactLaw::Restrainer(Restrainer {
            slack: 0.05,
            stiffness: 300.0,
            yield_force: 5.0,
            hardening: 0.1,
        })),
        link(ContactLaw::Viscous(Viscous {
            viscosity: 1.5,
            exponent: 0.5,
        })),
        link(ContactLaw::Multilinear(table)),
    ]
}

/// r, rdot and S of all steps by the recursion of the modes, with this force at t = 0.
fn by_modes<S: Scheme>(scheme: S, structure: &Structure, force: f64) -> Vec<[f64; 3]> {
    let masses = structure.nodes.iter().map(|node| node.mass).collect();
    let mut b = DMatrix::zeros(structure.len(), 1);
    for (node, sign) in structure.column(0) {
        b[(node, 0)] = sign;
    }
    let m = DMatrix::from_diagonal(&DVector::from_vec(masses));
    let modal = Modal::new(&m, &full(&structure.stiffness), &b).unwrap();
    let shares = |of: &[f64]| modal.shares(0, &DVector::from_column_slice(of));
    let (x, v) = (shares(&structure.displacement), shares(&structure.velocity));
    let numbered = modal.modes(0).into_iter().enumerate();
    let modes = numbered.map(|(j, mode)| ModeStart {
        mode: [mode],
        displacement: Lane([x[j]]),
        velocity: Lane([v[j]]),
    });
    let start = Start {
        method: [scheme.into()],
        dt: Lane([DT]),
        gap: Lane([structure.contacts[0].gap]),
        force: Lane([force]),
    };
    let mut method = S::Lanes::<1, ManyModes>::new(&start, modes).unwrap();
    let structure_law = &structure.contacts[0].law;
    let contact_law = structure_law.law(structure_law.limit().map_or(0.0, |limit| limit.at(0.0)));
    let mut law = ContactLaw::running(&[contact_law], &method.flexibilities());
    let mut rows = Vec::new();
    for _ in 0..STEPS {
        let now = method.step(&mut law);
        rows.push([now.displacement, now.velocity, now.force].map(|x| x.0[0]));
    }
    rows
}

#[test]
fn both_forms_of_a_method_agree_to_round_off() {
    for description in METHODS {
        let defaults: Vec<f64> = description.parameters.iter().map(|p| p.default).collect();
        let method = (description.method)(&defaults).unwrap();
        let mut laws = relations();
        if method.has_impulses() {
            laws.push(StructureLaw::new(
                ClippedLine::Stop { restitution: 0.7 },
                None,
            ));
        }
        for law in laws {
            let structure = row(law.clone());
            let mut rows = Vec::new();
            books(&method, &structure, DT, STEPS, |_, state| {
                rows.push(contact_of(state, 0));
            });
            let force = rows[0][2];
            let modes =
                slipgap_system::each_method!(method, form => by_modes(form, &structure, force));
            // The rigid stop is hit in some steps only.
            let forces = rows.iter().filter(|row| row[2] != 0.0).count();
            assert!(forces > 2, "{} {law:?}: {forces}", description.name);
            for (step, (a, b)) in rows[1..].iter().zip(&modes).enumerate() {
                for (i, tolerance) in TOLERANCES.into_iter().enumerate() {
                    let error = (a[i] - b[i]).abs();
                    let name = description.name;
                    assert!(error < tolerance, "{name} {law:?} {step} {i}: {error:e}");
                }
            }
        }
    }
}
