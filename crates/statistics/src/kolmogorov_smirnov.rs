//! The two-sample test of Kolmogorov and Smirnov.

use super::CONFIDENCE;
use super::quantile::quantile;
use libm::{exp, sqrt};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::f64::consts::PI;

/// Most products of both sizes for which ties are counted exactly: a tenth of a millisecond.
const MOST_PATHS: usize = 100_000;

/// The largest distance of two empirical distribution functions, and how probable one as large is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Test {
    /// D: the largest distance of the two functions.
    pub distance: f64,
    /// The probability of a distance at least as large if both samples are independent values of one distribution.
    pub p: f64,
}

/// Tests whether two samples of `rising` values come from one distribution; `None` if one is empty.
///
/// p is exact for up to 100 000 pairs of values, also with ties: among all ways to divide the values of both into samples
/// of these sizes, the part with a distance as large (Schroer and Trenkler 1995). It is also exact for samples of one size
/// without ties (Gnedenko and Korolyuk 1951). For others it is the limit of large samples (Smirnov 1939), which is too large
/// with ties.
pub fn test(first: &[f64], second: &[f64]) -> Option<Test> {
    if first.is_empty() || second.is_empty() {
        return None;
    }
    let (m, n) = (first.len(), second.len());
    let (most, ends) = merge(first, second);
    let distance = most as f64 / (m as f64 * n as f64);
    let p = match ends.iter().all(|end| *end) {
        _ if most == 0 => 1.0,
        true if m == n => without_ties(m, most / n),
        _ if m.saturating_mul(n) <= MOST_PATHS => by_paths([m, n], most, &ends),
        _ => limit(distance * (m as f64 * n as f64 / (m + n) as f64).sqrt()),
    };
    Some(Test { distance, p })
}

/// Bootstrap samples of an interval.
const SAMPLES: usize = 1000;

/// Seed of the bootstrap: the same samples have the same interval.
const SEED: u64 = 1;

/// The 95 % interval of the largest distance of the distribution functions F and G from which two samples of `rising` values
/// come; `None` if one is empty.
///
/// D errs by at most the largest |(Fm - F) - (Gn - G)|, of which samples drawn from both samples with replacement give the
/// quantile at 95 %, as the bootstrap holds for empirical processes (Bickel and Freedman 1981). The interval is D plus and
/// minus this, from 0 to 1. It also holds where F = G, where distances of drawn samples themselves are too large.
pub fn interval(first: &[f64], second: &[f64]) -> Option<[f64; 2]> {
    let distance = test(first, second)?.distance;
    let (m, n) = (first.len(), second.len());
    // The place of each value among all different ones.
    let mut values: Vec<f64> = first.iter().chain(second).copied().collect();
    values.sort_unstable_by(f64::total_cmp);
    values.dedup();
    let places = |sample: &[f64]| -> Vec<usize> {
        let rank = |x: &f64| values.partition_point(|known| known < x);
        sample.iter().map(rank).collect()
    };
    let [first, second] = [first, second].map(places);
    // Parts of 1/(m n): a value of the first sample counts n, one of the second -m, and those that are not drawn are missing.
    let [ones, others] = [n as i64, -(m as i64)];
    let mut none = vec![0; values.len()];
    first.iter().for_each(|rank| none[*rank] -= ones);
    second.iter().for_each(|rank| none[*rank] -= others);
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut draw = |places: &[usize]| {
        let at = (u64::from(random.next_u32()) * places.len() as u64) >> 32;
        places[at as usize]
    };
    let mut errors = Vec::with_capacity(SAMPLES);
    for _ in 0..SAMPLES {
        let mut change = none.clone();
        (0..m).for_each(|_| change[draw(&first)] += ones);
        (0..n).for_each(|_| change[draw(&second)] += others);
        let mut sum = 0_i64;
        let largest = change.iter().fold(0, |most: u64, step| {
            sum += step;
            most.max(sum.unsigned_abs())
        });
        errors.push(largest as f64 / (m as f64 * n as f64));
    }
    errors.sort_unstable_by(f64::total_cmp);
    let error = quantile(&errors, CONFIDENCE)?;
    Some([(distance - error).max(0.0), (distance + error).min(1.0)])
}

