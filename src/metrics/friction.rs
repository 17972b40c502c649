//! Metrics of the friction oscillator; `c` is the computed history, `e` the exact one, sums run over steps 0..=N.
//!
//! Displacements enter over |x0|, so that no sum of squares overflows before the displacements themselves do.

use super::reached;
use crate::exact::coulomb::Coulomb;
use crate::history::History;
use std::f64::consts::PI;

/// The metrics in the order of the problem's table; `None` where one is undefined.
pub fn evaluate(x0: f64, duration: f64, c: &History, e: &History) -> Vec<Option<f64>> {
    let exact = Coulomb::new(x0);
    let scale = x0.abs();
    let rests = exact.half_cycles() >= 1.0 && reached(duration, exact.rest_time());
    let errors = || pairs(c, e).map(|(c, e)| (c - e) / scale);
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        pairs(c, e).map(|(c, e)| f(c / scale, e / scale)).sum()
    };
    let (cc, ee, ce) = (sum(&|c, _| c * c), sum(&|_, e| e * e), sum(&|c, e| c * e));
    let magnitude = (cc / ee).sqrt() - 1.0;
    // Round-off can bring the cosine of two like histories past 1.
    let phase = libm::acos((ce / (cc.sqrt() * ee.sqrt())).clamp(-1.0, 1.0)) / PI;
    vec![
        Some((errors().map(|d| d * d).sum::<f64>() / c.len() as f64).sqrt()),
        errors().map(f64::abs).reduce(f64::max),
        peak_error(&exact, c).map(|d| d / scale),
        reached(duration, exact.rest_time())
            .then(|| errors().last().map(f64::abs))
            .flatten(),
        residual_motion(&exact, c).map(|d| d / scale),
        rests.then(|| work(c, scale) / (exact.work() / scale) - 1.0),
        Some(magnitude),
        Some(phase),
        Some((magnitude * magnitude + phase * phase).sqrt()),
    ]
    .into_iter()
    .map(|value| value.filter(|x: &f64| x.is_finite()))
    .collect()
}

/// What the error is made of, for the regularised motion `g` in continuous time between the exact one and the
/// computed: norms of g - e and c - g as `rms_error` has them, then their shares <part, c - e>/<c - e, c - e>.
///
/// Each share is a part's own; their sum is 1, and a share beyond 1 says that the other part takes from it.
pub fn budget(x0: f64, c: &History, e: &History, g: &History) -> [Option<f64>; 4] {
    let scale = x0.abs();
    let sum = |a: &History, b: &History, of: &dyn Fn(f64, f64) -> f64| -> f64 {
        let totals = pairs(c, e).map(|(c, e)| (c - e) / scale);
        let parts = pairs(a, b).map(|(a, b)| (a - b) / scale);
        parts.zip(totals).map(|(part, total)| of(part, total)).sum()
    };
    let rms = |a, b| (sum(a, b, &|part, _| part * part) / c.len() as f64).sqrt();
    let whole = sum(c, e, &|total, _| total * total);
    let share = |a, b| sum(a, b, &|part, total| part * total) / whole;
    [rms(g, e), rms(c, g), share(g, e), share(c, g)].map(|x| Some(x).filter(|x| x.is_finite()))
}

/// Displacements of two histories, step by step.
fn pairs<'a>(c: &'a History, e: &'a History) -> impl Iterator<Item = (f64, f64)> + 'a {
    c.displacement
        .iter()
        .copied()
        .zip(e.displacement.iter().copied())
}

/// Work of the friction force by trapezoids, sum (S_i + S_{i+1}) (X_{i+1} - X_i)/2, over `scale`.
pub fn work(c: &History, scale: f64) -> f64 {
    c.force
        .windows(2)
        .zip(c.displacement.windows(2))
        .map(|(s, x)| (s[0] + s[1]) * ((x[1] - x[0]) / scale) * 0.5)
        .sum()
}

