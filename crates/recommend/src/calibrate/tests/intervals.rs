//! Intervals and correlations against the formulas of textbooks, and how often intervals contain the truth.

use super::super::linear::{axis, solve};
use super::super::{Best, Determined, End, Options, determine, search};
use super::examples::{Value, function, noise, of_ranges, rms, sine};
use slipgap_statistics::fisher;

fn ends(end: Option<[End; 2]>) -> [f64; 2] {
    end.unwrap().map(|end| match end {
        End::At(at) => at,
        End::Open => panic!("an end is open"),
    })
}

fn at(at: Vec<f64>, misfit: f64) -> Best {
    Best {
        at,
        misfit,
        solved: 0,
        starts: [0, 0],
        spent: false,
    }
}

/// Rows x of a line, a parabola and a sine, whose sums with the coordinates are measured with noise.
fn regression(count: usize, deviation: f64) -> (Vec<Vec<f64>>, Vec<f64>) {
    let row = |i: usize| {
        let t = i as f64 / (count - 1) as f64;
        vec![1.0, t, t * t, libm::sin(9.0 * t)]
    };
    let rows: Vec<Vec<f64>> = (0..count).map(row).collect();
    let truth = [0.4, 0.55, 0.3, 0.7];
    let measured = rows.iter().enumerate().map(|(i, row)| {
        row.iter().zip(truth).map(|(x, b)| x * b).sum::<f64>() + deviation * noise(5, i as u64)
    });
    (rows.clone(), measured.collect())
}

#[test]
fn linear_least_squares_have_the_intervals_of_t_and_their_correlation() {
    for (count, deviation) in [(12, 0.004), (200, 0.01), (5000, 0.01)] {
        let (rows, measured) = regression(count, deviation);
        let computed = |x: &[f64]| -> Vec<f64> {
            rows.iter()
                .map(|row| row.iter().zip(x).map(|(a, b)| a * b).sum())
                .collect()
        };
        let mut misfit = function(|x: &[f64]| rms(&computed(x), &measured));
        // Textbook: b = (X^T X)^-1 X^T y, covariance s^2 (X^T X)^-1, interval b +- t s sqrt((X^T X)^-1_kk).
        let entry = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum::<f64>();
        let normal: Vec<Vec<f64>> = (0..4)
            .map(|i| (0..4).map(|j| entry(i, j)).collect())
            .collect();
        let right = (0..4).map(|i| {
            rows.iter()
                .zip(&measured)
                .map(|(row, y)| row[i] * y)
                .sum::<f64>()
        });
        let estimate = solve(&normal, &right.collect::<Vec<_>>()).unwrap();
        let inverse: Vec<Vec<f64>> = (0..4)
            .map(|k| solve(&normal, &axis(4, k)).unwrap())
            .collect();
        let rest = rms(&computed(&estimate), &measured);
        let freedom = count as f64 - 4.0;
        let variance = rest * rest * count as f64 / freedom;
        let t = fisher::quantile(0.95, 1.0, freedom).sqrt();

        let best = search(
            4,
            &mut misfit,
            &Options {
                seed: 2,
                cases: 20_000,
            },
        )
        .unwrap();
        let found = determine(&best, &mut misfit, Some(count as f64)).unwrap();
        assert!(found.quadratic && found.undetermined.is_none());
        let correlation = found.correlation.unwrap();
        for k in 0..4 {
            let half = t * (variance * inverse[k][k]).sqrt();
            let [low, high] = ends(found.profiles[k].interval);
            // The least squares are found to 1e-4 of the rise of an interval, which is 1 % of its width.
            assert!((found.best.at[k] - estimate[k]).abs() < 0.01 * half);
            assert!(
                (low - (estimate[k] - half)).abs() < 1e-3 * half,
                "{count} {k}: {low}"
            );
            assert!(
                (high - (estimate[k] + half)).abs() < 1e-3 * half,
                "{count} {k}: {high}"
            );
            // 10 %: (1.1^2 - 1) N/(N - p) s^2 instead of t^2 s^2.
            let tenth = half / t * (0.21 * freedom).sqrt();
            let [low, high] = ends(Some(found.profiles[k].within_tenth));
            assert!(
                ((high - low) / (2.0 * tenth) - 1.0).abs() < 1e-3,
                "{count} {k}: {low} {high} {tenth} {half} {:?}",
                found.profiles[k]
            );
            for l in 0..4 {
                let expected = inverse[k][l] / (inverse[k][k] * inverse[l][l]).sqrt();
                assert!((correlation[k][l] - expected).abs() < 1e-3);
            }
        }
    }
}

