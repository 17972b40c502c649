//! Cycles of loops and the energy that each takes.

use super::between;
use crate::metrics::structure::{extent, work};

/// How far a displacement must be below its middle, over its half range, before a new cycle can begin.
const BAND: f64 = 0.05;

/// Where the cycles of a displacement begin: places in the list, with fractions. The last one ends the last cycle.
///
/// A cycle begins where r rises through the middle of its extremes. Before that, r must have been below the middle by 5 % of its half
/// range, so that noise makes no cycles. What is before the first and after the last such place is no whole cycle.
pub fn cycles(r: &[f64]) -> Vec<f64> {
    let [low, high] = extent(r);
    let middle = 0.5 * (low + high);
    let below = middle - BAND * 0.5 * (high - low);
    let mut was_below = false;
    let mut places = Vec::new();
    for (i, pair) in r.windows(2).enumerate() {
        was_below |= pair[0] < below;
        if was_below && pair[0] < middle && pair[1] >= middle {
            places.push(i as f64 + (middle - pair[0]) / (pair[1] - pair[0]));
            was_below = false;
        }
    }
    places
}

/// Work of each of the cycles that begin and end at these places: the integral of S dr by trapezoids.
pub fn work_of_cycles(r: &[f64], s: &[f64], places: &[f64]) -> Vec<f64> {
    let part = |x: &[f64], from: f64, to: f64| {
        let indices = (from.floor() as usize + 1)..(to.ceil() as usize);
        let inner = indices.map(|i| x[i]);
        let ends = [between(x, from), between(x, to)];
        let part: Vec<f64> = [ends[0]]
            .into_iter()
            .chain(inner)
            .chain([ends[1]])
            .collect();
        part
    };
    let pairs = places.windows(2);
    pairs
        .map(|ends| work(&part(s, ends[0], ends[1]), &part(r, ends[0], ends[1])))
        .collect()
}

/// Mean work of the whole cycles of a loop; `None` if there is none.
pub fn energy_per_cycle(r: &[f64], s: &[f64]) -> Option<f64> {
    mean(&work_of_cycles(r, s, &cycles(r)))
}

/// mean |W(c) - W(m)| over mean |W(m)|, W the work of a whole cycle of the measured displacement, of two loops at the same times; `None`
/// without such a cycle, or if it has no work.
///
/// The measured cycles count in both loops, so that two loops always have as many.
pub fn energy_per_cycle_error(c: [&[f64]; 2], m: [&[f64]; 2]) -> Option<f64> {
    let places = cycles(m[0]);
    let measured = work_of_cycles(m[0], m[1], &places);
    let computed = work_of_cycles(c[0], c[1], &places);
    let differences = computed.iter().zip(&measured).map(|(c, m)| (c - m).abs());
    let size = mean(&measured.iter().map(|w| w.abs()).collect::<Vec<_>>())?;
    let difference = mean(&differences.collect::<Vec<_>>())?;
    (size > 0.0).then(|| difference / size)
}

