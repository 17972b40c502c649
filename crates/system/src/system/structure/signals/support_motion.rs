//! Motions of supports: an acceleration with its integrals from rest.

use super::motion_pieces::{MotionFault, Piece, harmonic, pieces, sine};
use crate::system::structure::{Baseline, Signal, Table};
use libm::{cos, sin};
use std::sync::Arc;

/// The motion of a support: at rest up to its start, from there on a given acceleration with its exact integrals.
///
/// Between the points of a table the acceleration is straight, v a parabola and u a cubic. The acceleration of a table is that of a
/// ground with the same table: constant before its first point and after its last one, but 0 before the start.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    pub(super) course: Course,
    /// Of one that is given by displacements, the accelerations of its points with straight lines between: those of the cubics jump
    /// at every point, and do not tend to those of a smooth motion.
    pub(super) accelerations: Option<Arc<Table>>,
    /// v at t = 0 in addition to the integral of the acceleration.
    pub(super) velocity: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Course {
    /// amplitude sin(omega (t - start) + phase).
    Sine {
        amplitude: f64,
        omega: f64,
        phase: f64,
        start: f64,
    },
    /// u = amplitude (sin(omega (t - start) + phase) - sin phase).
    Harmonic {
        amplitude: f64,
        omega: f64,
        phase: f64,
        start: f64,
    },
    /// Pieces with rising times; the last one has no end.
    Pieces(Vec<Piece>),
}

/// A quantity of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// u.
    Displacement,
    /// v.
    Velocity,
    /// a.
    Acceleration,
}

impl Motion {
    /// The motion with `scale` times this acceleration, from the time `delay` on.
    ///
    /// # Errors
    /// The function has no such motion.
    pub fn new(
        acceleration: &Signal,
        scale: f64,
        delay: f64,
        baseline: Baseline,
    ) -> Result<Motion, MotionFault> {
        let course = match acceleration {
            Signal::Sine {
                amplitude,
                omega,
                phase,
            } => {
                if baseline != Baseline::None {
                    return Err(MotionFault::NoEnd);
                }
                Course::Sine {
                    amplitude: scale * amplitude,
                    omega: *omega,
                    phase: *phase,
                    start: delay,
                }
            }
            Signal::Table(table) => Course::Pieces(pieces(table, scale, delay, baseline)?),
            // No study has the motion of a support as a function of time.
            Signal::Motion(..) => return Err(MotionFault::NotFinite),
        };
        Motion {
            course,
            accelerations: None,
            velocity: 0.0,
        }
        .finite()
    }

    /// Rest at u = 0.
    pub fn rest() -> Motion {
        Motion {
            course: Course::Pieces(Vec::new()),
            accelerations: None,
            velocity: 0.0,
        }
    }

    /// The motion with this velocity at t = 0 in addition; without an acceleration, it is constant.
    ///
    /// # Errors
    /// It is not finite.
    pub fn with_velocity(mut self, velocity: f64) -> Result<Motion, MotionFault> {
        if velocity == 0.0 {
            return Ok(self);
        }
        self.velocity = velocity;
        if let Course::Pieces(pieces) = &mut self.course {
            if pieces.first().is_none_or(|first| first.time > 0.0) {
                let rest = Piece {
                    time: 0.0,
                    values: [0.0; 4],
                };
                pieces.insert(0, rest);
            }
            for piece in pieces {
                piece.values[0] += velocity * piece.time;
                piece.values[1] += velocity;
            }
        }
        self.finite()
    }

    pub(super) fn finite(self) -> Result<Motion, MotionFault> {
        let last = match &self.course {
            Course::Sine { start, .. } | Course::Harmonic { start, .. } => self.at(*start),
            Course::Pieces(pieces) => pieces.last().map_or([0.0; 3], |last| last.at(last.time)),
        };
        match last.iter().all(|x| x.is_finite()) {
            true => Ok(self),
            false => Err(MotionFault::NotFinite),
        }
    }

