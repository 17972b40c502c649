//! Quantities along the structure: one row of panels a quantity, one column a time, the exact solution thin.

use super::Shown;
use super::label;
use super::layout::{self, Key};
use super::number;
use super::sheet::{Axis, Panel, Series, Sheet};
use super::style::{self, Marker, Stroke};
use super::ticks;
use crate::problem::{Lines, parameter::Value};
use crate::study::{Figure, FigureKind, Study};

/// Most markers on one part of a curve.
const MOST_MARKERS: usize = 14;

/// The sheet of a `profile` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let FigureKind::Profile { y, times } = &figure.kind else {
        return Sheet::default();
    };
    if cases.iter().all(|shown| shown.snapshots.is_empty()) {
        return super::blank();
    }
    let labels = label::labels(study.problem.parameters(), cases, None, &[]);
    let (looks, labels) = label::numbered(&labels);
    let panel_series = |quantity: usize, column: usize| -> Vec<Series> {
        let lines: Vec<(usize, &Lines)> = cases
            .iter()
            .zip(&looks)
            .filter_map(|(shown, look)| {
                let lines = shown.snapshots.get(column)?.profiles.get(quantity)?;
                Some((*look, lines))
            })
            .collect();
        let mut series: Vec<Series> = Vec::new();
        for part in lines.iter().flat_map(|(_, lines)| &lines.exact) {
            if !series.iter().any(|s| s.points == *part) {
                series.push(exact(part));
            }
        }
        for (look, lines) in &lines {
            let computed = lines.computed.iter();
            series.extend(computed.map(|part| computed_series(part, &labels[*look], *look)));
        }
        series
    };
    let rows: Vec<Vec<Vec<Series>>> = y
        .iter()
        .map(|q| (0..times.len()).map(|t| panel_series(*q, t)).collect())
        .collect();
    let height = 120.0;
    let axes: Vec<Axis> = y
        .iter()
        .zip(&rows)
        .map(|(q, row)| {
            let points = row.iter().flatten().flat_map(|s| &s.points);
            let title = study.problem.profiles()[*q].title;
            ticks::around(title, points.map(|p| p[1]), height / 17.0)
        })
        .collect();
    let width = if times.len() > 2 {
        style::DOUBLE
    } else {
        style::MIDDLE
    };
    let grid = layout::grid(width, times.len(), &vec![height; y.len()], &axes, 4.0);
    let places = rows.iter().flatten().flatten().flat_map(|s| &s.points);
    let (first, last) = places.fold((0.0, 0.0), |(a, b): (f64, f64), p| {
        (a.min(p[0]), b.max(p[0]))
    });
    let across = ticks::linear(
        study.problem.place_title(),
        [first, last],
        grid.width / 40.0,
    );

    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    let count = rows.len();
    for (r, row) in rows.into_iter().enumerate() {
        for (column, series) in row.into_iter().enumerate() {
            let (mut x, mut axis) = (across.clone(), axes[r].clone());
            if r + 1 < count {
                x.title.clear();
                x.numbered = false;
            }
            if column > 0 {
                axis.title.clear();
                axis.numbered = false;
            }
            let mut panel = Panel::new(grid.frames[r][column], grid.margin, x, axis);
            panel.zero = true;
            if r == 0 {
                let time = number::value(Value::Number(times[column]));
                panel.letter = format!("{} = {time}", study.problem.time_symbol());
            }
            panel.series = vec![contact(panel.y.range)];
            panel.series.extend(series);
            sheet.panels.push(panel);
        }
    }
    layout::letters(&mut sheet.panels);
    let mut keys: Vec<Key> = Vec::new();
    for series in sheet.panels.iter().flat_map(|panel| &panel.series) {
        if !series.label.is_empty() && !keys.iter().any(|key| key.label == series.label) {
            keys.push(Key {
                label: series.label.clone(),
                stroke: series.stroke,
                width: series.width,
                marker: series.marker,
            });
        }
    }
    layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
    sheet
}

fn exact(part: &[[f64; 2]]) -> Series {
    Series {
        label: "exact".into(),
        points: part.to_vec(),
        stroke: Stroke::Solid,
        width: style::EXACT_LINE,
        marker: None,
        marked: Vec::new(),
    }
}

fn computed_series(part: &[[f64; 2]], label: &str, look: usize) -> Series {
    let every = part.len().div_ceil(MOST_MARKERS).max(1);
    Series {
        label: label.to_owned(),
        points: part.to_vec(),
        stroke: Stroke::of_case(look),
        width: style::CASE_LINE,
        marker: Some(Marker::of_case(look)),
        marked: (0..part.len()).step_by(every).collect(),
    }
}

/// The place where the parts meet.
fn contact(range: [f64; 2]) -> Series {
    Series {
        label: String::new(),
        points: vec![[0.0, range[0]], [0.0, range[1]]],
        stroke: Stroke::Solid,
        width: style::ZERO_LINE,
        marker: None,
        marked: Vec::new(),
    }
}
