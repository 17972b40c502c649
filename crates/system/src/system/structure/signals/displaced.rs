//! Motions of supports that are given by displacements.

use super::motion_pieces::{MotionFault, Piece, accelerations, steps_and_secants};
use super::support_motion::{Course, Motion, Quantity};
use crate::system::structure::Signal;
use std::sync::Arc;

impl Motion {
    /// The motion u = amplitude (sin(omega t + phase) - sin phase) from the time `delay` on, at rest before: v may jump there, and there is
    /// no drift.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn harmonic(
        [amplitude, omega, phase]: [f64; 3],
        delay: f64,
    ) -> Result<Motion, MotionFault> {
        Motion {
            course: Course::Harmonic {
                amplitude,
                omega,
                phase,
                start: delay,
            },
            accelerations: None,
            velocity: 0.0,
        }
        .finite()
    }

    /// The motion through points (t, u) from the time `delay` on, at rest before the first one and after the last one.
    ///
    /// Between points u is a cubic. Its slope is 0 at the first and last point and where u turns, so that it does not pass the points
    /// there, and the mean of the slopes to both sides, weighted by Fritsch and Butland (1984), at other points: u rises and falls as
    /// the points do.
    ///
    /// # Errors
    /// The points do not begin with u = 0, or a number is not finite.
    pub fn through(
        times: &[f64],
        displacements: &[f64],
        delay: f64,
    ) -> Result<Motion, MotionFault> {
        let (steps, secants) = steps_and_secants(times, displacements)?;
        let mut slopes = vec![0.0; times.len()];
        for i in 1..secants.len() {
            let [before, after] = [secants[i - 1], secants[i]];
            if before * after > 0.0 {
                let [w0, w1] = [2.0 * steps[i] + steps[i - 1], steps[i] + 2.0 * steps[i - 1]];
                slopes[i] = (w0 + w1) / (w0 / before + w1 / after);
            }
        }
        let mut pieces: Vec<Piece> = Vec::with_capacity(times.len());
        for (i, (step, secant)) in steps.iter().zip(&secants).enumerate() {
            let [v0, v1] = [slopes[i], slopes[i + 1]];
            let a = (6.0 * secant - 4.0 * v0 - 2.0 * v1) / step;
            let rate = 6.0 * (v0 + v1 - 2.0 * secant) / (step * step);
            pieces.push(Piece {
                time: delay + times[i],
                values: [displacements[i], v0, a, rate],
            });
        }
        Motion::displaced(pieces, (times, displacements, &secants), delay)
    }

    /// The motion through points (t, u) from the time `delay` on, straight between them: v jumps at the points.
    ///
    /// # Errors
    /// The points do not begin with u = 0, or a number is not finite.
    pub fn straight(
        times: &[f64],
        displacements: &[f64],
        delay: f64,
    ) -> Result<Motion, MotionFault> {
        let (_, secants) = steps_and_secants(times, displacements)?;
        let points = times.iter().zip(displacements).zip(&secants);
        let pieces = points.map(|((time, u), secant)| Piece {
            time: delay + time,
            values: [*u, *secant, 0.0, 0.0],
        });
        Motion::displaced(pieces.collect(), (times, displacements, &secants), delay)
    }

    /// The motion with these pieces between points, at rest after the last one.
    fn displaced(
        mut pieces: Vec<Piece>,
        (times, displacements, secants): (&[f64], &[f64], &[f64]),
        delay: f64,
    ) -> Result<Motion, MotionFault> {
        if let (Some(time), Some(u)) = (times.last(), displacements.last()) {
            pieces.push(Piece {
                time: delay + time,
                values: [*u, 0.0, 0.0, 0.0],
            });
        }
        let finite = pieces
            .iter()
            .all(|piece| piece.values.iter().all(|x| x.is_finite()));
        let shown = accelerations(times, secants, delay)
            .filter(|_| finite)
            .ok_or(MotionFault::NotFinite)?;
        Ok(Motion {
            course: Course::Pieces(pieces),
            accelerations: Some(Arc::new(shown)),
            velocity: 0.0,
        })
    }

    /// Whether the motion is given by displacements.
    pub fn is_by_displacement(&self) -> bool {
        self.accelerations.is_some() || matches!(self.course, Course::Harmonic { .. })
    }

    /// Whether nodes follow the motion at rest in the equations ([`super::super::Structure::prescribe`]): not where v may jump.
    pub fn carries(&self) -> bool {
        !self.is_by_displacement() && self.velocity == 0.0
    }

    /// The times at which v jumps.
    pub fn blows(&self) -> Vec<f64> {
        let velocity = |time: f64| self.at(time)[1];
        match &self.course {
            Course::Sine { .. } => Vec::new(),
            Course::Harmonic { start, .. } => {
                let is_blow = velocity(*start) != 0.0;
                is_blow.then_some(*start).into_iter().collect()
            }
            Course::Pieces(pieces) => {
                let rest = Piece {
                    time: f64::NEG_INFINITY,
                    values: [0.0; 4],
                };
                let before = std::iter::once(&rest).chain(pieces);
                let jumps = before.zip(pieces).filter(|(before, after)| {
                    let v = match before.time.is_finite() {
                        true => before.at(after.time)[1],
                        false => self.velocity,
                    };
                    let largest = v.abs().max(after.values[1].abs());
                    // Round-off of a cubic at its end.
                    (after.values[1] - v).abs() > 1e-9 * largest
                });
                jumps.map(|(_, after)| after.time).collect()
            }
        }
    }

    /// The acceleration for channels, as a function of time: of displacements, straight between the points, where it is the change of
    /// slope over the mean of both lengths; from rest, and to rest again.
    pub fn shown_acceleration(self: &Arc<Self>) -> Signal {
        match &self.accelerations {
            Some(table) => Signal::Table((**table).clone()),
            None => Signal::Motion(self.clone(), Quantity::Acceleration),
        }
    }

    /// The same at time t.
    pub fn shown_acceleration_at(&self, t: f64) -> f64 {
        match &self.accelerations {
            Some(table) => table.at(t),
            None => self.at(t)[2],
        }
    }
}
