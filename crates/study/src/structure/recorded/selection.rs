//! The spectra of many motions whose mean and deviation come nearest to a target, by the greedy search of `[Baker and Lee 2018]`.

/// A target: mean and standard deviation of the logarithms at each period.
pub(super) struct Moments<'a> {
    pub mean: &'a [f64],
    pub deviation: &'a [f64],
}

/// Most passes over the chosen ones; the search mostly ends after two or three.
const PASSES: usize = 20;

/// Sums of the chosen spectra and of their squares.
#[derive(Clone)]
struct Sums {
    count: f64,
    first: Vec<f64>,
    second: Vec<f64>,
}

impl Sums {
    /// The sums with a spectrum times a sign more.
    fn with(&self, spectrum: &[f64], sign: f64) -> Sums {
        let first = self.first.iter().zip(spectrum);
        let second = self.second.iter().zip(spectrum);
        Sums {
            count: self.count + sign,
            first: first.map(|(sum, x)| sum + sign * x).collect(),
            second: second.map(|(sum, x)| sum + sign * (x * x)).collect(),
        }
    }

    /// The sum over the periods of the squared errors of mean and deviation, with one spectrum more.
    fn misfit(&self, more: &[f64], target: &Moments) -> f64 {
        let n = self.count + 1.0;
        let at = |i: usize| {
            let mean = (self.first[i] + more[i]) / n;
            let square = self.second[i] + more[i] * more[i] - n * mean * mean;
            let deviation = (square.max(0.0) / (n - 1.0).max(1.0)).sqrt();
            let errors = [mean - target.mean[i], deviation - target.deviation[i]];
            errors[0] * errors[0] + errors[1] * errors[1]
        };
        (0..more.len()).map(at).sum()
    }
}

