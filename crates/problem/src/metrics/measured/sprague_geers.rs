//! Differences of two motions by their size and by their phase.

use crate::metrics::structure::peak;
use libm::{atan2, hypot};
use std::f64::consts::PI;

/// Differences of two motions by their size and by their phase.
///
/// With the integrals over time I_cc = int c^2, I_mm = int m^2 and I_cm = int c m, by trapezoids:
/// M = sqrt(I_cc/I_mm) - 1, P = acos(I_cm/sqrt(I_cc I_mm))/pi, C = sqrt(M^2 + P^2). Sprague and Geers,
/// International Journal for Numerical Methods in Engineering 60 (2004) 2467.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpragueGeers {
    /// M, >= -1: above 0 where the computed motion is larger.
    pub magnitude: f64,
    /// P, 0 to 1: 0.5 without correlation, 1 for opposite signs.
    pub phase: f64,
    /// C, >= 0.
    pub combined: f64,
}

/// The differences of two motions at `times`, which rise; `None` if one of them is always 0.
pub fn sprague_geers(times: &[f64], c: &[f64], m: &[f64]) -> Option<SpragueGeers> {
    let weights = weights(times);
    let norm = |x: &[f64]| {
        // Divided by the peak, so that squares neither overflow nor vanish.
        let peak = peak(x);
        let squares = weights
            .iter()
            .zip(x)
            .map(|(w, x)| w * (x / peak) * (x / peak));
        (peak, squares.sum::<f64>().sqrt())
    };
    let ((peak_c, c_norm), (peak_m, m_norm)) = (norm(c), norm(m));
    let defined = |norm: f64| norm > 0.0 && norm.is_finite();
    if !defined(c_norm) || !defined(m_norm) {
        return None;
    }
    // The angle between two unit vectors from their sum and their difference: acos(1 - 1e-16) is 1.5e-8 instead of 0.
    let (mut sum, mut difference) = (0.0, 0.0);
    for (w, (c, m)) in weights.iter().zip(c.iter().zip(m)) {
        let (c, m) = (c / peak_c / c_norm, m / peak_m / m_norm);
        sum += w * (c + m) * (c + m);
        difference += w * (c - m) * (c - m);
    }
    let magnitude = (peak_c / peak_m) * (c_norm / m_norm) - 1.0;
    let phase = 2.0 / PI * atan2(difference.sqrt(), sum.sqrt());
    Some(SpragueGeers {
        magnitude,
        phase,
        combined: hypot(magnitude, phase),
    })
}

/// The weights of trapezoids for points at `times`.
fn weights(times: &[f64]) -> Vec<f64> {
    let last = times.len().saturating_sub(1);
    let weight = |i: usize| 0.5 * (times[(i + 1).min(last)] - times[i.saturating_sub(1)]);
    (0..times.len()).map(weight).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scaled_motion_has_a_magnitude_and_no_phase() {
        let times = [0.0, 0.3, 0.4, 1.0, 1.7];
        let m = [1.0, -2.0, 0.5, 3.0, -0.1];
        for a in [1.0, 1.25, 0.5, 3e-200, 1e200] {
            let by = sprague_geers(&times, &m.map(|m| a * m), &m).unwrap();
            assert!((by.magnitude - (a - 1.0)).abs() < 1e-15 * (1.0 + a));
            assert!(by.phase < 1e-15, "{}", by.phase);
            let opposite = sprague_geers(&times, &m.map(|m| -a * m), &m).unwrap();
            assert!((opposite.phase - 1.0).abs() < 1e-15);
        }
        assert_eq!(sprague_geers(&times, &[0.0; 5], &m), None);
        assert_eq!(sprague_geers(&times, &m, &[0.0; 5]), None);
        assert_eq!(sprague_geers(&[], &[], &[]), None);
    }

    #[test]
    fn sines_differ_by_their_shift() {
        // Over whole periods trapezoids are exact for sines, whose phase is then the shift over pi.
        let n = 1000;
        let times: Vec<f64> = (0..=n)
            .map(|i| 4.0 * PI * f64::from(i) / f64::from(n))
            .collect();
        let sine = |a: f64, shift: f64| -> Vec<f64> {
            let value = |t: &f64| a * (t - shift).sin();
            times.iter().map(value).collect()
        };
        for shift in [0.0, 1e-6, 0.1, 0.5 * PI, 3.0] {
            let by = sprague_geers(&times, &sine(2.0, shift), &sine(2.0, 0.0)).unwrap();
            assert!(by.magnitude.abs() < 1e-13, "{shift}: {}", by.magnitude);
            assert!(
                (by.phase - shift / PI).abs() < 1e-13,
                "{shift}: {}",
                by.phase
            );
            let by = sprague_geers(&times, &sine(3.0, shift), &sine(2.0, 0.0)).unwrap();
            let combined = (0.25 + shift * shift / (PI * PI)).sqrt();
            assert!((by.combined - combined).abs() < 1e-13, "{shift}");
        }
    }

    #[test]
    fn the_numbers_of_another_program_come_from_its_integrals() {
        // Altair MotionView 2022, bushing model: I_cc, I_mm and I_cm, M and P. Two points have any three integrals; the weights are
        // both 1/2.
        for ([cc, mm, cm], magnitude, phase) in [
            ([143.50, 143.50, 77.00], 0.0, 0.319714),
            ([13.9628, 6.67958, 9.59216], 0.445811, 0.037025),
        ] {
            let m = [f64::sqrt(2.0 * mm), 0.0];
            let along = 2.0 * cm / m[0];
            let c = [along, (2.0 * cc - along * along).sqrt()];
            let by = sprague_geers(&[0.0, 1.0], &c, &m).unwrap();
            // The integrals are printed with six digits, of which the difference in P leaves five.
            assert!((by.magnitude - magnitude).abs() < 2e-6, "{}", by.magnitude);
            assert!((by.phase - phase).abs() < 2e-6, "{}", by.phase);
        }
    }

    #[test]
    fn the_weights_of_uneven_times_are_those_of_trapezoids() {
        // c = 1 and m = t at uneven times: I_cc = 1, I_cm = 1/2, I_mm by the sum that follows.
        let times = [0.0, 0.1, 0.4, 1.0];
        let mm = 0.1 * 0.005 + 0.3 * 0.085 + 0.6 * 0.58;
        let by = sprague_geers(&times, &[1.0; 4], &times).unwrap();
        assert!((by.magnitude - (1.0 / f64::sqrt(mm) - 1.0)).abs() < 1e-14);
        assert!((by.phase - (0.5 / f64::sqrt(mm)).acos() / PI).abs() < 1e-14);
    }
}
