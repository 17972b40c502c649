use super::{DEFAULT, Shared, values};
use crate::history::History;
use crate::lane::Lane;
use crate::methods::ContactWork;
use crate::metrics::cells;
use crate::metrics::friction::{Compared, Sampled, work_by_steps};
use crate::metrics::tests::assert_metrics;
use std::f64::consts::PI;

/// Rows at T = i pi/2 with these X and S.
fn history(rows: &[(f64, f64)]) -> History {
    let rows = rows.iter().enumerate();
    rows.map(|(i, &(x, s))| (i as f64 * 0.5 * PI, [x, 0.0, s]))
        .collect()
}

fn evaluated(c: &[Lane<1>], work: Lane<1>, exact: &Sampled) -> [Option<f64>; DEFAULT.len()] {
    let compared = Compared::new(c, exact);
    cells(values(&Shared { compared, work }))
}

fn metrics(x0: f64, c: &History) -> [Option<f64>; DEFAULT.len()] {
    let (last, x) = (
        c.len() as u64 - 1,
        c.displacement().iter().map(|x| Lane([*x])),
    );
    let exact = Sampled::new(x0, 0.5 * PI, last, last as f64 * 0.5 * PI);
    let x: Vec<_> = x.collect();
    let rows: Vec<_> = (0..c.len())
        .map(|i| [c.displacement()[i], c.velocity()[i], c.force()[i]])
        .collect();
    let work = Lane([work_by_steps(&rows, x0, &ContactWork::Trapezoids)]);
    evaluated(&x, work, &exact)
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
    // e = 1 + 2 cos T to T = pi, then -1: c - e = 0, 0, -0.5, 0.1, -0.1, 0.2; work = 1 + 1.75 + 0.18 - 0.1 + 0.03.
    let (cc, ee, ce): (f64, f64, f64) = (14.91, 14.0, 14.3);
    let magnitude = (cc / ee).sqrt() - 1.0;
    let phase = (ce / (cc * ee).sqrt()).acos() / PI;
    let expected = [
        (0.31_f64 / 6.0).sqrt() / 3.0,
        0.5 / 3.0,
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
    assert_metrics(&metrics(3.0, &c), &expected.map(Some));
    // The mirrored motion has the same metrics.
    let mirror = |h: &History| {
        let mut h = h.clone();
        for x in h.channels.iter_mut().flatten() {
            *x = -*x;
        }
        h
    };
    assert_metrics(&metrics(-3.0, &mirror(&c)), &expected.map(Some));
}

#[test]
fn a_proportional_motion_has_no_phase_error() {
    // The square of the phase is round-off of either sign; its root is about 1e-8.
    for i in 1..200 {
        let factor = f64::from(i) * 0.013;
        let rows: Vec<_> = [3.0, 1.0, -1.0, -1.0, -1.0]
            .map(|e| (factor * e, 0.0))
            .to_vec();
        let metrics = metrics(3.0, &history(&rows));
        let phase = metrics[7].expect("a phase");
        assert!((0.0..4e-8).contains(&phase), "{factor}: {phase:e}");
        assert!((metrics[6].expect("a magnitude") - (factor - 1.0)).abs() < 1e-15 * 4.0);
    }
}

#[test]
fn peaks_need_the_whole_last_window() {
    // x0 = 12 has m = 6 half-cycles: the last window ends at 6.5 pi, where the run may end within the slack.
    let peak = |duration: f64| {
        let step = 0.01 * PI;
        let last = crate::metrics::steps(duration, step);
        let exact = Sampled::new(12.0, step, last, duration);
        let x: Vec<_> = exact.at.iter().map(|x| Lane([12.0 * x])).collect();
        evaluated(&x, Lane([0.0]), &exact)[2]
    };
    for (ends, defined) in [
        (5.49, false),
        (5.52, false),
        (6.0, false),
        (6.49, false),
        (6.5, true),
    ] {
        assert_eq!(peak(ends * PI).is_some(), defined, "{ends} pi");
    }
    assert!(peak(6.5 * PI * (1.0 - 5e-13)).is_some());
    assert!(peak(6.5 * PI * (1.0 - 2e-12)).is_none());
    // The exact motion has its peaks at steps.
    assert!(peak(6.5 * PI) < Some(1e-14));
}

#[test]
fn undefined_metrics_are_empty() {
    let rows = [(3.0, 0.0), (1.0, -1.0), (-1.5, -0.4), (-0.9, 1.0)];
    let defined = |x0: f64, rows: &[(f64, f64)]| {
        let metrics = metrics(x0, &history(rows));
        [metrics[2], metrics[3], metrics[4], metrics[5]].map(|m| m.is_some())
    };
    // peak, rest, residual motion, work
    assert_eq!(defined(3.0, &rows), [true, true, false, true]);
    // At m pi, in the middle of the peak's window; before it, with a step in the window and without.
    assert_eq!(defined(3.0, &rows[..3]), [false, true, false, true]);
    assert_eq!(defined(3.0, &rows[..2]), [false, false, false, false]);
    assert_eq!(defined(3.0, &rows[..1]), [false, false, false, false]);
    // No motion: m = 0, no peak, no work.
    assert_eq!(defined(0.5, &rows), [false, true, true, false]);
}
