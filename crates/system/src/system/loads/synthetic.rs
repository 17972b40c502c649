//! A synthetic ground acceleration by rule: noise with the spectrum of Clough and Penzien under the envelope of Jennings.

use super::{STANDARD_GRAVITY, signal::zero_beyond};
use crate::system::structure::Table;
use libm::{cos, exp, sin};
use std::f64::consts::PI;

/// Number of points of a motion, with the jump at its end.
pub const POINTS: usize = STEPS + 2;

/// Time step in s.
const STEP: f64 = 0.01;
/// Number of steps: 30 s.
const STEPS: usize = 3000;
/// Number of cosines: multiples of 1/30 Hz up to 25 Hz.
const COSINES: usize = 750;
/// The peak of every motion in g.
pub const PEAK: f64 = 0.3;
/// Circular frequency of the ground filter in rad/s for firm ground `[Clough and Penzien 1975]`.
pub const FIRM_GROUND: f64 = 15.6;

/// Whether a motion passes the ground filter of this omega: its cosines are numbers, and not all of them 0.
pub fn passes(omega: f64) -> bool {
    let densities = (1..=COSINES).map(|k| spectral_density(frequency(k), omega));
    let mut any = false;
    for density in densities {
        if !density.is_finite() {
            return false;
        }
        any |= density > 0.0;
    }
    any
}

/// Circular frequency of the k-th cosine.
fn frequency(k: usize) -> f64 {
    2.0 * PI * k as f64 / (STEPS as f64 * STEP)
}

/// The synthetic acceleration of a seed in m/s2, at 0, 0.01, .. 30 s, with a peak of 0.3 g. omega > 0 is the circular frequency of the
/// ground filter in rad/s, [`FIRM_GROUND`] for the rule's own. `None` if omega is so small or large that no motion is left.
///
/// The sum of sqrt(S(w)) cos(w t + 2 pi u_k) at the circular frequencies w = 2 pi k/30 s, k = 1 .. 750, with
///
/// ```text
/// S(w) = (1 + 1.44 x)/((1 - x)^2 + 1.44 x)  y^2/((1 - y)^2 + 1.44 y),  x = (w/omega)^2, y = (10 w/omega)^2
/// ```
///
/// (`[Clough and Penzien 1975]`; both damping ratios 0.6, the second filter at omega/10), times (t/2)^2 until 2 s, 1 until 10 s and
/// exp(-(t - 10)/4) after (`[Jennings et al. 1968]`), scaled to the peak. u_k is the k-th number of SplitMix64.
pub fn synthetic(seed: u64, omega: f64) -> Option<Table> {
    // w t = 2 pi (k i mod 3000)/3000 at step i: all angles are multiples of one.
    let angle = |n: usize| 2.0 * PI * (n as f64 / STEPS as f64);
    let turns: Vec<[f64; 2]> = (0..STEPS).map(|n| [cos(angle(n)), sin(angle(n))]).collect();
    let mut sum = vec![0.0; STEPS + 1];
    let mut random = SplitMix64(seed);
    for k in 1..=COSINES {
        let amplitude = spectral_density(frequency(k), omega).sqrt();
        let phase = 2.0 * PI * random.uniform();
        let [c, s] = [amplitude * cos(phase), amplitude * sin(phase)];
        let mut n = 0;
        for a in &mut sum {
            let [cos, sin] = turns[n];
            *a += c * cos - s * sin;
            n += k;
            if n >= STEPS {
                n -= STEPS;
            }
        }
    }
    let times: Vec<f64> = (0..=STEPS).map(|i| i as f64 * STEP).collect();
    let shaped: Vec<f64> = sum
        .iter()
        .zip(&times)
        .map(|(a, t)| a * envelope(*t))
        .collect();
    let peak = shaped.iter().fold(0.0, |peak: f64, a| peak.max(a.abs()));
    let scale = PEAK * STANDARD_GRAVITY / peak;
    zero_beyond(times, shaped.iter().map(|a| a * scale).collect())
}

