//! Metrics of the bar impact; `c` is the computed history, `wave` the exact solution.

mod budget;

pub use budget::budget;

use super::reached;
use crate::exact::wave::{State, Wave};
use crate::history::History;

/// Openings are counted and rdot is watched up to this time after the exact first touch: then the returning front
/// parts the ends for good.
const WATCHED: f64 = 0.9;

/// The metrics in the order of the problem's table; `None` where one is undefined.
pub fn evaluate(
    c: &History,
    wave: &Wave,
    duration: f64,
    energy: &[f64],
    restitution: f64,
) -> Vec<Option<f64>> {
    let touch = wave.first_touch();
    let drift = |e: f64| (e - energy[0]) / energy[0];
    let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
    let norm = |of| Norm {
        time: &c.time,
        wave,
        of,
        duration,
    };
    vec![
        contact_duration(c),
        Some(separations(c, touch)),
        // Adding zero turns -0 into 0.
        c.displacement.iter().map(|r| 0.0 - r).reduce(f64::max),
        rdot_oscillation(c, touch),
        c.force.iter().copied().reduce(f64::max),
        impulse_error(c, wave, duration),
        Some(restitution),
        energy.iter().map(|&e| drift(e)).reduce(larger),
        energy.last().map(|&e| drift(e)),
        Some(norm(displacement).rms_error(&c.displacement)),
        Some(norm(velocity).rms_error(&c.velocity)),
    ]
    .into_iter()
    .map(|value| value.filter(|x: &f64| x.is_finite()))
    .collect()
}

fn displacement(state: State) -> f64 {
    state.displacement
}

fn velocity(state: State) -> f64 {
    state.velocity
}

/// From the last step before the first overlap to the first step after the last one.
fn contact_duration(c: &History) -> Option<f64> {
    let first = c.displacement.iter().position(|&r| r < 0.0)?;
    let last = c.displacement.iter().rposition(|&r| r < 0.0)?;
    let (before, after) = (first.checked_sub(1)?, last + 1);
    Some(c.time.get(after)? - c.time[before])
}

/// Openings that close again, both in time.
fn separations(c: &History, touch: f64) -> f64 {
    let (mut count, mut opened) = (0, false);
    for (pair, &t) in c.displacement.windows(2).zip(&c.time[1..]) {
        if !reached(touch + WATCHED, t) {
            break;
        }
        match (pair[0] < 0.0, pair[1] < 0.0) {
            (true, false) => opened = true,
            (false, true) if opened => {
                count += 1;
                opened = false;
            }
            _ => {}
        }
    }
    f64::from(count)
}

fn rdot_oscillation(c: &History, touch: f64) -> Option<f64> {
    let watched = c
        .time
        .iter()
        .zip(&c.velocity)
        .filter(|&(&t, _)| reached(t, touch + 0.3) && reached(touch + WATCHED, t));
    let (count, sum) = watched.fold((0_u32, 0.0), |(count, sum), (_, v)| {
        (count + 1, sum + v * v)
    });
    (count > 0).then(|| (sum / f64::from(count)).sqrt())
}

/// Both impulses up to the last step; undefined unless the run outlasts the exact contact.
fn impulse_error(c: &History, wave: &Wave, duration: f64) -> Option<f64> {
    let [_, parted] = wave.durations();
    if reached(parted?, duration) {
        return None;
    }
    let impulse: f64 = c
        .time
        .windows(2)
        .zip(c.force.windows(2))
        .map(|(t, f)| 0.5 * (t[1] - t[0]) * (f[0] + f[1]))
        .sum();
    Some(impulse / wave.impulse(*c.time.last()?) - 1.0)
}

/// Means over the duration of something that depends on the exact r or rdot.
struct Norm<'a> {
    time: &'a [f64],
    wave: &'a Wave,
    of: fn(State) -> f64,
    duration: f64,
}

impl Norm<'_> {
    /// Of `what(i, e)`, i a step and e the exact value there: trapezoids over the steps, each with the exact limits of
    /// its own side; jumps inside a step are not looked for.
    fn mean(&self, what: impl Fn(usize, f64) -> f64) -> f64 {
        let steps = self.time.windows(2).enumerate();
        let integral: f64 = steps
            .map(|(i, t)| {
                let start = what(i, (self.of)(self.wave.at(t[0])));
                let end = what(i + 1, (self.of)(self.wave.before(t[1])));
                0.5 * (t[1] - t[0]) * (start + end)
            })
            .sum();
        integral / self.duration
    }

    fn rms_error(&self, c: &[f64]) -> f64 {
        self.mean(|i, e| (c[i] - e) * (c[i] - e)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::wave::Bars;
    use crate::metrics::tests::assert_metrics;

    fn wave(gap: f64, end: f64) -> Wave {
        Bars {
            impedance_ratio: 1.0,
            time_ratio: 1.0,
            gap,
        }
        .solve(end)
    }

    /// Rows (r, rdot, F) at steps of a quarter T_I.
    fn history(rows: &[(f64, f64, f64)]) -> History {
        let mut history = History::default();
        for (i, &(r, rdot, force)) in rows.iter().enumerate() {
            history.push(i as f64 * 0.25, r, rdot, force);
        }
        history
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
        let found = evaluate(&history(&ROWS), &wave(0.0, 1.5), 1.5, &energy, 0.8);
        assert_metrics(&found, &wanted.map(Some));
    }

    #[test]
    fn contact_ends_at_the_first_step_that_touches_without_overlap() {
        let rows = [0.0, -0.1, 0.0, 0.0, 0.3].map(|r| (r, 0.0, 0.0));
        assert_eq!(contact_duration(&history(&rows)), Some(0.5));
    }

    #[test]
    fn separations_must_close_again_in_time() {
        let count = |touch: f64, r: &[f64]| {
            let rows: Vec<_> = r.iter().map(|&r| (r, 0.0, 0.0)).collect();
            separations(&history(&rows), touch)
        };
        for (touch, r, wanted) in [
            (0.0, &[0.0, 0.1, -0.1][..], 0.0),
            (0.0, &[-0.1, 0.1, 0.1, 0.1, -0.1], 0.0),
            (0.1, &[-0.1, 0.1, 0.1, 0.1, -0.1], 1.0),
            (0.0, &[-0.1, 0.0, -0.1, 0.0], 1.0),
            (1.0, &[-0.1, 0.1, -0.1, 0.1, -0.1, 0.1, -0.1], 3.0),
        ] {
            assert_eq!(count(touch, r), wanted, "{touch} {r:?}");
        }
    }

    #[test]
    fn cells_without_meaning_are_empty() {
        let defined = |rows: &[(f64, f64, f64)], gap: f64| {
            let c = history(rows);
            let duration = *c.time.last().unwrap();
            let metrics = evaluate(&c, &wave(gap, duration), duration, &[1.0], 0.0);
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
        let overlap = evaluate(&history(&apart), &wave(9.0, 0.25), 0.25, &[1.0], 0.0)[2];
        assert_eq!(overlap, Some(-8.5));
    }
}
