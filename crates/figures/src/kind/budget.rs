//! The error and its parts over a parameter: a row of panels for each quantity.

use super::Draw;
use crate::label;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::slope;
use slipgap_drawing::style::{self, Look, Stroke};
use slipgap_problem::problem;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::Scale;
use slipgap_study::kinds::Budget;

/// Most panels side by side.
const COLUMNS: usize = 3;

impl Draw for Budget {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let Budget { x, y, panels } = self;
        let parameters = study.problem.parameters();
        let groups: Vec<Option<Value>> = match panels {
            Some(row) => label::values(cases, *row)
                .into_iter()
                .filter(Option::is_some)
                .collect(),
            None => vec![None],
        };
        let budgets: Vec<&problem::Budget> = y
            .iter()
            .map(|row| &study.problem.schema().budgets[*row])
            .collect();
        let member = |shown: &&DrawnCase, group: &Option<Value>| {
            panels.is_none_or(|row| label::same(shown.value(row), *group))
        };
        // Panel by panel: budget, group, curves.
        let mut content = Vec::new();
        for budget in &budgets {
            for group in &groups {
                let members: Vec<&DrawnCase> = cases.iter().filter(|c| member(c, group)).collect();
                content.push((*budget, *group, curves(data.look(), budget, &members, *x)));
            }
        }
        let [x_range, y_range] = figure.ranges;
        let columns = layout::side_by_side(groups.len().min(COLUMNS), figure.width);
        let rows = budgets.len() * groups.len().div_ceil(columns);
        let height = if columns == 1 { 190.0 } else { 165.0 };
        let axis_of = |budget: &problem::Budget| {
            let of_budget = content.iter().filter(|(b, ..)| b.name == budget.name);
            let series = of_budget.flat_map(|(_, _, series)| series);
            let heights = limits::heights(limits::points(series), x_range).into_iter();
            limits::axis(&budget.title, heights, Scale::Log, y_range, height / 24.0)
        };
        let axes: Vec<Axis> = budgets.iter().map(|budget| axis_of(budget)).collect();
        let usual = [1.2 * style::SINGLE, 1.5 * style::SINGLE, style::DOUBLE][columns - 1];
        let width = figure.width.unwrap_or(usual);
        let grid = layout::grid(width, columns, &vec![height; rows], &axes, 6.0);
        let at = cases.iter().filter_map(|c| c.number(*x));
        let title = &parameters[*x].title();
        let across = limits::axis(title, at, Scale::Log, x_range, grid.width / 40.0);

        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        let count = content.len();
        let mut cell = (0, 0);
        for (i, (budget, group, series)) in content.into_iter().enumerate() {
            let row = budgets
                .iter()
                .position(|b| b.name == budget.name)
                .unwrap_or(0);
            let x_axis = across.clone().labelled(i + columns >= count);
            let y_axis = axes[row].clone().labelled(cell.1 == 0);
            let mut panel = Panel::new(grid.frames[cell.0][cell.1], grid.margin, x_axis, y_axis);
            if let (Some(row), Some(value)) = (panels, group) {
                panel.caption =
                    label::value_label(&parameters[*row], value, label::form(cases, *row));
            }
            panel.series = series;
            slope::write(&mut panel);
            sheet.panels.push(panel);
            let last_of_row = cell.1 + 1 == columns || (i + 1) % groups.len() == 0;
            cell = if last_of_row {
                (cell.0 + 1, 0)
            } else {
                (cell.0, cell.1 + 1)
            };
        }
        layout::letter_panels(&mut sheet.panels);
        let mut keys: Vec<Key> = Vec::new();
        for series in sheet.panels.iter().flat_map(|panel| &panel.series) {
            if !keys.iter().any(|key| key.label == series.label) {
                keys.push(Key::of(series));
            }
        }
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        let whole = |shown: &&DrawnCase| {
            let mut rows = budgets.iter().flat_map(|b| b.metrics());
            rows.all(|row| shown.metric(row).is_some())
        };
        let bare = cases.len() - cases.iter().filter(whole).count();
        if bare > 0 {
            let words = format!(
                "{bare} of {} cases have no reference for the parts of the error; only their total is shown.",
                cases.len()
            );
            layout::small_print(&mut sheet, &words);
        }
        sheet
    }
}

/// The total, as an unbroken line, and its parts.
fn curves(look: Look, budget: &problem::Budget, members: &[&DrawnCase], x: usize) -> Vec<Series> {
    let of = |metric: usize| {
        let mut points: Vec<[f64; 2]> = members
            .iter()
            .filter_map(|shown| {
                let value = shown.metric(metric);
                Some([shown.number(x)?, value.unwrap_or(f64::NAN)])
            })
            .collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        points
    };
    let total = Series {
        label: "total".into(),
        points: of(budget.total),
        stroke: Stroke::Solid,
        width: 1.4 * style::CASE_LINE,
        marker: None,
        marked: Vec::new(),
    };
    let parts = budget
        .parts
        .iter()
        .enumerate()
        .map(|(index, (name, metric))| {
            let points = of(*metric);
            Series {
                label: (*name).to_string(),
                marked: (0..points.len()).collect(),
                points,
                stroke: look.stroke(index, budget.parts.len()),
                width: style::CASE_LINE,
                marker: look.marker(index),
            }
        });
    std::iter::once(total).chain(parts).collect()
}