/// The mean; `None` of nothing.
fn mean(x: &[f64]) -> Option<f64> {
    (!x.is_empty()).then(|| x.iter().sum::<f64>() / x.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// `count` rounds through these corners, each side in `pieces`.
    fn rounds(corners: &[[f64; 2]], count: usize, pieces: usize) -> [Vec<f64>; 2] {
        let point = |k: usize| {
            let (side, share) = (k / pieces, (k % pieces) as f64 / pieces as f64);
            let [a, b] = [side, side + 1].map(|i| corners[i % corners.len()]);
            [0, 1].map(|i| a[i] + share * (b[i] - a[i]))
        };
        let points: Vec<[f64; 2]> = (0..=count * corners.len() * pieces).map(point).collect();
        [0, 1].map(|i| points.iter().map(|point| point[i]).collect())
    }

    /// Asserts that `count` rounds have one cycle less, each of this work. The round must not begin where a cycle begins.
    fn assert_work(corners: &[[f64; 2]], expected: f64) {
        for pieces in [1, 7, 100] {
            let [r, s] = rounds(corners, 4, pieces);
            let works = work_of_cycles(&r, &s, &cycles(&r));
            assert_eq!(works.len(), 3, "{pieces}");
            for w in &works {
                assert!((w - expected).abs() < 1e-12 * expected, "{pieces}: {w}");
            }
            let mean = energy_per_cycle(&r, &s).unwrap();
            assert!((mean - expected).abs() < 1e-12 * expected);
        }
    }

    #[test]
    fn loops_of_straight_lines_take_the_energies_of_textbooks() {
        // Coulomb friction F with amplitude X: 4 F X.
        let (f, x) = (3.0, 0.25);
        assert_work(&[[-x, -f], [-x, f], [x, f], [x, -f]], 4.0 * f * x);
        // Bilinear with stiffnesses k1 and k2 and yield displacement y: 4 Q (X - y), Q = (k1 - k2) y.
        let (k1, k2, y, x) = (10.0, 1.0, 0.2, 1.5);
        let q = (k1 - k2) * y;
        let corners = [
            [-x, -q - k2 * x],
            [-x + 2.0 * y, q + k2 * (2.0 * y - x)],
            [x, q + k2 * x],
            [x - 2.0 * y, -q + k2 * (x - 2.0 * y)],
        ];
        assert_work(&corners, 4.0 * q * (x - y));
        // The middle of the extremes need not be 0.
        assert_work(&corners.map(|[r, s]| [r + 7.0, s]), 4.0 * q * (x - y));
    }

    #[test]
    fn a_viscous_loop_has_the_area_of_its_polygon() {
        // r = X sin wt, S = c w X cos wt at n points a period: the polygon in the ellipse has n/2 sin(2 pi/n) instead of pi.
        let (c, w, x, n) = (0.7, 3.0, 2.0, 60);
        let angles = (0..=5 * n + 7).map(|i| 2.0 * PI * f64::from(i) / f64::from(n) + 1.0);
        let (r, s): (Vec<f64>, Vec<f64>) = angles
            .map(|angle| (x * angle.sin(), c * w * x * angle.cos()))
            .unzip();
        let works = work_of_cycles(&r, &s, &cycles(&r));
        assert_eq!(works.len(), 4);
        let pi = 0.5 * f64::from(n) * (2.0 * PI / f64::from(n)).sin();
        for work in works {
            assert!((work - pi * c * w * x * x).abs() < 1e-12, "{work}");
        }
    }

    #[test]
    fn noise_makes_no_cycles() {
        let n = 2000;
        let r: Vec<f64> = (0..=n)
            .map(|i| {
                let t = 10.0 * PI * f64::from(i) / f64::from(n);
                let noise = 0.03 * (97.0 * t).sin();
                (t - 0.5).sin() + noise
            })
            .collect();
        // Five rises; before the first one the displacement was below the middle.
        let places = cycles(&r);
        assert_eq!(places.len(), 5, "{places:?}");
        for (k, rise) in places.iter().enumerate() {
            let t = 10.0 * PI * rise / f64::from(n);
            // The noise moves the middle and the crossing by 0.03 each.
            assert!((t - 0.5 - 2.0 * PI * k as f64).abs() < 0.07, "{t}");
        }
        assert!(cycles(&[1.0; 5]).is_empty() && cycles(&[]).is_empty());
        assert_eq!(energy_per_cycle(&[0.0, 1.0, 2.0], &[1.0; 3]), None);
    }

    #[test]
    fn the_error_is_that_of_the_mean_cycle() {
        // Coulomb loops of 1.0 and of 1.3 times the force on the same displacement: 0.3, whatever the sign.
        let [r, s] = rounds(&[[-1.0, -2.0], [-1.0, 2.0], [1.0, 2.0], [1.0, -2.0]], 4, 5);
        for a in [1.3, 0.7] {
            let computed: Vec<f64> = s.iter().map(|s| a * s).collect();
            let error = energy_per_cycle_error([&r, &computed], [&r, &s]).unwrap();
            assert!((error - 0.3).abs() < 1e-12);
        }
        // The cycles are the measured ones: a computed loop that does not move takes nothing.
        let still = vec![0.0; r.len()];
        assert_eq!(energy_per_cycle_error([&still, &s], [&r, &s]), Some(1.0));
        assert_eq!(energy_per_cycle_error([&r, &s], [&still, &s]), None);
        assert_eq!(energy_per_cycle_error([&r, &s], [&r, &still]), None);
    }
}