    /// u, v and a at time t; where a jumps, the value from then on.
    pub fn at(&self, t: f64) -> [f64; 3] {
        match &self.course {
            Course::Sine {
                amplitude,
                omega,
                phase,
                start,
            } if t >= *start => {
                let [u, v, a] = sine([*amplitude, *omega, *phase], t - start);
                [u + self.velocity * t, v + self.velocity, a]
            }
            Course::Harmonic {
                amplitude,
                omega,
                phase,
                start,
            } if t >= *start => harmonic([*amplitude, *omega, *phase], t - start),
            Course::Sine { .. } | Course::Harmonic { .. } => [0.0; 3],
            Course::Pieces(pieces) => {
                let after = pieces.partition_point(|piece| piece.time <= t);
                let piece = after.checked_sub(1).map(|i| pieces[i]);
                piece.map_or([0.0; 3], |piece| piece.at(t))
            }
        }
    }

    /// u, v and a at 0, dt, .. steps dt.
    pub fn at_steps(&self, dt: f64, steps: usize) -> Vec<[f64; 3]> {
        let mut found = 0;
        let times = (0..=steps).map(|i| i as f64 * dt);
        times.map(|t| self.at_later(t, &mut found)).collect()
    }

    /// u, v and a at a time that is not before the one for which `found` was written last; 0 at first.
    pub fn at_later(&self, t: f64, found: &mut usize) -> [f64; 3] {
        let Course::Pieces(pieces) = &self.course else {
            return self.at(t);
        };
        let passed = pieces[*found..].iter().take_while(|piece| piece.time <= t);
        *found += passed.count();
        let piece = found.checked_sub(1).map(|i| pieces[i]);
        piece.map_or([0.0; 3], |piece| piece.at(t))
    }

    /// A quantity at time t.
    pub fn quantity(&self, quantity: Quantity, t: f64) -> f64 {
        self.at(t)[quantity as usize]
    }

    /// The times from which on the motion has another form.
    pub fn points(&self) -> Vec<f64> {
        match &self.course {
            Course::Sine { start, .. } | Course::Harmonic { start, .. } => vec![*start],
            Course::Pieces(pieces) => pieces.iter().map(|piece| piece.time).collect(),
        }
    }

    /// The time up to which the support is at rest.
    pub fn start(&self) -> f64 {
        match &self.course {
            Course::Sine { start, .. } | Course::Harmonic { start, .. } => *start,
            Course::Pieces(pieces) => pieces.first().map_or(0.0, |piece| piece.time),
        }
    }

    /// Times after 0 at which a jumps, with the values before and after.
    pub fn jumps(&self) -> Vec<(f64, [f64; 2])> {
        let acceleration = |time: f64| self.at(time)[2];
        let corners = match &self.course {
            Course::Sine { start, .. } | Course::Harmonic { start, .. } => {
                vec![(*start, [0.0, acceleration(*start)])]
            }
            Course::Pieces(pieces) => {
                let at_start = pieces.iter().take(1);
                let first = at_start.map(|piece| (piece.time, [0.0, piece.values[2]]));
                let others = pieces.windows(2).map(|pair| {
                    let time = pair[1].time;
                    (time, [pair[0].at(time)[2], pair[1].values[2]])
                });
                first.chain(others).collect()
            }
        };
        let jumps = corners.into_iter().filter(|(time, [before, after])| {
            // Round-off of a line at its end.
            *time > 0.0 && (after - before).abs() > 1e-12 * before.abs().max(after.abs())
        });
        jumps.collect()
    }

    /// The circular frequency of a sine; 0 of other motions.
    pub fn omega(&self) -> f64 {
        match &self.course {
            Course::Sine { omega, .. } | Course::Harmonic { omega, .. } => *omega,
            Course::Pieces(_) => 0.0,
        }
    }

