//! Forces of rigid contacts: within bounds, and within discs in a plane.

use super::curved::{CurvedForces, Directions, Laws};
use super::{CoupledForces, Unsolved};
use crate::contact::pair::{Pair, length};

/// Minimises 1/2 S^T A S - S^T d over intervals, and discs where contacts are in a plane.
pub enum RigidForces {
    /// Within bounds.
    Intervals(Box<CoupledForces>),
    /// Also within discs; which rows are the first ones of a plane.
    Discs(Box<CurvedForces>, Vec<bool>),
}

impl RigidForces {
    /// A by rows, and which rows are the first of two in a plane.
    pub fn new(flexibility: Vec<f64>, firsts: Vec<bool>) -> RigidForces {
        let m = firsts.len();
        let planes: Vec<usize> = (0..m).filter(|i| firsts[*i]).collect();
        match planes.is_empty() {
            true => RigidForces::Intervals(Box::new(CoupledForces::new(flexibility, m))),
            false => {
                let forces = CurvedForces::with_planes(flexibility, m, &planes);
                RigidForces::Discs(Box::new(forces), firsts)
            }
        }
    }

    /// The forces; of a plane the bounds of its first row are the radius of its disc.
    ///
    /// # Errors
    /// The forces are not unique, or a number is not finite.
    pub fn solve(
        &mut self,
        d: &[f64],
        [low, high]: [&[f64]; 2],
        size: &[f64],
        force: &mut [f64],
    ) -> Result<(), Unsolved> {
        match self {
            RigidForces::Intervals(forces) => forces.solve(d, low, high, size, force),
            RigidForces::Discs(forces, firsts) => {
                let flexibilities = (0..firsts.len()).map(|i| forces.flexibility(i)).collect();
                let laws = Bounded {
                    own: flexibilities,
                    low,
                    high,
                    firsts,
                };
                forces.solve(d, size, &laws, force)
            }
        }
    }
}

/// Rigid laws: a force follows its contact until it is at its bound.
struct Bounded<'a> {
    own: Vec<f64>,
    low: &'a [f64],
    high: &'a [f64],
    firsts: &'a [bool],
}

impl Laws for Bounded<'_> {
    fn answer(&self, contact: usize, y: f64) -> f64 {
        let [low, high] = self.bounds(contact);
        (y / self.own[contact]).clamp(low, high)
    }

    fn compliance(&self, contact: usize, _: f64, force: f64, _: f64) -> f64 {
        let [low, high] = self.bounds(contact);
        let is_inside = low < force && force < high;
        if is_inside { 0.0 } else { f64::INFINITY }
    }

    fn bounds(&self, contact: usize) -> [f64; 2] {
        [self.low[contact], self.high[contact]]
    }

    fn is_plane(&self, contact: usize) -> bool {
        self.firsts[contact]
    }

    fn answer_plane(&self, contact: usize, y: Pair) -> Pair {
        let limit = self.high[contact];
        let force = y.map(|y| y / self.own[contact]);
        let size = length(force);
        let share = if size > limit { limit / size } else { 1.0 };
        force.map(|s| s * share)
    }

    fn directions(&self, contact: usize, y: Pair, _: Pair) -> Directions {
        let (limit, flexibility, size) = (self.high[contact], self.own[contact], length(y));
        match size > limit * flexibility {
            true => Directions {
                along: y.map(|y| y / size),
                slopes: [f64::INFINITY, size / limit - flexibility],
            },
            false => Directions {
                along: [1.0, 0.0],
                slopes: [0.0; 2],
            },
        }
    }
}
