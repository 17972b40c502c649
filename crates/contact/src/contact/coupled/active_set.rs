//! A pattern of contacts at their limits and free ones, and the forces that follow from it.

use super::factor::Factor;
use super::matrix::Matrix;
use super::step::Step;

/// The place of a force in its box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    Low,
    Free,
    High,
}

/// The place of each contact, with the factor of the free ones.
#[derive(Debug, Clone)]
pub(super) struct ActiveSet {
    matrix: Matrix,
    places: Vec<At>,
    /// The free contacts, if `factored`.
    free: Vec<usize>,
    factor: Factor,
    factored: bool,
    /// q = d - A S.
    residual: Vec<f64>,
    /// The forces of the free contacts.
    block: Vec<f64>,
    /// Whether all contacts together are singular.
    singular: bool,
    /// If so: contacts that q does not press against a limit.
    movable: Vec<usize>,
}

impl ActiveSet {
    /// All contacts at their high limits.
    pub(super) fn new(matrix: Matrix) -> ActiveSet {
        let contacts = matrix.width();
        let mut factor = Factor::new(contacts);
        let free = Vec::from_iter(0..contacts);
        ActiveSet {
            singular: !factor.compute(&matrix, &free),
            matrix,
            places: vec![At::High; contacts],
            free,
            factor,
            factored: false,
            residual: vec![0.0; contacts],
            block: vec![0.0; contacts],
            movable: Vec::with_capacity(contacts),
        }
    }

    /// Whether all contacts together are singular.
    pub(super) fn is_singular(&self) -> bool {
        self.singular
    }

    pub(super) fn diagonal(&self, contact: usize) -> f64 {
        self.matrix.row(contact)[contact]
    }

    /// Changes A_ii to another positive number.
    pub(super) fn set_diagonal(&mut self, contact: usize, value: f64) {
        self.matrix.set_diagonal(contact, value);
        self.factored = false;
    }

    /// Changes A_ii, A_ij and A_jj, j = i + 1; A stays positive definite.
    pub(super) fn set_pair(&mut self, contact: usize, entries: [f64; 3]) {
        self.matrix.set_pair(contact, entries);
        self.factored = false;
    }

    pub(super) fn place(&self, contact: usize) -> At {
        self.places[contact]
    }

    #[inline]
    pub(super) fn put(&mut self, contact: usize, at: At) {
        let was = std::mem::replace(&mut self.places[contact], at);
        self.factored &= was != At::Free && at != At::Free;
    }

    /// Puts contacts with equal limits at them, and takes others away from infinite limits.
    #[inline(always)]
    pub(super) fn adapt(&mut self, contacts: usize, step: Step) {
        for i in 0..contacts {
            let [low, high] = [step.low[i], step.high[i]];
            match self.places[i] {
                At::Free if low == high => self.put(i, At::Low),
                At::Low if low == f64::NEG_INFINITY => self.put(i, At::Free),
                At::High if high == f64::INFINITY => self.put(i, At::Free),
                At::Low | At::Free | At::High => (),
            }
        }
    }

    /// Factors the free contacts unless it is done; false if they are singular.
    #[inline]
    pub(super) fn factor(&mut self) -> bool {
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

    /// The forces by A_FF S_F = d_F - A_FB S_B, and q; false if they are not finite. The residual of the free contacts is round-off
    /// because they are not singular.
    ///
    /// `contacts` is their number, which the compiler may know.
    #[inline(always)]
    pub(super) fn follow(&mut self, contacts: usize, step: Step, force: &mut [f64]) -> bool {
        let (q, x) = (&mut self.residual[..contacts], &mut self.block[..contacts]);
        q.copy_from_slice(step.d);
        for (i, at) in self.places[..contacts].iter().enumerate() {
            let s = match at {
                At::Low => step.low[i],
                At::Free => 0.0,
                At::High => step.high[i],
            };
            force[i] = s;
            if s != 0.0 {
                self.matrix.take(i, s, q);
            }
        }
        if !self.free.is_empty() {
            x.copy_from_slice(q);
            self.factor.solve(contacts, x);
            for i in 0..contacts {
                force[i] += x[i];
                self.matrix.take(i, x[i], q);
            }
        }
        force.iter().all(|s| s.is_finite())
    }

    /// The place that a contact has to change to; `None` if its place is right.
    ///
    /// A force that is outside its limits by round-off goes to the limit. There q is round-off, so that it stays.
    #[inline(always)]
    pub(super) fn better_place(&self, contact: usize, step: Step, force: &[f64]) -> Option<At> {
        let [q, s] = [self.residual[contact], force[contact]];
        let [low, high] = [step.low[contact], step.high[contact]];
        let pressed = match self.places[contact] {
            At::Free if s < low => return Some(At::Low),
            At::Free if s > high => return Some(At::High),
            At::Free => return None,
            At::Low => q <= 0.0,
            At::High => q >= 0.0,
        };
        let right = pressed || low == high || self.matrix.is_round_off(contact, q, step, force);
        (!right).then_some(At::Free)
    }

    /// Whether these forces, which are right, are the only ones: contacts that q does not press against a limit are not singular.
    pub(super) fn is_unique(&mut self, step: Step, force: &[f64]) -> bool {
        if !self.singular {
            return true;
        }
        self.movable.clear();
        for i in 0..force.len() {
            let hidden = self.matrix.is_round_off(i, self.residual[i], step, force);
            if self.places[i] == At::Free || hidden && step.low[i] < step.high[i] {
                self.movable.push(i);
            }
        }
        if self.movable == self.free {
            return true;
        }
        self.factored = false;
        self.factor.compute(&self.matrix, &self.movable)
    }
}
