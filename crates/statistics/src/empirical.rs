//! The empirical distribution function of a sample, and its confidence band.

use super::CONFIDENCE;

/// The steps of the empirical distribution function of `rising` values: each different value, and the part of the values
/// that are at most as large.
pub fn steps(rising: &[f64]) -> Vec<[f64; 2]> {
    let count = rising.len();
    let mut steps: Vec<[f64; 2]> = Vec::new();
    for (i, value) in rising.iter().enumerate() {
        let part = (i + 1) as f64 / count as f64;
        match steps.last_mut() {
            Some(last) if last[0] == *value => last[1] = part,
            _ => steps.push([*value, part]),
        }
    }
    steps
}

/// How far the distribution function of independent values lies from the empirical one of `count` of them, everywhere at
/// once with a probability of at least 95 %: sqrt(ln(2/0.05)/(2 n)), the inequality of Dvoretzky, Kiefer and Wolfowitz
/// (1956) with the constant of Massart (1990). It holds for any distribution, also with ties.
pub fn half_band(count: usize) -> f64 {
    let tail = 1.0 - CONFIDENCE;
    (libm::log(2.0 / tail) / (2.0 * count as f64)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    #[test]
    fn steps_rise_by_the_part_of_equal_values() {
        let steps = steps(&[1.0, 2.0, 2.0, 5.0]);
        assert_eq!(steps, [[1.0, 0.25], [2.0, 0.75], [5.0, 1.0]]);
        assert!(super::steps(&[]).is_empty());
    }

    #[test]
    fn the_band_has_the_width_of_massart() {
        // sqrt(ln 40/200) = 0.13581015157406195 by hand from ln 40 = 3.6888794541139363.
        assert!((half_band(100) - 0.135_810_151_574_061_95).abs() < 1e-15);
    }

    #[test]
    fn the_band_contains_a_uniform_distribution_as_often_as_it_says() {
        // 2000 samples: the part that is contained scatters by sqrt(0.95 * 0.05/2000) = 0.005. The inequality is sharp as
        // n grows, and at n = 50 a little too wide.
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let contained = (0..2000).filter(|_| {
            let mut values: Vec<f64> = (0..50).map(|_| uniform(&mut random)).collect();
            values.sort_by(f64::total_cmp);
            let far = values.iter().enumerate().map(|(i, u)| {
                let (below, above) = (i as f64 / 50.0, (i + 1) as f64 / 50.0);
                (u - below).max(above - u)
            });
            far.fold(0.0, f64::max) <= half_band(50)
        });
        let part = contained.count() as f64 / 2000.0;
        assert!((0.94..0.98).contains(&part), "{part}");
    }

    fn uniform(random: &mut ChaCha8Rng) -> f64 {
        ((random.next_u64() >> 12) as f64 + 0.5) / (1u64 << 52) as f64
    }
}
