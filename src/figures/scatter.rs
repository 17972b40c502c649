//! One column of the results against another, a dot a case.

use super::Shown;
use super::cloud::Cloud;
use super::layout;
use super::limits;
use super::map;
use super::sheet::{Axis, FilledMap, Panel, Sheet};
use super::style;
use super::text;
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
        Column::Parameter(row) => &study.problem.parameters()[row].symbol,
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
    let [x_range, y_range] = figure.ranges;
    let heights = limits::heights(points.iter().map(|(at, _)| at), x_range).into_iter();
    let y_axis = limits::axis(title(study, *y), heights, scales[1], y_range, height / 24.0);
    let colours: Option<Axis> = colour.map(|column| {
        let values = points.iter().filter_map(|(_, value)| *value);
        map::colours(title(study, column), values, scales[2])
    });
    let right = colours.as_ref().map_or(4.0, map::beside);
    let width = figure.width.unwrap_or(1.3 * style::SINGLE);
    let grid = layout::grid(width, 1, &[height], std::slice::from_ref(&y_axis), right);
    let places = points.iter().map(|(at, _)| at[0]);
    let most = grid.width / 40.0;
    let x_axis = limits::axis(title(study, *x), places, scales[0], x_range, most);
    let frame = grid.frames[0][0];
    let mut panel = Panel::new(frame, grid.margin, x_axis, y_axis);
    let lacking = without_dot(points.len(), cases.len());
    // Over the frame where the title of the colours leaves room, else under it.
    let beside = colours
        .as_ref()
        .map_or(0.0, |c| text::width(&c.title, style::TITLE));
    let room = width - frame.left - style::EDGE - beside;
    let over = text::width(&lacking, style::TITLE) + style::TITLE <= room;
    if over {
        panel.letter.clone_from(&lacking);
    }
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
    if !over {
        layout::small_print(&mut sheet, &lacking);
    }
    sheet
}