/// The largest distance in parts of 1/(m n), and for each of the pooled values in order whether the next one is larger.
fn merge(first: &[f64], second: &[f64]) -> (usize, Vec<bool>) {
    let (m, n) = (first.len(), second.len());
    let (mut i, mut j, mut most) = (0, 0, 0);
    let mut ends = Vec::with_capacity(m + n);
    while i < m || j < n {
        let next = match (first.get(i), second.get(j)) {
            (Some(a), Some(b)) => a.min(*b),
            (Some(one), None) | (None, Some(one)) => *one,
            (None, None) => break,
        };
        let before = i + j;
        i += first[i..].iter().take_while(|x| **x == next).count();
        j += second[j..].iter().take_while(|x| **x == next).count();
        ends.resize(ends.len() + (i + j - before).saturating_sub(1), false);
        ends.push(true);
        most = most.max((i * n).abs_diff(j * m));
    }
    (most, ends)
}

/// The part of all paths from (0, 0) to (m, n) that are as far from the diagonal somewhere, where a value of the pooled
/// sample ends; by the part of the paths to each place that were.
fn by_paths([m, n]: [usize; 2], most: usize, ends: &[bool]) -> f64 {
    let far = |i: usize, j: usize| {
        let end = (i + j).checked_sub(1).is_none_or(|rank| ends[rank]);
        end && (i * n).abs_diff(j * m) >= most
    };
    let mut row = vec![0.0; n + 1];
    for i in 0..=m {
        for j in 0..=n {
            row[j] = match (i, j) {
                _ if far(i, j) => 1.0,
                (0, 0) => 0.0,
                (0, _) => row[j - 1],
                (_, 0) => row[0],
                // The last value before is of the first sample for i of i + j paths.
                _ => {
                    let part = i as f64 / (i + j) as f64;
                    part * row[j] + (1.0 - part) * row[j - 1]
                }
            };
        }
    }
    row[n]
}

/// The probability of a distance of at least `steps`/n between two samples of `n` different values: twice the alternating
/// sum over k of C(2n, n - k steps)/C(2n, n), from its last term on.
fn without_ties(n: usize, steps: usize) -> f64 {
    let mut p = 0.0;
    for k in (1..=n / steps).rev() {
        // C(2n, n - k steps) over C(2n, n - (k - 1) steps).
        let ratio: f64 = (1..=steps)
            .map(|j| {
                let rank = (k - 1) * steps + j;
                (n - rank + 1) as f64 / (n + rank) as f64
            })
            .product();
        p = ratio * (1.0 - p);
    }
    (2.0 * p).min(1.0)
}