/// S(w) of ground with omega_g = omega, zeta_g = 0.6, omega_f = omega/10, zeta_f = 0.6.
fn spectral_density(w: f64, omega: f64) -> f64 {
    let [x, y] = [omega, omega / 10.0].map(|corner| (w / corner) * (w / corner));
    let soil = (1.0 + 1.44 * x) / ((1.0 - x) * (1.0 - x) + 1.44 * x);
    soil * (y * y / ((1.0 - y) * (1.0 - y) + 1.44 * y))
}

/// The envelope at time t.
fn envelope(t: f64) -> f64 {
    if t < 2.0 {
        (t / 2.0) * (t / 2.0)
    } else if t <= 10.0 {
        1.0
    } else {
        exp(-0.25 * (t - 10.0))
    }
}

/// SplitMix64 `[Steele, Lea and Flood 2014]`.
struct SplitMix64(u64);

impl SplitMix64 {
    /// The next number in [0, 1): the upper 53 bits.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::loads::spectrum::arias;

    #[test]
    fn the_numbers_of_seed_1_are_the_printed_ones() {
        let mut random = SplitMix64(1);
        let printed = [0.5665615751722809, 0.7457817572627011, 0.9710027535867962];
        assert_eq!([(); 3].map(|()| random.uniform()), printed);
    }

    #[test]
    fn the_record_of_seed_1_has_the_printed_intensity_and_peak() {
        let record = synthetic(1, FIRM_GROUND).unwrap();
        // Half a unit of the last printed digit.
        assert!((arias(&record, STANDARD_GRAVITY) - 1.8006723669).abs() < 5e-11);
        let (mut at, mut peak) = (0.0, 0.0);
        for (t, a) in record.times().iter().zip(record.values()) {
            if a.abs() > peak {
                (at, peak) = (*t, a.abs());
            }
        }
        // Round-off of a product, and of a product and a quotient.
        assert!((at - 6.52).abs() < 1e-14 && (peak - 0.3 * 9.80665).abs() < 1e-14);
        assert_eq!((record.times().len(), record.at(30.0)), (3002, 0.0));
    }

    #[test]
    fn the_sum_is_the_rule_term_by_term() {
        // Points of the rule, computed with numpy's cosine of w t + 2 pi u_k for seed 1.
        let record = synthetic(1, FIRM_GROUND).unwrap();
        for (i, a) in [
            (0, 0.0),
            (1, -9.687694883518868e-06),
            (137, 0.23914552883852627),
            (652, -2.941995),
            (1000, -0.4278404090159567),
            (1500, 0.578680956746348),
            (2999, 0.0030913090576033474),
            (3000, 3.994658015260115e-06),
        ] {
            // 750 terms of a few units of the sum, which the scale makes 1e-13.
            assert!(
                (record.values()[i] - a).abs() < 1e-12,
                "{i} {} {a}",
                record.values()[i]
            );
        }
    }

    #[test]
    fn another_ground_filter_gives_the_points_of_another_program() {
        // numpy, as above, for seed 7 and omega = 8.
        let record = synthetic(7, 8.0).unwrap();
        for (i, a) in [
            (1, -1.3213589629819991e-05),
            (137, -0.10028052766048313),
            (652, -2.19378707157089),
            (1000, -1.0649441612226678),
            (2999, -0.0002167355736162065),
        ] {
            assert!((record.values()[i] - a).abs() < 1e-12, "{i}");
        }
        // No motion is left beyond the cosines of the rule.
        for omega in [1e-200, 1e-160, 1e-150, 8.0, 1e60, 1e100, 1e162, 1e200] {
            assert_eq!(passes(omega), synthetic(1, omega).is_some(), "{omega}");
        }
        assert!(!passes(1e-200) && !passes(1e200) && passes(1e60));
    }
}
