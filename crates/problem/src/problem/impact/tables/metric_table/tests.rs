use super::{DEFAULT, values};
use crate::exact::wave::{Bars, Wave};
use crate::lane::Lane;
use crate::metrics::cells;
use crate::metrics::impact::{Compared, Energy, Sampled, Track};
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

fn evaluated(
    track: &Track<1>,
    energy: &Energy<1>,
    restitution: Lane<1>,
    exact: &Sampled,
) -> [Option<f64>; DEFAULT.len()] {
    cells(values(&Compared::new(track, energy, restitution, exact)))
}

/// Rows (r, rdot, F) at steps of a quarter T_I, and their metrics.
fn metrics(
    rows: &[(f64, f64, f64)],
    gap: f64,
    energy: &[f64],
    restitution: f64,
) -> [Option<f64>; DEFAULT.len()] {
    let column = |of: fn(&(f64, f64, f64)) -> f64| rows.iter().map(|row| Lane([of(row)])).collect();
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
    evaluated(&track, &Energy::of(energy), restitution, &exact)
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
    let metrics = evaluated(&track, &energy, rest, &Sampled::new(&wave, 0.25, 16, 4.0));
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
        evaluated(&track, &Energy::of(&[1.0]), Lane([0.0]), &exact)[6]
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
