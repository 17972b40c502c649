//! Forces of many contacts with any laws S = f(r') that do not fall, at the end of a step.
//!
//! As for clipped lines, r' = d - H S; the forces minimise 1/2 S^T H S - S^T d + sum phi_i(S_i), where phi_i' is the inverse of f_i.
//! A law gives its answer alone, J(y): the S of r' = y - a S, S = f(r'). It is one number for every y, also where f jumps, and its
//! slope is from 0 to 1/a. With M = diag(a) - H the forces are the fixed point S = J(d + M S).
//!
//! If M is positive definite, the fixed point is the minimum of the forward-backward envelope (Patrinos, Stella and Bemporad 2014)
//!
//! ```text
//! E(S) = 1/2 S^T M S - sum e_i(d_i + (M S)_i),   e' = J,   E' = M (S - J),   E'' = M - M diag(J') M
//! ```
//!
//! Since J' <= 1/a, E'' is at least M - M diag(1/a) M = M diag(1/a) H, which has no negative eigenvalue: E is convex, and E' is
//! continuous. Newton's step from S replaces each law by its tangent at J, cut to the bounds of its force. That is a problem of
//! clipped lines ([`CoupledForces`](super::CoupledForces)) with the same E' at S and a convex envelope, whose minimum is J + x with
//! (H + diag(1/f')) x = M (J - S) within the bounds. So the step leads downhill, whatever slopes f' > 0 it uses.
//!
//! A step is taken if it halves the least residual so far. If not, it is taken as far as E falls along it, which the sign of E'
//! tells. The first happens only as often as a residual can be halved to round-off; steps of the second kind alone lead to the
//! minimum, because E is convex. So the search does not cycle.
//!
//! A law may also fall as long as its answer is one number that follows y without jumps: then J' < 0, and E'' is only larger. In
//! steps such a law counts as level.

mod laws;
mod point;
mod tangents;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_convex;
#[cfg(test)]
mod tests_plane;
mod unique;

pub use laws::{Directions, Laws};

use super::Unsolved;
use super::factor::Factor;
use super::matrix::{Matrix, ROUND_OFF};
use point::Point;
use tangents::Tangents;

/// Residual of r' = d - H S, as part of the sum of its terms, at which the search ends at once.
const TARGET: f64 = 1e-15;

/// Steps that do not halve the residual, after which round-off is enough.
const STALLS: usize = 3;

/// Most steps; few problems have needed more than 20.
const STEPS: usize = 1000;

/// Evaluations of a search along a step.
const TRIES: usize = 60;

/// Part of the slope of E at the start of a step that may remain at its end.
const SLOPE: f64 = 0.3;

/// a_i - H_ii as part of sum_j |H_ij| sqrt(H_ii/H_jj); M is positive definite above 1.
const EXCESS: f64 = 1.25;

/// Largest 1/f' as part of a, at which the force still follows.
const LEVEL: f64 = 1e30;

/// Minimises 1/2 S^T H S - S^T d + sum phi_i(S_i), step after step.
#[derive(Debug, Clone)]
pub struct CurvedForces {
    contacts: usize,
    /// H by rows.
    flexibility: Vec<f64>,
    /// a.
    own: Vec<f64>,
    /// M by rows.
    coupling: Vec<f64>,
    /// Whether H is singular.
    singular: bool,
    now: Point,
    next: Point,
    tangents: Tangents,
    steps: usize,
}

/// The numbers of a step.
#[derive(Clone, Copy)]
struct Numbers<'a> {
    d: &'a [f64],
    size: &'a [f64],
    laws: &'a dyn Laws,
}

impl Numbers<'_> {
    /// 1/f'; infinite where a law or a chord of it does not rise.
    fn compliance(&self, contact: usize, y: f64, force: f64, width: f64) -> f64 {
        match self.laws.compliance(contact, y, force, width) {
            g if g >= 0.0 => g,
            _ => f64::INFINITY,
        }
    }
}

impl CurvedForces {
    /// `flexibility`: H, row-major, symmetric positive semidefinite.
    pub fn new(flexibility: Vec<f64>, contacts: usize) -> CurvedForces {
        CurvedForces::with_planes(flexibility, contacts, &[])
    }

    /// The same with contacts in a plane: each of `planes` and the next row are the components of one.
    pub fn with_planes(flexibility: Vec<f64>, contacts: usize, planes: &[usize]) -> CurvedForces {
        let m = contacts;
        let h = |i: usize, j: usize| flexibility[i * m + j];
        // Without the round-off of a - H_ii, so that M = 0 for contacts that do not move each other.
        let excess = |i: usize| {
            let others = (0..m).filter(|j| *j != i && h(i, *j) != 0.0);
            let part = |j: usize| h(i, j).abs() * (h(i, i) / h(j, j)).sqrt();
            EXCESS * others.map(part).sum::<f64>()
        };
        let mut flexibilities: Vec<f64> = (0..m).map(|i| h(i, i) + excess(i)).collect();
        // One a for both components, so that the answer has no preferred direction.
        for i in planes {
            let most = flexibilities[*i].max(flexibilities[i + 1]);
            flexibilities[*i..i + 2].fill(most);
        }
        let mut coupling: Vec<f64> = flexibility.iter().map(|h| -h).collect();
        let mut regular = flexibility.clone();
        for i in 0..m {
            coupling[i * m + i] = match planes.iter().any(|p| *p == i || p + 1 == i) {
                true => flexibilities[i] - h(i, i),
                false => excess(i),
            };
            regular[i * m + i] += flexibilities[i];
        }
        let every_contact = Vec::from_iter(0..m);
        let singular =
            !Factor::new(m).compute(&Matrix::new(flexibility.clone(), m), &every_contact);
        let point = Point::new(m);
        let tangents = Tangents::new(regular, m);
        CurvedForces {
            contacts,
            flexibility,
            own: flexibilities,
            coupling,
            singular,
            now: point.clone(),
            next: point,
            tangents,
            steps: 0,
        }
    }

