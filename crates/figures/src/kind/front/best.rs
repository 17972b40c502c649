//! The points of a front, and which of them are the best.

use crate::DrawnCase;
use crate::column::has_place;
use slipgap_study::Study;
use slipgap_study::alike;
use slipgap_study::kinds::Front;

/// A case, or the mean of several cases.
pub struct Point<'a> {
    /// The two metrics.
    pub at: [f64; 2],
    /// The case, or the first of several.
    pub shown: DrawnCase<'a>,
}

/// The points that have a place, and how many cases have none.
pub fn points<'a>(
    front: &Front,
    study: &Study,
    cases: &[DrawnCase<'a>],
) -> (Vec<Point<'a>>, usize) {
    let groups = match front.mean_over {
        None => cases.iter().map(|shown| vec![*shown]).collect(),
        Some(row) => {
            let shared = alike::unaffected(&*study.problem, &study.blocks, &[row]);
            let identity = |shown: &DrawnCase| shown.identity(&shared);
            alike::grouped(cases.iter().copied(), identity)
        }
    };
    let mut lacking = 0;
    let mut points = Vec::new();
    for group in groups {
        let placed = |at: &[f64; 2]| {
            at.iter()
                .zip(front.scales)
                .all(|(x, scale)| has_place(scale, *x))
        };
        match mean(front, &group).filter(placed) {
            Some(at) => points.push(Point {
                at,
                shown: group[0],
            }),
            None => lacking += group.len(),
        }
    }
    (points, lacking)
}

/// The mean of x and the root mean square of y; `None` if either is undefined in a case.
fn mean(front: &Front, group: &[DrawnCase]) -> Option<[f64; 2]> {
    let metric = |row: usize| -> Option<Vec<f64>> {
        let values = group.iter().map(|shown| shown.metric(row));
        values.collect()
    };
    let (x, y) = (metric(front.x)?, metric(front.y)?);
    match (x.as_slice(), y.as_slice()) {
        // Without the rounding of a square and its root.
        ([x], [y]) => Some([*x, *y]),
        _ => {
            let count = group.len() as f64;
            let squares: f64 = y.iter().map(|y| y * y).sum();
            Some([x.iter().sum::<f64>() / count, (squares / count).sqrt()])
        }
    }
}

/// Which points no other one surpasses in one coordinate without being worse in the other, by rising x. Of several points
/// at one place it is the first.
pub fn best(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let [across, up] =
        [0, 1].map(|k| move |a: usize, b: usize| points[a][k].total_cmp(&points[b][k]));
    order.sort_by(|a, b| across(*a, *b).then(up(*a, *b)));
    let mut best: Vec<usize> = Vec::new();
    for i in order {
        if best
            .last()
            .is_none_or(|last| points[i][1] < points[*last][1])
        {
            best.push(i);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        // By the definition, point against point. Coarse coordinates give points at one place and on one line.
        #[test]
        fn the_best_are_those_that_no_other_surpasses(
            points in prop::collection::vec([0_u8..12, 0_u8..12], 0..40)
        ) {
            let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
            let surpasses = |a: &[f64; 2], b: &[f64; 2]| a != b && a[0] <= b[0] && a[1] <= b[1];
            let first = |i: usize| points[..i].iter().all(|p| *p != points[i]);
            let mut expected: Vec<usize> = (0..points.len())
                .filter(|i| first(*i) && !points.iter().any(|p| surpasses(p, &points[*i])))
                .collect();
            expected.sort_by(|a, b| points[*a][0].total_cmp(&points[*b][0]));
            prop_assert_eq!(best(&points), expected);
        }
    }
}
