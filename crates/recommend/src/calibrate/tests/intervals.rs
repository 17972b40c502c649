//! Intervals and correlations against the formulas of textbooks, and how often intervals contain the truth.

use super::super::linear::{axis, solve};
use super::super::{Best, Determined, End, Options, determine, search};
use super::examples::{function, noise, of_ranges, rms, sine};
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
            assert!(((high - low) / (2.0 * tenth) - 1.0).abs() < 1e-3);
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
    let mut solved = 0;
    for seed in 1..=200 {
        let found = repetition(seed);
        solved += found.solved;
        for k in 0..4 {
            let [low, high] = ends(found.profiles[k].interval);
            inside[k] += usize::from((low..=high).contains(&truth[k]));
        }
    }
    println!("{inside:?} {solved}");
    // Of a binomial distribution with 200 trials and 0.95 the probability of fewer than 182 is 0.5 %, of more than 198 0.05 %.
    assert!(
        inside.iter().all(|count| (182..=198).contains(count)),
        "{inside:?}"
    );
}
