//! The equilibrium under static loads, and the steps from it.

use super::at_rest::{LAWS, Random, law};
use super::*;
use crate::contact::{
    Bilinear, BoucWen, ClippedLine, ContactLaw, Hertz, HertzDamp, HuntCrossley, Ye,
};
use crate::methods::{Method, MoreauJean};
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
    let largest = |values: &[f64]| values.iter().fold(0.0, |a, x| f64::max(a, x.abs()));
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
    let bouc_wen = BoucWen {
        compliance: 1.0 / k,
        limit,
        exponent: 1.0,
        beta: 0.5,
    };
    let law =
        StructureLaw::new(ContactLaw::BoucWen(bouc_wen), Limit::constant(limit)).from_its_answer();
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

/// Bodies on each other on the ground under their weight, with this law between them.
fn stack(masses_of: &[f64], gap: f64, law: &StructureLaw) -> Structure {
    let mut structure = masses(masses_of);
    structure.contacts = (0..masses_of.len())
        .map(|i| contact([i.checked_sub(1), Some(i)], gap, law.clone()))
        .collect();
    let weights = masses_of.iter().map(|m| -9.81 * m);
    structure.loads = vec![Load {
        pattern: weights.clone().enumerate().collect(),
        signal: Arc::new(Signal::constant(1.0)),
    }];
    structure.preload.load = weights.collect();
    structure
}

#[test]
fn contacts_carry_the_weight_above_them() {
    let stop = StructureLaw::new(ClippedLine::Stop { restitution: 0.0 }, None);
    let hertz = StructureLaw::new(ContactLaw::Hertz(Hertz { stiffness: 1e6 }), None);
    let damped = [
        ContactLaw::HertzDamp(HertzDamp::new(1e6, 0.5)),
        ContactLaw::HuntCrossley(HuntCrossley::new(1e6, 0.5)),
        ContactLaw::Ye(Ye::new(1e6, 0.5)),
    ]
    .map(|law| StructureLaw::new(law, None));
    for law in [stop, hertz].into_iter().chain(damped) {
        for (bodies, ratio) in [2, 3, 8, 14, 50]
            .into_iter()
            .flat_map(|n| [1.0, 45.0, 1e3, 1e6].map(|ratio| (n, ratio)))
        {
            for order in 0..3 {
                let part = |i: usize| match order {
                    0 => i as f64 / (bodies - 1) as f64,
                    1 => 1.0 - i as f64 / (bodies - 1) as f64,
                    _ => (i % 2) as f64,
                };
                let body_masses: Vec<f64> =
                    (0..bodies).map(|i| libm::pow(ratio, part(i))).collect();
                for gap in [0.0, 1e-3, 0.5] {
                    let mut structure = stack(&body_masses, gap, &law);
                    settle(&mut structure).unwrap();
                    for (i, force) in structure.preload.forces.iter().flatten().enumerate() {
                        let above = 9.81 * body_masses[i..].iter().sum::<f64>();
                        let part = -force / above - 1.0;
                        assert!(
                            part.abs() < 1e-9,
                            "{bodies} {ratio} {order} {gap}: {part:e}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn bodies_at_rest_on_stops_stay() {
    // Round-off of r opens no contact: each step would let a body fall, and the next one stop it.
    let stop = StructureLaw::new(ClippedLine::Stop { restitution: 0.0 }, None);
    for gap in [0.0, 0.01, 0.3] {
        for ratio in [0.5, 1.0, 3.0, 5.0] {
            let mut structure = stack(&[1.0, ratio, 1.0], gap, &stop);
            settle(&mut structure).unwrap();
            for dt in [0.01, 1e-4] {
                // Round-off of the weights; a body that falls for a step would have 9.81 dt.
                let speed = largest_speed(&structure, dt);
                assert!(speed < 1e-14 * 9.81, "{gap} {ratio} {dt}: {speed:e}");
            }
        }
    }
}

#[test]
fn laws_that_fall_carry_what_is_below_their_limit() {
    // Two storeys on springs that soften: the load is 1 % of what they yield at.
    let bilinear = Bilinear {
        stiffness: 2e4,
        hardening: -1e3,
        yield_force: 400.0,
    };
    let law = StructureLaw::new(ContactLaw::Bilinear(bilinear), None);
    let mut structure = stack(&[100.0, 100.0], 0.0, &law);
    structure.preload.load = vec![0.0, 4.0];
    settle(&mut structure).unwrap();
    for (u, expected) in structure.displacement.iter().zip([2e-4, 4e-4]) {
        assert!((u / expected - 1.0).abs() < 1e-11, "{u}");
    }
    // Above the limit, the reason is the law.
    structure = stack(&[100.0, 100.0], 0.0, &law);
    structure.preload.load = vec![0.0, 500.0];
    let why = settle(&mut structure).unwrap_err().to_string();
    assert!(why.contains("contact 'contact' falls"), "{why}");
}

#[test]
fn a_deck_on_two_sliders_that_may_lift_off_stays() {
    // The last node is a rotation of the deck, whose contacts have an arm of 4.
    let stop = StructureLaw::new(ClippedLine::Stop { restitution: 0.0 }, None);
    for deck in [1.0, 10.0, 40.0, 100.0, 400.0, 800.0] {
        let mut structure = stack(&[1.0, 1.0, deck, deck * 100.0 / 12.0], 0.0, &stop);
        let along = [
            vec![(0, 1.0)],
            vec![(1, 1.0)],
            vec![(0, -1.0), (2, 1.0), (3, -4.0)],
            vec![(1, -1.0), (2, 1.0), (3, 4.0)],
        ];
        for (contact, along) in structure.contacts.iter_mut().zip(along) {
            contact.along = along;
        }
        structure.preload.load[3] = 0.0;
        structure.loads[0].pattern.pop();
        settle(&mut structure).unwrap();
        let method = Method::MoreauJean(MoreauJean { theta: 0.5 });
        let prepared = Prepared::by(&method, &structure, 1e-3).unwrap();
        let mut largest = 0.0_f64;
        let [done] = run::<1>(&[&structure], &prepared, 10_000, |_, state| {
            for node in 0..structure.len() {
                largest = largest.max(state.velocity(node).0[0].abs());
            }
        });
        done.unwrap();
        assert!(largest < 1e-12 * 9.81e-3, "{deck}: {largest:e}");
    }
}
