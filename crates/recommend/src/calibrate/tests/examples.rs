//! Objectives.

use super::super::{Objective, Stopped};

/// A misfit.
pub type Value<'a> = &'a dyn Fn(&[f64]) -> f64;

/// A function of one point, with the number of calls and points.
pub struct Function<F> {
    pub value: F,
    pub calls: usize,
    pub points: usize,
    /// Computes the points from the last to the first.
    pub backwards: bool,
}

pub fn function<F: FnMut(&[f64]) -> f64>(value: F) -> Function<F> {
    Function {
        value,
        calls: 0,
        points: 0,
        backwards: false,
    }
}

impl<F: FnMut(&[f64]) -> f64> Objective for Function<F> {
    fn misfits(&mut self, points: &[Vec<f64>]) -> Result<Vec<f64>, Stopped> {
        self.calls += 1;
        self.points += points.len();
        for x in points.iter().flatten() {
            assert!((0.0..=1.0).contains(x), "{points:?}");
        }
        if self.backwards {
            let mut values: Vec<f64> = points.iter().rev().map(|p| (self.value)(p)).collect();
            values.reverse();
            return Ok(values);
        }
        Ok(points.iter().map(|p| (self.value)(p)).collect())
    }
}

/// A normal value from a hash of two numbers: noise that needs no generator.
pub fn noise(seed: u64, index: u64) -> f64 {
    let mut x =
        seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ index.wrapping_mul(0xD1B5_4A32_D192_ED03);
    for _ in 0..3 {
        x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        x ^= x >> 31;
    }
    let uniform = ((x >> 12) as f64 + 0.5) / (1_u64 << 52) as f64;
    slipgap_statistics::normal::quantile(uniform)
}

/// The root of the mean square of differences.
pub fn rms(computed: &[f64], measured: &[f64]) -> f64 {
    let squares = computed
        .iter()
        .zip(measured)
        .map(|(c, m)| (c - m) * (c - m));
    (squares.sum::<f64>() / measured.len() as f64).sqrt()
}

/// Damped sine with amplitude, decay, frequency and phase at 200 times.
pub fn sine([a, decay, frequency, phase]: [f64; 4]) -> Vec<f64> {
    let time = (0..200).map(|i| f64::from(i) * 0.05);
    time.map(|t| a * libm::exp(-decay * t) * libm::sin(frequency * t + phase))
        .collect()
}

/// Amplitude 0.5 to 2, decay 0.02 to 2 (logarithmic), frequency 1 to 6, phase -1.5 to 1.5.
pub fn of_ranges(x: &[f64]) -> [f64; 4] {
    [
        0.5 + 1.5 * x[0],
        0.02 * libm::pow(100.0, x[1]),
        1.0 + 5.0 * x[2],
        -1.5 + 3.0 * x[3],
    ]
}
