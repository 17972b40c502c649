//! The parts of the error of the friction oscillator.

use crate::history::History;
use crate::lane::Lane;
use crate::metrics::norm::rms_over_samples;

/// The parts of the error for the motion `g` with the softened law in continuous time, which is between the exact motion `e` and
/// the computed motion `c`: the norms of g - e and c - g, defined as `rms_error`, then their shares
/// <part, c - e>/<c - e, c - e>. Not defined if the error is zero.
///
/// The two shares add up to 1. A share above 1 means that the parts have opposite signs.
pub fn budget(x0: f64, c: &History, e: &History, g: &History) -> [Option<f64>; 4] {
    let scale = x0.abs();
    let sum = |a: &History, b: &History, of: &dyn Fn(f64, f64) -> f64| -> f64 {
        let totals = pairs(c, e).map(|(c, e)| (c - e) / scale);
        let parts = pairs(a, b).map(|(a, b)| (a - b) / scale);
        parts.zip(totals).map(|(part, total)| of(part, total)).sum()
    };
    let rms = |a, b| {
        let squares = sum(a, b, &|part, _| part * part);
        rms_over_samples(Lane([squares]), c.len()).0[0]
    };
    let total = sum(c, e, &|total, _| total * total);
    let share = |a, b| sum(a, b, &|part, total| part * total) / total;
    [rms(g, e), rms(c, g), share(g, e), share(c, g)].map(|x| Some(x).filter(|x| x.is_finite()))
}

/// The error of a motion `g` against `coarse`, which has some of its times: the norm of their difference, defined as `rms_error`.
pub fn reference(x0: f64, g: &History, coarse: &History) -> f64 {
    let mut times = g.time.iter().zip(g.displacement());
    let same = coarse.time.iter().zip(coarse.displacement());
    let squares = same.filter_map(|(time, coarse)| {
        let (_, x) = times.find(|(own, _)| *own == time)?;
        let error = (x - coarse) / x0.abs();
        Some(error * error)
    });
    rms_over_samples(Lane([squares.sum::<f64>()]), coarse.len()).0[0]
}

/// Displacements of two histories, step by step.
fn pairs<'a>(c: &'a History, e: &'a History) -> impl Iterator<Item = (f64, f64)> + 'a {
    c.displacement()
        .iter()
        .copied()
        .zip(e.displacement().iter().copied())
}
