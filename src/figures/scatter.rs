//! One column of the results against another, a dot a case.

use super::Shown;
use super::cloud::Cloud;
use super::layout;
use super::map;
use super::metric;
use super::sheet::{Axis, FilledMap, Panel, Sheet};
use super::style;
use crate::study::{Column, Figure, FigureKind, Scale, Study};

/// What a case has in a column.
pub fn value(shown: &Shown, column: Column) -> Option<f64> {
    match column {
        Column::Parameter(row) => shown.case.values[row].and_then(|value| value.as_f64()),
        Column::Metric(row) => shown.metrics.get(row).copied().flatten(),
    }
}

/// What figures call a column, in markup.
pub fn title(study: &Study, column: Column) -> &str {
    match column {
        Column::Parameter(row) => study.problem.parameters()[row].symbol,
        Column::Metric(row) => &study.measures[row].symbol,
    }
}

/// Whether a number has a place on a scale.
pub fn fits(scale: Scale, x: f64) -> bool {
    x.is_finite() && (scale == Scale::Linear || x > 0.0)
}

/// Says how many of the cases have no dot, if there are any.
pub fn without_dot(some: usize, all: usize) -> String {
    match all - some {
        0 => String::new(),
        lacking => format!("{lacking} of {all} cases without a value"),
    }
}

/// The sheet of a `scatter` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let FigureKind::Scatter {
        x,
        y,
        colour,
        scales,
    } = &figure.kind
    else {
        return Sheet::default();
    };
    // A case has a dot if it has a place along all that is shown.
    let place = |shown: &Shown| {
        let of = |column, scale| value(shown, column).filter(|x| fits(scale, *x));
        let at = [of(*x, scales[0])?, of(*y, scales[1])?];
        match colour {
            Some(column) => Some((at, Some(of(*column, scales[2])?))),
            None => Some((at, None)),
        }
    };
    let points: Vec<([f64; 2], Option<f64>)> = cases.iter().filter_map(place).collect();
    let height = 190.0;
    let along = |k: usize| points.iter().map(move |(at, _)| at[k]);
    let y_axis = metric::axis(title(study, *y), along(1), scales[1], height / 24.0);
    let colours: Option<Axis> = colour.map(|column| {
        let values = points.iter().filter_map(|(_, value)| *value);
        map::colours(title(study, column), values, scales[2])
    });
    let right = colours.as_ref().map_or(4.0, map::beside);
    let width = 1.3 * style::SINGLE;
    let grid = layout::grid(width, 1, &[height], std::slice::from_ref(&y_axis), right);
    let x_axis = metric::axis(title(study, *x), along(0), scales[0], grid.width / 40.0);
    let frame = grid.frames[0][0];
    let mut panel = Panel::new(frame, grid.margin, x_axis, y_axis);
    panel.letter = without_dot(points.len(), cases.len());
    let count = points.len();
    panel.cloud = Some(Cloud::of(points.into_iter(), colours.as_ref(), count));
    let bar = Some(map::bar(&frame));
    panel.map = colours.map(|colours| FilledMap::of_cells(Vec::new(), colours, bar));
    let mut sheet = Sheet {
        width,
        panels: vec![panel],
        ..Sheet::default()
    };
    layout::finish(&mut sheet, Vec::new(), figure.title.as_deref());
    sheet
}
