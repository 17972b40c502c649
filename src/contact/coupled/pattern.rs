//! A pattern of contacts at their limits and free ones, and the forces that follow from it.

use super::factor::Factor;

/// Round-off of q_i as part of the sum of its terms: some 500 times the unit round-off, for sums of many terms and solutions of
/// blocks. As part of d_i alone, which may be a small difference of large numbers, it would be too small.
const ROUND_OFF: f64 = 1e-13;

/// Corrections of the free forces by their residual. One is enough unless the block is singular to round-off.
const CORRECTIONS: usize = 3;

/// The place of a force in its box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    Low,
    Free,
    High,
}

/// The numbers of one step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<'a> {
    pub d: &'a [f64],
    pub low: &'a [f64],
    pub high: &'a [f64],
    pub size: &'a [f64],
}

/// The place of each contact, with the factor of the free ones.
#[derive(Debug, Clone)]
pub(super) struct Pattern {
    matrix: Vec<f64>,
    places: Vec<At>,
    /// The free contacts, if `factored`.
    free: Vec<usize>,
    factor: Factor,
    factored: bool,
    /// q = d - A S.
    residual: Vec<f64>,
    /// Right side and solution of the free contacts.
    block: Vec<f64>,
    /// Whether all contacts together are singular.
    singular: bool,
}

impl Pattern {
    /// All contacts at their high limits.
    pub fn new(matrix: Vec<f64>, contacts: usize) -> Pattern {
        let mut factor = Factor::new(contacts);
        let free = Vec::from_iter(0..contacts);
        Pattern {
            singular: !factor.compute(&matrix, &free),
            matrix,
            places: vec![At::High; contacts],
            free,
            factor,
            factored: false,
            residual: vec![0.0; contacts],
            block: vec![0.0; contacts],
        }
    }

    pub fn place(&self, contact: usize) -> At {
        self.places[contact]
    }

    #[inline]
    pub fn put(&mut self, contact: usize, at: At) {
        let was = std::mem::replace(&mut self.places[contact], at);
        self.factored &= was != At::Free && at != At::Free;
    }

    /// Puts contacts with equal limits at them, and takes others away from infinite limits.
    #[inline(always)]
    pub fn adapt(&mut self, contacts: usize, step: Step) {
        for i in 0..contacts {
            let [low, high] = [step.low[i], step.high[i]];
            match self.places[i] {
                At::Free if low == high => self.put(i, At::Low),
                At::Low if low == f64::NEG_INFINITY => self.put(i, At::Free),
                At::High if high == f64::INFINITY => self.put(i, At::Free),
                _ => (),
            }
        }
    }

    /// Factors the free contacts unless it is done; false if they are singular.
    #[inline]
    pub fn factor(&mut self) -> bool {
        if self.factored {
            return true;
        }
        self.free.clear();
        for (i, at) in self.places.iter().enumerate() {
            if *at == At::Free {
                self.free.push(i);
            }
        }
        self.factored = self.factor.compute(&self.matrix, &self.free);
        self.factored
    }

    /// The forces by A_FF S_F = d_F - A_FB S_B, and q; false if the free contacts have a residual above round-off.
    #[inline(always)]
    pub fn follow(&mut self, contacts: usize, step: Step, force: &mut [f64]) -> bool {
        let (q, x) = (&mut self.residual[..contacts], &mut self.block[..contacts]);
        let force = &mut force[..contacts];
        q.copy_from_slice(&step.d[..contacts]);
        let (low, high) = (&step.low[..contacts], &step.high[..contacts]);
        for (i, at) in self.places[..contacts].iter().enumerate() {
            let s = match at {
                At::Low => low[i],
                At::Free => 0.0,
                At::High => high[i],
            };
            force[i] = s;
            if s != 0.0 {
                take(&self.matrix, i, s, q);
            }
        }
        for _ in 0..=CORRECTIONS {
            x.copy_from_slice(q);
            self.factor.solve(contacts, x);
            for i in 0..contacts {
                force[i] += x[i];
                take(&self.matrix, i, x[i], q);
            }
            let held = |(i, at): (usize, &At)| {
                *at == At::Free && !is_round_off(&self.matrix, i, q, step, force)
            };
            if !self.places[..contacts].iter().enumerate().any(held) {
                return true;
            }
        }
        false
    }

    /// The place that a contact has to change to; `None` if its place is right.
    ///
    /// A force that is outside its limits by round-off goes to the limit. There q is round-off, so that it stays.
    #[inline(always)]
    pub fn better_place(&self, contact: usize, step: Step, force: &[f64]) -> Option<At> {
        let [q, s] = [self.residual[contact], force[contact]];
        let [low, high] = [step.low[contact], step.high[contact]];
        let pressed = match self.places[contact] {
            At::Free if s < low => return Some(At::Low),
            At::Free if s > high => return Some(At::High),
            At::Free => return None,
            At::Low => q <= 0.0,
            At::High => q >= 0.0,
        };
        let right = pressed
            || low == high
            || is_round_off(&self.matrix, contact, &self.residual, step, force);
        (!right).then_some(At::Free)
    }

    /// Whether these forces, which are right, are the only ones: contacts that q does not press against a limit are not singular.
    pub fn is_unique(&mut self, step: Step, force: &[f64]) -> bool {
        if !self.singular {
            return true;
        }
        let movable = |i: &usize| {
            step.low[*i] < step.high[*i]
                && is_round_off(&self.matrix, *i, &self.residual, step, force)
        };
        let movable = Vec::from_iter((0..force.len()).filter(movable));
        if movable == self.free {
            return true;
        }
        self.factored = false;
        self.factor.compute(&self.matrix, &movable)
    }
}

#[inline]
fn row(matrix: &[f64], row: usize, width: usize) -> &[f64] {
    &matrix[row * width..][..width]
}

/// Takes the part of a force off q.
#[inline(always)]
fn take(matrix: &[f64], contact: usize, force: f64, q: &mut [f64]) {
    let column = row(matrix, contact, q.len());
    for (q, a) in q.iter_mut().zip(column) {
        *q -= a * force;
    }
}

/// Whether q is round-off of its terms.
#[inline(always)]
fn is_round_off(matrix: &[f64], contact: usize, q: &[f64], step: Step, force: &[f64]) -> bool {
    let [size, sum] = [step.size[contact], q[contact].abs()];
    // Most often the first of the terms is enough.
    sum <= ROUND_OFF * size || {
        let terms = row(matrix, contact, force.len()).iter().zip(force);
        sum <= ROUND_OFF * (size + terms.map(|(a, s)| (a * s).abs()).sum::<f64>())
    }
}