/// The damped sine with noise, from the truth.
fn repetition(seed: u64) -> Determined {
    let truth = [0.45, 0.6, 0.42, 0.63];
    let exact = sine(of_ranges(&truth));
    let noisy = exact
        .iter()
        .enumerate()
        .map(|(i, x)| x + 0.02 * noise(seed, i as u64));
    let measured: Vec<f64> = noisy.collect();
    let mut misfit = function(|x: &[f64]| rms(&sine(of_ranges(x)), &measured));
    let start = rms(&exact, &measured);
    determine(&at(truth.to_vec(), start), &mut misfit, Some(200.0)).unwrap()
}

#[test]
fn intervals_contain_the_truth_95_times_in_100() {
    let truth = [0.45, 0.6, 0.42, 0.63];
    let mut inside = [0; 4];
    for seed in 1..=200 {
        let found = repetition(seed);
        for k in 0..4 {
            let [low, high] = ends(found.profiles[k].interval);
            inside[k] += usize::from((low..=high).contains(&truth[k]));
        }
    }
    // Of a binomial distribution with 200 trials and 0.95 the probability of fewer than 182 is 0.6 %, of more than 198 0.04 %.
    assert!(
        inside.iter().all(|count| (182..=198).contains(count)),
        "{inside:?}"
    );
}

#[test]
fn the_range_of_one_of_two_factors_is_that_of_the_other() {
    // Only (0.1 + x)(0.1 + y) is measured, as 0.3 with the root of the mean square 0.01. The interval of x begins where y is at its end, at
    // (0.3 - d)/1.1 - 0.1 with d^2 the rise of the interval, and is open above.
    let value = |x: &[f64]| {
        let difference = (0.1 + x[0]) * (0.1 + x[1]) - 0.3;
        (difference * difference + 1e-4).sqrt()
    };
    let mut misfit = function(value);
    let best = search(
        2,
        &mut misfit,
        &Options {
            seed: 1,
            cases: 20_000,
        },
    )
    .unwrap();
    let found = determine(&best, &mut misfit, Some(200.0)).unwrap();
    let d = (1e-4 * fisher::quantile(0.95, 1.0, 198.0) / 198.0).sqrt();
    let begin = (0.3 - d) / 1.1 - 0.1;
    for profile in &found.profiles {
        let [End::At(low), End::Open] = profile.interval.unwrap() else {
            panic!("{profile:?}");
        };
        // Values next to a bend of the profile are 2 % apart.
        assert!(
            (low - begin).abs() < 0.01 * (best.at[0] - begin).abs(),
            "{low} {begin}"
        );
    }
    assert!(!found.quadratic && found.widened == 1.0);
    assert!(found.correlation.unwrap()[0][1] < -0.99);
}

