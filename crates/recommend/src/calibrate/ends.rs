//! Where independent starts ended, and whether they ended at the same minimum.

use super::Stopped;
use super::counted::{Counted, squared};

/// Misfits within this part of the best are equal.
const SAME: f64 = 0.01;

/// So are misfits within this part of a usual one.
const SAME_SMALL: f64 = 1e-5;

/// So are squared misfits that differ by fewer jumps.
const JUMPS: f64 = 2.0;

/// Points whose coordinates differ by less are the same minimum.
const PLACE: f64 = 0.02;

/// The misfits between two points of the same valley are at most higher by this part.
const VALLEY: f64 = 0.1;

/// Points between two.
const BETWEEN: [f64; 3] = [0.25, 0.5, 0.75];

/// Starts that must end at the same minimum, the best of all.
const AGREEING: usize = 3;

/// Starts of several rounds that must end with the best misfit, if they end at many points: a bent valley.
const ANYWHERE: usize = 5;

/// Ends of starts: points and misfits.
#[derive(Debug, Default)]
pub struct Ends {
    pub all: Vec<(Vec<f64>, f64)>,
    /// A usual misfit.
    pub usual: f64,
    /// The smallest jumps of the squared misfit at an end.
    pub jumps: f64,
}

impl Ends {
    fn limit(&self, best: f64) -> f64 {
        let small = best + (SAME * best.abs()).max(SAME_SMALL * self.usual.abs());
        let jumped = squared(best) + JUMPS * self.jumps;
        small.max(jumped.abs().sqrt().copysign(jumped))
    }

    /// Number of starts that ended with the best misfit.
    pub fn equal(&self, best: f64) -> usize {
        let limit = self.limit(best);
        self.all
            .iter()
            .filter(|(_, misfit)| *misfit <= limit)
            .count()
    }

    /// Whether so many starts ended at the best point that no better one is expected. Points between those that are apart are computed.
    pub fn agree(&self, counted: &mut Counted) -> Result<bool, Stopped> {
        let Some((best, misfit)) = counted.best.clone() else {
            return Ok(false);
        };
        if self.equal(misfit) < AGREEING {
            return Ok(false);
        }
        if self.equal(misfit) >= ANYWHERE {
            return Ok(true);
        }
        let limit = self.limit(misfit);
        let equal = self.all.iter().filter(|(_, misfit)| *misfit <= limit);
        let near = |at: &[f64]| at.iter().zip(&best).all(|(x, b)| (x - b).abs() < PLACE);
        let (same, apart): (Vec<&[f64]>, Vec<&[f64]>) =
            equal.map(|(at, _)| at.as_slice()).partition(|at| near(at));
        let blend = |at: &[f64], part: f64| {
            let pairs = at.iter().zip(&best);
            pairs.map(|(x, b)| b + part * (x - b)).collect::<Vec<f64>>()
        };
        let points = apart
            .iter()
            .flat_map(|at| BETWEEN.map(|part| blend(at, part)));
        let Some(misfits) = counted.misfits(&points.collect::<Vec<_>>())? else {
            return Ok(false);
        };
        let highest = limit + VALLEY * limit.abs();
        let valleys = misfits.chunks(BETWEEN.len());
        let joined = valleys
            .filter(|between| between.iter().all(|m| *m <= highest))
            .count();
        Ok(same.len() + joined >= AGREEING)
    }
}