/// The probability of a distance of `x` > 0 or more in the limit of large samples, 2 sum (-1)^(k-1) exp(-2 k^2 x^2).
///
/// For small x it is 1 - sqrt(2 pi)/x sum exp(-(2 k - 1)^2 pi^2/(8 x^2)), which is the same by Poisson's summation.
fn limit(x: f64) -> f64 {
    if x < 0.5 {
        let term = |k: f64| exp(-k * k * PI * PI / (8.0 * x * x));
        return 1.0 - (term(5.0) + term(3.0) + term(1.0)) * sqrt(2.0 * PI) / x;
    }
    let term = |k: u32| exp(-2.0 * f64::from(k * k) * x * x);
    let sum: f64 = (1..=20)
        .rev()
        .map(|k| if k % 2 == 1 { term(k) } else { -term(k) })
        .sum();
    (2.0 * sum).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether the first sample has the value, for each way to choose `m` of the places.
    fn divisions(m: usize, n: usize) -> Vec<Vec<bool>> {
        let ways = (0..1_u32 << (m + n)).filter(|bits| bits.count_ones() == m as u32);
        let way = |bits: u32| (0..m + n).map(|i| bits >> i & 1 == 1).collect();
        ways.map(way).collect()
    }

    fn distance(pooled: &[f64], in_first: &[bool]) -> usize {
        let of = |first: bool| {
            let of_sample = pooled
                .iter()
                .zip(in_first)
                .filter(|(_, its)| **its == first);
            of_sample.map(|(x, _)| *x).collect::<Vec<f64>>()
        };
        merge(&of(true), &of(false)).0
    }

    #[test]
    fn p_is_the_part_of_all_divisions_with_and_without_ties() {
        let pools: [&[f64]; 4] = [
            &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0],
            &[1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 4.0, 4.0, 5.0],
            &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0],
            &[3.0; 9],
        ];
        for pooled in pools {
            for m in [2, 4, 5, 8] {
                let ways = divisions(m, 9 - m);
                let distances: Vec<usize> = ways.iter().map(|way| distance(pooled, way)).collect();
                for way in ways.iter().step_by(7) {
                    let of = |first: bool| {
                        let of_sample = pooled.iter().zip(way).filter(|(_, its)| **its == first);
                        of_sample.map(|(x, _)| *x).collect::<Vec<f64>>()
                    };
                    let found = test(&of(true), &of(false)).unwrap();
                    let own_distance = distance(pooled, way);
                    let as_far = distances.iter().filter(|d| **d >= own_distance).count();
                    let p = as_far as f64 / ways.len() as f64;
                    // A few roundings.
                    assert!(
                        (found.p - p).abs() < 1e-14,
                        "{pooled:?} {way:?}: {found:?} {p}"
                    );
                    assert_eq!(found.distance, own_distance as f64 / (m * (9 - m)) as f64);
                }
            }
        }
    }

    /// Values of a quadratic, in rising order, without ties with others of another start.
    fn sample(count: usize, start: f64, slope: f64) -> Vec<f64> {
        (0..count)
            .map(|i| start + slope * i as f64 + 1e-3 * (i * i) as f64)
            .collect()
    }

    #[test]
    fn distances_and_probabilities_are_those_of_scipy() {
        for ([m, n], [start, slope], [distance, p]) in SCIPY {
            let found = test(&sample(m, 0.0, 1.0), &sample(n, start, slope)).unwrap();
            assert!(
                (found.distance - distance).abs() < 1e-15,
                "{m} {n}: {found:?}"
            );
            assert!((found.p / p - 1.0).abs() < 1e-10, "{m} {n}: {found:?} {p}");
        }
    }

    /// Sizes, start and slope of the second sample, and what scipy's ks_2samp(x, y, method="exact") gives.
    const SCIPY: [([usize; 2], [f64; 2], [f64; 2]); 8] = [
        ([10, 10], [2.5005, 1.0], [0.3, 0.7869297884777761]),
        ([20, 20], [0.5005, 0.7], [0.3, 0.33559098126008213]),
        (
            [7, 13],
            [1.5005, 0.4],
            [0.2857142857142857, 0.7343653250773995],
        ),
        (
            [30, 50],
            [4.5005, 0.5],
            [0.16666666666666666, 0.6227763284451165],
        ),
        ([100, 100], [8.5005, 1.05], [0.11, 0.5830090612540064]),
        (
            [200, 300],
            [20.5005, 0.6],
            [0.14833333333333334, 0.009407232626032385],
        ),
        ([1000, 1000], [50.50005, 1.0], [0.049, 0.18116454248303263]),
        (
            [120, 80],
            [-3.50005, 2.0],
            [0.17083333333333334, 0.11204721438537643],
        ),
    ];

    #[test]
    fn the_forms_agree() {
        // The closed form for equal sizes is the count of paths.
        for n in [1, 2, 7, 40, 100] {
            for steps in 1..=n {
                let paths = by_paths([n, n], steps * n, &vec![true; 2 * n]);
                let closed = without_ties(n, steps);
                assert!(
                    (closed - paths).abs() < 1e-13,
                    "{n} {steps}: {closed} {paths}"
                );
            }
        }
        // And tends to the limit: the error falls with the size, to 1e-4 for 10^6 values.
        for steps in [600, 1000, 1400, 2000] {
            let n = 1_000_000;
            let x = f64::from(steps) / (2.0 * n as f64).sqrt();
            let (exact, limit) = (without_ties(n, steps as usize), limit(x));
            assert!(
                (exact / limit - 1.0).abs() < 1e-4,
                "{steps}: {exact} {limit}"
            );
        }
        // scipy's kstwobign.sf.
        assert!((limit(0.5) - 0.963_945_243_664_875_1).abs() < 1e-15);
        assert!((limit(1.36) / 0.049_485_876_755_377_876 - 1.0).abs() < 1e-14);
        // Both series, at the place where one takes the other's place and around it: a few roundings of terms up to 1.
        for x in [0.3, 0.4, 0.499, 0.5, 0.501, 0.6, 0.8, 1.0] {
            let rising =
                (1..=20).map(|k| f64::from(1 - 2 * (k % 2)) * exp(-2.0 * f64::from(k * k) * x * x));
            let falling = (1..=4)
                .map(|k| exp(-f64::from((2 * k - 1) * (2 * k - 1)) * PI * PI / (8.0 * x * x)));
            let [one, other] = [
                -2.0 * rising.sum::<f64>(),
                1.0 - falling.sum::<f64>() * sqrt(2.0 * PI) / x,
            ];
            assert!((one - other).abs() < 2e-15, "{x} {one} {other}");
            assert!((limit(x) - other).abs() < 2e-15, "{x} {} {other}", limit(x));
        }
        // sqrt(2 pi)/0.2 exp(-pi^2/0.32) = 12.53314 4.029642e-14 is missing to 1, then less than a rounding.
        assert!((1.0 - limit(0.2) - 5.0504073e-13).abs() < 2e-16);
        assert_eq!(limit(1e-3), 1.0);
    }

    #[test]
    fn the_interval_holds_the_distance_of_two_normal_distributions() {
        // Those of N(0, 1) and N(shift, 1) are 2 Phi(shift/2) - 1 apart, where their densities cross.
        let mut random = ChaCha8Rng::seed_from_u64(7);
        let mut normal = |count: usize, shift: f64| -> Vec<f64> {
            let one = |_| {
                let part = (f64::from(random.next_u32()) + 0.5) / 4_294_967_296.0;
                crate::normal::quantile(part) + shift
            };
            let mut values: Vec<f64> = (0..count).map(one).collect();
            values.sort_unstable_by(f64::total_cmp);
            values
        };
        for (shift, apart) in [
            (0.0, 0.0),
            (0.5, 0.197_412_651_364_847),
            (2.0, 0.682_689_492_137_086),
        ] {
            for [m, n] in [[10, 100], [30, 200]] {
                let holds = (0..200).filter(|_| {
                    let (first, second) = (normal(m, 0.0), normal(n, shift));
                    let [low, high] = interval(&first, &second).unwrap();
                    low <= apart && apart <= high
                });
                let held = holds.count();
                // Of 200 intervals that hold it with 95 %, fewer than 181 do so with a probability of 0.4 % (binomial).
                assert!(held >= 181, "{shift} {m} {n}: {held} of 200");
            }
        }
    }

    #[test]
    fn the_interval_is_that_of_all_samples_that_can_be_drawn() {
        // Of {1, 2} and {1.5}: 1 1 and 2 2 are drawn with a quarter each, and err by 1/2; D = 1/2.
        assert_eq!(interval(&[1.0, 2.0], &[1.5]), Some([0.0, 1.0]));
        // Equal values have no scatter.
        assert_eq!(interval(&[1.0; 3], &[2.0; 4]), Some([1.0, 1.0]));
        assert_eq!(interval(&[1.0; 3], &[]), None);
    }

    #[test]
    fn extremes_have_no_surprises() {
        assert_eq!(test(&[], &[1.0]), None);
        let same = test(&[1.0, 2.0], &[1.0, 2.0]).unwrap();
        assert_eq!([same.distance, same.p], [0.0, 1.0]);
        let apart = test(&[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0]).unwrap();
        // Two of the 20 divisions of six values.
        assert_eq!(apart.distance, 1.0);
        assert!((apart.p - 0.1).abs() < 1e-15);
    }
}