#[test]
fn what_the_misfit_does_not_determine_is_named() {
    // On logarithmic scales only the sum of two coordinates is determined; then a coordinate without influence.
    let sum = |x: &[f64]| ((x[0] + x[1] - 1.0) * (x[0] + x[1] - 1.0) + 0.01).sqrt();
    let flat =
        |x: &[f64]| ((x[0] - 0.3) * (x[0] - 0.3) + (x[1] - 0.8) * (x[1] - 0.8) + 1e-4).sqrt();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    type Expected<'a> = (Vec<f64>, &'a [usize], &'a [usize]);
    let cases: [(Value, usize, Expected); 3] = [
        (&sum, 2, (vec![half, -half], &[0, 1], &[0, 1])),
        (&flat, 3, (vec![0.0, 0.0, 1.0], &[2], &[])),
        (&|_| 0.7, 1, (vec![1.0], &[0], &[])),
    ];
    for (value, n, (direction, open, combined)) in cases {
        let mut misfit = function(value);
        let best = search(
            n,
            &mut misfit,
            &Options {
                seed: 1,
                cases: 20_000,
            },
        )
        .unwrap();
        let found = determine(&best, &mut misfit, Some(100.0)).unwrap();
        let named = found.undetermined.unwrap();
        // Its sign is not determined.
        let along: f64 = named.iter().zip(&direction).map(|(a, b)| a * b).sum();
        assert!((along.abs() - 1.0).abs() < 1e-6, "{named:?}");
        assert!(found.correlation.is_none());
        assert_eq!(found.combined, combined);
        for (k, profile) in found.profiles.iter().enumerate() {
            let is_open = profile.interval.unwrap().map(|end| end == End::Open);
            assert_eq!(is_open == [true; 2], open.contains(&k), "{k}: {profile:?}");
        }
    }
}

#[test]
fn coordinates_without_influence_are_no_combination() {
    // The direction between the last two is arbitrary, so that it contains both.
    let value = |x: &[f64]| ((x[0] - 0.3) * (x[0] - 0.3) + 1e-4).sqrt();
    for rotated in [0.0, 1e-12] {
        let mut misfit = function(|x: &[f64]| value(x) + rotated * (x[1] - x[2]) * (x[1] - x[2]));
        let start = at(vec![0.3, 0.4, 0.8], 0.01);
        let found = determine(&start, &mut misfit, Some(100.0)).unwrap();
        assert!(found.combined.is_empty(), "{:?}", found.combined);
        assert!(found.undetermined.is_some());
    }
}

#[test]
fn a_straight_valley_that_ends_at_a_bound_has_no_jumps() {
    // Only the sum of the first two coordinates is determined, and not quadratically; the best point is near the end of the first one.
    let value = |x: &[f64]| {
        let line = x[0] + x[1] - 0.8;
        let sum = 300.0 * (line + 3.0 * line * line);
        let other = 30.0 * (x[2] - 0.6);
        (sum * sum + other * other + 1.0).sqrt()
    };
    for first in [0.0, 1e-5, 0.004, 0.03] {
        let mut misfit = function(value);
        let start = at(vec![first, 0.8 - first, 0.6], 1.0);
        let found = determine(&start, &mut misfit, Some(200.0)).unwrap();
        assert_eq!(found.widened, 1.0, "{first}: {found:?}");
        let half = (fisher::quantile(0.95, 1.0, 197.0) / 197.0).sqrt();
        let [low, high] = ends(found.profiles[2].interval);
        assert!(
            (low - (0.6 - half / 30.0)).abs() < 0.01 * half / 30.0,
            "{low}"
        );
        assert!(
            (high - (0.6 + half / 30.0)).abs() < 0.01 * half / 30.0,
            "{high}"
        );
        for profile in &found.profiles[..2] {
            let [End::Open, End::At(high)] = profile.interval.unwrap() else {
                panic!("{profile:?}");
            };
            // Values next to a bend of the profile are 2 % apart.
            let expected = 0.8 + half / 300.0;
            assert!((high - expected).abs() < 0.01 * expected, "{high}");
        }
    }
}

#[test]
fn perfect_data_end_with_a_narrow_range_round_the_truth() {
    let truth = [0.45, 0.6, 0.42, 0.63];
    let exact = sine(of_ranges(&truth));
    let mut misfit = function(|x: &[f64]| rms(&sine(of_ranges(x)), &exact));
    let best = search(
        4,
        &mut misfit,
        &Options {
            seed: 1,
            cases: 20_000,
        },
    )
    .unwrap();
    let found = determine(&best, &mut misfit, Some(200.0)).unwrap();
    assert!(found.quadratic && found.solved < 2000);
    for (k, profile) in found.profiles.iter().enumerate() {
        for range in [ends(profile.interval), ends(Some(profile.within_tenth))] {
            assert!(range[0] < truth[k] && truth[k] < range[1] && range[1] - range[0] < 1e-4);
        }
    }
}

