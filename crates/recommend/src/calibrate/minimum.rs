//! A minimum with the quadratic function round it, fitted over lengths at which the jumps of the misfit are small.

use super::Stopped;
use super::counted::{Counted, Round, round, squared};
use super::linear::{Eigen, axis, block, dot, solve};
use super::local::{Local, Threshold};
use super::search_start::{LEAST, TENTH};

/// Distance of the points from which a usual rise is known.
const USUAL: f64 = 0.05;

/// A fit that leaves more than this part of the rise over its points is rough.
pub const ROUGH: f64 = 0.4;

/// What a function without jumps leaves of a fit falls by more, if the lengths of the points are halved: of an edge to a quarter, of a
/// curve to an eighth. It never is larger than the rise.
const BENT: f64 = 0.35;

/// Values whose squared misfits differ by fewer jumps are not told apart.
const JUMPS: f64 = 2.0;

/// Jumps are looked for up to this rise, relative to the squared misfit, and up to the second one if there are any.
const FAR: f64 = TENTH;
const FARTHEST: f64 = 100.0;

/// A minimum with the quadratic function of the squared misfit round it.
#[derive(Debug)]
pub struct Minimum {
    pub at: Vec<f64>,
    pub misfit: f64,
    pub curvature: Vec<Vec<f64>>,
    /// What the fit of the quadratic function leaves.
    pub residual: f64,
    /// The rises of the squared misfit at the ends of the interval and of the range of 10 %; without a probability both are the second.
    pub rises: (f64, f64),
    /// The rise over the points of the fit: its jumps are smaller.
    pub smooth: f64,
    /// The factor of the interval because of jumps.
    pub widened: f64,
}

/// A local search that ended.
struct Fitted {
    best: (Vec<f64>, f64),
    shape: Eigen,
    curvature: Vec<Vec<f64>>,
    residual: f64,
}

impl Fitted {
    fn new(
        at: Vec<f64>,
        shape: Eigen,
        rise: f64,
        counted: &mut Counted,
    ) -> Result<Fitted, Stopped> {
        let n = at.len();
        let threshold = Threshold {
            relative: 0.0,
            ground: 0.0,
            least: rise,
        };
        let mut local = [Local::new(at, (0..n).collect(), shape, threshold).steady()];
        while round(&mut local, counted)? == Round::Next {}
        let [local] = local;
        let (curvature, residual) = match local.model {
            Some((model, _)) => (model.curvature, model.residual),
            None => (vec![vec![0.0; n]; n], f64::INFINITY),
        };
        Ok(Fitted {
            best: local.best,
            shape: local.shape,
            curvature,
            residual,
        })
    }
}

/// Fits over points whose rises are larger by a factor of 4 from one to the next.
struct Levels {
    fits: Vec<(Fitted, f64)>,
}

impl Levels {
    /// From the rise of the interval to a far one, and farther if the fits are rough there.
    fn new(
        at: Vec<f64>,
        shape: Eigen,
        [near, far]: [f64; 2],
        counted: &mut Counted,
    ) -> Result<Levels, Stopped> {
        let first = Fitted::new(at, shape, near, counted)?;
        let mut levels = Levels {
            fits: vec![(first, near)],
        };
        let farthest = far * FARTHEST / FAR;
        let mut rise = near;
        loop {
            let rough = levels.jumps() > ROUGH * rise;
            if rise >= farthest || (rise >= far && !rough) {
                return Ok(levels);
            }
            rise *= 4.0;
            levels.add(rise, counted)?;
        }
    }

    fn add(&mut self, rise: f64, counted: &mut Counted) -> Result<(), Stopped> {
        let Some((last, _)) = self.fits.last() else {
            return Ok(());
        };
        let next = Fitted::new(last.best.0.clone(), last.shape.clone(), rise, counted)?;
        self.fits.push((next, rise));
        Ok(())
    }

    /// The size of the jumps of the squared misfit; 0 if they are small next to the rise of the interval.
    fn jumps(&self) -> f64 {
        let Some((_, near)) = self.fits.first() else {
            return 0.0;
        };
        let residuals = self.fits.iter().skip(1).map(|(fit, _)| fit.residual);
        let following = residuals.chain([f64::INFINITY]);
        let jumps = self.fits.iter().zip(following).map(|((fit, rise), next)| {
            let stays = fit.residual > BENT * next || fit.residual > *rise;
            let counts = stays && fit.residual.is_finite() && fit.residual > ROUGH * near;
            if counts { fit.residual } else { 0.0 }
        });
        jumps.fold(0.0, f64::max)
    }

    /// The fit over the smallest rise that is larger than the jumps, with this rise and the best point of all.
    fn smooth(mut self, jumps: f64) -> (Fitted, f64) {
        let bests = self.fits.iter().map(|(fit, _)| fit.best.clone());
        let best = bests.min_by(|a, b| a.1.total_cmp(&b.1));
        let smooth = self.fits.iter().position(|(_, rise)| jumps <= ROUGH * rise);
        let (mut fitted, rise) = self.fits.swap_remove(smooth.unwrap_or(self.fits.len() - 1));
        fitted.best = best.unwrap_or(fitted.best);
        (fitted, rise)
    }
}

