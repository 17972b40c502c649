//! Metrics of the bar impact, for several cases with the same exact solution and steps.

mod contact;
mod energy;
mod reference;
mod sampled;
mod track;

pub use energy::{Energy, damping_work, energy_of_books, step_work};
pub use reference::reference;
pub use sampled::Sampled;
pub use track::Track;

use super::or_undefined;
use crate::lane::{Lane, largest, smallest};
use contact::{durations, impulse, oscillation, separations};

/// Number of the metrics here.
pub const COUNT: usize = 12;

/// The metrics in the order of the problem's table, for each lane; not a finite number if undefined.
///
/// `restitution` is the relative velocity of the mass centres at the end over c.
#[inline(always)]
pub fn evaluate<const L: usize>(
    c: &Track<L>,
    energy: &Energy<L>,
    restitution: Lane<L>,
    exact: &Sampled,
) -> [Lane<L>; COUNT] {
    // Next to longer runs a lane has more steps than the case.
    let own = ..exact.count();
    let (r, rdot) = (&c.displacement[own], &c.velocity[own]);
    let force = &c.force[own];
    let start = energy.start;
    let (lost, gained) = (energy.smallest - start, energy.largest - start);
    let drift = lost.zip(
        gained,
        |lost, gained| if -lost > gained { lost } else { gained },
    );
    let end = energy.last - start;
    // The sum to the last step is not finite if an energy overflowed, also where the extremes ignored NaN.
    let drift = drift.zip(
        end,
        |drift, end| if end.is_finite() { drift } else { f64::NAN },
    );
    // A rigid contact is closed while it has a force.
    let touching = if c.touching.is_empty() {
        r
    } else {
        &c.touching[own]
    };
    let deepest = smallest(touching);
    let overlap = smallest(r).map(|r| if r < 0.0 { -r } else { 0.0 });
    // Without contact its metrics are undefined. A touch at the last step would be a contact by round-off only.
    let in_contact = |metric: Lane<L>| {
        deepest.zip(metric, |r, metric| {
            if r < 0.0 && exact.touches {
                metric
            } else {
                f64::NAN
            }
        })
    };
    let [duration, steps] = durations(touching, exact.step);
    let separations = separations(&touching[..exact.openings]);
    let oscillation = or_undefined(oscillation(rdot, exact));
    let impulse = impulse(force, exact.step);
    let impulse = exact.impulse.map(|e| impulse.map(|i| i / e - 1.0));
    let norms = [rms(0, r, exact), rms(1, rdot, exact)];
    let of_start = |energy: Lane<L>| energy.zip(start, |energy, start| energy / start);
    [
        in_contact(duration),
        in_contact(steps),
        in_contact(separations),
        in_contact(overlap),
        in_contact(oscillation),
        in_contact(largest(force)),
        in_contact(or_undefined(impulse)),
        in_contact(restitution),
        of_start(drift),
        of_start(end),
        norms[0],
        norms[1],
    ]
}

