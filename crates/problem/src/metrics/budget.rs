//! The parts of an error: differences of motions in a row, from the exact one to the computed one.

use crate::history::History;

/// The norm of the errors of a motion's first channels.
pub struct Norm<'a> {
    /// Number of channels.
    pub channels: usize,
    /// What errors are divided by.
    pub size: f64,
    /// Sum of `value(i, e)` over the steps, e the exact value of a channel at step i.
    pub sum: &'a dyn Fn(usize, &dyn Fn(usize, f64) -> f64) -> f64,
    /// The norm is the root of the sum of squares over this number.
    pub count: f64,
}

/// The norms of the parts, of each part those of all channels, and then in the same order the shares
/// <part, c - e>/<c - e, c - e>; `between` has the motions between the exact one e and the `computed` one c. A number that is not
/// finite is not defined.
///
/// The shares of a channel add up to 1. A share below 0 or above 1 means that parts have opposite signs.
pub fn parts(between: &[History], computed: &History, norm: &Norm) -> Vec<Option<f64>> {
    let motions: Vec<&History> = between.iter().chain([computed]).collect();
    let (mut norms, mut shares) = (Vec::new(), Vec::new());
    for last in 0..motions.len() {
        for channel in 0..norm.channels {
            let at = |motion: usize, i: usize| motions[motion].channel(channel)[i];
            let part = |i: usize, e: f64| {
                let before = last.checked_sub(1).map_or(e, |before| at(before, i));
                (at(last, i) - before) / norm.size
            };
            let all = |i: usize, e: f64| (at(between.len(), i) - e) / norm.size;
            let sum = |value: &dyn Fn(usize, f64) -> f64| (norm.sum)(channel, value);
            norms.push((sum(&|i, e| part(i, e) * part(i, e)) / norm.count).sqrt());
            let total = sum(&|i, e| all(i, e) * all(i, e));
            shares.push(sum(&|i, e| part(i, e) * all(i, e)) / total);
        }
    }
    let both = norms.into_iter().chain(shares);
    both.map(|x| Some(x).filter(|x| x.is_finite())).collect()
}
