//! The parts of an error: differences of motions in a row, from the exact one to the computed one.

use crate::history::History;

/// A number of a step i and the exact value e of a channel there.
pub type Value<'a> = dyn Fn(usize, f64) -> f64 + 'a;

/// The norm of the errors of a motion's first channels.
pub struct Norm<'a> {
    /// Number of channels.
    pub channels: usize,
    /// What errors are divided by.
    pub size: f64,
    /// Sum of the values of a channel over the steps.
    pub sum: &'a dyn Fn(usize, &Value) -> f64,
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
            let whole = |i: usize, e: f64| (at(between.len(), i) - e) / norm.size;
            let sum = |value: &Value| (norm.sum)(channel, value);
            norms.push((sum(&|i, e| part(i, e) * part(i, e)) / norm.count).sqrt());
            let total = sum(&|i, e| whole(i, e) * whole(i, e));
            shares.push(sum(&|i, e| part(i, e) * whole(i, e)) / total);
        }
    }
    let both = norms.into_iter().chain(shares);
    both.map(|x| Some(x).filter(|x| x.is_finite())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_parts_by_hand() {
        // e = 0, 0; g = 2, 0; c = 2, -4; over a size of 2 the parts are (1, 0) and (0, -2), and the error is (1, -2).
        let history = |values: [f64; 2]| History {
            time: vec![0.0, 1.0],
            channels: vec![values.to_vec()],
        };
        let norm = Norm {
            channels: 1,
            size: 2.0,
            sum: &|_, value| value(0, 0.0) + value(1, 0.0),
            count: 2.0,
        };
        let found = parts(&[history([2.0, 0.0])], &history([2.0, -4.0]), &norm);
        let expected = [0.5_f64.sqrt(), 2.0_f64.sqrt(), 0.2, 0.8];
        assert_eq!(found, expected.map(Some));
        // A part with another sign has a negative share; all motions alike have no error to share.
        let found = parts(&[history([-2.0, 0.0])], &history([2.0, -4.0]), &norm);
        assert_eq!(found[2..], [Some(-0.2), Some(1.2)]);
        let none = parts(&[history([0.0; 2])], &history([0.0; 2]), &norm);
        assert_eq!(none, [Some(0.0), Some(0.0), None, None]);
    }
}
