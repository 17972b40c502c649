//! A point of the search.

use super::{Laws, Numbers};

/// A point of the search.
#[derive(Debug, Clone)]
pub(super) struct Point {
    /// S.
    pub(super) force: Vec<f64>,
    /// y = d + M S.
    pub(super) y: Vec<f64>,
    /// Sizes of the terms of y and J.
    pub(super) terms: Vec<f64>,
    /// J(y).
    pub(super) answer: Vec<f64>,
    /// M (J - S), the residual of r' = d - H J.
    pub(super) rest: Vec<f64>,
    /// The largest of its parts of the terms; not finite only if a number is not.
    pub(super) residual: f64,
}

impl Point {
    pub(super) fn new(contacts: usize) -> Point {
        let zero = || vec![0.0; contacts];
        Point {
            force: zero(),
            y: zero(),
            terms: zero(),
            answer: zero(),
            rest: zero(),
            residual: f64::INFINITY,
        }
    }

    /// y, J and the residual of the forces.
    pub(super) fn evaluate(&mut self, step: Numbers, coupling: &[f64], flexibilities: &[f64]) {
        let m = flexibilities.len();
        for i in 0..m {
            let [mut y, mut terms] = [step.d[i], step.size[i]];
            for (m, s) in coupling[i * m..(i + 1) * m].iter().zip(&self.force) {
                y += m * s;
                terms += (m * s).abs();
            }
            self.y[i] = y;
            self.terms[i] = terms;
        }
        self.answer(step.laws, flexibilities);
        self.residual = 0.0;
        for i in 0..m {
            let row = coupling[i * m..(i + 1) * m].iter();
            let pairs = row.zip(self.answer.iter().zip(&self.force));
            self.rest[i] = pairs.map(|(m, (j, s))| m * (j - s)).sum();
            let part = part(self.rest[i], self.terms[i]);
            // A part that is not finite stays.
            if part > self.residual || part.is_nan() {
                self.residual = part;
            }
        }
    }

    /// J(y), and its part of the terms.
    fn answer(&mut self, laws: &dyn Laws, flexibilities: &[f64]) {
        let mut i = 0;
        while i < flexibilities.len() {
            if laws.is_plane(i) {
                let answer = laws.answer_plane(i, [self.y[i], self.y[i + 1]]);
                self.answer[i..i + 2].copy_from_slice(&answer);
                // A direction that turns mixes both components.
                let size = flexibilities[i] * (answer[0].abs() + answer[1].abs());
                let terms = self.terms[i] + self.terms[i + 1] + size;
                self.terms[i..i + 2].fill(terms);
                i += 2;
                continue;
            }
            let answer = laws.answer(i, self.y[i]);
            self.answer[i] = answer;
            self.terms[i] += flexibilities[i] * answer.abs();
            i += 1;
        }
    }

    /// The slope of E along a change of S.
    pub(super) fn slope(&self, change: &[f64]) -> f64 {
        let products = self.rest.iter().zip(change).map(|(rest, c)| rest * c);
        -products.sum::<f64>()
    }
}

/// A residual as part of its terms. A body at rest has terms of exactly 0 while the forces on others already leave a residual: that
/// part is large, but as finite as the numbers.
fn part(rest: f64, terms: f64) -> f64 {
    if rest == 0.0 {
        return 0.0;
    }
    let part = rest.abs() / terms;
    match rest.is_finite() && terms.is_finite() {
        true => part.min(f64::MAX),
        false => f64::NAN,
    }
}
