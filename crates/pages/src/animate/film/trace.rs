//! A curve over time in the page.

use super::short_numbers::{differences, peak};
use super::thin;
use serde_json::{Value, json};

/// Most points of a curve.
const MOST: usize = 4000;

/// Parts of the largest value in which values are rounded: finer than the points of a screen.
const PARTS: f64 = 1000.0;

/// Points between which only the smallest and the largest value are looked at, if there are more than this.
const LOOKED_AT: usize = 40_000;

/// A curve with a value at each step; times in half steps.
pub fn of_steps(values: &[f64]) -> Value {
    let steps: Vec<u64> = (0..values.len() as u64).map(|step| 2 * step).collect();
    curve(&steps, values)
}

/// A curve with a value at each time.
pub fn curve(steps: &[u64], values: &[f64]) -> Value {
    let largest = peak(values);
    let unit = if largest > 0.0 { largest / PARTS } else { 1.0 };
    let size = values.len().div_ceil(LOOKED_AT / 2).max(1);
    let mut candidates = Vec::new();
    for (block, part) in values.chunks(size).enumerate() {
        let [low, high] = thin::extremes(part);
        candidates.extend([block * size + low, block * size + high]);
    }
    let kept = match values.is_empty() {
        true => Vec::new(),
        false => thin::extremes(values).to_vec(),
    };
    let points = thin::thin(steps, candidates, kept, &[(values, 2.0 * unit)], MOST);
    let rounded = points.iter().map(|i| (values[*i] / unit).round() as i64);
    json!({
        "t": differences(points.iter().map(|i| steps[*i] as i64)),
        "unit": unit,
        "v": differences(rounded),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_burst_of_one_step_in_a_million_is_kept() {
        let mut values = vec![0.0; 1_000_000];
        values[123_456] = -7.0;
        values[777_777] = 3.0;
        let curve = of_steps(&values);
        let sums = |key: &str| -> Vec<i64> {
            let mut sum = 0;
            let numbers = curve[key].as_array().unwrap().iter();
            numbers
                .map(|x| {
                    sum += x.as_i64().unwrap();
                    sum
                })
                .collect()
        };
        let (t, v) = (sums("t"), sums("v"));
        let at = |step: i64| t.iter().position(|t| *t == 2 * step).map(|i| v[i]);
        assert_eq!(at(123_456), Some(-1000));
        assert_eq!(at(777_777), Some(429));
        // The curve is 0 beside the burst, as far as its neighbours are looked at.
        let i = t.iter().position(|t| *t == 2 * 123_456).unwrap();
        assert!(v[i - 1] == 0 && v[i + 1] == 0);
        assert!(t[i + 1] - t[i - 1] <= 2 * 200);
    }
}