#[test]
fn jumps_widen_the_intervals_until_they_contain_the_truth() {
    // A quadratic function with steps of 2 % of random size in cells of 1/300; without them an interval is shorter than a cell.
    // Fewer than 53 of 60 have a probability of 0.9 % if each interval contains the truth 95 times in 100.
    let (mut inside, mut widest): (usize, f64) = (0, 0.0);
    for seed in 1..=20 {
        let value = |x: &[f64]| {
            let cell = x
                .iter()
                .fold(seed, |cell, x| cell * 1009 + (x * 300.0).floor() as u64);
            let parts = x.iter().zip([1.0, 2.0, 3.0]);
            let square: f64 = parts.map(|(x, w)| w * (x - 0.4) * (x - 0.4)).sum();
            (square + 1e-4).sqrt() * (1.0 + 0.02 * noise(seed, cell))
        };
        let mut misfit = function(value);
        let best = search(
            3,
            &mut misfit,
            &Options {
                seed,
                cases: 20_000,
            },
        )
        .unwrap();
        let found = determine(&best, &mut misfit, Some(5000.0)).unwrap();
        assert!(found.widened > 2.0 && !found.quadratic, "{}", found.widened);
        for profile in &found.profiles {
            let [low, high] = ends(profile.interval);
            inside += usize::from((low..=high).contains(&0.4));
            widest = widest.max(high - low);
        }
    }
    assert!(inside >= 53 && widest < 0.05, "{inside} of 60, {widest}");
}

#[test]
fn a_misfit_without_probability_has_its_range_of_10_percent_only() {
    // A sum of absolute values: the profile of each coordinate is best + w |x - x0|.
    let value = |x: &[f64]| 0.5 + 2.0 * (x[0] - 0.3).abs() + (x[1] - 0.6).abs();
    let mut misfit = function(value);
    let best = search(
        2,
        &mut misfit,
        &Options {
            seed: 1,
            cases: 20_000,
        },
    )
    .unwrap();
    let found = determine(&best, &mut misfit, None).unwrap();
    // A quadratic function does not describe an edge: values on a profile are optimised to a fifth of the range.
    for (profile, (at, half)) in found.profiles.iter().zip([(0.3, 0.025), (0.6, 0.05)]) {
        assert!(profile.interval.is_none());
        let [low, high] = ends(Some(profile.within_tenth));
        assert!(
            (low - (at - half)).abs() < 0.25 * half && (high - (at + half)).abs() < 0.25 * half,
            "{low} {high}"
        );
    }
    let few = determine(&best, &mut misfit, Some(2.0)).unwrap();
    assert!(few.profiles[0].interval.is_none());
}

#[test]
fn a_lower_misfit_on_a_profile_becomes_the_best_point() {
    // Two valleys; the profile of the first coordinate from the higher one leads into the lower one.
    let value = |x: &[f64]| {
        let valley =
            |a: f64, floor: f64| (x[0] - a) * (x[0] - a) + 0.2 * (x[1] - a) * (x[1] - a) + floor;
        valley(0.3, 0.012).min(valley(0.36, 0.01)).sqrt()
    };
    let mut misfit = function(value);
    let start = at(vec![0.3, 0.3], value(&[0.3, 0.3]));
    let found = determine(&start, &mut misfit, Some(200.0)).unwrap();
    // The rise of the interval is 2e-4: a point is better if its squared misfit is lower by a tenth.
    assert!(
        found.best.misfit * found.best.misfit < 0.01 + 2e-5,
        "{:?}",
        found.best
    );
    assert!(found.best.at.iter().all(|x| (x - 0.36).abs() < 0.01));
}
