//! Contacts of parts that nothing connects: each part moves as it does alone.

use super::*;
use crate::contact::{BoucWen, ClippedLine, ContactLaw, Hertz};
use crate::solve::structure::sizes_of_blocks;
use crate::system::structure::PlaneRow;

/// Parts with two contacts each, so that there are blocks.
const PARTS: usize = 40;
const DT: f64 = 0.005;
const STEPS: usize = 400;

/// Two masses that meet each other, of which one slides on the ground or meets a wall; parts differ in their stiffness and start.
fn part(number: usize, laws: &[StructureLaw; 2]) -> Structure {
    let x = number as f64;
    let mut part = masses(&[1.0, 1.5]);
    part.stiffness.add_spring([None, Some(0)], 30.0 + x);
    part.stiffness.add_spring([None, Some(1)], 50.0 - 0.5 * x);
    part.damping.add_spring([None, Some(1)], 0.2);
    part.velocity = vec![1.0 + 0.1 * x, -0.8 + 0.02 * x];
    part.displacement = vec![0.01 * x, 0.0];
    part.contacts = vec![
        contact([Some(0), Some(1)], 0.02, laws[0].clone()),
        contact([None, Some(1)], 0.0, laws[1].clone()),
    ];
    part
}

/// All parts as one structure: their first nodes, then their second ones; the contacts in the opposite order.
fn together(parts: &[Structure]) -> Structure {
    let count = parts.len();
    let mass = |i: usize| parts[i % count].nodes[i / count].mass;
    let mut joined = masses(&(0..2 * count).map(mass).collect::<Vec<_>>());
    for (p, part) in parts.iter().enumerate() {
        let joined_node = |node: usize| node * count + p;
        for ((i, j), k) in part.stiffness.entries() {
            joined.stiffness.add(joined_node(i), joined_node(j), k);
        }
        for ((i, j), c) in part.damping.entries() {
            joined.damping.add(joined_node(i), joined_node(j), c);
        }
        for node in 0..2 {
            joined.displacement[joined_node(node)] = part.displacement[node];
            joined.velocity[joined_node(node)] = part.velocity[node];
        }
    }
    for c in [1, 0] {
        for (p, part) in parts.iter().enumerate().rev() {
            let mut contact = part.contacts[c].clone();
            contact
                .along
                .iter_mut()
                .for_each(|(node, _)| *node = *node * count + p);
            joined.contacts.push(contact);
        }
    }
    joined
}

/// u and S of both nodes and contacts of part `p` at the steps.
fn motion(structure: &Structure, method: &Method, places: [[usize; 2]; 2]) -> Vec<[f64; 4]> {
    let [nodes, contacts] = places;
    let prepared = Prepared::by(method, structure, DT).unwrap();
    let mut states = Vec::new();
    let done = run::<1>(&[structure], &prepared, STEPS, |_, state| {
        let u = nodes.map(|node| state.displacement(node).0[0]);
        let s = contacts.map(|contact| state.contact(contact).force.0[0]);
        states.push([u[0], u[1], s[0], s[1]]);
    });
    assert!(done.iter().all(Result::is_ok), "{done:?}");
    states
}

fn laws() -> [[StructureLaw; 2]; 3] {
    let spring = || StructureLaw::new(ClippedLine::Spring { stiffness: 2e3 }, None);
    let hertz = ContactLaw::Hertz(Hertz { stiffness: 5e3 });
    let bouc_wen = ContactLaw::BoucWen(BoucWen {
        compliance: 1e-3,
        limit: 0.5,
        exponent: 2.0,
        beta: 0.5,
    });
    let friction = StructureLaw::new(bouc_wen, Limit::constant(0.5)).from_its_answer();
    [
        [spring(), displacement_control(300.0, 0.4)],
        [spring(), spring()],
        [StructureLaw::new(hertz, None).from_its_answer(), friction],
    ]
}

#[test]
fn parts_that_nothing_connects_move_as_alone() {
    let average = (
        "average-acceleration",
        Method::AverageAcceleration(AverageAcceleration),
    );
    for (name, method) in [average].into_iter().chain(methods()) {
        for laws in laws() {
            let parts: Vec<Structure> = (0..PARTS).map(|p| part(p, &laws)).collect();
            let joined = together(&parts);
            assert_eq!(sizes_of_blocks(&joined), vec![2; PARTS]);
            for p in [0, 17] {
                let alone = motion(&parts[p], &method, [[0, 1], [0, 1]]);
                let places = [[p, PARTS + p], [2 * PARTS - 1 - p, PARTS - 1 - p]];
                let found = motion(&joined, &method, places);
                assert!(
                    alone.iter().any(|state| state[2] != 0.0),
                    "{name}: no impact"
                );
                for (step, (alone, found)) in alone.iter().zip(&found).enumerate() {
                    for (a, b) in alone.iter().zip(found) {
                        // The order of elimination differs; a curved law ends its search at round-off.
                        assert!(
                            (a - b).abs() < 1e-9 * (1.0 + a.abs()),
                            "{name} {p} {step}: {a} {b}"
                        );
                    }
                }
            }
        }
    }
}

/// Both directions of a contact in a plane are together, though no spring connects them.
#[test]
fn both_directions_of_a_plane_are_in_one_block() {
    let coulomb = || StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
    let mut plane = masses(&[1.0; 128]);
    for i in 0..64 {
        let [first, second] = coulomb().in_plane().expect("a law in a plane");
        plane.contacts.push(contact([None, Some(i)], 0.0, first));
        plane
            .contacts
            .push(contact([None, Some(64 + i)], 0.0, second));
    }
    assert_eq!(plane.contacts[0].law.row(), Some(PlaneRow::First));
    assert_eq!(sizes_of_blocks(&plane), vec![2; 64]);
    let prepared = Prepared::by(
        &Method::AverageAcceleration(AverageAcceleration),
        &plane,
        DT,
    );
    let blocks = prepared.unwrap().flexibility.blocks;
    assert!(blocks.iter().all(|block| block.contacts.len() == 2));
}
