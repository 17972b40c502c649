//! Curves over time: one row of panels a quantity, the exact solution thin below the cases.

use super::Shown;
use super::curves::{Curves, is_error};
use super::label;
use super::layout;
use super::sheet::{Axis, Panel, Series, Sheet};
use super::style;
use super::ticks;
use crate::problem::Quantity;
use crate::study::{Figure, FigureKind, Study};

/// The sheet of a `history` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let FigureKind::History { y, by, panels } = &figure.kind else {
        return Sheet::default();
    };
    let solved: Vec<Shown> = cases
        .iter()
        .copied()
        .filter(|c| c.solution.is_some())
        .collect();
    let drawn = &solved[..solved.len().min(style::MOST_LOOKS)];
    let except: Vec<usize> = panels.iter().copied().collect();
    let mut labels = label::labels(study.problem.parameters(), drawn, *by, &except);
    let groups = match panels {
        Some(row) if !drawn.is_empty() => label::values(drawn, *row),
        _ => vec![None],
    };
    // A case alone in its panel needs no name of its own.
    if panels.is_some() && groups.len() == drawn.len() {
        labels.fill("computed".into());
    }
    let (looks, labels) = label::numbered(&labels);
    // Groups side by side, at most three; of one quantity alone, below one another.
    let columns = if y.len() > 1 { groups.len().min(3) } else { 1 };
    let width = if columns > 1 {
        style::DOUBLE
    } else {
        style::MIDDLE
    };
    let end = drawn
        .iter()
        .flat_map(|c| c.solution)
        .filter_map(|s| s.computed.time.last());
    let end = end.fold(0.0, |a: f64, b| a.max(*b));
    let curves = Curves {
        study,
        cases: drawn,
        looks: &looks,
        labels: &labels,
        end,
        // Fewer in narrow panels.
        markers: 9.3 / (0.6 + 0.4 * columns as f64),
    };

    // One row of panels for each quantity, or each group and quantity.
    let quantities: Vec<&Quantity> = y.iter().map(|q| &study.problem.quantities()[*q]).collect();
    let members: Vec<Vec<usize>> = groups
        .iter()
        .map(|group| curves.members(panels.map(|row| (row, *group))))
        .collect();
    let blocks: Vec<&[Vec<usize>]> = members.chunks(columns).collect();
    let mut rows: Vec<Vec<(Vec<Series>, &Quantity, usize)>> = Vec::new();
    for (b, block) in blocks.iter().enumerate() {
        for quantity in &quantities {
            let panel = |(k, members): (usize, &Vec<usize>)| {
                (curves.of(quantity, members), *quantity, b * columns + k)
            };
            rows.push(block.iter().enumerate().map(panel).collect());
        }
    }
    // Several blocks of rows still go on one page.
    let shrink = if blocks.len() > 1 { 0.7 } else { 1.0 };
    let height = |quantity: &Quantity| shrink * height(quantity);
    let heights: Vec<f64> = rows.iter().map(|row| height(row[0].1)).collect();
    let axes: Vec<Axis> = quantities
        .iter()
        .map(|quantity| {
            let of_it = rows
                .iter()
                .flatten()
                .filter(|panel| panel.1.name == quantity.name);
            let values = of_it
                .flat_map(|panel| &panel.0)
                .flat_map(|s| &s.points)
                .map(|p| p[1]);
            ticks::around(quantity.title, values, height(quantity) / 17.0)
        })
        .collect();

    let grid = layout::grid(width, columns, &heights, &axes, 4.0);
    let time = time_axis(study, end, grid.width / 38.0);
    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    let rows_below: Vec<Option<usize>> = (0..rows.len())
        .map(|r| rows.get(r + 1).map(Vec::len))
        .collect();
    for (r, row) in rows.into_iter().enumerate() {
        for (column, (series, _, group)) in row.into_iter().enumerate() {
            let mut y = axes[r % quantities.len()].clone();
            if column > 0 {
                y.title.clear();
                y.numbered = false;
            }
            let mut x = time.clone();
            // The last panel of its column has the numbers, below it or where its block is not full.
            if rows_below[r].is_some_and(|below| below > column) {
                x.title.clear();
                x.numbered = false;
            }
            let mut panel = Panel::new(grid.frames[r][column], grid.margin, x, y);
            panel.zero = panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
            panel.series = series;
            if let (Some(row), Some(Some(value))) = (panels, groups.get(group))
                && r % quantities.len() == 0
            {
                panel.letter = label::said(&study.problem.parameters()[*row], *value);
            }
            sheet.panels.push(panel);
        }
    }
    layout::letters(&mut sheet.panels);
    layout::left_out(&mut sheet, drawn.len(), solved.len());
    let keys = curves.keys(&sheet);
    layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
    sheet
}

/// Errors lie flatter than the response.
fn height(quantity: &Quantity) -> f64 {
    if is_error(quantity) { 76.0 } else { 160.0 }
}

fn time_axis(study: &Study, end: f64, most: f64) -> Axis {
    let range = [0.0, if end > 0.0 { end } else { 1.0 }];
    let title = study.problem.time_title();
    if study.problem.time_in_pi() {
        ticks::in_pi(title, range, most)
    } else {
        ticks::linear(title, range, most)
    }
}
