//! The limits of axes: those of the study, or else round the values that are drawn.

use crate::layout::axis::Axis;
use crate::layout::axis::Scale;
use crate::layout::sheet::Series;
use crate::layout::ticks;

/// An axis over `range`, or else round the values; `most` labels at most.
pub fn axis(
    title: &str,
    values: impl Iterator<Item = f64>,
    scale: Scale,
    range: Option<[f64; 2]>,
    most: f64,
) -> Axis {
    match (scale, range) {
        (Scale::Linear, None) => ticks::around(title, values, most),
        (Scale::Log, None) => ticks::log(title, values, most),
        (Scale::Linear, Some(range)) => ticks::linear(title, range, most),
        (Scale::Log, Some(range)) => ticks::log_range(title, range, most),
    }
}

/// The heights of points inside of `x`; of all points if fewer than two are inside, or `x` is not given.
pub fn heights<'a>(
    points: impl Iterator<Item = &'a [f64; 2]> + Clone,
    x: Option<[f64; 2]>,
) -> Vec<f64> {
    let inside = |point: &&[f64; 2]| x.is_none_or(|[a, b]| (a..=b).contains(&point[0]));
    let ordinates = points.clone().map(|point| point[1]);
    let heights: Vec<f64> = points.filter(inside).map(|point| point[1]).collect();
    let known = heights.iter().filter(|height| height.is_finite()).count();
    if known < 2 {
        ordinates.collect()
    } else {
        heights
    }
}

/// The points of several curves.
pub fn points<'a>(
    series: impl Iterator<Item = &'a Series> + Clone,
) -> impl Iterator<Item = &'a [f64; 2]> + Clone {
    series.flat_map(|series| &series.points)
}
