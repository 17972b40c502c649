//! The error of an exact motion, as the convergence of the steps shows it.
//!
//! A second integration with a coarser tolerance has the start and the equations of the first one, and their faults. Steps have
//! their own. Motions by steps of dt, dt/2, dt/4 .. tend to a limit. Where each of their differences is at most q < 1 times the one
//! before, the last motion is at most d q/(1 - q) from the limit, with d a bound of the last difference. What is left of the distance of
//! the last motion from the exact one is an error of the exact one.

use super::structure::rms_error;
use crate::exact::adaptive::coarse_times;

/// Motions in a row whose differences are compared.
const WINDOW: usize = 5;

/// Most halvings of the step.
pub const MOST_HALVINGS: u32 = 6;

/// Halvings after which an error has been seen twice.
pub const ENOUGH_HALVINGS: u32 = 5;

/// Halved steps in place of a step at least: those of four halvings.
pub const FEWEST_HALVED: u64 = 2 + 4 + 8 + 16;

/// The least q: that of the second order. Corners of laws make differences uneven, and one that is small by chance has no meaning.
const LEAST_RATIO: f64 = 0.25;

/// How many times as far from the limit the last motion may be. With corners, q is not the same in each halving.
const MARGIN: f64 = 4.0;

/// Differences of motions over their largest value that may be round-off of the steps.
const ROUND_OFF: f64 = 1e-10;

/// A channel of an exact motion.
pub struct Referred {
    /// Its values at the steps.
    pub exact: Vec<f64>,
    /// The same of the computed motion.
    pub computed: Vec<f64>,
    /// The size of its terms, whose round-off it has.
    pub size: f64,
    /// Its error by two tolerances.
    pub estimate: f64,
}

/// The channels of a motion with halved steps.
pub struct Halved {
    /// Their values at the steps that are not halved.
    pub channels: Vec<Vec<f64>>,
    /// Whether the steps resolve the motion.
    pub resolved: bool,
}

/// The norm over `size` of the difference of an exact motion and the same at [`coarse_times`].
pub fn difference(motion: &[f64], coarse: &[f64], size: f64) -> f64 {
    let same = coarse_times(motion);
    let differences = same
        .iter()
        .zip(coarse)
        .map(|(finer, coarse)| (finer - coarse) / size);
    let squares: f64 = differences.map(|error| error * error).sum();
    (squares / coarse.len() as f64).sqrt()
}

/// What the steps cannot explain of the distance of the last of these motions from the exact one, 0 if they can; `None` where they do
/// not converge. Values at t = 0 do not count: forces may jump there.
fn unexplained(motions: &[&[f64]], exact: &[f64], size: f64) -> Option<f64> {
    let distance = |a: &[f64], b: &[f64]| {
        let later = |x| <[f64]>::get(x, 1..).unwrap_or_default();
        rms_error(later(a), later(b))
    };
    let distances = motions.windows(2).map(|pair| distance(pair[0], pair[1]));
    let differences: Vec<f64> = distances.collect();
    let round_off = ROUND_OFF * size;
    let ratios = differences.windows(2).map(|pair| pair[1] / pair[0]);
    let q = ratios.fold(LEAST_RATIO, f64::max);
    let bound = differences
        .iter()
        .fold(0.0, |d: f64, difference| difference.max(d * q));
    let left = match differences.iter().all(|d| *d <= round_off) {
        true => 0.0,
        false if q < 1.0 => bound * q / (1.0 - q),
        false => return None,
    };
    let error = distance(motions.last()?, exact) - MARGIN * (left + round_off);
    Some(error.max(0.0)).filter(|x| x.is_finite())
}

/// The errors of the channels of an exact motion: each the larger one of its estimate, and what the steps cannot explain after two
/// halvings in a row. Steps are halved until they explain all but the estimates, at most [`MOST_HALVINGS`] times. `halved` gives the
/// motion with steps of dt/2^k; `None` ends the halvings.
pub fn reference_errors(
    channels: &[Referred],
    mut halved: impl FnMut(u32) -> Option<Halved>,
) -> Vec<f64> {
    let computed = channels.iter().map(|referred| referred.computed.clone());
    let mut motions: Vec<Vec<Vec<f64>>> = vec![computed.collect()];
    let mut seen: [Vec<Option<f64>>; 2] = Default::default();
    for halvings in 1..=MOST_HALVINGS {
        let Some(next) = halved(halvings) else { break };
        motions.push(next.channels);
        let Some(first) = motions.len().checked_sub(WINDOW) else {
            continue;
        };
        let of_channel = |(channel, referred): (usize, &Referred)| {
            let window: Option<Vec<&[f64]>> = motions[first..]
                .iter()
                .map(|motion| Some(&motion.get(channel)?[..]))
                .collect();
            unexplained(&window?, &referred.exact, referred.size).filter(|_| next.resolved)
        };
        let now: Vec<Option<f64>> = channels.iter().enumerate().map(of_channel).collect();
        let explained =
            |(x, referred): (&Option<f64>, &Referred)| x.is_some_and(|x| x <= referred.estimate);
        let all_explained = now.iter().zip(channels).all(explained);
        let [_, before] = seen;
        seen = [before, now];
        if all_explained {
            break;
        }
    }
    let [before, last] = seen;
    let pairs = before.iter().zip(&last);
    let mut twice = pairs.map(|(a, b)| a.zip(*b).map_or(0.0, |(a, b)| a.min(b)));
    let error = |referred: &Referred| referred.estimate.max(twice.next().unwrap_or(0.0));
    channels.iter().map(error).collect()
}

#[cfg(test)]
mod tests;
