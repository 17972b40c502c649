//! Fragility curves by incremental scaling and of a cloud of cases.

use super::point::{FragilityPoint, Probability};
use crate::DrawnCase;
use slipgap_statistics::binomial;
use slipgap_statistics::capacity::{Estimate, of_capacities, of_cloud};
use slipgap_statistics::lognormal::NoFit;
use slipgap_study::kinds::Fragility;
use slipgap_study::{ColumnRef, alike};

/// Points and estimate of a curve.
pub type Found = (Vec<FragilityPoint>, Result<Estimate, NoFit>);

/// The place of a case along the horizontal axis.
fn place(figure: &Fragility, shown: &DrawnCase) -> Option<f64> {
    match figure.x {
        ColumnRef::Parameter(row) => shown.value(row)?.as_f64(),
        ColumnRef::Metric(row) => shown.metric(row),
    }
}

/// Place and metric of the cases that have both.
fn points<'a>(
    figure: &Fragility,
    cases: impl Iterator<Item = &'a &'a DrawnCase<'a>>,
) -> Vec<[f64; 2]> {
    let point = |shown: &&DrawnCase| Some([place(figure, shown)?, shown.metric(figure.y)?]);
    cases.filter_map(point).collect()
}

/// By incremental scaling: each member of the ensemble reaches the limit between two of its cases. The points are the parts of the
/// members that have reached it.
pub fn incremental(figure: &Fragility, ensemble: &[usize], cases: &[&DrawnCase]) -> Found {
    let members = alike::grouped(cases, |shown| shown.identity(ensemble));
    let (mut reached, mut empty, mut beyond, mut before) = (Vec::new(), 0, 0, 0);
    for member in &members {
        let mut points = points(figure, member.iter().copied());
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        match capacity(&points, figure.limit) {
            Capacity::None => empty += 1,
            Capacity::Beyond => beyond += 1,
            Capacity::Before => before += 1,
            Capacity::At(x) => reached.push(x),
        }
    }
    reached.sort_by(f64::total_cmp);
    let cases = members.len() as u64;
    let count = cases - empty;
    let point = |(i, at): (usize, &f64)| {
        let exceeded = before + i as u64 + 1;
        let [low, high] = binomial::interval(exceeded, count);
        FragilityPoint {
            at: *at,
            cases,
            empty,
            exceeded,
            probability: Some(Probability {
                value: exceeded as f64 / count as f64,
                low,
                high,
            }),
        }
    };
    let mut points: Vec<FragilityPoint> = reached.iter().enumerate().map(point).collect();
    if points.is_empty() {
        // At no place; its row says why.
        points.push(FragilityPoint {
            at: f64::NAN,
            cases,
            empty,
            exceeded: before,
            probability: None,
        });
    }
    let estimate = match (before, beyond) {
        (0, 0) => of_capacities(&reached),
        (0, beyond) => Err(NoFit::Beyond(beyond)),
        (before, _) => Err(NoFit::Before(before as usize)),
    };
    (points, estimate)
}

/// Where a member of an ensemble reaches a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Capacity {
    /// It has no case with a value.
    None,
    /// Its first case exceeds it.
    Before,
    /// No case exceeds it.
    Beyond,
    /// There, straight between its last case before and its first one that exceeds.
    At(f64),
}

fn capacity(points: &[[f64; 2]], limit: f64) -> Capacity {
    match points.iter().position(|point| point[1] > limit) {
        _ if points.is_empty() => Capacity::None,
        None => Capacity::Beyond,
        Some(0) => Capacity::Before,
        Some(i) => {
            let ([x0, y0], [x1, y1]) = (points[i - 1], points[i]);
            Capacity::At(x0 + (x1 - x0) * ((limit - y0) / (y1 - y0)))
        }
    }
}

/// Of a cloud: each case is a point, 1 if it exceeds.
pub fn cloud(figure: &Fragility, cases: &[&DrawnCase]) -> Found {
    let all = points(figure, cases.iter());
    let point = |[at, y]: &[f64; 2]| {
        let exceeded = u64::from(*y > figure.limit);
        let value = exceeded as f64;
        FragilityPoint {
            at: *at,
            cases: 1,
            empty: 0,
            exceeded,
            probability: Some(Probability {
                value,
                low: value,
                high: value,
            }),
        }
    };
    let mut points: Vec<FragilityPoint> = all.iter().map(point).collect();
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    (points, of_cloud(&all, figure.limit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_capacity_is_between_the_last_case_before_and_the_first_that_exceeds() {
        let points = [[1.0, 0.5], [2.0, 1.5], [3.0, 0.9], [4.0, 9.0]];
        assert_eq!(capacity(&points, 1.0), Capacity::At(1.5));
        assert_eq!(capacity(&points, 0.4), Capacity::Before);
        assert_eq!(capacity(&points, 9.0), Capacity::Beyond);
        assert_eq!(capacity(&[], 1.0), Capacity::None);
    }
}