    /// The flexibility a with which a contact has to answer.
    pub fn flexibility(&self, contact: usize) -> f64 {
        self.own[contact]
    }

    /// Number of Newton's steps to the last answer.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// y of a contact in the last answer, S = J(y).
    pub fn argument(&self, contact: usize) -> f64 {
        self.now.y[contact]
    }

    /// Forces of a step; the slices have one number for each contact. `force` has a guess at the start.
    ///
    /// `size[i]` is the size of the numbers that `d[i]` is the difference of.
    ///
    /// # Errors
    /// The forces are not unique, or a number is not finite.
    pub fn solve(
        &mut self,
        d: &[f64],
        size: &[f64],
        laws: &dyn Laws,
        force: &mut [f64],
    ) -> Result<(), Unsolved> {
        if d.iter().any(|d| !d.is_finite()) {
            return Err(Unsolved::TooManyRounds);
        }
        let step = Numbers { d, size, laws };
        for (s, guess) in self.now.force.iter_mut().zip(&*force) {
            *s = if guess.is_finite() { *guess } else { 0.0 };
        }
        self.now.evaluate(step, &self.coupling, &self.own);
        self.search(step)?;
        force.copy_from_slice(&self.now.answer);
        match self.is_unique(step) {
            true => Ok(()),
            false => Err(Unsolved::Singular),
        }
    }

    /// Moves `now` to the minimum.
    fn search(&mut self, step: Numbers) -> Result<(), Unsolved> {
        self.steps = 0;
        let (mut least, mut stalls) = (self.now.residual, 0);
        loop {
            if self.now.residual <= TARGET {
                return Ok(());
            }
            if !self.now.residual.is_finite() || self.steps == STEPS {
                return Err(Unsolved::TooManyRounds);
            }
            self.steps += 1;
            let (own_flexibilities, flexibility) = (&self.own, &self.flexibility);
            let steps = self.steps;
            if !(self.tangents).solve(step, &self.now, own_flexibilities, flexibility, steps) {
                self.average(step);
                continue;
            }
            self.go(step, 1.0);
            if self.next.residual <= 0.5 * least {
                (least, stalls) = (self.next.residual, 0);
                std::mem::swap(&mut self.now, &mut self.next);
                continue;
            }
            stalls += 1;
            let falls = self.descend(step);
            if (!falls || stalls > STALLS) && self.is_round_off() {
                return Ok(());
            }
            if !falls {
                self.average(step);
            }
        }
    }

    /// `next` is a part of the step from `now`.
    fn go(&mut self, step: Numbers, part: f64) {
        for (i, s) in self.next.force.iter_mut().enumerate() {
            *s = self.now.force[i] + part * self.tangents.change[i];
        }
        self.next.evaluate(step, &self.coupling, &self.own);
    }

    /// Goes from `next` at the end of the step to where E falls along the step from `now` by a part of its slope at the start;
    /// false if it does not fall.
    fn descend(&mut self, step: Numbers) -> bool {
        let slope = self.now.slope(&self.tangents.change);
        let falls = slope < 0.0;
        if !falls {
            return false;
        }
        let [mut low, mut high, mut part] = [0.0, 1.0, 1.0];
        for _ in 0..TRIES {
            let there = self.next.slope(&self.tangents.change);
            if there > 0.0 {
                high = part;
            } else if there >= SLOPE * slope || part == 1.0 {
                std::mem::swap(&mut self.now, &mut self.next);
                return true;
            } else {
                low = part;
            }
            part = 0.5 * (low + high);
            self.go(step, part);
        }
        false
    }

    /// S = J(y), which leads downhill, too.
    fn average(&mut self, step: Numbers) {
        self.now.force.copy_from_slice(&self.now.answer);
        self.now.evaluate(step, &self.coupling, &self.own);
    }

    /// Whether the residual is round-off of the terms of y, and of the answers, which follow y with the slopes of the step.
    fn is_round_off(&self) -> bool {
        let m = self.contacts;
        let point = &self.now;
        let slope = |j: usize| 1.0 / (self.own[j] + self.tangents.compliance[j]);
        (0..m).all(|i| {
            let row = &self.coupling[i * m..(i + 1) * m];
            let entries = row.iter().enumerate();
            let answers = entries.map(|(j, m)| m.abs() * point.terms[j] * slope(j));
            let terms = point.terms[i] + answers.sum::<f64>();
            point.rest[i].abs() <= ROUND_OFF * terms
        })
    }
}
