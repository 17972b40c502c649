//! The parameters that a design samples against one another and one metric: the lower half of a matrix of panels.

use super::Shown;
use super::cloud::Cloud;
use super::layout;
use super::limits;
use super::map;
use super::scatter::{fits, title, value, without_dot};
use super::sheet::{Axis, FilledMap, Panel, Sheet};
use super::style;
use crate::study::{Column, Figure, FigureKind, Scale, Study};

/// The sheet of a `samples` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let FigureKind::Samples {
        parameters,
        y,
        y_scale,
    } = &figure.kind
    else {
        return Sheet::default();
    };
    let across: Vec<(Column, Scale)> = parameters
        .iter()
        .map(|(row, scale)| (Column::Parameter(*row), *scale))
        .collect();
    // The metric in the last row; every other row has the parameter of the next column.
    let up: Vec<(Column, Scale)> = across
        .iter()
        .skip(1)
        .copied()
        .chain([(Column::Metric(*y), *y_scale)])
        .collect();
    let of = |shown: &Shown, (column, scale): (Column, Scale)| {
        value(shown, column).filter(|x| fits(scale, *x))
    };
    let complete = |shown: &&Shown| {
        let mut all = across.iter().chain(&up);
        all.all(|column| of(shown, *column).is_some())
    };
    let drawn: Vec<&Shown> = cases.iter().filter(complete).collect();
    let column = |of_it| drawn.iter().filter_map(move |shown| of(shown, of_it));
    let count = across.len();
    let width = figure.width.unwrap_or(match count > 2 {
        true => style::DOUBLE,
        false => style::MIDDLE,
    });
    let height = (width / count.max(1) as f64 - 20.0).clamp(40.0, 150.0);
    let axis = |of_it: (Column, Scale), room: f64| -> Axis {
        limits::axis(title(study, of_it.0), column(of_it), of_it.1, None, room)
    };
    let ys: Vec<Axis> = up.iter().map(|row| axis(*row, height / 24.0)).collect();
    // The colours have the axis of the last row, so that the bar continues it.
    let colours = ys.last().cloned().unwrap_or_else(|| axis(up[0], 4.0));
    let grid = layout::grid(
        width,
        count.max(1),
        &vec![height; ys.len()],
        &ys,
        map::beside(&colours),
    );
    let xs: Vec<Axis> = across
        .iter()
        .map(|of_it| axis(*of_it, grid.width / 32.0))
        .collect();
    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    let last = ys.len() - 1;
    let dots = drawn.len() * count * (count + 1) / 2;
    for (i, row) in up.iter().enumerate() {
        for (j, of_it) in across.iter().enumerate().take(i + 1) {
            let (mut x, mut y) = (xs[j].clone(), ys[i].clone());
            if i < last {
                x.title.clear();
                x.numbered = false;
            }
            if j > 0 {
                y.title.clear();
                y.numbered = false;
            }
            let frame = grid.frames[i][j];
            let mut panel = Panel::new(frame, grid.margin, x, y);
            let points = drawn.iter().filter_map(|shown| {
                let at = [of(shown, *of_it)?, of(shown, *row)?];
                Some((at, of(shown, up[last])))
            });
            panel.cloud = Some(Cloud::of(points, Some(&colours), dots));
            if (i, j) == (last, count - 1) {
                let bar = Some(map::bar(&frame));
                panel.map = Some(FilledMap::of_cells(Vec::new(), colours.clone(), bar));
            }
            sheet.panels.push(panel);
        }
    }
    if let Some(first) = sheet.panels.first_mut() {
        first.letter = without_dot(drawn.len(), cases.len());
    }
    layout::finish(&mut sheet, Vec::new(), figure.title.as_deref());
    sheet
}
