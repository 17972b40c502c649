//! A link: neither an impact nor friction.

use super::*;
use crate::contact::{ContactKind, ContactLaw, Viscous};
use crate::methods::{AverageAcceleration, Bathe, Coefficients, Method};
use crate::solve::structure::{Books, Prepared, Watch, run};

const VISCOSITY: f64 = 0.7;

/// Two masses on springs, which a dashpot connects: as a contact, or in C.
fn decks(as_contact: bool) -> Structure {
    let mut structure = masses(&[1.0, 2.5]);
    structure.stiffness.add_spring([None, Some(0)], 3.0);
    structure.stiffness.add_spring([None, Some(1)], 20.0);
    structure.displacement = vec![0.4, -0.2];
    structure.velocity = vec![1.0, -2.0];
    match as_contact {
        false => structure.damping.add_spring([Some(0), Some(1)], VISCOSITY),
        true => {
            let damper = Viscous {
                viscosity: VISCOSITY,
                exponent: 1.0,
            };
            let law = StructureLaw::new(ContactLaw::Viscous(damper), None);
            assert_eq!(
                (law.kind(), law.limit().is_none()),
                (ContactKind::Link, true)
            );
            structure.contacts = vec![contact([Some(0), Some(1)], 0.3, law)];
        }
    }
    structure
}

/// u and v of both nodes after each step, the forces of the contact, its work, and the energy error.
fn motion(structure: &Structure, method: &Method) -> (Vec<[f64; 4]>, Vec<f64>, f64, f64) {
    let prepared = Prepared::by(method, structure, 0.01).unwrap();
    let (mut rows, mut forces) = (Vec::new(), Vec::new());
    let mut books: Option<Books<1>> = None;
    let mut watch: Option<Watch<1>> = None;
    let [done] = run::<1>(&[structure], &prepared, 2000, |_, state| {
        let node = |node: usize| [state.displacement(node), state.velocity(node)].map(|x| x.0[0]);
        let ([u0, v0], [u1, v1]) = (node(0), node(1));
        rows.push([u0, v0, u1, v1]);
        if state.contacts() > 0 {
            let now = state.contact(0);
            assert_eq!(now.limit.0[0], 0.0);
            forces.push(now.force.0[0]);
        }
        match (&mut books, &mut watch) {
            (Some(books), Some(watch)) => {
                books.add(state);
                watch.add(state);
            }
            _ => {
                books = Some(Books::new(state));
                watch = Some(Watch::new(&[structure], state, 1));
            }
        }
    });
    done.unwrap();
    let (books, watch) = (books.unwrap(), watch.unwrap().of_lane(0));
    let work = watch.contacts.first();
    // A dashpot never gives energy, and stores none.
    assert!(work.is_none_or(|contact| contact.work >= 0.0));
    assert_eq!(watch.stored, 0.0);
    let work = work.map_or(0.0, |_| books.work(0).0[0]);
    (rows, forces, work, books.energy_error().0[0])
}

#[test]
fn a_dashpot_as_a_contact_moves_the_masses_like_a_dashpot_of_the_structure() {
    for method in [
        Method::AverageAcceleration(AverageAcceleration),
        Method::Family(Coefficients::hht(-0.1)),
        Method::Bathe(Bathe),
    ] {
        let (expected, _, _, _) = motion(&decks(false), &method);
        let (rows, forces, work, error) = motion(&decks(true), &method);
        for (row, expected) in rows.iter().zip(&expected) {
            for (x, expected) in row.iter().zip(expected) {
                // Round-off of 2000 steps of a motion of 2.
                assert!(
                    (x - expected).abs() < 1e-11,
                    "{method:?} {row:?} {expected:?}"
                );
            }
        }
        assert!(error < 1e-12, "{error}");
        // It pulls and pushes.
        assert!(forces.iter().any(|s| *s > 0.1) && forces.iter().any(|s| *s < -0.1));
        let energy = |row: &[f64; 4]| {
            let [u0, v0, u1, v1] = row;
            0.5 * (v0 * v0 + 2.5 * v1 * v1 + 3.0 * u0 * u0 + 20.0 * u1 * u1)
        };
        let lost = energy(&rows[0]) - energy(&rows[rows.len() - 1]);
        assert!(lost > 1.0, "{lost}");
        if method == Method::AverageAcceleration(AverageAcceleration) {
            assert!((work - lost).abs() < 1e-11 * lost, "{work} {lost}");
        }
    }
}