    /// Coefficients of u for the times `start` + `length` s, in powers of s; no point of the motion lies between.
    pub fn taylor<const N: usize>(&self, [start, length]: [f64; 2]) -> [f64; N] {
        let [u, v, a] = self.at(start);
        let mut derivatives = [0.0; N];
        for (to, x) in derivatives.iter_mut().zip([u, v, a]) {
            *to = x;
        }
        match &self.course {
            Course::Sine {
                amplitude,
                omega,
                phase,
                start: begin,
            }
            | Course::Harmonic {
                amplitude,
                omega,
                phase,
                start: begin,
            } if start >= *begin => {
                let angle = omega * (start - begin) + phase;
                let cycle = [sin(angle), cos(angle), -sin(angle), -cos(angle)];
                let mut factor = match self.course {
                    Course::Harmonic { .. } => -amplitude * omega * omega,
                    Course::Sine { .. } | Course::Pieces(_) => *amplitude,
                };
                for (k, to) in derivatives.iter_mut().skip(2).enumerate() {
                    *to = factor * cycle[k % 4];
                    factor *= omega;
                }
            }
            Course::Sine { .. } | Course::Harmonic { .. } => {}
            Course::Pieces(pieces) => {
                let after = pieces.partition_point(|piece| piece.time <= start);
                if let (Some(i), Some(to)) = (after.checked_sub(1), derivatives.get_mut(3)) {
                    *to = pieces[i].values[3];
                }
            }
        }
        let mut factor = 1.0;
        for (k, to) in derivatives.iter_mut().enumerate() {
            if k > 0 {
                factor *= length / k as f64;
            }
            *to *= factor;
        }
        derivatives
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::structure::Table;
    use std::f64::consts::TAU;

    /// u and v by Simpson's rule over short intervals of v and a.
    fn integrals(a: impl Fn(f64) -> f64, end: f64) -> [f64; 2] {
        let n = 4000;
        let h = end / f64::from(n);
        let [mut u, mut v] = [0.0; 2];
        for i in 0..n {
            let t = f64::from(i) * h;
            let [a0, a1, a2] = [t, t + 0.5 * h, t + h].map(&a);
            // The cubic through a, exact for a parabola.
            u += h * v + h * h * (a0 + 2.0 * a1) / 6.0;
            v += h * (a0 + 4.0 * a1 + a2) / 6.0;
        }
        [u, v]
    }

    #[test]
    fn a_sine_has_its_integrals_from_rest() {
        for (omega, phase, delay) in [(3.0, 0.0, 0.0), (0.7, 1.1, 0.4), (1e-3, 0.3, 0.0)] {
            let signal = Signal::Sine {
                amplitude: 1.3,
                omega,
                phase,
            };
            let motion = Motion::new(&signal, 2.0, delay, Baseline::None).unwrap();
            assert_eq!(motion.at(delay)[..2], [0.0; 2]);
            if delay > 0.0 {
                assert_eq!(motion.at(0.99 * delay), [0.0; 3]);
            }
            for t in [0.01, 0.5, 2.0, 6.0] {
                let [u, v] = integrals(|t| 2.6 * (omega * t + phase).sin(), t);
                let moved = motion.at(delay + t);
                // Simpson's rule: (omega h)^4/180 = 3e-12, and its round-off.
                assert!(
                    (moved[0] - u).abs() < 1e-10 && (moved[1] - v).abs() < 1e-10,
                    "{t}: {moved:?} {u} {v}"
                );
                let taylor: [f64; 27] = motion.taylor([delay + t, 0.8]);
                let at = taylor.iter().rev().fold(0.0, |sum, c| sum * 0.6 + c);
                let [u, ..] = motion.at(delay + t + 0.48);
                assert!((at - u).abs() <= 1e-14 * (1.0 + u.abs()), "{t}: {at} {u}");
            }
        }
    }

    #[test]
    fn a_table_has_cubics_and_its_delay_shifts_them() {
        // a = 6 t up to 1, then -2: u = t^3, v = 3 t^2; later 1 + 3 s - s^2.
        let table = Table::new(vec![0.0, 1.0, 1.0], vec![0.0, 6.0, -2.0]).unwrap();
        let signal = Signal::Table(table);
        for delay in [0.0, 0.5] {
            let motion = Motion::new(&signal, 1.0, delay, Baseline::None).unwrap();
            let at = |t: f64| motion.at(delay + t);
            assert_eq!(at(0.5), [0.125, 0.75, 3.0]);
            assert_eq!(at(1.0), [1.0, 3.0, -2.0]);
            assert_eq!(at(3.0), [3.0, -1.0, -2.0]);
            assert_eq!(motion.at(-0.1), [0.0; 3]);
            let jumps = motion.jumps();
            assert_eq!(jumps, [(delay + 1.0, [6.0, -2.0])]);
            let steps = motion.at_steps(0.25, 12);
            let expected: Vec<_> = (0..=12).map(|i| motion.at(0.25 * f64::from(i))).collect();
            assert_eq!(steps, expected);
        }
    }

    #[test]
    fn a_linear_baseline_leaves_no_velocity_at_the_end() {
        let table = Table::new(vec![0.0, 1.0, 3.0], vec![1.0, 3.0, 0.0]).unwrap();
        let motion = Motion::new(&Signal::Table(table), 1.0, 0.2, Baseline::Linear).unwrap();
        // The area is 2 + 3, its mean over 3 s is 5/3.
        assert!((motion.at(0.2)[2] - (1.0 - 5.0 / 3.0)).abs() < 1e-15);
        let [u, v, a] = motion.at(3.2);
        assert_eq!([v, a], [0.0; 2]);
        assert_eq!(motion.at(9.0), [u, 0.0, 0.0]);
        // By parts, u(3) is the integral of (3 - t) a: of the lines, and of the mean.
        let expected = {
            let by = |t: f64| {
                (3.0 - t)
                    * if t < 1.0 {
                        1.0 + 2.0 * t
                    } else {
                        4.5 - 1.5 * t
                    }
            };
            let simpson =
                |a: f64, b: f64| (b - a) / 6.0 * (by(a) + 4.0 * by(0.5 * (a + b)) + by(b));
            simpson(0.0, 1.0) + simpson(1.0, 3.0) - 5.0 / 3.0 * 4.5
        };
        assert!((u - expected).abs() < 1e-14, "{u} {expected}");
        let sine = Signal::Sine {
            amplitude: 1.0,
            omega: 1.0,
            phase: 0.0,
        };
        let refused = Motion::new(&sine, 1.0, 0.0, Baseline::Linear);
        assert_eq!(refused, Err(MotionFault::NoEnd));
    }

    #[test]
    fn the_acceleration_of_displacements_is_of_second_order_and_ends_at_rest() {
        // u = 1 - cos 2 pi t over two periods.
        let errors = [50, 100, 200].map(|count| {
            let times: Vec<f64> = (0..=2 * count)
                .map(|i| f64::from(i) / f64::from(count))
                .collect();
            let u: Vec<f64> = times.iter().map(|t| 1.0 - cos(TAU * t)).collect();
            let motion = Motion::through(&times, &u, 0.3).unwrap();
            let error = |t: &f64| {
                let shown = motion.shown_acceleration_at(0.3 + t);
                (shown - TAU * TAU * cos(TAU * t)).abs()
            };
            // Between the points, too.
            let inner = times.windows(2).map(|t| 0.5 * (t[0] + t[1]));
            let instants = times[..times.len() - 1].iter().copied().chain(inner);
            instants.fold(0.0, |most: f64, t| most.max(error(&t)))
        });
        // h^2/12 of (2 pi)^4 at the points, h^2/8 more between them.
        assert!(errors[0] < 0.21 * TAU.powi(4) / 2500.0, "{errors:?}");
        for pair in errors.windows(2) {
            assert!((pair[0] / pair[1] - 4.0).abs() < 0.02, "{errors:?}");
        }
        // Its integral is the velocity, 0 at both ends.
        let motion = Motion::through(&[0.0, 0.4, 1.0, 1.5], &[0.0, 2.0, -1.0, 3.0], 0.0).unwrap();
        let Some(table) = &motion.accelerations else {
            panic!("no displacements");
        };
        let points = table.times().windows(2).zip(table.values().windows(2));
        let area: f64 = points
            .map(|(t, a)| 0.5 * (t[1] - t[0]) * (a[0] + a[1]))
            .sum();
        assert!(area.abs() < 1e-14, "{area}");
        assert_eq!(
            [-0.1, 1.6].map(|t| motion.shown_acceleration_at(t)),
            [0.0; 2]
        );
    }
}
