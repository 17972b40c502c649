//! Motions between the points of a table, and of a sine.

use super::baseline::NoEnd;
use crate::system::structure::{Baseline, Table};
use libm::{cos, sin};
use std::fmt;

/// A cubic from a time on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    pub(crate) time: f64,
    /// u, v, a and the rate of a at this time.
    pub(crate) values: [f64; 4],
}

impl Piece {
    pub(crate) fn at(&self, t: f64) -> [f64; 3] {
        let ([u, v, a, rate], t) = (self.values, t - self.time);
        [
            u + t * (v + t * (0.5 * a + t * (rate / 6.0))),
            v + t * (a + t * (0.5 * rate)),
            a + t * rate,
        ]
    }
}

/// The pieces of a table from rest.
pub(crate) fn pieces(
    table: &Table,
    scale: f64,
    delay: f64,
    baseline: Baseline,
) -> Result<Vec<Piece>, MotionFault> {
    let points = baseline
        .removed(table, scale)
        .map_err(|NoEnd| MotionFault::NoEnd)?;
    let [mut u, mut v] = [0.0; 2];
    let mut pieces: Vec<Piece> = Vec::with_capacity(points.len());
    for (i, (time, a)) in points.iter().enumerate() {
        let next = points.get(i + 1);
        let rate = match next {
            // A jump.
            Some((next, _)) if next == time => continue,
            Some((next, b)) => (b - a) / (next - time),
            None => 0.0,
        };
        let piece = Piece {
            time: delay + time,
            values: [u, v, *a, rate],
        };
        if let Some((next, _)) = next {
            let end = Piece {
                time: *time,
                ..piece
            };
            [u, v, _] = end.at(*next);
        }
        pieces.push(piece);
    }
    if let (Baseline::Linear, Some(last)) = (baseline, pieces.last_mut()) {
        // Without the round-off of the sum, which would become a drift.
        last.values[1] = 0.0;
    }
    Ok(pieces)
}

/// Accelerations at points with these slopes between them: the velocities that they make are 0 at both ends.
pub(crate) fn accelerations(times: &[f64], secants: &[f64], delay: f64) -> Option<Table> {
    let (mut t, mut a) = (vec![delay + times[0]], vec![0.0]);
    for (i, time) in times.iter().enumerate() {
        let before = i.checked_sub(1);
        let slope = |i: Option<usize>| i.and_then(|i| secants.get(i)).copied().unwrap_or(0.0);
        let length = |i: usize| match times.get(i + 1) {
            Some(next) => next - times[i],
            None => 0.0,
        };
        let both = before.map_or(0.0, length) + length(i);
        t.push(delay + time);
        a.push(match both > 0.0 {
            true => 2.0 * (slope(Some(i)) - slope(before)) / both,
            false => 0.0,
        });
    }
    t.extend(t.last().copied());
    a.push(0.0);
    Table::new(t, a)
}

/// u, v and a of a sine at the time t after its start: the integrals from rest, without differences of nearly equal numbers.
pub(crate) fn sine([amplitude, omega, phase]: [f64; 3], t: f64) -> [f64; 3] {
    let x = omega * t;
    let (half, a) = (sin(0.5 * x), amplitude * sin(x + phase));
    if x.abs() < 1e-150 {
        // Its square is 0.
        return [0.5 * a * t * t, a * t, a];
    }
    let v = 2.0 * amplitude / omega * sin(phase + 0.5 * x) * half;
    let shape = cos(phase) * x_minus_sine(x) + sin(phase) * (2.0 * half * half);
    [amplitude / (omega * omega) * shape, v, a]
}

/// u, v and a of amplitude (sin(omega t + phase) - sin phase), without a difference of nearly equal numbers.
pub(crate) fn harmonic([amplitude, omega, phase]: [f64; 3], t: f64) -> [f64; 3] {
    let x = omega * t;
    [
        2.0 * amplitude * cos(phase + 0.5 * x) * sin(0.5 * x),
        amplitude * omega * cos(x + phase),
        -amplitude * omega * omega * sin(x + phase),
    ]
}

/// The times between points (t, u), and the slopes of the lines between them.
///
/// # Errors
/// The times do not rise, or the first u is not 0.
pub(crate) fn steps_and_secants(
    times: &[f64],
    displacements: &[f64],
) -> Result<(Vec<f64>, Vec<f64>), MotionFault> {
    let rising = times.windows(2).all(|pair| pair[0] < pair[1]);
    if !rising || times.len() != displacements.len() || displacements.first() != Some(&0.0) {
        return Err(MotionFault::Displacements);
    }
    let steps: Vec<f64> = times.windows(2).map(|t| t[1] - t[0]).collect();
    let pairs = displacements.windows(2).zip(&steps);
    let secants = pairs.map(|(u, step)| (u[1] - u[0]) / step).collect();
    Ok((steps, secants))
}

/// x - sin x.
pub(crate) fn x_minus_sine(x: f64) -> f64 {
    if x.abs() > 1.0 {
        return x - sin(x);
    }
    let square = x * x;
    let (mut term, mut sum): (f64, f64) = (x * square / 6.0, 0.0);
    let mut k = 4.0;
    while term.abs() > 1e-18 * sum.abs() && k < 40.0 {
        sum += term;
        term *= -square / (k * (k + 1.0));
        k += 2.0;
    }
    sum
}

/// Why a function is no motion of a support.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum MotionFault {
    /// The baseline of a function without an end.
    NoEnd,
    /// A number is not finite.
    NotFinite,
    /// Imposed displacements do not begin with 0, or their times do not rise.
    Displacements,
}

impl fmt::Display for MotionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MotionFault::NoEnd => {
                "a baseline needs a function with an end after t = 0; a sine has none"
            }
            MotionFault::Displacements => {
                "imposed displacements need rising times and u = 0 at the first one, where the support is at rest"
            }
            MotionFault::NotFinite => {
                "the displacement of the support is not finite; use a smaller scale"
            }
        })
    }
}
