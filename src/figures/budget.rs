//! The error of a study and its parts against a parameter: a row of panels for each quantity, the total beside.

use super::Shown;
use super::label;
use super::layout;
use super::legend::Key;
use super::limits;
use super::sheet::{Axis, Panel, Series, Sheet};
use super::slope;
use super::style::{self, Marker, Stroke};
use crate::problem::Budget;
use crate::problem::parameter::Value;
use crate::study::{Figure, FigureKind, Scale, Study};

/// Most panels beside each other.
const COLUMNS: usize = 3;

/// The sheet of a `budget` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let FigureKind::Budget { x, y, panels } = &figure.kind else {
        return Sheet::default();
    };
    let parameters = study.problem.parameters();
    let groups: Vec<Option<Value>> = match panels {
        Some(row) => label::values(cases, *row)
            .into_iter()
            .filter(Option::is_some)
            .collect(),
        None => vec![None],
    };
    let budgets: Vec<&Budget> = y
        .iter()
        .map(|row| &study.problem.schema().budgets[*row])
        .collect();
    let member = |shown: &&Shown, group: &Option<Value>| {
        panels.is_none_or(|row| label::same(shown.case.values[row], *group))
    };
    // Panel by panel: budget, group, curves.
    let mut content = Vec::new();
    for budget in &budgets {
        for group in &groups {
            let members: Vec<&Shown> = cases.iter().filter(|c| member(c, group)).collect();
            content.push((*budget, *group, curves(budget, &members, *x)));
        }
    }
    let [x_range, y_range] = figure.ranges;
    let columns = layout::side_by_side(groups.len().min(COLUMNS), figure.width);
    let rows = budgets.len() * groups.len().div_ceil(columns);
    let height = if columns == 1 { 190.0 } else { 165.0 };
    let axis_of = |budget: &Budget| {
        let own = content.iter().filter(|(b, ..)| b.name == budget.name);
        let series = own.flat_map(|(_, _, series)| series);
        let heights = limits::heights(limits::points(series), x_range).into_iter();
        limits::axis(&budget.title, heights, Scale::Log, y_range, height / 24.0)
    };
    let axes: Vec<Axis> = budgets.iter().map(|budget| axis_of(budget)).collect();
    let usual = [1.2 * style::SINGLE, 1.5 * style::SINGLE, style::DOUBLE][columns - 1];
    let width = figure.width.unwrap_or(usual);
    let grid = layout::grid(width, columns, &vec![height; rows], &axes, 6.0);
    let at = cases.iter().filter_map(|c| c.case.values[*x]?.as_f64());
    let title = &parameters[*x].symbol;
    let across = limits::axis(title, at, Scale::Log, x_range, grid.width / 40.0);

    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    let count = content.len();
    let mut place = (0, 0);
    for (i, (budget, group, series)) in content.into_iter().enumerate() {
        let row = budgets
            .iter()
            .position(|b| b.name == budget.name)
            .unwrap_or(0);
        let (mut x_axis, mut y_axis) = (across.clone(), axes[row].clone());
        if i + columns < count {
            x_axis.title.clear();
            x_axis.numbered = false;
        }
        if place.1 > 0 {
            y_axis.title.clear();
            y_axis.numbered = false;
        }
        let mut panel = Panel::new(grid.frames[place.0][place.1], grid.margin, x_axis, y_axis);
        if let (Some(row), Some(value)) = (panels, group) {
            panel.letter = label::said(&parameters[*row], value, label::digits(cases, *row));
        }
        panel.series = series;
        slope::write(&mut panel);
        sheet.panels.push(panel);
        let last_of_row = place.1 + 1 == columns || (i + 1) % groups.len() == 0;
        place = if last_of_row {
            (place.0 + 1, 0)
        } else {
            (place.0, place.1 + 1)
        };
    }
    layout::letters(&mut sheet.panels);
    let mut keys: Vec<Key> = Vec::new();
    for series in sheet.panels.iter().flat_map(|panel| &panel.series) {
        if !keys.iter().any(|key| key.label == series.label) {
            keys.push(Key::of(series));
        }
    }
    layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
    let whole = |shown: &&Shown| {
        let mut rows = budgets.iter().flat_map(|b| b.metrics());
        rows.all(|row| shown.metrics.get(row).is_some_and(Option::is_some))
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

/// The total, unbroken, and its parts.
fn curves(budget: &Budget, members: &[&Shown], x: usize) -> Vec<Series> {
    let of = |metric: usize| {
        let mut points: Vec<[f64; 2]> = members
            .iter()
            .filter_map(|shown| {
                let value = shown.metrics.get(metric).copied().flatten();
                Some([shown.case.values[x]?.as_f64()?, value.unwrap_or(f64::NAN)])
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
        .map(|(look, (name, metric))| {
            let points = of(*metric);
            Series {
                label: (*name).to_string(),
                marked: (0..points.len()).collect(),
                points,
                stroke: Stroke::of_case(look),
                width: style::CASE_LINE,
                marker: Some(Marker::of_case(look)),
            }
        });
    std::iter::once(total).chain(parts).collect()
}
