//! Bootstrap samples, and the intervals that they give.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Samples: the ends of an interval then scatter by a fiftieth of its width.
pub const SAMPLES: usize = 1000;

/// Part of the samples below an interval, and above it.
const TAIL: f64 = 0.025;

/// The places, below `count`, that each sample picks, with repetition.
pub fn samples(count: usize, seed: u64) -> impl Iterator<Item = Vec<usize>> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    (0..SAMPLES).map(move |_| {
        let pick = |_| ((u128::from(random.next_u64()) * count as u128) >> 64) as usize;
        (0..count).map(pick).collect()
    })
}

/// The middle 95 % of the estimates of the samples; `None` if as many as a tail have none.
pub fn interval(mut estimates: Vec<f64>) -> Option<[f64; 2]> {
    if estimates.len() as f64 <= (1.0 - TAIL) * SAMPLES as f64 {
        return None;
    }
    estimates.sort_by(f64::total_cmp);
    let end = |part: f64| estimates[(part * (estimates.len() - 1) as f64).round() as usize];
    Some([end(TAIL), end(1.0 - TAIL)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_of_a_mean_is_that_of_its_closed_form() {
        // Mean and deviation of 0 .. 399 by hand, over many samples.
        let values: Vec<f64> = (0..400).map(f64::from).collect();
        let mean = |picked: Vec<usize>| picked.iter().map(|i| values[*i]).sum::<f64>() / 400.0;
        let [low, high] = interval(samples(400, 1).map(mean).collect()).unwrap();
        let half = 1.96 * ((400.0_f64 * 400.0 - 1.0) / 12.0).sqrt() / 20.0;
        // The ends scatter by a fiftieth of the width, here three times that.
        assert!((low - (199.5 - half)).abs() < 0.12 * half, "{low}");
        assert!((high - (199.5 + half)).abs() < 0.12 * half, "{high}");
        assert!(samples(3, 1).flatten().all(|i| i < 3));
        assert_eq!(samples(3, 1).count(), SAMPLES);
    }

    #[test]
    fn too_few_estimates_have_no_interval() {
        assert_eq!(interval(vec![1.0; 975]), None);
        assert_eq!(interval(vec![1.0; 976]), Some([1.0; 2]));
    }
}
