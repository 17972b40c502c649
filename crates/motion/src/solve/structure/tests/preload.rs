//! The equilibrium under static loads, and the steps from it.

use super::at_rest::{LAWS, Random, law};
use super::*;
use crate::contact::{BoucWen, ClippedLine, ContactLaw};
use crate::solve::Unsolvable;
use crate::solve::structure::{Prepared, run, settle};

/// Two masses on springs, pushed by these static forces, with a contact between them.
fn pair(law: StructureLaw, forces: [f64; 2], springs: [f64; 2]) -> Structure {
    let mut structure = masses(&[2.0, 1.0]);
    for (node, k) in springs.into_iter().enumerate() {
        structure.stiffness.add_spring([None, Some(node)], k);
    }
    structure.contacts = vec![contact([Some(0), Some(1)], 0.0, law)];
    structure.loads = vec![Load {
        pattern: forces.into_iter().enumerate().collect(),
        signal: Arc::new(Signal::constant(1.0)),
    }];
    structure.preload.load = forces.to_vec();
    structure
}

/// The largest part of p - K u - B S over the largest force.
fn residual(structure: &Structure) -> f64 {
    let mut left: Vec<f64> = structure.preload.load.iter().map(|p| -p).collect();
    structure
        .stiffness
        .add_product(&structure.displacement, &mut left);
    for (c, force) in structure.preload.forces.iter().flatten().enumerate() {
        for (node, factor) in structure.column(c) {
            left[node] += factor * force;
        }
    }
    let largest = |all: &[f64]| all.iter().fold(0.0, |a, x| f64::max(a, x.abs()));
    largest(&left) / largest(&structure.preload.load)
}

/// The largest speed of the steps from rest.
fn largest_speed(structure: &Structure, dt: f64) -> f64 {
    let prepared = Prepared::new(structure, dt).unwrap();
    let mut largest = 0.0_f64;
    let [done] = run::<1>(&[structure], &prepared, 500, |_, state| {
        for node in 0..structure.len() {
            largest = largest.max(state.velocity(node).0[0].abs());
        }
    });
    done.unwrap();
    largest
}

#[test]
fn every_law_stays_in_its_equilibrium() {
    let random = &mut Random(7);
    for number in (0..LAWS).cycle().take(4 * LAWS) {
        let (mut law, gap) = law(number, random);
        if let Some(limit) = law.limit_mut() {
            limit.varying = None;
        }
        let forces = [random.between(5.0, 20.0), -random.between(1.0, 20.0)];
        let springs = [random.scale(1e2, 1e4), random.scale(1e2, 1e4)];
        let mut structure = pair(law, forces, springs);
        structure.contacts[0].gap = gap;
        settle(&mut structure).unwrap();
        let residual = residual(&structure);
        assert!(residual < 1e-12, "law {number}: {residual:e}");
        // Forces of 1e-12 of 20 on masses of 1 for 5 s.
        let speed = largest_speed(&structure, 0.01);
        assert!(speed < 1e-9, "law {number}: {speed:e}");
    }
}

#[test]
fn contacts_alone_hold_a_part() {
    // Two bearings in parallel share the force by their stiffness; a girder on them has no other spring.
    let mut structure = pair(displacement_control(3e4, 1e3), [0.0, 70.0], [2e4, 0.0]);
    let other = contact([None, Some(1)], 0.0, displacement_control(1e4, 1e3));
    structure.contacts.push(other);
    settle(&mut structure).unwrap();
    let [k0, k1, k2] = [2e4, 3e4, 1e4];
    let series = 1.0 / (1.0 / k0 + 1.0 / k1);
    let u = 70.0 / (series + k2);
    let expected = [series * u, k2 * u];
    for (force, expected) in structure.preload.forces.iter().flatten().zip(expected) {
        assert!((force / expected - 1.0).abs() < 1e-12, "{force}");
    }
    let moved = structure.displacement[1];
    assert!((moved / u - 1.0).abs() < 1e-12, "{moved} {u}");
    assert!(largest_speed(&structure, 0.01) < 1e-11);
}

#[test]
fn a_bearing_that_slides_leaves_the_rest_to_the_springs() {
    let mut structure = pair(displacement_control(1e5, 4.0), [0.0, 10.0], [100.0, 50.0]);
    settle(&mut structure).unwrap();
    let expected = [4.0 / 100.0, 6.0 / 50.0];
    for (u, expected) in structure.displacement.iter().zip(expected) {
        assert!((u / expected - 1.0).abs() < 1e-12, "{u}");
    }
}

#[test]
fn a_stop_carries_what_presses_it() {
    let stop = StructureLaw::new(ClippedLine::Stop { restitution: 0.5 }, None);
    let mut structure = pair(stop, [0.0, -12.0], [100.0, 0.0]);
    settle(&mut structure).unwrap();
    assert!((structure.preload.force(0).unwrap() + 12.0).abs() < 1e-12);
    assert!(
        structure
            .displacement
            .iter()
            .all(|u| (u + 0.12).abs() < 1e-13)
    );
}

#[test]
fn the_memory_of_a_curved_law_is_that_of_a_slow_push() {
    // dS/dr = k (1 - S/L): S = L (1 - exp(-k r/L)).
    let (k, limit, force) = (1e3, 10.0, 8.0);
    let law = BoucWen {
        compliance: 1.0 / k,
        limit,
        exponent: 1.0,
    };
    let law = StructureLaw::new(ContactLaw::BoucWen(law), Limit::constant(limit)).from_its_answer();
    let mut structure = pair(law, [0.0, force], [1e3, 0.0]);
    settle(&mut structure).unwrap();
    let r = structure.displacement[1] - structure.displacement[0];
    let expected = -limit / k * libm::log(1.0 - force / limit);
    // 50 parts of an implicit step.
    assert!((r / expected - 1.0).abs() < 0.02, "{r} {expected}");
}

#[test]
fn what_nothing_holds_is_named() {
    let mut structure = pair(displacement_control(1e5, 4.0), [0.0, 10.0], [100.0, 0.0]);
    let why = settle(&mut structure).unwrap_err();
    assert_eq!(
        why,
        Unsolvable::NoEquilibrium {
            node: "m1".to_owned()
        }
    );
}