impl Minimum {
    /// The minimum near a point, also at bounds. `fraction` is the rise at the ends of the interval, relative to the squared misfit.
    pub fn near(
        (at, misfit): (Vec<f64>, f64),
        counted: &mut Counted,
        fraction: Option<f64>,
    ) -> Result<Minimum, Stopped> {
        let square = squared(misfit);
        let rises = rises(&at, square, counted)?;
        let mut finite: Vec<f64> = rises.iter().copied().filter(|x| x.is_finite()).collect();
        finite.sort_by(f64::total_cmp);
        let usual = finite.get(finite.len() / 2).copied().unwrap_or(0.0);
        let threshold = Threshold {
            relative: fraction.unwrap_or(TENTH),
            ground: 0.0,
            least: (LEAST * usual).max(f64::MIN_POSITIVE),
        };
        let rise = threshold.at(square);
        let length = |pair: &[f64]| match pair
            .iter()
            .copied()
            .filter(|x| x.is_finite())
            .fold(0.0, f64::max)
        {
            largest if largest > 0.0 => USUAL * (rise / largest).sqrt(),
            _ => 1.0,
        };
        let shape = Eigen {
            values: rises.chunks(2).map(length).collect(),
            vectors: (0..at.len()).map(|k| axis(at.len(), k)).collect(),
        };
        let levels = Levels::new(at, shape, [rise, FAR * square.abs()], counted)?;
        let jumps = levels.jumps();
        let (fitted, smooth) = levels.smooth(jumps);
        let (at, misfit) = fitted.best;
        let square = squared(misfit);
        let far = (squared(misfit + 0.1 * misfit.abs()) - square).max(threshold.least);
        let near = fraction.map_or(far, |_| threshold.at(square));
        Ok(Minimum {
            at,
            misfit,
            curvature: fitted.curvature,
            residual: fitted.residual,
            smooth,
            rises: (
                near + jumps,
                if jumps > 0.0 {
                    far.max(near + JUMPS * jumps)
                } else {
                    far
                },
            ),
            widened: ((near + JUMPS * jumps) / near).sqrt(),
        })
    }

    /// Half the width of the range of a coordinate with this rise, by the quadratic function; half of the coordinate's range at most.
    pub fn width(&self, k: usize, rise: f64) -> f64 {
        let Some(eigen) = Eigen::of(&self.curvature) else {
            return 0.5;
        };
        let parts = eigen.values.iter().zip(&eigen.vectors);
        let square: f64 = parts
            .map(|(value, b)| rise * b[k] * b[k] / value.max(4.0 * rise))
            .sum();
        square.sqrt().max(1e-9)
    }

    /// Whether the squared misfit rises to that of the interval within the range of a coordinate, while the others stay.
    pub fn limits(&self, k: usize) -> bool {
        let room = self.at[k].max(1.0 - self.at[k]);
        self.curvature[k][k] * room * room > self.rises.0
    }

    /// The change of the other coordinates with coordinate `k` along the valley of the quadratic function.
    pub fn valley(&self, k: usize, others: &[usize]) -> Vec<f64> {
        let coupling = block(&self.curvature, others, &[k]).concat();
        let Some(eigen) = Eigen::of(&block(&self.curvature, others, others)) else {
            return vec![0.0; others.len()];
        };
        let largest = eigen.values.last().copied().unwrap_or(0.0);
        let mut slope = vec![0.0; others.len()];
        for (value, direction) in eigen
            .values
            .iter()
            .zip(&eigen.vectors)
            .filter(|(v, _)| **v > 1e-12 * largest)
        {
            let along = -dot(direction, &coupling) / value;
            slope
                .iter_mut()
                .zip(direction)
                .for_each(|(to, b)| *to += along * b);
        }
        slope
    }

    /// Of the coordinates, if the quadratic function has a minimum within sight.
    pub fn correlation(&self) -> Option<Vec<Vec<f64>>> {
        let n = self.at.len();
        let eigen = Eigen::of(&self.curvature)?;
        let least = eigen.values.first()?;
        if *least <= 1e-3 * self.rises.0 {
            return None;
        }
        let column = |k: usize| solve(&self.curvature, &axis(n, k));
        let inverse: Vec<Vec<f64>> = (0..n).map(column).collect::<Option<_>>()?;
        let entry = |i: usize, j: usize| match i == j {
            true => 1.0,
            false => 0.5 * (inverse[i][j] + inverse[j][i]) / (inverse[i][i] * inverse[j][j]).sqrt(),
        };
        Some(
            (0..n)
                .map(|i| (0..n).map(|j| entry(i, j)).collect())
                .collect(),
        )
    }

    /// The direction of the least curvature, if the squared misfit rises too little on both ways to the ends of the ranges.
    pub fn direction(&self) -> Option<Vec<f64>> {
        let eigen = Eigen::of(&self.curvature)?;
        let (value, direction) = (eigen.values.first()?, eigen.vectors.first()?);
        let room = |sign: f64| {
            let each = self.at.iter().zip(direction).map(|(x, d)| match sign * d {
                d if d > 0.0 => (1.0 - x) / d,
                d if d < 0.0 => -x / d,
                _ => f64::INFINITY,
            });
            each.fold(f64::INFINITY, f64::min)
        };
        let rise = |length: f64| value * length * length;
        if rise(room(1.0)) > self.rises.0 || rise(room(-1.0)) > self.rises.0 {
            return None;
        }
        let largest = direction
            .iter()
            .copied()
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        Some(direction.iter().map(|d| d * largest.signum()).collect())
    }
}

/// The rises of the squared misfit at a distance on both sides of each coordinate.
fn rises(at: &[f64], square: f64, counted: &mut Counted) -> Result<Vec<f64>, Stopped> {
    let moved = |k: usize, d: f64| {
        let mut point = at.to_vec();
        let inside = (0.0..=1.0).contains(&(point[k] + d));
        point[k] += if inside { d } else { -d };
        point
    };
    let both = |k| [moved(k, -USUAL), moved(k, USUAL)];
    let points: Vec<Vec<f64>> = (0..at.len()).flat_map(both).collect();
    let misfits = counted.misfits(&points)?.unwrap_or_default();
    Ok(misfits
        .iter()
        .map(|misfit| squared(*misfit) - square)
        .collect())
}
