//! Intervals from estimates without one of the members each (Tukey's jackknife).

use crate::{CONFIDENCE, student};
use libm::{exp, log};

/// The 95 % interval of a positive number: its logarithm plus and minus Student's t with n - 1 times the standard error of the
/// jackknife, sqrt((n - 1)/n sum (z - mean z)^2), z the logarithms of the n estimates `without` one of the members each. `None`
/// if there are fewer than two of them, or if one of them is no positive number.
pub fn interval(value: f64, without: &[f64]) -> Option<[f64; 2]> {
    let n = without.len() as f64;
    let logs: Vec<f64> = without.iter().map(|x| log(*x)).collect();
    let mean = logs.iter().sum::<f64>() / n;
    let squares: f64 = logs.iter().map(|z| (z - mean) * (z - mean)).sum();
    let error = ((n - 1.0) / n * squares).sqrt();
    if without.len() < 2 || !error.is_finite() {
        return None;
    }
    let half = student::quantile(n - 1.0, CONFIDENCE) * error;
    Some([-half, half].map(|half| exp(log(value) + half)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_of_a_geometric_mean_is_that_of_student() {
        // The logarithms 1 .. 5 without one each: the standard error is that of their mean, sqrt(2.5/5); t for 4 from tables.
        let without = [14.0, 13.0, 12.0, 11.0, 10.0].map(|sum: f64| exp(sum / 4.0));
        let [low, high] = interval(exp(3.0), &without).unwrap();
        let half = 2.776445 * 0.5_f64.sqrt();
        assert!((log(low) - 3.0 + half).abs() < 1e-6, "{low}");
        assert!((log(high) - 3.0 - half).abs() < 1e-6, "{high}");
    }

    #[test]
    fn what_has_no_logarithm_has_no_interval() {
        assert_eq!(interval(1.0, &[1.0]), None);
        assert_eq!(interval(1.0, &[1.0, 0.0]), None);
        assert_eq!(interval(1.0, &[1.0, f64::NAN]), None);
        assert_eq!(interval(2.0, &[2.0, 2.0]), Some([exp(log(2.0)); 2]));
    }
}
