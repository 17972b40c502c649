//! Points are computed many at a time: those of all searches that run next to one another.

use super::{Objective, Stopped};

/// An objective with the number of points computed and the best of them.
pub struct Counted<'a> {
    objective: &'a mut dyn Objective,
    /// Most points.
    limit: u64,
    pub solved: u64,
    /// The first of the points with the smallest misfit.
    pub best: Option<(Vec<f64>, f64)>,
}

impl<'a> Counted<'a> {
    pub fn new(objective: &'a mut dyn Objective, limit: u64) -> Counted<'a> {
        Counted {
            objective,
            limit,
            solved: 0,
            best: None,
        }
    }

    /// Number of points that can still be computed.
    pub fn left(&self) -> u64 {
        self.limit - self.solved
    }

    /// The misfits of points; those that are no numbers, or missing, are infinite. `None` if they are more than are left.
    pub fn misfits(&mut self, points: &[Vec<f64>]) -> Result<Option<Vec<f64>>, Stopped> {
        if points.len() as u64 > self.left() {
            return Ok(None);
        }
        let mut misfits = self.objective.misfits(points)?;
        self.solved += points.len() as u64;
        misfits.resize(points.len(), f64::INFINITY);
        for (point, misfit) in points.iter().zip(&mut misfits) {
            if !misfit.is_finite() {
                *misfit = f64::INFINITY;
            }
            if self.best.as_ref().is_none_or(|(_, best)| *misfit < *best) {
                self.best = Some((point.clone(), *misfit));
            }
        }
        Ok(Some(misfits))
    }
}

/// A search that asks for points and is given their misfits.
pub trait Asking {
    /// The next points; none at the end.
    fn ask(&mut self) -> Vec<Vec<f64>>;
    /// Their misfits.
    fn tell(&mut self, misfits: &[f64]);
}

/// How a round ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Round {
    Next,
    /// No search asks for points.
    Ended,
    /// Fewer points are left than are asked for.
    Spent,
}

/// The next points of all searches, in one call.
pub fn round<T: Asking>(searches: &mut [T], counted: &mut Counted) -> Result<Round, Stopped> {
    let asked: Vec<Vec<Vec<f64>>> = searches.iter_mut().map(T::ask).collect();
    let counts: Vec<usize> = asked.iter().map(Vec::len).collect();
    let points: Vec<Vec<f64>> = asked.into_iter().flatten().collect();
    if points.is_empty() {
        return Ok(Round::Ended);
    }
    let Some(misfits) = counted.misfits(&points)? else {
        return Ok(Round::Spent);
    };
    let mut rest = misfits.as_slice();
    for (search, count) in searches.iter_mut().zip(counts) {
        let (of_search, after) = rest.split_at(count);
        if count > 0 {
            search.tell(of_search);
        }
        rest = after;
    }
    Ok(Round::Next)
}

/// The misfit with its square as size: of a root of a mean square, a smooth function at its minimum.
pub fn squared(misfit: f64) -> f64 {
    misfit * misfit.abs()
}
