//! How sharply a minimum is determined: its curvature, then the profiles of all coordinates next to one another.

use super::arm::{Arm, Reached};
use super::counted::{Counted, Round, round, squared};
use super::linear::{Eigen, axis, solve};
use super::local::{Local, Threshold};
use super::start::{LEAST, TENTH};
use super::{Best, Determined, End, Objective, Profile, ProfilePoint, Stopped};
use slipgap_statistics::{CONFIDENCE, fisher};

/// Searches for a better minimum at most, after the profiles found one.
const RESTARTS: usize = 2;

/// Distance of the points that tell a usual misfit.
const USUAL: f64 = 0.05;

/// Parts of the rise of the interval: a better point is lower by more; a fit that leaves more is rough.
const BETTER: f64 = 0.1;
const ROUGH: f64 = 0.4;

/// Values whose squared misfits differ by fewer jumps are not told apart.
const JUMPS: f64 = 2.0;

/// Residuals of a bent function fall by more, if the lengths of the points are halved.
const BENT: f64 = 0.25;

/// The largest rise over the points, relative to the squared misfit.
const ROUGHEST: f64 = 100.0;

/// Intervals of the quadratic function and of the profile agree within this part.
const AGREE: f64 = 0.2;

/// Components of a direction that count.
const COMPONENT: f64 = 0.1;

/// A minimum with the quadratic function of the squared misfit round it.
#[derive(Debug)]
pub struct Minimum {
    pub at: Vec<f64>,
    pub misfit: f64,
    pub curvature: Vec<Vec<f64>>,
    /// What the fit of the quadratic function leaves.
    residual: f64,
    /// The rises of the squared misfit at the ends of the interval and of the range of 10 %; without a probability both are the second.
    pub rises: (f64, f64),
    /// The rise over the points of the fit: its jumps are smaller.
    pub smooth: f64,
    /// The factor of the interval because of jumps.
    widened: f64,
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
        (at, _): (Vec<f64>, f64),
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

    fn is_rough(&self, rise: f64) -> bool {
        self.residual > ROUGH * rise
    }
}

