//! The parameters that a design samples, in pairs, and one metric: the lower half of a matrix of panels.

use super::Draw;
use crate::column::{has_place, title, value, without_dot};
use crate::{DrawnCase, FigureData};
use slipgap_drawing::colour_map::bar;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::cloud::Cloud;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{FilledMap, Panel, Sheet};
use slipgap_drawing::style;
use slipgap_study::kinds::Samples;
use slipgap_study::{ColumnRef, Scale};

impl Draw for Samples {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let Samples {
            parameters,
            y,
            y_scale,
        } = self;
        let across: Vec<(ColumnRef, Scale)> = parameters
            .iter()
            .map(|(row, scale)| (ColumnRef::Parameter(*row), *scale))
            .collect();
        // The metric in the last row; every other row has the parameter of the next column.
        let up: Vec<(ColumnRef, Scale)> = across
            .iter()
            .skip(1)
            .copied()
            .chain([(ColumnRef::Metric(*y), *y_scale)])
            .collect();
        let of = |shown: &DrawnCase, (column, scale): (ColumnRef, Scale)| {
            value(shown, column).filter(|x| has_place(scale, *x))
        };
        let complete = |shown: &&DrawnCase| {
            let mut columns = across.iter().chain(&up);
            columns.all(|column| of(shown, *column).is_some())
        };
        let drawn: Vec<&DrawnCase> = cases.iter().filter(complete).collect();
        let column = |of_it| drawn.iter().filter_map(move |shown| of(shown, of_it));
        let count = across.len();
        let width = figure.width.unwrap_or(match count > 2 {
            true => style::DOUBLE,
            false => style::MIDDLE,
        });
        let height = (width / count.max(1) as f64 - 20.0).clamp(40.0, 150.0);
        let axis = |of_it: (ColumnRef, Scale), room: f64| -> Axis {
            limits::axis(&title(study, of_it.0), column(of_it), of_it.1, None, room)
        };
        let ys: Vec<Axis> = up.iter().map(|row| axis(*row, height / 24.0)).collect();
        // The colours have the axis of the last row, so that the bar continues it.
        let colours = ys.last().cloned().unwrap_or_else(|| axis(up[0], 4.0));
        let grid = layout::grid(
            width,
            count.max(1),
            &vec![height; ys.len()],
            &ys,
            bar::room(&colours),
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
                let x = xs[j].clone().labelled(i == last);
                let y = ys[i].clone().labelled(j == 0);
                let frame = grid.frames[i][j];
                let mut panel = Panel::new(frame, grid.margin, x, y);
                let points = drawn.iter().filter_map(|shown| {
                    let at = [of(shown, *of_it)?, of(shown, *row)?];
                    Some((at, of(shown, up[last])))
                });
                panel.cloud = Some(Cloud::of(points, Some(&colours), dots));
                if (i, j) == (last, count - 1) {
                    let bar = Some(bar::frame(&frame));
                    panel.map = Some(FilledMap::of_cells(Vec::new(), colours.clone(), bar));
                }
                sheet.panels.push(panel);
            }
        }
        if let Some(first) = sheet.panels.first_mut() {
            first.caption = without_dot(drawn.len(), cases.len());
        }
        layout::finish(&mut sheet, Vec::new(), figure.title.as_deref());
        sheet
    }
}