/// Norm of c - e, see [`Sampled::rms`].
#[inline(always)]
fn rms<const L: usize>(component: usize, c: &[Lane<L>], exact: &Sampled) -> Lane<L> {
    exact.rms(
        component,
        #[inline(always)]
        |i, e| c[i] - Lane::splat(e),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::wave::{Bars, Wave};
    use crate::metrics::cells;
    use crate::metrics::tests::assert_metrics;
    use crate::solve::Track as _;

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
            touching: Vec::new(),
        };
        let last = rows.len() as u64 - 1;
        let end = last as f64 * 0.25;
        let exact = Sampled::new(&wave(gap, end), 0.25, last, end);
        let restitution = Lane([restitution]);
        cells(evaluate(&track, &Energy::of(energy), restitution, &exact))
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
        let expected = [
            // From r = 0 at t = 0 to a quarter of the way from r = -0.1 at t = 1 to 0.3 at 1.25.
            1.0625,
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
        assert_metrics(&metrics(&ROWS, 0.0, &energy, 0.8), &expected.map(Some));
    }

    #[test]
    fn contact_lasts_from_zero_to_zero_of_r() {
        // Steps of 1/4, of binary fractions only: no sum rounds.
        let (zero, large) = (-0.0, 1e308);
        for (r, linear, in_steps) in [
            // Zero at both steps; zero for longer before and after; from t = 0 on.
            (&[0.5, 0.0, -0.5, 0.0, 0.5][..], 0.5, 0.5),
            (&[0.5, 0.0, 0.0, -0.5, 0.0, 0.0, 0.5], 0.5, 0.5),
            (&[0.0, -0.5, 0.0, 0.0, 0.5], 0.5, 0.5),
            (&[zero, -0.5, zero], 0.5, 0.5),
            // Half a step before 1/2 and a quarter of one after it.
            (&[0.5, 0.125, -0.125, 0.375], 0.1875, 0.5),
            // Touched without overlap, before and after.
            (&[0.5, 0.0, 0.25, -0.25, 0.25, 0.0, 0.5], 0.25, 0.5),
            // Opens in between; ends at the last step.
            (&[0.0, -0.5, 0.5, 0.5, -0.25, 0.75], 1.0625, 1.25),
            // A difference above the range of double precision.
            (&[large, -large, large], 0.25, 0.5),
        ] {
            let lanes: Vec<_> = r.iter().map(|r| Lane([*r])).collect();
            assert_eq!(
                durations(&lanes, 0.25),
                [Lane([linear]), Lane([in_steps])],
                "{r:?}"
            );
        }
        for r in [&[0.5, 0.0, 0.5][..], &[0.5, -0.5, -0.25], &[0.0]] {
            let lanes: Vec<_> = r.iter().map(|r| Lane([*r])).collect();
            assert!(durations(&lanes, 0.25).iter().all(|d| d.0[0].is_nan()));
        }
    }

    #[test]
    fn impulses_are_relative_to_the_exact_one() {
        // Bars that differ: their exact impulse is not 1.
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
        track.displacement.fill(Lane([-0.1]));
        let (energy, rest) = (Energy::of(&[1.0]), Lane([0.0]));
        let metrics = cells(evaluate(
            &track,
            &energy,
            rest,
            &Sampled::new(&wave, 0.25, 16, 4.0),
        ));
        let expected = 1.2 / exact - 1.0;
        assert!(
            (metrics[6].unwrap() - expected).abs() < 1e-14,
            "{metrics:?}"
        );
    }

    #[test]
    fn impulses_end_with_the_last_step_before_separation() {
        // Steps of 0.3 to 0.9, exact separation at 1, end of the run at 1.1: both impulses are up to 0.9.
        let wave = wave(0.0, 1.1);
        let mut track = Track::<1>::default();
        track.resize(4);
        track.force.fill(Lane([0.7]));
        track.displacement.fill(Lane([-0.1]));
        let impulse_error = |duration: f64| {
            let exact = Sampled::new(&wave, 0.3, 3, duration);
            cells(evaluate(&track, &Energy::of(&[1.0]), Lane([0.0]), &exact))[6]
        };
        assert!(
            (impulse_error(1.1).unwrap() + 0.3).abs() < 1e-15,
            "{:?}",
            impulse_error(1.1)
        );
        // The duration must be beyond the separation.
        assert_eq!([impulse_error(1.0), impulse_error(0.95)], [None; 2]);
    }

    #[test]
    fn separations_must_close_again_in_time() {
        let count = |touch: f64, r: &[f64]| {
            let last = r.len() as u64 - 1;
            let sampled = Sampled::new(&wave(2.0 * touch, 2.0), 0.25, last, 2.0);
            let r: Vec<_> = r.iter().map(|r| Lane([*r])).collect();
            separations(&r[..sampled.openings]).0[0]
        };
        for (touch, r, expected) in [
            (0.0, &[0.0, 0.1, -0.1][..], 0.0),
            (0.0, &[-0.1, 0.1, 0.1, 0.1, -0.1], 0.0),
            (0.1, &[-0.1, 0.1, 0.1, 0.1, -0.1], 1.0),
            (0.0, &[-0.1, 0.0, -0.1, 0.0], 1.0),
            (1.0, &[-0.1, 0.1, -0.1, 0.1, -0.1, 0.1, -0.1], 3.0),
            (1.0, &[-0.1, -0.1, 0.1, 0.1, -0.1, -0.1, -0.1], 1.0),
            (1.0, &[0.3, 0.2, 0.1, 0.2, 0.3], 0.0),
        ] {
            assert_eq!(count(touch, r), expected, "{touch} {r:?}");
        }
    }

    #[test]
    fn undefined_metrics_are_empty() {
        let defined = |rows: &[(f64, f64, f64)], gap: f64| {
            let metrics = metrics(rows, gap, &[1.0], 0.0);
            // contact duration twice, oscillation of rdot, impulse
            assert_eq!(metrics[0].is_some(), metrics[1].is_some());
            [metrics[0], metrics[4], metrics[6]].map(|m| m.is_some())
        };
        assert_eq!(defined(&ROWS, 0.0), [true, true, true]);
        // Still in contact; exact contact ends with the run, which is not beyond it.
        assert_eq!(defined(&ROWS[..5], 0.0), [false, true, false]);
        // Ends before 0.3 T_I.
        assert_eq!(defined(&ROWS[..2], 0.0), [false, false, false]);
    }

    #[test]
    fn without_contact_its_metrics_are_empty() {
        let without = |rows: &[(f64, f64, f64)], gap: f64| {
            let metrics = metrics(rows, gap, &[2.0, 2.5], 0.5);
            let empty = metrics[..8].iter().all(Option::is_none);
            assert!(empty || metrics[..8].iter().any(Option::is_some));
            assert!(metrics[8..].iter().all(Option::is_some), "{metrics:?}");
            empty
        };
        assert!(without(&[(9.0, -1.0, 0.0), (8.5, -1.0, 0.0)], 9.0));
        // A touch at the last step, where the sign of r is round-off.
        for r in [0.0, -1e-17, 1e-17] {
            assert!(without(&[(0.5, -1.0, 0.0), (r, -1.0, -1e-16)], 0.5));
        }
        // A step later there is a contact.
        let touching = [(0.25, -1.0, 0.0), (-0.1, -0.5, 1.0)];
        assert!(!without(&touching, 0.25));
        let metrics = metrics(&touching, 0.25, &[2.0], 0.5);
        assert_eq!(
            [metrics[2], metrics[3], metrics[5], metrics[7]],
            [Some(0.0), Some(0.1), Some(1.0), Some(0.5)]
        );
    }
}
