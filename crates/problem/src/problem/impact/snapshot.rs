//! Velocity and stress along the bars at given times, computed and exact.

use super::scaled::Scaled;
use crate::exact::wave::Wave;
use crate::problem::{Lines, Snapshot};
use crate::solve;
pub use crate::solve::visited::State;
use crate::system::System;
use crate::system::bar::{Bar, Mass};
use crate::system::massless::MasslessMode;

/// Most elements of a bar that are drawn; of more elements, only every second, third, ... is drawn.
const DRAWN: u32 = 1000;

/// The profiles at the steps nearest to `times`, in the order of the times.
///
/// The abscissa is in lengths of the left bar, with the contact at 0; velocity is (v - mean of the two V0)/(c/2); stress is force
/// over F0, tension positive; displacement is over c T_I/2,
/// positive to the right, in the frame of the mean of the two V0, or of the wall.
pub fn snapshots(system: &System, scaled: &Scaled, times: &[f64]) -> Vec<Snapshot> {
    let steps: Vec<u64> = times
        .iter()
        .map(|t| ((t / system.step).round() as u64).min(system.last))
        .collect();
    let furthest = steps.iter().copied().max().unwrap_or(0);
    let wave = scaled.bars.solve(furthest as f64 * system.step);
    let mut snapshots: Vec<Option<Snapshot>> = vec![None; times.len()];
    solve::visit(
        &System {
            last: furthest,
            ..*system
        },
        |step, stepper| {
            for (slot, _) in snapshots
                .iter_mut()
                .zip(&steps)
                .filter(|(_, s)| **s == step)
            {
                let modes = stepper.modes();
                let time = step as f64 * system.step;
                let separate = scaled.pair.separate(time, &modes);
                let force = contact_force(system, stepper);
                *slot = Some(snapshot(scaled, &wave, time, &separate, force));
            }
        },
    );
    snapshots.into_iter().flatten().collect()
}

/// The force of the contact on an end, and its rate; only ends without mass need it.
fn contact_force(system: &System, stepper: &dyn State) -> [f64; 2] {
    let compliance = system.linear.contact_compliance();
    if compliance == 0.0 {
        return [0.0; 2];
    }
    let state = stepper.contact();
    let modes = [state.displacement, state.velocity, state.force].map(|lane| lane.0[0]);
    let [_, rate, s] = system.at_contact(modes);
    // The elements without mass have the part of the motion that the contact does not have.
    [-s, (rate - modes[1]) / compliance]
}

fn snapshot(
    scaled: &Scaled,
    wave: &Wave,
    time: f64,
    modes: &[[f64; 2]],
    force: [f64; 2],
) -> Snapshot {
    let mut velocity = Lines::default();
    let mut stress = Lines::default();
    let mut displacement = Lines::default();
    let mut fronts = Vec::new();
    let mut modes = modes;
    // The motion at a wall is in the frame of the wall; the mean of the two V0 is half of the velocity of the bar.
    let frame = if scaled.pair.right.is_some() {
        0.0
    } else {
        1.0
    };
    for (i, bar) in scaled.pair.each().enumerate() {
        let (of_bar, rest) = modes.split_at(bar.mode_count() as usize);
        modes = rest;
        let (sign, length) = [(-1.0, 1.0), (1.0, scaled.length_ratio)][i];
        let field = Field::new(&bar, of_bar, force);
        let n = bar.elements;
        let stride = n.div_ceil(DRAWN);
        let position = |s: f64| sign * length * s / f64::from(n);
        let nodes = (0..=n).step_by(stride as usize);
        // Scaled coordinates are positive if they open the gap, so the left bar has the opposite sign.
        velocity.computed.push(
            nodes
                .map(|k| [position(f64::from(k)), sign * field.at(k)[1] - frame])
                .collect(),
        );
        let nodes = (0..=n).step_by(stride as usize);
        displacement.computed.push(
            nodes
                .map(|k| [position(f64::from(k)), sign * field.at(k)[0]])
                .collect(),
        );
        let elements = (0..n).step_by(stride as usize);
        stress.computed.push(
            elements
                .map(|k| {
                    let stretch = field.at(k + 1)[0] - field.at(k)[0];
                    [
                        position(f64::from(k) + 0.5),
                        bar.element_stiffness() * stretch,
                    ]
                })
                .collect(),
        );
        let exact = wave.profile(i, time);
        let line = |of: &dyn Fn(&[f64; 3]) -> f64| -> Vec<[f64; 2]> {
            exact
                .iter()
                .map(|corner| [sign * length * corner[0], of(corner)])
                .collect()
        };
        velocity.exact.push(line(&|c| 2.0 * c[1] - frame));
        stress.exact.push(line(&|c| c[2]));
        let moved = wave.displacement(i, time, &exact).into_iter();
        displacement
            .exact
            .push(moved.map(|[s, u]| [sign * length * s, u]).collect());
        let places = wave.fronts(i, time).into_iter();
        fronts.extend(places.map(|s| sign * length * s));
    }
    Snapshot {
        time,
        profiles: vec![velocity, stress],
        displacement,
        fronts,
    }
}

