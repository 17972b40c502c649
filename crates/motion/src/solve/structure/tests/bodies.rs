//! Motions that the two problems of one contact also have.

use super::*;
use crate::contact::{self, ClippedLine, ContactLaw};
use crate::methods::{AverageAcceleration, Method};
use crate::solve::structure::{Prepared, run};
use crate::solve::{ContactTrack, run as run_modes};
use crate::system::bar::{Bar, Mass};
use crate::system::{BarPair, Linear, Mode, System};
use crate::textbook::assemble;

/// r, rdot and S of the first contact at all steps.
fn track(structure: &Structure, dt: f64, steps: usize) -> Vec<[f64; 3]> {
    let prepared = Prepared::new(structure, dt).unwrap();
    let mut track = Vec::new();
    let [done] = run::<1>(&[structure], &prepared, steps, |_, state| {
        let now = state.contact(0);
        track.push([now.displacement, now.velocity, now.force].map(|x| x.0[0]));
    });
    done.unwrap();
    track
}

/// Largest difference of both tracks in each channel, over the largest value of the channel.
fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> [f64; 3] {
    assert_eq!(a.len(), b.len());
    std::array::from_fn(|k| {
        let largest = |of: &mut dyn Iterator<Item = f64>| of.fold(0.0, |a: f64, b| a.max(b.abs()));
        let size = largest(&mut b.iter().map(|b| b[k]));
        largest(&mut a.iter().zip(b).map(|(a, b)| a[k] - b[k])) / size
    })
}

#[test]
fn a_mass_with_friction_moves_like_the_oscillator() {
    let [k, c] = [50.0, 20.0];
    for (relation, law) in [
        (
            displacement_control(k, 1.0),
            ContactLaw::DisplacementControl(contact::DisplacementControl {
                compliance: 1.0 / k,
                limit: 1.0,
            }),
        ),
        (
            velocity_control(c, 1.0),
            ContactLaw::VelocityControl(contact::VelocityControl {
                compliance: 1.0 / c,
                limit: 1.0,
            }),
        ),
    ] {
        for (dt, last) in [(0.02, 3000), (1e-4, 200_000)] {
            let mut structure = masses(&[1.0]);
            structure.stiffness.add(0, 0, 1.0);
            structure.displacement[0] = 12.0;
            structure.contacts = vec![contact([None, Some(0)], 0.0, relation.clone())];
            let system = System {
                linear: Linear::Oscillator {
                    mode: Mode::new(1.0, 1.0),
                    displacement: 12.0,
                },
                law,
                gap: 0.0,
                force: 0.0,
                step: dt,
                last,
                method: Method::AverageAcceleration(AverageAcceleration),
            };
            let expected = run_modes::<ContactTrack>(&system).unwrap().track.0;
            let difference = difference(&track(&structure, dt, last as usize), &expected);
            // Sums of `last` steps on both sides.
            assert!(difference.iter().all(|d| *d < 1e-10), "{dt} {difference:?}");
        }
    }
}

#[test]
fn bars_move_like_the_modes_of_the_bars() {
    for (gamma, n, other) in [(0.25, 10, 10), (4.0, 10, 10), (1.0, 7, 16), (1e6, 10, 10)] {
        let bar = |elements: u32, travel_time: f64| Bar {
            elements,
            mass: 0.5,
            travel_time,
            kind: Mass::Lumped,
        };
        let right = if other == n {
            bar(n, 1.0)
        } else {
            bar(other, 1.7)
        };
        let pair = BarPair {
            left: bar(n, 1.0),
            right: Some(right),
            velocity: -2.0,
        };
        let (dt, last, gap, stiffness) = (0.005, 600, 0.1, 2.0 * gamma * f64::from(n));
        let system = System {
            linear: Linear::Bars(pair),
            law: ContactLaw::ImpactSpring(contact::ImpactSpring { stiffness }),
            gap,
            force: 0.0,
            step: dt,
            last,
            method: Method::AverageAcceleration(AverageAcceleration),
        };
        let (assembly, _, v) = assemble(&system.linear, gap);
        let mass: Vec<f64> = assembly.mass.diagonal().iter().copied().collect();
        let mut structure = masses(&mass);
        for i in 0..mass.len() {
            structure.velocity[i] = v[i];
            for j in 0..=i {
                let value = assembly.stiffness[(i, j)];
                if value != 0.0 {
                    structure.stiffness.add(i, j, value);
                }
            }
        }
        let law = StructureLaw::new(ClippedLine::Spring { stiffness }, None);
        structure.contacts = vec![contact(assembly.nodes, gap, law)];
        let expected = run_modes::<ContactTrack>(&system).unwrap().track.0;
        let difference = difference(&track(&structure, dt, last as usize), &expected);
        // With a spring much stiffer than the elements, r of the closed contact is round-off of u, and so are the instants at which
        // it opens and closes again.
        let tolerance = if gamma > 1e3 { 1e-7 } else { 1e-12 };
        assert!(
            difference.iter().all(|d| *d < tolerance),
            "{gamma} {difference:?}"
        );
    }
}
