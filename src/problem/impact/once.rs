//! The bars by the papers' element matrices, each step solved once: the other reading of [I], where the residual was
//! held against an external force that is zero.

use super::scaled::Scaled;
use crate::lane::Lane;
use crate::metrics::impact::Track;
use crate::textbook::element::ImpactElement;
use crate::textbook::{Iteration, Newmark, bars::assemble};
use nalgebra::DVector;

/// Most elements of both bars, whose matrices are full here.
const MOST_ELEMENTS: u32 = 400;

/// Runs `last` steps; the error says why not.
pub fn run(scaled: &Scaled, dt: f64, last: u64) -> Result<Track<1>, String> {
    let elements: u32 = scaled.each().map(|bar| bar.elements).sum();
    if elements > MOST_ELEMENTS {
        return Err(format!(
            "without iteration there may be at most {MOST_ELEMENTS} elements, got {elements}"
        ));
    }
    let assembly = assemble(scaled.left, scaled.right, scaled.bars.gap);
    let first = scaled.left.elements as usize + 1;
    let size = assembly.mass.nrows();
    // Velocities in c/2, in the frame of their mean; of the wall for a wall.
    let [left, right] = match scaled.right {
        Some(_) => [1.0, -1.0],
        None => [2.0, 0.0],
    };
    let v = DVector::from_fn(size, |i, _| if i < first { left } else { right });
    let (mass, stiffness) = (assembly.mass.clone(), assembly.stiffness.clone());
    let element = ImpactElement::new(scaled.spring);
    let mut newmark = Newmark::new(assembly, element, dt, DVector::zeros(size), v)
        .ok_or("the mass matrix has no inverse")?;
    let one = |from: usize, to: usize| {
        DVector::from_fn(size, |i, _| if (from..to).contains(&i) { 1.0 } else { 0.0 })
    };
    let (ones, masses) = match scaled.right {
        Some(_) => (
            vec![one(0, first), one(first, size)],
            [scaled.left.mass, scaled.right.map_or(0.0, |bar| bar.mass)],
        ),
        None => (vec![one(0, first)], [scaled.left.mass, 0.0]),
    };
    let mut track = Track::default();
    let mut centres = vec![0.0; ones.len()];
    for i in 0..=last {
        if i > 0 {
            newmark
                .step(Iteration::Once)
                .map_err(|cycle| format!("step {} has no solution", cycle.step))?;
        }
        let [r, rdot, s] = newmark.contact();
        track.displacement.push(Lane([r]));
        track.velocity.push(Lane([0.5 * rdot]));
        track.force.push(Lane([0.0 - s]));
        let (u, v) = newmark.state();
        let momentum = &mass * v;
        for ((centre, one), mass) in centres.iter_mut().zip(&ones).zip(masses) {
            *centre = one.dot(&momentum) / mass;
        }
        // A wall is a body of infinite mass, and the common centre stays with it.
        let common = match scaled.right {
            Some(_) => momentum.sum() / (masses[0] + masses[1]),
            None => 0.0,
        };
        let relative = v.add_scalar(-common);
        let kinetic = relative.dot(&(&mass * &relative));
        let strain = u.dot(&(&stiffness * u));
        let spring = scaled.spring * r.min(0.0) * r.min(0.0);
        track.energy.push(Lane([0.5 * (kinetic + strain + spring)]));
    }
    let restitution = 0.5 * (centres.get(1).copied().unwrap_or(0.0) - centres[0]);
    track.restitution = Lane([restitution]);
    Ok(track)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::wave::Bars;
    use crate::problem::impact::run;
    use crate::structure::bar::{Bar, Mass};

    /// Impedances z : 1, trips 1 : theta; a wall for z = 0.
    fn scaled(z: f64, theta: f64, gap: f64) -> Scaled {
        let mass = 0.25 * (1.0 + z);
        let bar = |elements, mass, trip| Bar {
            elements,
            mass,
            trip,
            kind: Mass::Lumped,
        };
        Scaled {
            left: bar(4, mass, 1.0),
            right: (z > 0.0).then(|| bar(3, mass * theta / z, theta)),
            bars: Bars {
                impedance_ratio: z,
                time_ratio: theta,
                gap,
            },
            spring: 4.0 * (1.0 + z),
            length_ratio: theta,
        }
    }

    #[test]
    fn energy_is_that_of_the_common_mass_centre() {
        for (z, theta) in [(1.0, 1.0), (3.0, 2.0), (0.4, 1.7), (2.0, 0.5), (0.0, 1.0)] {
            let case = scaled(z, theta, 0.31);
            // Velocities in c/2: the bars close at 2, with their reduced mass; a wall's is infinite.
            let left = case.left.mass;
            let reduced = case
                .right
                .map_or(left, |right| left * right.mass / (left + right.mass));
            let start = 0.5 * reduced * 2.0 * 2.0;
            let energy = |track: &Track<1>| -> Vec<f64> {
                let over = track.energy.iter().map(|e| e.0[0] / start - 1.0);
                over.collect()
            };
            // A step solved once misjudges the contact where it changes, by the less the shorter the step is. The converged
            // one's energy is from the work of the contact.
            let apart = |dt: f64, last: u64| {
                let once = energy(&super::run(&case, dt, last).unwrap());
                let converged = energy(&run::run(&case, dt, last));
                // In flight, to 0.155 T_I, nothing changes.
                let flight = (0.15 / dt) as usize;
                let worst = once[..flight].iter().fold(0.0, |w: f64, e| w.max(e.abs()));
                // Velocities are differences of displacements over dt/2.
                assert!(worst < 16.0 * f64::EPSILON / dt, "{z} {theta}: {worst:e}");
                let both = once.iter().zip(&converged).map(|(a, b)| (a - b).abs());
                both.fold(0.0, f64::max)
            };
            let [coarse, fine] = [(0.004, 500), (0.001, 2000)].map(|(dt, last)| apart(dt, last));
            assert!(
                fine < 0.004 && fine < 0.7 * coarse,
                "{z} {theta}: {coarse} {fine}"
            );
        }
    }
}