/// Displacements and velocities at the nodes from those of the modes.
struct Field<'a> {
    modes: &'a [[f64; 2]],
    shapes: Shapes,
    /// Displacement and velocity of the contact node relative to its neighbour due to the contact force, if it has no mass.
    end: [f64; 2],
}

/// What the shapes of the modes are computed from.
enum Shapes {
    /// cos(k pi/n), k = 0..2n, which contain the shape of every mode at every node.
    Cosines(Vec<f64>),
    /// The modes of a bar whose contact node has no mass.
    Massless(Vec<MasslessMode>),
}

impl<'a> Field<'a> {
    fn new(bar: &Bar, modes: &'a [[f64; 2]], force: [f64; 2]) -> Field<'a> {
        let n = bar.elements;
        let shapes = match bar.kind {
            Mass::Lumped | Mass::Consistent => {
                Shapes::Cosines((0..2 * n).map(|k| bar.shape(1, k)).collect())
            }
            Mass::MasslessContact => {
                Shapes::Massless((0..n).map(|j| MasslessMode::new(j, n)).collect())
            }
        };
        let end = force.map(|f| f * bar.contact_compliance());
        Field { modes, shapes, end }
    }

    /// Displacement and velocity of node `i`, counted from the contact.
    fn at(&self, i: u32) -> [f64; 2] {
        let mut sum = if i == 0 { self.end } else { [0.0; 2] };
        let mut add = |shape: f64, mode: &[f64; 2]| {
            sum[0] += shape * mode[0];
            sum[1] += shape * mode[1];
        };
        match &self.shapes {
            Shapes::Cosines(cosines) => {
                let mut turn = 0;
                for mode in self.modes {
                    add(cosines[turn], mode);
                    turn = (turn + i as usize) % cosines.len();
                }
            }
            Shapes::Massless(shapes) => {
                for (shape, mode) in shapes.iter().zip(self.modes) {
                    add(shape.shape(i), mode);
                }
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use crate::problem::numbers::parameter::Value;
    use crate::problem::{Case, find};

    /// The ends at the contact are r apart, in the computed and in the exact motion.
    #[test]
    fn displacements_of_the_ends_give_r() {
        let problem = find("bar-impact").unwrap();
        let unequal = [
            ("right.E", Value::Number(250.0)),
            ("right.L", Value::Number(7.0)),
        ];
        let wall = [("right", Value::Name("wall")); 1];
        for pairs in [&unequal[..], &wall[..], &[]] {
            let mut given = vec![
                ("gamma", Value::Number(1.0)),
                ("n", Value::Whole(12)),
                ("dt", Value::Number(0.004)),
                ("duration", Value::Number(3.0)),
                ("gap", Value::Number(0.3)),
            ];
            given.extend(pairs);
            let (case, broken) = Case::given(&*problem, &given);
            assert_eq!(broken, []);
            let solution = problem.solve(&case, &[]).unwrap();
            let steps = [0, 1, 37, 120, 200, 310, 480, 750];
            let times = steps.map(|step| solution.computed.time[step]);
            let snapshots = problem
                .as_textbook()
                .map_or(Vec::new(), |textbook| textbook.snapshots(&case, &times));
            assert_eq!(snapshots.len(), steps.len());
            for (step, snapshot) in steps.into_iter().zip(&snapshots) {
                let motions = [
                    (&snapshot.displacement.computed, &solution.computed),
                    (&snapshot.displacement.exact, &solution.exact),
                ];
                for (bars, history) in motions {
                    let right = bars.get(1).map_or(0.0, |bar| bar[0][1]);
                    let r = 0.3 + right - bars[0][0][1];
                    let computed = history.displacement()[step];
                    // Round-off of sums over the modes and over the pieces.
                    assert!((r - computed).abs() < 1e-10, "{step}: {r} {computed}");
                }
            }
        }
    }
}
