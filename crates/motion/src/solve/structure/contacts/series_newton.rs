//! Newton's method for contacts in series.

use super::in_series::{Series, Shares};
use super::series_root::NEAR;

/// Most steps of Newton's method, and half the width of its chords as part of the size of numbers.
const STEPS: usize = 12;
const WIDTH: f64 = 1e-7;

/// A slope is at least this part of the largest one: a contact that slides has the change that the others leave.
const LEVEL: f64 = 1e-8;

impl Series<'_> {
    /// The answer by Newton's method in S, if all laws have their changes in closed form on the way.
    pub(crate) fn by_changes(&self, y: f64, guess: f64) -> Option<Shares> {
        let mut changes = vec![[0.0; 2]; self.parts.len()];
        let mut force = guess;
        for _ in 0..STEPS {
            let (mut rest, mut slope) = (self.own * force - y, self.own);
            for (i, numbers) in changes.iter_mut().enumerate() {
                *numbers = (self.change)(i, force)?;
                rest += numbers[0];
                slope += numbers[1];
            }
            let step = rest / slope;
            if step.abs() <= NEAR * (force.abs() + self.size / slope) {
                // The softest one has what the others leave, as below.
                let softest =
                    (0..changes.len()).max_by(|i, j| changes[*i][1].total_cmp(&changes[*j][1]))?;
                let mut changes: Vec<f64> = changes.iter().map(|numbers| numbers[0]).collect();
                changes[softest] -= rest;
                return Some(Shares { force, changes });
            }
            force -= step;
        }
        None
    }

    /// The answer by Newton's method from the state of the step before, if it gets there.
    pub(crate) fn newton(&self, y: f64, guess: f64, [low, high]: [f64; 2]) -> Option<Shares> {
        let of_guess = self.parts.iter().map(|part| part.own * guess + part.change);
        let mut places: Vec<f64> = of_guess.collect();
        let of_parts: f64 = self.parts.iter().map(|part| part.own).sum();
        let mut answers = vec![[0.0; 2]; places.len()];
        for _ in 0..STEPS {
            let (mut flexibility, mut sum) = (self.own - of_parts, y);
            let mut steepest = 0.0;
            for (i, (start, answer)) in places.iter().zip(&mut answers).enumerate() {
                let width = WIDTH * (self.size + start.abs());
                let [force, after] = [*start, start + width].map(|y| (self.answer)(i, y));
                let slope = (after - force) / width;
                if slope.is_nan() || slope < 0.0 {
                    return None;
                }
                *answer = [force, slope];
                steepest = f64::max(steepest, slope);
            }
            if steepest == 0.0 {
                return None;
            }
            for (y, [force, slope]) in places.iter().zip(&mut answers) {
                *slope = slope.max(LEVEL * steepest);
                flexibility += 1.0 / *slope;
                sum += *force / *slope - y;
            }
            let force = sum / flexibility;
            if !(low < force && force < high) {
                return None;
            }
            let mut is_near = true;
            for (y, [answered, slope]) in places.iter_mut().zip(&answers) {
                let away = force - answered;
                is_near &= away.abs() <= NEAR * (force.abs() + slope * (self.size + y.abs()));
                *y += away / slope;
            }
            if is_near {
                let pairs = places.iter().zip(self.parts);
                let mut changes: Vec<f64> = pairs.map(|(y, part)| y - part.own * force).collect();
                // Round-off of the force is most of the change of the softest one: it has what the others leave, wherever it is.
                let softest =
                    (0..answers.len()).min_by(|i, j| answers[*i][1].total_cmp(&answers[*j][1]))?;
                changes[softest] = 0.0;
                let others: f64 = changes.iter().sum();
                changes[softest] = y - self.own * force - others;
                return Some(Shares { force, changes });
            }
        }
        None
    }

    /// The change of a contact under a force by Newton's method, where it is the only one and the law is smooth on the way.
    pub(crate) fn only_change(&self, part: usize, force: f64) -> Option<f64> {
        let start = self.parts[part].own * force;
        let mut y = start;
        for _ in 0..STEPS {
            let size = self.size + y.abs();
            let width = WIDTH * size;
            let [before, answered, after] =
                [y - width, y, y + width].map(|at| (self.answer)(part, at));
            let slope = (after - before) / (2.0 * width);
            if !(before < answered && answered < after) {
                return None;
            }
            let away = force - answered;
            y += away / slope;
            if away.abs() <= NEAR * (force.abs() + slope * size) {
                return Some(y - start);
            }
        }
        None
    }
}