/// Largest error of the peaks k = 1..=m, each the extreme of s_k c over (k - 1/2) pi <= T <= (k + 1/2) pi.
///
/// Undefined where there is no peak, or where a peak's window holds no step.
fn peak_error(exact: &Coulomb, c: &History) -> Option<f64> {
    let m = exact.half_cycles();
    let (mut largest, mut k, mut first) = (None, 1.0, 0);
    while k <= m {
        let (from, to) = ((k - 0.5) * PI, (k + 0.5) * PI);
        first += c.time[first..]
            .iter()
            .take_while(|&&t| !reached(t, from))
            .count();
        // A step on the border belongs to both windows.
        let peak = c.time[first..]
            .iter()
            .zip(&c.displacement[first..])
            .take_while(|&(&t, _)| reached(to, t))
            .map(|(_, x)| exact.side(k) * x)
            .reduce(f64::max)?;
        let error = (peak - exact.amplitude(k)).abs();
        largest = Some(largest.map_or(error, |l: f64| l.max(error)));
        k += 1.0;
    }
    largest
}

/// Half the range of the motion from T = (m + 1) pi on; undefined where the run ends before.
fn residual_motion(exact: &Coulomb, c: &History) -> Option<f64> {
    let from = (exact.half_cycles() + 1.0) * PI;
    let late = || {
        c.time
            .iter()
            .zip(&c.displacement)
            .filter(move |&(&t, _)| reached(t, from))
            .map(|(_, &x)| x)
    };
    Some((late().reduce(f64::max)? - late().reduce(f64::min)?) * 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::tests::assert_metrics;

    /// Rows at T = i pi/2 with these X and S.
    fn history(rows: &[(f64, f64)]) -> History {
        let mut history = History::default();
        for (i, &(x, s)) in rows.iter().enumerate() {
            history.push(i as f64 * 0.5 * PI, x, 0.0, s);
        }
        history
    }

    #[test]
    fn a_short_history_by_hand() {
        // x0 = 3 rests at -1 from T = pi on (m = 1), having lost (9 - 1)/2 = 4.
        let c = history(&[
            (3.0, 0.0),
            (1.0, -1.0),
            (-1.5, -0.4),
            (-0.9, 1.0),
            (-1.1, 0.0),
            (-0.8, 0.2),
        ]);
        let e = history(&[
            (3.0, 0.0),
            (0.0, 0.0),
            (-1.0, 0.0),
            (-1.0, 0.0),
            (-1.0, 0.0),
            (-1.0, 0.0),
        ]);
        // c - e = 0, 1, -0.5, 0.1, -0.1, 0.2; work = 1 + 1.75 + 0.18 - 0.1 + 0.03 = 2.86.
        let (cc, ee, ce): (f64, f64, f64) = (14.91, 13.0, 13.3);
        let magnitude = (cc / ee).sqrt() - 1.0;
        let phase = (ce / (cc * ee).sqrt()).acos() / PI;
        let wanted = [
            (1.31_f64 / 6.0).sqrt() / 3.0,
            1.0 / 3.0,
            // Within pi/2 <= T <= 3 pi/2 the lowest is -1.5.
            0.5 / 3.0,
            0.2 / 3.0,
            // From 2 pi on: -1.1 and -0.8.
            0.15 / 3.0,
            2.86 / 4.0 - 1.0,
            magnitude,
            phase,
            magnitude.hypot(phase),
        ];
        assert_metrics(&evaluate(3.0, 2.5 * PI, &c, &e), &wanted.map(Some));
        // Mirrored, everything stays.
        let mirror = |h: &History| {
            let mut h = h.clone();
            for x in h.displacement.iter_mut().chain(&mut h.force) {
                *x = -*x;
            }
            h
        };
        assert_metrics(
            &evaluate(-3.0, 2.5 * PI, &mirror(&c), &mirror(&e)),
            &wanted.map(Some),
        );
    }

    #[test]
    fn cells_without_meaning_are_empty() {
        let rows = [(3.0, 0.0), (1.0, -1.0), (-1.5, -0.4), (-0.9, 1.0)];
        let defined = |x0: f64, rows: &[(f64, f64)]| {
            let c = history(rows);
            let duration = *c.time.last().unwrap();
            let metrics = evaluate(x0, duration, &c, &c);
            [metrics[2], metrics[3], metrics[4], metrics[5]].map(|m| m.is_some())
        };
        // peak, rest, residual motion, work
        assert_eq!(defined(3.0, &rows), [true, true, false, true]);
        // Before m pi, with a step in the peak's window and without.
        assert_eq!(defined(3.0, &rows[..2]), [true, false, false, false]);
        assert_eq!(defined(3.0, &rows[..1]), [false, false, false, false]);
        // Never moves: m = 0, no peak, no work.
        assert_eq!(defined(0.5, &rows), [false, true, true, false]);
    }
}