impl Minimum {
    /// The least squared misfit near a point, which also may be at bounds.
    fn near(
        (at, misfit): (Vec<f64>, f64),
        counted: &mut Counted,
        fraction: Option<f64>,
    ) -> Result<Minimum, Stopped> {
        let n = at.len();
        let moved = |k: usize, d: f64| {
            let mut point = at.clone();
            point[k] += if point[k] + d > 1.0 || point[k] + d < 0.0 {
                -d
            } else {
                d
            };
            point
        };
        let points: Vec<Vec<f64>> = (0..n)
            .flat_map(|k| [moved(k, -USUAL), moved(k, USUAL)])
            .collect();
        let square = squared(misfit);
        let rises: Vec<f64> = match counted.misfits(&points)? {
            Some(misfits) => misfits.iter().map(|m| squared(*m) - square).collect(),
            None => Vec::new(),
        };
        let mut finite: Vec<f64> = rises.iter().copied().filter(|x| x.is_finite()).collect();
        finite.sort_by(f64::total_cmp);
        let usual = finite.get(finite.len() / 2).copied().unwrap_or(0.0);
        let least = (LEAST * usual).max(f64::MIN_POSITIVE);
        let relative = fraction.unwrap_or(TENTH);
        let threshold = Threshold {
            relative,
            ground: 0.0,
            least,
        };
        let length = |pair: &[f64]| {
            let largest = pair
                .iter()
                .copied()
                .filter(|x| x.is_finite())
                .fold(0.0, f64::max);
            if largest > 0.0 {
                USUAL * (threshold.at(square) / largest).sqrt()
            } else {
                1.0
            }
        };
        let shape = Eigen {
            values: rises.chunks(2).map(length).collect(),
            vectors: (0..n).map(|k| axis(n, k)).collect(),
        };
        let mut rise = threshold.at(square);
        let mut fitted = Fitted::new((at, misfit), shape, rise, counted)?;
        let mut rough = false;
        if fitted.is_rough(rise) {
            // What a bent function leaves of a fit vanishes over smaller lengths, jumps do not.
            let closer = Fitted::new(
                fitted.best.clone(),
                fitted.shape.clone(),
                rise / 4.0,
                counted,
            )?;
            rough = closer.residual > BENT * fitted.residual;
            fitted.best = closer.best;
        }
        while rough && fitted.is_rough(rise) && rise < ROUGHEST * square.abs().max(least) {
            rise *= 4.0;
            fitted = Fitted::new(fitted.best, fitted.shape, rise, counted)?;
        }
        let (at, misfit) = fitted.best;
        let square = squared(misfit);
        let far = (squared(misfit + 0.1 * misfit.abs()) - square).max(least);
        let near = fraction.map_or(far, |part| (part * square.abs()).max(least));
        // A value is outside of the interval only if jumps cannot explain its misfit.
        let jumps = if rough { JUMPS * fitted.residual } else { 0.0 };
        let largest = ROUGHEST * square.abs().max(least);
        Ok(Minimum {
            at,
            misfit,
            curvature: fitted.curvature,
            residual: fitted.residual,
            smooth: rise,
            rises: (
                near + jumps.min(largest),
                far.max(near + jumps.min(largest)),
            ),
            widened: ((near + jumps.min(largest)) / near).sqrt(),
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

    fn correlation(&self) -> Option<Vec<Vec<f64>>> {
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
    fn direction(&self) -> Option<Vec<f64>> {
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

/// Determines the profiles at the best point of a search. `residuals` is the effective number of independent residuals if the misfit is the
/// root of their mean square; otherwise there is no probability.
///
/// # Errors
/// The user ended it.
pub fn determine(
    best: &Best,
    objective: &mut dyn Objective,
    residuals: Option<f64>,
) -> Result<Determined, Stopped> {
    let n = best.at.len();
    if !best.misfit.is_finite() {
        return Ok(nothing(best));
    }
    let freedom = residuals
        .map(|count| count - n as f64)
        .filter(|freedom| *freedom > 0.0);
    let fraction = freedom.map(|freedom| fisher::quantile(CONFIDENCE, 1.0, freedom) / freedom);
    let mut counted = Counted::new(objective, u64::MAX);
    let mut from = (best.at.clone(), best.misfit);
    let mut restarts = 0;
    loop {
        let minimum = Minimum::near(from, &mut counted, fraction)?;
        let sides = (0..n).flat_map(|k| [(k, -1.0), (k, 1.0)]);
        let mut arms: Vec<Arm> = sides.map(|(k, side)| Arm::new(&minimum, k, side)).collect();
        let limit = squared(minimum.misfit) - (BETTER * minimum.rises.0).max(minimum.residual);
        let better = |counted: &Counted| {
            counted
                .best
                .clone()
                .filter(|(_, misfit)| squared(*misfit) < limit)
        };
        let most = if minimum.widened > 1.0 { 1 } else { RESTARTS };
        let again = |counted: &Counted| restarts < most && better(counted).is_some();
        while !again(&counted) && round(&mut arms, &mut counted)? == Round::Next {}
        match better(&counted) {
            Some(point) if restarts < most => {
                from = point;
                restarts += 1;
            }
            point => {
                let mut found = describe(best, &minimum, &arms, fraction.is_some());
                if let Some((at, misfit)) = point {
                    (found.best.at, found.best.misfit) = (at, misfit);
                    found.quadratic = false;
                }
                found.solved = counted.solved;
                return Ok(found);
            }
        }
    }
}

/// Of a search without any solution.
fn nothing(best: &Best) -> Determined {
    let profile = Profile {
        points: Vec::new(),
        interval: None,
        within_tenth: [End::Open; 2],
    };
    Determined {
        best: best.clone(),
        profiles: vec![profile; best.at.len()],
        correlation: None,
        undetermined: None,
        widened: 1.0,
        quadratic: false,
        solved: 0,
    }
}

fn describe(best: &Best, minimum: &Minimum, arms: &[Arm], probable: bool) -> Determined {
    let (near, far) = minimum.rises;
    let profile = |(k, pair): (usize, &[Arm])| {
        let at = minimum.at[k];
        let end = |arm: &Arm, sign: f64, rise: f64| match arm.crossing(rise) {
            Some(distance) if !arm.is_open(rise) => End::At((at + sign * distance).clamp(0.0, 1.0)),
            _ => End::Open,
        };
        let ends = |rise: f64| [end(&pair[0], -1.0, rise), end(&pair[1], 1.0, rise)];
        let below = pair[0].reached.iter().skip(1).rev();
        let points = below
            .chain(&pair[1].reached)
            .map(|reached| point(reached, k));
        Profile {
            points: points.collect(),
            interval: probable.then(|| ends(near)),
            within_tenth: ends(far),
        }
    };
    let profiles: Vec<Profile> = arms.chunks(2).enumerate().map(profile).collect();
    let agrees = |arm: &Arm| match arm.crossing(near) {
        Some(distance) if !arm.is_open(near) => {
            (distance / minimum.width(arm.k, near) - 1.0).abs() <= AGREE
        }
        _ => arm.room <= (1.0 + AGREE) * minimum.width(arm.k, near),
    };
    let open = |k: usize| arms[2 * k].is_open(near) || arms[2 * k + 1].is_open(near);
    let counts = |direction: &Vec<f64>| {
        direction
            .iter()
            .enumerate()
            .any(|(k, d)| d.abs() > COMPONENT && open(k))
    };
    Determined {
        best: Best {
            at: minimum.at.clone(),
            misfit: minimum.misfit,
            ..best.clone()
        },
        profiles,
        correlation: minimum.correlation(),
        widened: minimum.widened,
        undetermined: minimum.direction().filter(counts),
        quadratic: minimum.widened == 1.0
            && minimum.residual <= ROUGH * near
            && arms.iter().all(agrees),
        solved: 0,
    }
}

fn point(reached: &Reached, k: usize) -> ProfilePoint {
    let mut others = reached.at.clone();
    let at = others.remove(k);
    ProfilePoint {
        at,
        misfit: reached.misfit,
        others,
    }
}
