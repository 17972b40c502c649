//! A quantity over place and time, computed beside exact, in the same shades.

use super::Shown;
use super::layout;
use super::map::{BAR_GAP, BAR_WIDTH};
use super::sheet::{FilledMap, Panel, Rect, Sheet};
use super::style;
use super::text;
use super::ticks;
use crate::problem::Lines;
use crate::study::{Figure, FigureKind, Study};

/// Cells of the exact picture across the structure.
const FINE: usize = 600;

/// The sheet of a `wave` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let (FigureKind::Wave { y }, Some(shown)) = (&figure.kind, cases.first()) else {
        return super::blank();
    };
    let rows: Vec<(f64, &Lines)> = shown
        .snapshots
        .iter()
        .filter_map(|snapshot| Some((snapshot.time, snapshot.profiles.get(*y)?)))
        .collect();
    let (Some((_, first)), Some((end, _))) = (rows.first(), rows.last()) else {
        return super::blank();
    };
    let parts: Vec<[f64; 2]> = first.exact.iter().map(|part| extent(part)).collect();
    let coarse: Vec<f64> = first
        .computed
        .iter()
        .zip(&parts)
        .flat_map(|(part, extent)| cells(part, *extent))
        .collect();
    let coarse = joined(coarse);
    let left = parts.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    let right = parts.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
    let fine: Vec<f64> = (0..=FINE)
        .map(|k| left + (right - left) * k as f64 / FINE as f64)
        .collect();
    let computed: Vec<Option<f64>> = rows
        .iter()
        .flat_map(|(_, lines)| rising(&lines.computed))
        .map(|point| Some(point[1]))
        .collect();
    let exact: Vec<Option<f64>> = rows
        .iter()
        .flat_map(|(_, lines)| sampled(&lines.exact, &fine))
        .collect();
    let values = computed.iter().chain(&exact).flatten().copied();
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(f64::NEG_INFINITY, f64::max);
    let title = study.problem.profiles()[*y].title;
    let colours = ticks::linear(title, [low, high.max(low + 1e-9)], 7.0);

    let height = 190.0;
    let numbers = colours
        .ticks
        .iter()
        .map(|t| text::width(&t.label, style::LABEL));
    let beside = BAR_GAP + BAR_WIDTH + style::LABEL_GAP + numbers.fold(0.0, f64::max);
    let upwards = ticks::linear(study.problem.time_title(), [0.0, *end], height / 28.0);
    let axes = std::slice::from_ref(&upwards);
    let grid = layout::grid(style::DOUBLE, 2, &[height], axes, beside);
    let across = ticks::linear(
        study.problem.place_title(),
        [left, right],
        grid.width / 100.0,
    );
    let times: Vec<f64> = rows.iter().map(|row| row.0).collect();
    let mut sheet = Sheet {
        width: style::DOUBLE,
        ..Sheet::default()
    };
    let pictures = [("computed", coarse, computed), ("exact", fine, exact)];
    for (column, (name, x_edges, values)) in pictures.into_iter().enumerate() {
        let frame = grid.frames[0][column];
        let mut y = upwards.clone();
        if column > 0 {
            y.title.clear();
            y.numbered = false;
        }
        let mut panel = Panel::new(frame, grid.margin, across.clone(), y);
        panel.letter = name.into();
        panel.map = Some(FilledMap {
            x_edges,
            y_edges: between(&times, [0.0, *end]),
            values,
            colours: colours.clone(),
            bar: (column > 0).then(|| Rect {
                left: frame.right() + BAR_GAP,
                width: BAR_WIDTH,
                ..frame
            }),
        });
        sheet.panels.push(panel);
    }
    layout::letters(&mut sheet.panels);
    layout::finish(&mut sheet, Vec::new(), figure.title.as_deref());
    sheet
}

/// First and last place of a part.
fn extent(part: &[[f64; 2]]) -> [f64; 2] {
    let places = part.iter().map(|p| p[0]);
    [
        places.clone().fold(f64::INFINITY, f64::min),
        places.fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// Edges of the cells round a part's points, from the left.
fn cells(part: &[[f64; 2]], extent: [f64; 2]) -> Vec<f64> {
    let mut places: Vec<f64> = part.iter().map(|p| p[0]).collect();
    places.sort_by(f64::total_cmp);
    between(&places, extent)
}

/// The ends of a range, and half-way between neighbours.
fn between(places: &[f64], [first, last]: [f64; 2]) -> Vec<f64> {
    let mut edges = vec![first];
    edges.extend(places.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0));
    edges.push(last);
    edges
}

/// The edges of all parts in one row: where two parts meet, their common edge once.
fn joined(mut edges: Vec<f64>) -> Vec<f64> {
    edges.sort_by(f64::total_cmp);
    edges.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
    edges
}

/// All points of all parts from left to right.
fn rising(parts: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = parts.concat();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    points
}

/// The value of the lines in the middle of each cell.
fn sampled(parts: &[Vec<[f64; 2]>], edges: &[f64]) -> Vec<Option<f64>> {
    let pieces: Vec<&[[f64; 2]]> = parts.iter().flat_map(|part| part.chunks(2)).collect();
    let value = |x: f64| {
        let inside = |piece: &&&[[f64; 2]]| (piece[0][0] - x) * (piece[1][0] - x) <= 0.0;
        pieces.iter().find(inside).map(|piece| piece[0][1])
    };
    edges
        .windows(2)
        .map(|edge| value((edge[0] + edge[1]) / 2.0))
        .collect()
}
