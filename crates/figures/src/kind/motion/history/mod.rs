//! Curves over time: one row of panels for each quantity, the exact solution thin under the cases, what was measured in grey
//! under both.

pub(in crate::kind) mod arrangement;
pub(in crate::kind) mod curves;
pub(in crate::kind) mod measured_curves;
mod stacked;

use crate::kind::Draw;
use crate::kind::order::{order, strokes};
use crate::label;
use crate::{DrawnCase, FigureData};
use arrangement::Arrangement;
use curves::Curves;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::inset;
use slipgap_drawing::layout::legend::{self, Key};
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style;
use slipgap_problem::problem::Quantity;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_study::kinds::History;
use slipgap_study::{Scale, Study};

impl Draw for History {
    fn sheet(&self, data: &FigureData) -> Sheet {
        if self.stacked {
            return stacked::sheet(self, data);
        }
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let History {
            y,
            by,
            panels,
            in_units,
            stacked: _,
            inset,
        } = self;
        let units = study.units.as_ref().filter(|_| *in_units);
        let in_units = units.is_some();
        let solved: Vec<DrawnCase> = cases
            .iter()
            .copied()
            .filter(|c| c.solution().is_some())
            .collect();
        let drawn = &solved[..solved.len().min(style::MOST_STYLES)];
        let table = study.problem.parameters();
        let except = panels.map_or(Vec::new(), |row| label::bound(table, drawn, row));
        let (indices, labels) = label::numbered(&label::labels(table, drawn, *by, &except));
        let groups = match panels {
            Some(row) if !drawn.is_empty() => label::values(drawn, *row),
            Some(_) | None => vec![None],
        };
        let arranged = Arrangement::of(y.len(), groups.len(), figure.width);
        let columns = arranged.columns(y.len(), groups.len());
        let usual = if columns > 1 {
            style::DOUBLE
        } else {
            style::MIDDLE
        };
        let width = figure.width.unwrap_or(usual);
        let [x_range, y_range] = figure.ranges;
        let end = drawn.iter().filter_map(|c| {
            let size = match in_units {
                true => study
                    .problem
                    .as_textbook()
                    .and_then(|textbook| textbook.size(&c.case(), Dimension::Time))?,
                false => 1.0,
            };
            Some(c.solution()?.computed.time.last()? * size)
        });
        let end = end.fold(0.0, f64::max);
        let title = |scaled: &str, dimension| match units {
            Some(units) => units.title(&*study.problem, scaled, dimension),
            None => scaled.to_owned(),
        };
        let named = label::named(table, drawn, *by, &except);
        let order = order(&named, drawn, &indices, labels.len());
        let strokes = strokes(data.look(), order.as_deref(), labels.len());
        let curves = Curves {
            study,
            cases: drawn,
            indices: &indices,
            labels: &labels,
            look: data.look(),
            strokes: &strokes,
            in_units,
            window: window(x_range, end),
            // Fewer in narrow panels.
            markers: 9.3 * (width / usual) / (0.6 + 0.4 * columns as f64),
        };

        let quantities: Vec<&Quantity> = y
            .iter()
            .map(|q| &study.problem.schema().quantities[*q])
            .collect();
        let members: Vec<Vec<usize>> = groups
            .iter()
            .map(|group| curves::members(drawn, panels.map(|row| (row, *group))))
            .collect();
        let rows = arranged.rows(quantities.len(), groups.len());
        let mut series: Vec<Vec<Vec<Series>>> = members
            .iter()
            .map(|group| quantities.iter().map(|q| curves.of(q, group)).collect())
            .collect();
        curves::unmark_alone(series.iter_mut().flatten().flatten(), &labels);
        let strip = inset.map_or(0.0, |_| inset::HEIGHT);
        let heights: Vec<f64> = rows
            .iter()
            .map(|row| match arranged {
                Arrangement::QuantitiesAcross => LOW + strip,
                Arrangement::Stack | Arrangement::GroupsAcross => {
                    row.first()
                        .map_or(LOW, |cell| height(quantities[cell.quantity]))
                        + strip
                }
            })
            .collect();
        let tallest = heights.iter().fold(0.0, |a: f64, b| a.max(*b)) - strip;
        let axes: Vec<Axis> = quantities
            .iter()
            .enumerate()
            .map(|(q, quantity)| {
                let of_it = series.iter().flat_map(|group| &group[q]);
                let values = limits::heights(limits::points(of_it), x_range).into_iter();
                let most = height(quantity).min(tallest) / 17.0;
                let title = title(
                    &quantity.title,
                    study.problem.schema().channels[quantity.channel].dimension,
                );
                limits::axis(&title, values, Scale::Linear, y_range, most)
            })
            .collect();

        // One grid for the whole sheet, or one for each column with a separate vertical axis.
        let grids = match arranged {
            Arrangement::QuantitiesAcross => layout::columns(width, &heights, &axes),
            Arrangement::Stack | Arrangement::GroupsAcross => {
                vec![layout::grid(width, columns, &heights, &axes, 4.0)]
            }
        };
        let time = time_axis(
            study,
            &title(&study.problem.schema().time.title, Dimension::Time),
            x_range.unwrap_or([0.0, if end > 0.0 { end } else { 1.0 }]),
            grids.first().map_or(1.0, |grid| grid.width / 38.0),
        );
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        let last = rows.len().saturating_sub(1);
        for (r, row) in rows.iter().enumerate() {
            for (column, cell) in row.iter().enumerate() {
                let (grid, frame) = match grids.get(column) {
                    Some(grid) if grids.len() > 1 => (grid, grid.frames[r][0]),
                    _ => (&grids[0], grids[0].frames[r][column]),
                };
                let mut y = axes[cell.quantity]
                    .clone()
                    .labelled(column == 0 || grids.len() > 1);
                let x = time.clone().labelled(r == last);
                if inset.is_some() {
                    y = inset::with_strip(y, frame.height);
                }
                let mut panel = Panel::new(frame, grid.margin, x, y);
                panel.zero = panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
                panel.series = series[cell.group][cell.quantity].clone();
                if let Some(window) = *inset {
                    let most = frame.width / 60.0;
                    inset::add(&mut panel, time_axis(study, "", window, most));
                }
                if let (0, Some(first)) = (cell.quantity, members[cell.group].first()) {
                    panel.caption =
                        label::caption(table, drawn, &except, &drawn[*first].case(), frame.width);
                }
                sheet.panels.push(panel);
            }
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, drawn.len(), solved.len());
        let mut keys = legend::keys(&sheet.panels);
        // By rising number behind the measured and exact ones.
        if let Some(order) = &order {
            let rank = |key: &Key| {
                let index = labels.iter().position(|label| *label == key.label);
                index.map(|index| order.iter().position(|other| *other == index))
            };
            keys.sort_by_key(rank);
        }
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        sheet
    }

    fn has_dense_curves(&self) -> bool {
        true
    }
}

/// Height of panels in a sheet of many rows.
const LOW: f64 = 92.0;

/// Height of a panel; lower for errors than for the response.
fn height(quantity: &Quantity) -> f64 {
    if quantity.error { 76.0 } else { 160.0 }
}

/// The part of the time up to `end` that the axis shows; all of it if it shows no part.
fn window(range: Option<[f64; 2]>, end: f64) -> [f64; 2] {
    match range.map(|[a, b]| [a.max(0.0), b.min(end)]) {
        Some([a, b]) if a < b => [a, b],
        _ => [0.0, end],
    }
}

fn time_axis(study: &Study, title: &str, range: [f64; 2], most: f64) -> Axis {
    if study.problem.schema().time.in_pi {
        ticks::in_pi(title, range, most)
    } else {
        ticks::linear(title, range, most)
    }
}
