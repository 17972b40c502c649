//! Velocity and stress along the bars at given times, computed and exact.

use super::scaled::Scaled;
use crate::exact::wave::Wave;
use crate::problem::{Lines, Snapshot};
use crate::solve;
use crate::system::System;
use crate::system::bar::Bar;

/// Most elements of a bar that are drawn; of more elements, only every second, third, ... is drawn.
const DRAWN: u32 = 1000;

/// The profiles at the steps nearest to `times`, in the order of the times.
///
/// The abscissa is in lengths of the left bar, with the contact at 0; velocity is (v - mean of the two V0)/(c/2); stress is force
/// over F0, tension positive.
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
                *slot = Some(snapshot(scaled, &wave, time, &separate));
            }
        },
    );
    snapshots.into_iter().flatten().collect()
}

fn snapshot(scaled: &Scaled, wave: &Wave, time: f64, modes: &[[f64; 2]]) -> Snapshot {
    let mut velocity = Lines::default();
    let mut stress = Lines::default();
    let mut fronts = Vec::new();
    let mut modes = modes;
    // The motion at a wall is in the frame of the wall; the mean of the two V0 is half of the velocity of the bar.
    let frame = if scaled.pair.right.is_some() {
        0.0
    } else {
        1.0
    };
    for (i, bar) in scaled.pair.each().enumerate() {
        let (own, rest) = modes.split_at(bar.elements as usize + 1);
        modes = rest;
        let (sign, length) = [(-1.0, 1.0), (1.0, scaled.length_ratio)][i];
        let field = Field::new(&bar, own);
        let n = bar.elements;
        let stride = n.div_ceil(DRAWN);
        let place = |s: f64| sign * length * s / f64::from(n);
        let nodes = (0..=n).step_by(stride as usize);
        // Scaled coordinates are positive if they open the gap, so the left bar has the opposite sign.
        velocity.computed.push(
            nodes
                .map(|k| [place(f64::from(k)), sign * field.at(k)[1] - frame])
                .collect(),
        );
        let elements = (0..n).step_by(stride as usize);
        stress.computed.push(
            elements
                .map(|k| {
                    let stretch = field.at(k + 1)[0] - field.at(k)[0];
                    [place(f64::from(k) + 0.5), element_stiffness(&bar) * stretch]
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
        let places = wave.fronts(i, time).into_iter();
        fronts.extend(places.map(|s| sign * length * s));
    }
    Snapshot {
        time,
        profiles: vec![velocity, stress],
        fronts,
    }
}

/// EA/h, scaled.
fn element_stiffness(bar: &Bar) -> f64 {
    let n = f64::from(bar.elements);
    bar.mass / n * (2.0 * n / bar.travel_time) * (2.0 * n / bar.travel_time)
}

/// Displacements and velocities at the nodes from those of the modes.
struct Field<'a> {
    modes: &'a [[f64; 2]],
    /// cos(k pi/n), k = 0..2n, which contain the shape of every mode at every node.
    cosines: Vec<f64>,
}

impl<'a> Field<'a> {
    fn new(bar: &Bar, modes: &'a [[f64; 2]]) -> Field<'a> {
        let cosines = (0..2 * bar.elements).map(|k| bar.shape(1, k)).collect();
        Field { modes, cosines }
    }

    /// Displacement and velocity of node `i`, counted from the contact.
    fn at(&self, i: u32) -> [f64; 2] {
        let mut sum = [0.0; 2];
        let mut turn = 0;
        for mode in self.modes {
            let shape = self.cosines[turn];
            sum[0] += shape * mode[0];
            sum[1] += shape * mode[1];
            turn = (turn + i as usize) % self.cosines.len();
        }
        sum
    }
}
