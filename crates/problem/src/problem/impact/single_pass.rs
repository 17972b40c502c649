//! The bars by the papers' element matrices, each step solved once. This is the second reading of [I], which compares the residual
//! with an external force, although there is none.

use super::scaled::Scaled;
use crate::lane::Lane;
use crate::metrics::impact::{Energy, Track};
use crate::solve::{self, Unsolvable};
use crate::system::System;
use nalgebra::DVector;

/// A run: the contact, the energy, and the relative velocity of the mass centres at the end over c.
pub struct Once {
    pub track: Track<1>,
    pub energy: Energy<1>,
    pub restitution: f64,
}

/// Runs all steps. A step solved once is not in equilibrium at its end, so that the energy is summed over the structure.
pub fn run(system: &System, scaled: &Scaled) -> Result<Once, Unsolvable> {
    let (track, energy, restitution) = record(system, scaled)?;
    Ok(Once {
        track,
        energy: Energy::of(&energy),
        restitution,
    })
}

/// The contact and the energy at the steps, and the relative velocity of the mass centres at the end.
fn record(system: &System, scaled: &Scaled) -> Result<(Track<1>, Vec<f64>, f64), Unsolvable> {
    let pair = scaled.pair;
    let first = pair.left.elements as usize + 1;
    let size = first + pair.right.map_or(0, |right| right.elements as usize + 1);
    let one = |from: usize, to: usize| {
        DVector::from_fn(size, |i, _| if (from..to).contains(&i) { 1.0 } else { 0.0 })
    };
    let (ones, masses) = match pair.right {
        Some(right) => (
            vec![one(0, first), one(first, size)],
            [pair.left.mass, right.mass],
        ),
        None => (vec![one(0, first)], [pair.left.mass, 0.0]),
    };
    let (mut track, mut energy) = (Track::default(), Vec::new());
    let mut centres = vec![0.0; ones.len()];
    solve::single_pass::run(system, |structure| {
        let [r, rdot, s] = structure.contact();
        track.displacement.push(Lane([r]));
        track.velocity.push(Lane([0.5 * rdot]));
        track.force.push(Lane([0.0 - s]));
        let (u, v) = structure.state();
        let assembly = structure.assembly();
        let momentum = &assembly.mass * v;
        for ((centre, one), mass) in centres.iter_mut().zip(&ones).zip(masses) {
            *centre = one.dot(&momentum) / mass;
        }
        // A wall is a body of infinite mass, so the common mass centre is at rest.
        let common = match pair.right {
            Some(_) => momentum.sum() / (masses[0] + masses[1]),
            None => 0.0,
        };
        let relative = v.add_scalar(-common);
        let kinetic = relative.dot(&(&assembly.mass * &relative));
        let strain = u.dot(&(&assembly.stiffness * u));
        let spring = scaled.spring * r.min(0.0) * r.min(0.0);
        energy.push(0.5 * (kinetic + strain + spring));
    })?;
    let restitution = 0.5 * (centres.get(1).copied().unwrap_or(0.0) - centres[0]);
    Ok((track, energy, restitution))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{ContactLaw, ImpactSpring};
    use crate::exact::wave::Bars;
    use crate::methods::AverageAcceleration;
    use crate::problem::impact::case::system;
    use crate::problem::impact::scaled::CLOSING;
    use crate::system::BarPair;
    use crate::system::bar::{Bar, Mass};

    /// Impedances z : 1, travel times 1 : theta; a wall for z = 0.
    fn scaled(z: f64, theta: f64, gap: f64) -> Scaled {
        let mass = 0.25 * (1.0 + z);
        let bar = |elements, mass, travel_time| Bar {
            elements,
            mass,
            travel_time,
            kind: Mass::Lumped,
        };
        Scaled {
            pair: BarPair {
                left: bar(4, mass, 1.0),
                right: (z > 0.0).then(|| bar(3, mass * theta / z, theta)),
                velocity: CLOSING,
            },
            bars: Bars {
                impedance_ratio: z,
                time_ratio: theta,
                gap,
            },
            spring: 4.0 * (1.0 + z),
            law: ContactLaw::ImpactSpring(ImpactSpring {
                stiffness: 4.0 * (1.0 + z),
            }),
            method: AverageAcceleration.into(),
            length_ratio: theta,
        }
    }

    #[test]
    fn energy_is_that_of_the_common_mass_centre() {
        for (z, theta) in [(1.0, 1.0), (3.0, 2.0), (0.4, 1.7), (2.0, 0.5), (0.0, 1.0)] {
            let case = scaled(z, theta, 0.31);
            // Velocities in c/2: the bars close at 2, with their reduced mass; the mass of a wall is infinite.
            let left = case.pair.left.mass;
            let reduced = case
                .pair
                .right
                .map_or(left, |right| left * right.mass / (left + right.mass));
            let start = 0.5 * reduced * 2.0 * 2.0;
            // The error of a step solved once, at changes of the contact, falls with the time step.
            let difference = |dt: f64, last: u64| {
                let system = system(&case, dt, last);
                let energies = record(&system, &case).unwrap().1;
                let once: Vec<f64> = energies.iter().map(|e| e / start - 1.0).collect();
                let mut converged = Vec::new();
                solve::visit(&system, |_, stepper| {
                    let modes = (0..).zip(stepper.modes());
                    let energy = |(j, [x, v]): (usize, [f64; 2])| case.pair.mode(j).energy(x, v);
                    let contact = stepper.contact();
                    let spring = 0.5 * contact.displacement.0[0] * contact.force.0[0];
                    converged.push((modes.map(energy).sum::<f64>() + spring) / start - 1.0);
                });
                // In flight, until 0.155 T_I, the energy is constant.
                let flight = (0.15 / dt) as usize;
                let worst = once[..flight].iter().fold(0.0, |w: f64, e| w.max(e.abs()));
                // Velocities are differences of displacements over dt/2.
                assert!(worst < 16.0 * f64::EPSILON / dt, "{z} {theta}: {worst:e}");
                let both = once.iter().zip(&converged).map(|(a, b)| (a - b).abs());
                both.fold(0.0, f64::max)
            };
            let [coarse, fine] =
                [(0.004, 500), (0.001, 2000)].map(|(dt, last)| difference(dt, last));
            assert!(
                fine < 0.004 && fine < 0.7 * coarse,
                "{z} {theta}: {coarse} {fine}"
            );
        }
    }
}