/// The places of `n` spectra, rising: begun one by one, then each one exchanged for the one that is better than it, until none is.
///
/// Spectra are logarithms less those of the target's median, so that no digits are lost in their squares. The first one of equals is
/// chosen, so that the choice does not depend on the machine.
pub(super) fn select(spectra: &[Vec<f64>], target: &Moments, n: usize) -> Vec<usize> {
    let from = |spectrum: &Vec<f64>| -> Vec<f64> {
        let both = spectrum.iter().zip(target.mean);
        both.map(|(x, mean)| x - mean).collect()
    };
    let spectra: Vec<Vec<f64>> = spectra.iter().map(from).collect();
    let zero = vec![0.0; target.mean.len()];
    let target = Moments {
        mean: &zero,
        deviation: target.deviation,
    };
    let mut sums = Sums {
        count: 0.0,
        first: zero.clone(),
        second: zero.clone(),
    };
    let mut chosen: Vec<usize> = Vec::new();
    let best = |sums: &Sums, chosen: &[usize]| {
        let free = (0..spectra.len()).filter(|i| !chosen.contains(i));
        let misfits = free.map(|i| (sums.misfit(&spectra[i], &target), i));
        misfits.min_by(|a, b| a.0.total_cmp(&b.0))
    };
    while chosen.len() < n {
        let Some((_, index)) = best(&sums, &chosen) else {
            break;
        };
        sums = sums.with(&spectra[index], 1.0);
        chosen.push(index);
    }
    for _ in 0..PASSES {
        let mut changed = false;
        for k in 0..chosen.len() {
            let replaced = chosen[k];
            let without = sums.with(&spectra[replaced], -1.0);
            let now = without.misfit(&spectra[replaced], &target);
            // Round-off is no improvement.
            if let Some((misfit, index)) = best(&without, &chosen)
                && misfit < now * (1.0 - 1e-12)
            {
                sums = without.with(&spectra[index], 1.0);
                chosen[k] = index;
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    chosen.sort_unstable();
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipgap_statistics::normal;

    /// Numbers from 0 to 1 by SplitMix64.
    struct Uniform(u64);

    impl Uniform {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.0;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    const PERIODS: usize = 12;

    /// The target of a conditional spectrum: no deviation at one period, more at others.
    fn target() -> [Vec<f64>; 2] {
        let mean = (0..PERIODS).map(|i| -0.3 * i as f64).collect();
        let deviation = (0..PERIODS)
            .map(|i| 0.08 * (i as f64 - 5.0).abs())
            .collect();
        [mean, deviation]
    }

    /// Many spectra that are too high and too different, all with the same value at the period without deviation.
    fn candidates(count: usize) -> Vec<Vec<f64>> {
        let mut uniform = Uniform(7);
        let [mean, deviation] = target();
        let one = |_| {
            let level = 1.6 * (uniform.next() - 0.3);
            let tilt = 2.0 * (uniform.next() - 0.5);
            let at = |i: usize| {
                let away = i as f64 - 5.0;
                let noise = 2.0 * (uniform.next() - 0.5);
                mean[i] + deviation[i] * (level + noise) + 0.1 * tilt * away
            };
            (0..PERIODS).map(at).collect()
        };
        (0..count).map(one).collect()
    }

    /// The squared errors of mean and deviation by their definitions.
    fn misfit(spectra: &[Vec<f64>], chosen: &[usize]) -> f64 {
        let [mean, deviation] = target();
        let n = chosen.len() as f64;
        let at = |i: usize| {
            let values: Vec<f64> = chosen.iter().map(|index| spectra[*index][i]).collect();
            let average = values.iter().sum::<f64>() / n;
            let squares: f64 = values.iter().map(|x| (x - average) * (x - average)).sum();
            let spread = (squares / (n - 1.0)).sqrt();
            (average - mean[i]).powi(2) + (spread - deviation[i]).powi(2)
        };
        (0..PERIODS).map(at).sum()
    }

    #[test]
    fn no_exchange_of_one_motion_is_better_and_no_random_set_is_near() {
        let spectra = candidates(400);
        let [mean, deviation] = target();
        let moments = Moments {
            mean: &mean,
            deviation: &deviation,
        };
        let chosen = select(&spectra, &moments, 11);
        assert_eq!(chosen.len(), 11);
        assert!(chosen.windows(2).all(|pair| pair[0] < pair[1]));
        let reached = misfit(&spectra, &chosen);
        for k in 0..chosen.len() {
            for other in (0..spectra.len()).filter(|i| !chosen.contains(i)) {
                let mut exchanged = chosen.clone();
                exchanged[k] = other;
                // Round-off of sums of 12 squares.
                assert!(misfit(&spectra, &exchanged) >= reached * (1.0 - 1e-9));
            }
        }
        let mut uniform = Uniform(3);
        let random = |_| {
            let mut set: Vec<usize> = Vec::new();
            while set.len() < 11 {
                let index = (uniform.next() * 400.0) as usize;
                if !set.contains(&index) {
                    set.push(index);
                }
            }
            misfit(&spectra, &set)
        };
        let least = (0..5000).map(random).fold(f64::INFINITY, f64::min);
        assert!(reached < 0.2 * least, "{reached} {least}");
    }

    #[test]
    fn a_set_with_the_moments_of_the_target_is_found_among_others() {
        // Pairs at mean +- d have the mean and, of n, the deviation d sqrt(n/(n - 1)).
        let [mean, deviation] = target();
        let n = 6.0_f64;
        let planted = |sign: f64| -> Vec<f64> {
            let size = ((n - 1.0) / n).sqrt();
            (0..PERIODS)
                .map(|i| mean[i] + sign * size * deviation[i])
                .collect()
        };
        let mut spectra = candidates(100);
        for (k, index) in [3, 20, 50, 51, 77, 104].into_iter().enumerate() {
            spectra.insert(index, planted(if k % 2 == 0 { 1.0 } else { -1.0 }));
        }
        let moments = Moments {
            mean: &mean,
            deviation: &deviation,
        };
        let chosen = select(&spectra, &moments, 6);
        assert_eq!(chosen, [3, 20, 50, 51, 77, 104]);
        // Of a normal sample, the quantiles; all of them, if all are asked for.
        let quantile = |i: u32| normal::quantile((f64::from(i) + 0.5) / 5.0);
        let few: Vec<Vec<f64>> = (0..5).map(|i| vec![quantile(i); PERIODS]).collect();
        assert_eq!(select(&few, &moments, 9), [0, 1, 2, 3, 4]);
    }
}
