//! Fewer points of curves that are looked at: those without which straight lines would be farthest from the curves.

use std::collections::{BTreeSet, BinaryHeap};

/// A curve, and by how much a line may miss it.
pub type Row<'a> = (&'a [f64], f64);

/// The places of the first smallest and of the first largest value.
pub fn extremes(values: &[f64]) -> [usize; 2] {
    let by = |better: fn(f64, f64) -> bool| {
        let mut best = 0;
        for (i, x) in values.iter().enumerate() {
            if better(*x, values[best]) {
                best = i;
            }
        }
        best
    };
    [by(|a, b| a < b), by(|a, b| a > b)]
}

/// Places of points in rising order: the first, the last, those of `kept`, and as many of the candidates that no row misses its
/// line by more than allowed, or `most` in all. `steps` has the time of each point.
pub fn thin(
    steps: &[u64],
    mut candidates: Vec<usize>,
    kept: Vec<usize>,
    rows: &[Row],
    most: usize,
) -> Vec<usize> {
    let Some(last) = steps.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut taken: BTreeSet<usize> = [0, last].into_iter().collect();
    taken.extend(kept);
    candidates.extend(&taken);
    candidates.sort_unstable();
    candidates.dedup();
    let position = |i: usize| candidates.binary_search(&i).unwrap_or(0);
    let ends: Vec<usize> = taken.iter().map(|i| position(*i)).collect();
    let farthest = |from: usize, to: usize| farthest(steps, &candidates[from..=to], rows);
    let mut pieces = BinaryHeap::new();
    let push = |pieces: &mut BinaryHeap<_>, from: usize, to: usize| {
        if let Some((miss, at)) = farthest(from, to) {
            // Of positive numbers the bits are in the order of the numbers; of equal ones the earliest piece is first.
            pieces.push((miss.to_bits(), std::cmp::Reverse(from), to, from + at));
        }
    };
    for pair in ends.windows(2) {
        push(&mut pieces, pair[0], pair[1]);
    }
    while taken.len() < most {
        let Some((_, std::cmp::Reverse(from), to, at)) = pieces.pop() else {
            break;
        };
        taken.insert(candidates[at]);
        push(&mut pieces, from, at);
        push(&mut pieces, at, to);
    }
    taken.into_iter().collect()
}

/// By how many times what is allowed the rows are off the line between the ends of a piece, and where; `None` if they are not.
fn farthest(steps: &[u64], piece: &[usize], rows: &[Row]) -> Option<(f64, usize)> {
    let (first, last) = (*piece.first()?, *piece.last()?);
    let length = (steps[last] - steps[first]) as f64;
    let mut most = (1.0, 0);
    for (values, allowed) in rows {
        let slope = (values[last] - values[first]) / length;
        let start = values[first];
        for (at, i) in piece.iter().enumerate().skip(1) {
            let line = start + slope * (steps[*i] - steps[first]) as f64;
            let miss = (values[*i] - line).abs() / allowed;
            if miss > most.0 && *i != last {
                most = (miss, at);
            }
        }
    }
    (most.1 > 0).then_some(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polygon_keeps_its_corners_only() {
        let steps: Vec<u64> = (0..=100).collect();
        let values: Vec<f64> = (0..=100_i32)
            .map(|i| f64::from((i - 30).abs().min((i - 70).abs())))
            .collect();
        let steps_all: Vec<usize> = (0..=100).collect();
        let found = thin(&steps, steps_all, Vec::new(), &[(&values, 1e-9)], 50);
        assert_eq!(found, [0, 30, 50, 70, 100]);
        assert_eq!(extremes(&values), [30, 0]);
    }

    #[test]
    fn what_is_kept_stays_even_without_room() {
        let steps: Vec<u64> = (0..=1000).collect();
        let values: Vec<f64> = (0..=1000).map(|i| libm::sin(f64::from(i))).collect();
        let steps_all: Vec<usize> = (0..=1000).collect();
        let kept = vec![3, 4, 500, 999];
        let found = thin(&steps, steps_all, kept.clone(), &[(&values, 1e-3)], 20);
        assert_eq!(found.len(), 20);
        assert!(kept.iter().all(|i| found.contains(i)));
    }

    #[test]
    fn lines_between_the_points_are_as_near_as_asked() {
        let steps: Vec<u64> = (0..=2000).collect();
        let curve = |k: f64| -> Vec<f64> {
            let value = |i: i32| libm::sin(k * f64::from(i) / 200.0);
            (0..=2000).map(value).collect()
        };
        let (slow, fast) = (curve(1.0), curve(3.0));
        let steps_all: Vec<usize> = (0..=2000).collect();
        let rows: [Row; 2] = [(&slow, 0.01), (&fast, 0.02)];
        let found = thin(&steps, steps_all, Vec::new(), &rows, 5000);
        assert!(found.len() < 120, "{}", found.len());
        for (values, allowed) in rows {
            for pair in found.windows(2) {
                let slope = (values[pair[1]] - values[pair[0]]) / (pair[1] - pair[0]) as f64;
                for i in pair[0]..pair[1] {
                    let line = values[pair[0]] + slope * (i - pair[0]) as f64;
                    assert!((values[i] - line).abs() <= allowed);
                }
            }
        }
    }
}
