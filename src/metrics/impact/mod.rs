//! Metrics of the bar impact, of cases side by side that share their exact solution and their steps.

mod budget;
mod sampled;
mod track;

pub use budget::budget;
pub use sampled::Sampled;
pub use track::{Row, Track};

use super::or_undefined;
use crate::lane::{Lane, largest, smallest};

/// Number of the metrics here.
pub const COUNT: usize = 11;

/// The metrics in the order of the problem's table, for each lane; not a finite number where one is undefined.
#[inline(always)]
pub fn evaluate<const L: usize>(c: &Track<L>, exact: &Sampled) -> [Lane<L>; COUNT] {
    let zero = Lane::splat(0.0);
    // Beside longer runs a lane has steps that are not its own.
    let steps = ..exact.count();
    let (r, rdot) = (&c.displacement[steps], &c.velocity[steps]);
    let (force, energy) = (&c.force[steps], &c.energy[steps]);
    let start = energy.first().copied().unwrap_or(zero);
    let (lost, won) = (smallest(energy) - start, largest(energy) - start);
    let drift = lost.zip(won, |lost, won| if -lost > won { lost } else { won });
    let end = energy.last().copied().unwrap_or(zero) - start;
    let (contact, separations) = (
        contact_duration(r, exact.step),
        separations(&r[..exact.openings]),
    );
    // Adding zero turns -0 into 0.
    let overlap = zero - smallest(r);
    let peak = largest(force);
    let oscillation = oscillation(rdot, exact);
    let impulse = impulse(force, exact.step);
    let norms = [rms(0, r, exact), rms(1, rdot, exact)];
    let of_start = |energy: Lane<L>| energy.zip(start, |energy, start| energy / start);
    [
        contact,
        separations,
        overlap,
        or_undefined(oscillation),
        peak,
        or_undefined(exact.impulse.map(|e| impulse.map(|i| i / e - 1.0))),
        c.restitution,
        of_start(drift),
        of_start(end),
        norms[0],
        norms[1],
    ]
}

/// Root of the mean square of c - e over the duration, `of` as in [`Sampled::mean`].
#[inline(always)]
fn rms<const L: usize>(of: usize, c: &[Lane<L>], exact: &Sampled) -> Lane<L> {
    let mean = exact.mean(
        of,
        #[inline(always)]
        |i, e| {
            let d = c[i] - Lane::splat(e);
            d * d
        },
    );
    mean.map(f64::sqrt)
}

/// From the last step before the first overlap to the first step after the last one, where both are there.
#[inline(always)]
fn contact_duration<const L: usize>(r: &[Lane<L>], step: f64) -> Lane<L> {
    // Step numbers as numbers: a lane is one comparison a step.
    let mut last = Lane::splat(0.0);
    for (i, r) in r.iter().enumerate() {
        let i = i as f64;
        last = last.zip(*r, |last, r| if r < 0.0 { i } else { last });
    }
    let mut contact = Lane::splat(f64::NAN);
    for l in 0..L {
        let first = r.iter().position(|r| r.0[l] < 0.0);
        let after = last.0[l] as usize + 1;
        if let Some(before) = first.and_then(|first| first.checked_sub(1))
            && after < r.len()
        {
            contact.0[l] = after as f64 * step - before as f64 * step;
        }
    }
    contact
}

/// Openings that close again, both within the steps `r`.
#[inline(always)]
fn separations<const L: usize>(r: &[Lane<L>]) -> Lane<L> {
    let closed = |r: Lane<L>| r.map(|r| if r < 0.0 { 1.0 } else { 0.0 });
    let Some(first) = r.first().map(|r| closed(*r)) else {
        return Lane::splat(0.0);
    };
    let (mut closings, mut before) = (Lane::splat(0.0), first);
    for r in &r[1..] {
        let now = closed(*r);
        closings = closings + now.zip(before, |now, before| now * (1.0 - before));
        before = now;
    }
    // From open at the start the first closing is the first touch.
    closings.zip(
        first,
        |n, first| if n > 0.0 { n - (1.0 - first) } else { n },
    )
}

/// RMS of rdot over the watched steps, if there are any.
#[inline(always)]
fn oscillation<const L: usize>(rdot: &[Lane<L>], exact: &Sampled) -> Option<Lane<L>> {
    let watched = rdot.get(exact.watched.clone())?;
    let mut sum = Lane::splat(0.0);
    for v in watched {
        sum = sum + *v * *v;
    }
    let count = watched.len() as f64;
    (count > 0.0).then(|| sum.map(|sum| (sum / count).sqrt()))
}

