//! Metrics of the contact: duration, separations, oscillation of rdot, impulse.

use super::Sampled;
use crate::lane::Lane;
use crate::metrics::norm::rms_over_samples;

/// Two durations of the contact: from the first zero of r (falling) to the last zero of r (rising), with r linear between steps;
/// and in whole steps, from the last step before the first overlap to the first step after the last one.
///
/// NaN if r is never negative, or is negative at the last step.
#[inline(always)]
pub fn durations<const L: usize>(r: &[Lane<L>], step: f64) -> [Lane<L>; 2] {
    // Step numbers as floating-point numbers: a lane needs one comparison in a step.
    let mut last = Lane::splat(0.0);
    for (i, r) in r.iter().enumerate() {
        let i = i as f64;
        last = last.zip(*r, |last, r| if r < 0.0 { i } else { last });
    }
    let mut durations = [Lane::splat(f64::NAN); 2];
    for l in 0..L {
        let first = r.iter().position(|r| r.0[l] < 0.0);
        let after = last.0[l] as usize + 1;
        if let Some(before) = first.and_then(|first| first.checked_sub(1))
            && after < r.len()
        {
            let zero = |i: usize| i as f64 + share(r[i].0[l], r[i + 1].0[l]);
            durations[0].0[l] = (zero(after - 1) - zero(before)) * step;
            durations[1].0[l] = after as f64 * step - before as f64 * step;
        }
    }
    durations
}

/// The share of a step after which r, linear from `before` to `after`, is zero.
fn share(before: f64, after: f64) -> f64 {
    // Halves, so that the difference of two finite numbers is finite.
    let (before, after) = (0.5 * before, 0.5 * after);
    if before == 0.0 {
        0.0
    } else {
        before / (before - after)
    }
}

/// Openings that close again, both within the steps `r`.
#[inline(always)]
pub fn separations<const L: usize>(r: &[Lane<L>]) -> Lane<L> {
    let closed = |r: Lane<L>| r.map(|r| if r < 0.0 { 1.0 } else { 0.0 });
    let Some(first) = r.first().map(|r| closed(*r)) else {
        return Lane::splat(0.0);
    };
    let (mut closings, mut before) = (Lane::splat(0.0), first);
    for r in &r[1..] {
        let now = closed(*r);
        closings = closings + now.zip(before, |now, before| now * (1.0 - before));
        before = now;
    }
    // If the contact is open at the start, the first closing is the first touch.
    closings.zip(
        first,
        |n, first| if n > 0.0 { n - (1.0 - first) } else { n },
    )
}

/// RMS of rdot minus the exact rdot over the steps `exact.watched`; `None` if there are none.
#[inline(always)]
pub fn oscillation<const L: usize>(rdot: &[Lane<L>], exact: &Sampled) -> Option<Lane<L>> {
    let watched = rdot.get(exact.watched.clone())?;
    let mut sum = Lane::splat(0.0);
    for (c, e) in watched.iter().zip(exact.watched_velocity()) {
        let d = *c - Lane::splat(*e);
        sum = sum + d * d;
    }
    let count = watched.len();
    (count > 0).then(|| rms_over_samples(sum, count))
}

/// Integral of the force over the steps, by trapezoids.
#[inline(always)]
pub fn impulse<const L: usize>(force: &[Lane<L>], step: f64) -> Lane<L> {
    match force {
        [first, inner @ .., last] => {
            let mut sum = (*first + *last) * 0.5;
            for f in inner {
                sum = sum + *f;
            }
            sum * step
        }
        [] | [_] => Lane::splat(0.0),
    }
}
