//! Parts of accelerations, and later ones.

use super::signal::zero_beyond;
use crate::system::structure::{Baseline, NoEnd, Table};

/// The part of an acceleration from `start` to `end`, with `start` as its t = 0; 0 beyond. Without them from t = 0, to the last point.
///
/// `None` if no part is left.
pub fn cut(acceleration: &Table, start: Option<f64>, end: Option<f64>) -> Option<Table> {
    let (times, values) = acceleration.own_points();
    let [first, last] = [*times.first()?, *times.last()?];
    let from = start.unwrap_or(0.0).max(first);
    let to = end.unwrap_or(last).min(last);
    if from >= to {
        return None;
    }
    // The value before a jump at the end is that of the points.
    let at_end = match times.iter().position(|t| *t == to) {
        Some(index) => values[index],
        None => acceleration.at(to),
    };
    let table_points = times.iter().zip(values);
    let inner = table_points.filter(|(t, _)| **t > from && **t < to);
    let ends = |t: f64, a: f64| std::iter::once((t, a));
    let points = ends(from, acceleration.at(from)).chain(inner.map(|(t, a)| (*t, *a)));
    let shift = start.unwrap_or(0.0);
    let points = points.chain(ends(to, at_end)).map(|(t, a)| (t - shift, a));
    let (times, values) = points.unzip();
    zero_beyond(times, values)
}

/// An acceleration without its baseline; 0 after its last point.
///
/// # Errors
/// It has no end.
pub fn without_baseline(acceleration: Table, baseline: Baseline) -> Result<Table, NoEnd> {
    if baseline == Baseline::None {
        return Ok(acceleration);
    }
    let (times, values) = baseline.removed(&acceleration, 1.0)?.into_iter().unzip();
    Table::new(times, values).ok_or(NoEnd)
}

/// An acceleration that is `delay` >= 0 later, and 0 before; `None` if a time is not finite.
pub fn delayed(acceleration: &Table, delay: f64) -> Option<Table> {
    if delay == 0.0 {
        return Some(acceleration.clone());
    }
    // What is before t = 0 does not act.
    let times = acceleration.times().iter().zip(acceleration.values());
    let after_start = times.filter(|(t, _)| **t > 0.0);
    let points =
        std::iter::once((0.0, acceleration.at(0.0))).chain(after_start.map(|(t, a)| (*t, *a)));
    let (mut times, mut values): (Vec<f64>, Vec<f64>) = points.map(|(t, a)| (t + delay, a)).unzip();
    if values.first().is_some_and(|first| *first != 0.0) {
        times.insert(0, delay);
        values.insert(0, 0.0);
    }
    Table::new(times, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(table: &Table) -> Vec<(f64, f64)> {
        let times = table.times().iter().copied();
        times.zip(table.values().iter().copied()).collect()
    }

    fn record() -> Table {
        zero_beyond(vec![0.0, 1.0, 2.0, 4.0], vec![1.0, 3.0, -1.0, 2.0]).unwrap()
    }

    #[test]
    fn a_part_begins_at_zero_and_is_zero_beyond() {
        assert_eq!(
            points(&cut(&record(), None, None).unwrap()),
            points(&record())
        );
        let part = cut(&record(), Some(0.5), Some(3.0)).unwrap();
        let expected = [(0.0, 2.0), (0.5, 3.0), (1.5, -1.0), (2.5, 0.5), (2.5, 0.0)];
        assert_eq!(points(&part), expected);
        let rest = cut(&record(), Some(2.0), Some(99.0)).unwrap();
        assert_eq!(points(&rest), [(0.0, -1.0), (2.0, 2.0), (2.0, 0.0)]);
        assert_eq!(cut(&record(), Some(4.0), None), None);
        assert_eq!(cut(&record(), Some(2.0), Some(1.0)), None);
        // A motion that begins later keeps the time before.
        let later = zero_beyond(vec![2.0, 3.0], vec![1.0, 1.0]).unwrap();
        let part = cut(&later, Some(1.0), None).unwrap();
        assert_eq!(
            points(&part),
            [(1.0, 0.0), (1.0, 1.0), (2.0, 1.0), (2.0, 0.0)]
        );
    }

    #[test]
    fn a_delay_shifts_all_of_a_motion() {
        let late = delayed(&record(), 1.5).unwrap();
        let expected = [
            (1.5, 0.0),
            (1.5, 1.0),
            (2.5, 3.0),
            (3.5, -1.0),
            (5.5, 2.0),
            (5.5, 0.0),
        ];
        assert_eq!(points(&late), expected);
        assert_eq!([late.at(0.7), late.at(2.0)], [0.0, 2.0]);
        assert_eq!(delayed(&record(), 0.0), Some(record()));
    }

    #[test]
    fn a_baseline_leaves_no_velocity() {
        let part = cut(&record(), Some(0.5), Some(3.0)).unwrap();
        let level = without_baseline(part, Baseline::Linear).unwrap();
        let (t, a) = (level.times(), level.values());
        let area: f64 = (1..t.len())
            .map(|i| (t[i] - t[i - 1]) * (a[i] + a[i - 1]) / 2.0)
            .sum();
        assert!(area.abs() < 1e-15 && level.at(9.0) == 0.0);
    }
}