/// Integral of the force over the steps, by trapezoids.
#[inline(always)]
fn impulse<const L: usize>(force: &[Lane<L>], step: f64) -> Lane<L> {
    match force {
        [first, inner @ .., last] => {
            let mut sum = (*first + *last) * 0.5;
            for f in inner {
                sum = sum + *f;
            }
            sum * step
        }
        _ => Lane::splat(0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::wave::{Bars, Wave};
    use crate::metrics::cells;
    use crate::metrics::tests::assert_metrics;

    fn wave(gap: f64, end: f64) -> Wave {
        Bars {
            impedance_ratio: 1.0,
            time_ratio: 1.0,
            gap,
        }
        .solve(end)
    }

    /// Rows (r, rdot, F) at steps of a quarter T_I, and their metrics.
    fn metrics(
        rows: &[(f64, f64, f64)],
        gap: f64,
        energy: &[f64],
        restitution: f64,
    ) -> [Option<f64>; COUNT] {
        let column =
            |of: fn(&(f64, f64, f64)) -> f64| rows.iter().map(|row| Lane([of(row)])).collect();
        let track = Track {
            displacement: column(|row| row.0),
            velocity: column(|row| row.1),
            force: column(|row| row.2),
            energy: (0..rows.len())
                .map(|i| Lane([energy[i.min(energy.len() - 1)]]))
                .collect(),
            restitution: Lane([restitution]),
        };
        let last = rows.len() as u64 - 1;
        let end = last as f64 * 0.25;
        cells(evaluate(
            &track,
            &Sampled::new(&wave(gap, end), 0.25, last, end),
        ))
    }

    const ROWS: [(f64, f64, f64); 7] = [
        (0.0, -0.5, 0.0),
        (-0.1, -0.1, 1.2),
        (0.05, 0.3, 0.0),
        (-0.2, -0.4, 1.5),
        (-0.1, 0.2, 0.9),
        (0.3, 1.0, 0.0),
        (0.8, 1.0, 0.0),
    ];

    #[test]
    fn a_short_history_by_hand() {
        let energy = [2.0, 2.1, 1.8, 1.9, 1.9, 2.05, 2.05];
        // Exact r is 0 until T_I, then 2 (t - 1): off by 0, -0.1, 0.05, -0.2, -0.1, -0.2, -0.2. Exact rdot is 0, then
        // 1, and at t = 1 each side has its own: trapezoids of (0.25, 0.01), (0.01, 0.09), (0.09, 0.16), (0.16, 0.04),
        // (0.64, 0), (0, 0).
        let r: f64 = 0.25 * (0.1425 - 0.02) / 1.5;
        let rdot: f64 = 0.25 * 0.5 * 1.45 / 1.5;
        let wanted = [
            // From the step before the first overlap to the step after the last.
            1.25,
            // Open at 0.5, closed at 0.75.
            1.0,
            0.2,
            // Steps at 0.5 and 0.75.
            (0.125_f64).sqrt(),
            1.5,
            0.25 * 3.6 - 1.0,
            0.8,
            -0.1,
            0.025,
            r.sqrt(),
            rdot.sqrt(),
        ];
        assert_metrics(&metrics(&ROWS, 0.0, &energy, 0.8), &wanted.map(Some));
    }

    #[test]
    fn contact_ends_at_the_first_step_that_touches_without_overlap() {
        for r in [[0.0, -0.1, 0.0, 0.0, 0.3], [0.2, 0.1, -0.1, 0.0, 0.3]] {
            assert_eq!(contact_duration(&r.map(|r| Lane([r])), 0.25), Lane([0.5]));
        }
    }

    #[test]
    fn impulses_are_over_the_exact_one() {
        // Unlike bars: their exact impulse is not 1.
        let wave = Bars {
            impedance_ratio: 2.0,
            time_ratio: 0.25,
            gap: 0.0,
        }
        .solve(4.0);
        let exact = wave.impulse(4.0);
        assert!((exact - 1.0).abs() > 0.1, "{exact}");
        let mut track = Track::<1>::default();
        track.resize(17);
        track.force.fill(Lane([0.3]));
        let metrics = cells(evaluate(&track, &Sampled::new(&wave, 0.25, 16, 4.0)));
        let wanted = 1.2 / exact - 1.0;
        assert!((metrics[5].unwrap() - wanted).abs() < 1e-14, "{metrics:?}");
    }

    #[test]
    fn separations_must_close_again_in_time() {
        let count = |touch: f64, r: &[f64]| {
            let last = r.len() as u64 - 1;
            let sampled = Sampled::new(&wave(2.0 * touch, 2.0), 0.25, last, 2.0);
            let r: Vec<_> = r.iter().map(|r| Lane([*r])).collect();
            separations(&r[..sampled.openings]).0[0]
        };
        for (touch, r, wanted) in [
            (0.0, &[0.0, 0.1, -0.1][..], 0.0),
            (0.0, &[-0.1, 0.1, 0.1, 0.1, -0.1], 0.0),
            (0.1, &[-0.1, 0.1, 0.1, 0.1, -0.1], 1.0),
            (0.0, &[-0.1, 0.0, -0.1, 0.0], 1.0),
            (1.0, &[-0.1, 0.1, -0.1, 0.1, -0.1, 0.1, -0.1], 3.0),
            (1.0, &[-0.1, -0.1, 0.1, 0.1, -0.1, -0.1, -0.1], 1.0),
            (1.0, &[0.3, 0.2, 0.1, 0.2, 0.3], 0.0),
        ] {
            assert_eq!(count(touch, r), wanted, "{touch} {r:?}");
        }
    }

    #[test]
    fn cells_without_meaning_are_empty() {
        let defined = |rows: &[(f64, f64, f64)], gap: f64| {
            let metrics = metrics(rows, gap, &[1.0], 0.0);
            // contact duration, oscillation of rdot, impulse
            [metrics[0], metrics[3], metrics[5]].map(|m| m.is_some())
        };
        assert_eq!(defined(&ROWS, 0.0), [true, true, true]);
        // Still in contact; exact contact ends with the run, which is not beyond it.
        assert_eq!(defined(&ROWS[..5], 0.0), [false, true, false]);
        // Ends before 0.3 T_I; never in contact at all.
        assert_eq!(defined(&ROWS[..2], 0.0), [false, false, false]);
        let apart = [(9.0, -1.0, 0.0), (8.5, -1.0, 0.0)];
        assert_eq!(defined(&apart, 9.0), [false, false, false]);
        assert_eq!(metrics(&apart, 9.0, &[1.0], 0.0)[2], Some(-8.5));
    }
}
