//! The line along a map: in each column through the place where the metric is least, greatest or nearest to 1.

use crate::colour_map::Ridge;
use crate::colour_map::bands::Values;
use crate::layout::axis::Axis;
use crate::layout::axis::Scale;
use crate::layout::sheet::{Panel, Series};
use crate::style::{self, Stroke};

/// Largest distance of neighbours of one line, as a fraction of the height.
const JUMP: f64 = 0.03;

/// Largest distance of neighbours of one line in places of the grid, if that is more.
const STEPS: usize = 2;

/// Its label in the legend; the colour bar names the metric.
pub fn label(ridge: Ridge, x: &str) -> String {
    let what = match ridge {
        Ridge::Least => "least",
        Ridge::Greatest => "greatest",
        Ridge::NearestToOne => "nearest to 1",
    };
    format!("{what} at each {x}")
}

/// The row of each column's place; none at the edge, because the extreme value may be outside of the map.
pub fn rows(values: &Values, ridge: Ridge) -> Vec<Option<usize>> {
    let [x, y] = &values.places;
    let rank = |z: f64| match ridge {
        Ridge::Least => z,
        Ridge::Greatest => -z,
        Ridge::NearestToOne => (z - 1.0).abs(),
    };
    let row = |i: usize| {
        let column = values.z[i * y.len()..(i + 1) * y.len()].iter().enumerate();
        let known = column.filter(|(_, z)| z.is_finite());
        let j = known.min_by(|a, b| rank(*a.1).total_cmp(&rank(*b.1)))?.0;
        (j > 0 && j + 1 < y.len()).then_some(j)
    };
    (0..x.len()).map(row).collect()
}

/// The line: broken where the place jumps from one column to the next. A single place is a stroke over its column.
pub fn line(panel: &Panel, [x, y]: [&[f64]; 2], rows: &[Option<usize>], label: String) -> Series {
    let height = |row: usize| panel.y.fraction(y[row]);
    let linked = |a: usize, b: usize| match (rows.get(a), rows.get(b)) {
        (Some(Some(a)), Some(Some(b))) => {
            a.abs_diff(*b) <= STEPS || (height(*a) - height(*b)).abs() <= JUMP
        }
        _ => false,
    };
    let gap = [f64::NAN; 2];
    let mut points = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let Some(row) = row else { continue };
        let (before, after) = (i > 0 && linked(i - 1, i), linked(i, i + 1));
        if before || after {
            points.push([x[i], y[*row]]);
        } else {
            let [left, right] = [i.saturating_sub(1), (i + 1).min(x.len() - 1)];
            let ends = [left, right].map(|other| [between(&panel.x, x[i], x[other]), y[*row]]);
            points.extend(ends);
        }
        if !after {
            points.push(gap);
        }
    }
    Series {
        label,
        points,
        stroke: Stroke::Solid,
        width: style::RIDGE_LINE,
        marker: None,
        marked: Vec::new(),
    }
}

/// Half-way between two places on the scale.
fn between(axis: &Axis, a: f64, b: f64) -> f64 {
    match axis.scale {
        Scale::Linear => a / 2.0 + b / 2.0,
        Scale::Log => a.sqrt() * b.sqrt(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::sheet::Rect;
    use crate::layout::ticks;

    /// Three columns of five places each.
    fn values() -> Values {
        let columns = [
            [5.0, 2.0, 0.5, 4.0, 3.0],
            [5.0, 1.1, 7.0, 0.2, 9.0],
            [0.1, 2.0, 3.0, 4.0, 5.0],
        ];
        Values {
            places: [vec![1.0, 2.0, 4.0], vec![0.0, 1.0, 2.0, 3.0, 4.0]],
            z: columns.concat(),
        }
    }

    #[test]
    fn each_ridge_follows_its_value_and_not_along_the_edge() {
        assert_eq!(rows(&values(), Ridge::Least), [Some(2), Some(3), None]);
        assert_eq!(rows(&values(), Ridge::Greatest), [None, None, None]);
        // 0.5 is nearer to 1 than 2 is; the last column starts with 0.1 and goes on with 2.
        assert_eq!(
            rows(&values(), Ridge::NearestToOne),
            [Some(2), Some(1), None]
        );
        let mut turned = values();
        turned.z.iter_mut().for_each(|z| *z = -*z);
        assert_eq!(rows(&turned, Ridge::Greatest), [Some(2), Some(3), None]);
    }

    #[test]
    fn a_line_breaks_where_its_place_jumps() {
        let frame = Rect {
            width: 100.0,
            height: 100.0,
            ..Rect::default()
        };
        let y: Vec<f64> = (0..=100).map(f64::from).collect();
        let x: Vec<f64> = (0..6).map(f64::from).collect();
        let axes = (
            ticks::linear("", [0.0, 5.0], 5.0),
            ticks::linear("", [0.0, 100.0], 5.0),
        );
        let panel = Panel::new(frame, 0.0, axes.0, axes.1);
        // 3 % of the height is no jump, 4 % is one; after it a place alone, and none, and a pair.
        let rows = [Some(10), Some(13), Some(17), None, Some(50), Some(52)];
        let line = line(&panel, [&x, &y], &rows, String::new());
        let pieces: Vec<Vec<[f64; 2]>> = line
            .points
            .split(|p| p[1].is_nan())
            .filter(|piece| !piece.is_empty())
            .map(<[_]>::to_vec)
            .collect();
        assert_eq!(
            pieces,
            [
                vec![[0.0, 10.0], [1.0, 13.0]],
                vec![[1.5, 17.0], [2.5, 17.0]],
                vec![[4.0, 50.0], [5.0, 52.0]],
            ]
        );
    }
}
