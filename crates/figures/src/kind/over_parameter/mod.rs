//! What metric and convergence figures share: metrics over a parameter, one panel for each
//! metric, one curve for each set of values of the other parameters that vary.

pub(super) mod convergence;
mod limits_of_checks;
pub(super) mod metric;
mod orders;
mod reference;

use super::motion::history::arrangement::Arrangement;
use super::motion::history::curves::members;
use super::order::{graded, order};
use crate::label;
use crate::{DrawnCase, FigureData};
use orders::{ORDERS, order_lines};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::slope;
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_drawing::text::number;
use slipgap_study::Scale;

/// Most panels side by side for the curves of one metric.
const MOST_PARTS: usize = 3;

/// Metrics over a parameter.
pub struct Curves<'a> {
    /// Parameter along the horizontal axis.
    pub x: usize,
    /// Rows of the study's measures.
    pub y: &'a [usize],
    /// Parameter with one line style for each value; `None`: all others that vary.
    pub by: Option<usize>,
    /// Parameter with one panel for each value.
    pub panels: Option<usize>,
    /// Scales of the axes.
    pub scales: [Scale; 2],
    /// Whether it shows the observed orders, instead of exact values.
    pub orders: bool,
    /// Whether it shows the limits of the study's checks.
    pub checks: bool,
}

impl Curves<'_> {
    /// The sheet of a `metric` or `convergence` figure.
    pub fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let Curves {
            x,
            y,
            by,
            scales: [x_scale, y_scale],
            orders,
            ..
        } = *self;
        let look = data.look();
        let parameter = &study.problem.parameters()[x];
        let at = |shown: &DrawnCase| shown.number(x);
        let cases: Vec<DrawnCase> = cases.iter().copied().filter(|c| at(c).is_some()).collect();
        let table = study.problem.parameters();
        let bound = self
            .panels
            .map_or(Vec::new(), |row| label::bound(table, &cases, row));
        let mut except = label::along(study, &cases, x);
        except.extend(&bound);
        let labels = label::labels(table, &cases, by, &except);
        let (indices, mut labels) = label::numbered(&labels);
        let named = label::named(table, &cases, by, &except);
        let label_count = labels.len();
        labels.truncate(style::MOST_STYLES);
        let order = order(&named, &cases, &indices, labels.len());
        // More names than colours: panels side by side, each with some of the curves and its own legend.
        let parts = match (&order, self.panels) {
            (None, None) if look.colour => {
                let parts = labels.len().div_ceil(Marker::KINDS);
                layout::side_by_side(parts.clamp(1, MOST_PARTS), figure.width)
            }
            _ => 1,
        };
        let per_part = labels.len().div_ceil(parts).max(1);
        let (strokes, width, marked) = match &order {
            Some(order) => (graded(order), 1.3 * style::CASE_LINE, false),
            None => (
                (0..labels.len())
                    .map(|i| look.stroke(i % per_part, labels.len()))
                    .collect(),
                style::CASE_LINE,
                true,
            ),
        };
        let marker = |index: usize| look.marker(index % per_part).filter(|_| marked);
        let groups_are_one = self.panels.is_none() && parts == 1;
        let curves = |metric: usize, group: &[usize]| -> Vec<Series> {
            let curve = |(index, label): (usize, &String)| {
                let members = group.iter().filter(|i| indices[**i] == index);
                let mut points: Vec<[f64; 2]> = members
                    .filter_map(|i| {
                        let value = cases[*i].metric(metric);
                        Some([at(&cases[*i])?, value.unwrap_or(f64::NAN)])
                    })
                    .collect();
                points.sort_by(|a, b| a[0].total_cmp(&b[0]));
                Series {
                    label: label.clone(),
                    marked: (0..points.len()).collect(),
                    points,
                    stroke: strokes[index],
                    width,
                    marker: marker(index),
                }
            };
            let curves = labels.iter().enumerate().map(curve);
            curves
                .filter(|curve| groups_are_one || !curve.points.is_empty())
                .collect()
        };
        // The exact values under the curves.
        let exact = |metric: usize, group: &[usize]| {
            let row = reference::row(&study.measures, &study.columns, metric).filter(|_| !orders);
            row.map_or(Vec::new(), |row| {
                let line_cases: Vec<DrawnCase> = group.iter().map(|i| cases[*i]).collect();
                let indices: Vec<usize> = group.iter().map(|i| indices[*i]).collect();
                reference::lines(&line_cases, &indices, &strokes, at, row)
            })
        };
        let levels = match self.panels {
            Some(row) if !cases.is_empty() => label::values(&cases, row),
            Some(_) | None => vec![None],
        };
        let groups: Vec<Vec<usize>> = match parts {
            1 => levels
                .into_iter()
                .map(|value| members(&cases, self.panels.map(|row| (row, value))))
                .collect(),
            parts => {
                let part_of = |i: usize| indices[i] / per_part;
                (0..parts)
                    .map(|part| (0..cases.len()).filter(|i| part_of(*i) == part).collect())
                    .collect()
            }
        };
        let panel = |metric: usize, group: &Vec<usize>| {
            [exact(metric, group), curves(metric, group)].concat()
        };
        let panels: Vec<Vec<Vec<Series>>> = y
            .iter()
            .map(|metric| groups.iter().map(|group| panel(*metric, group)).collect())
            .collect();
        let limits_of = |metric: usize, group: &[usize]| match self.checks {
            true => {
                let panel_cases = group.iter().map(|i| cases[*i]);
                limits_of_checks::of(&study.checks, metric, panel_cases, at)
            }
            false => Vec::new(),
        };
        let arranged = match parts {
            1 => Arrangement::of(y.len(), groups.len(), figure.width),
            _ => Arrangement::GroupsAcross,
        };
        let columns = arranged.columns(y.len(), groups.len());
        let rows = arranged.rows(y.len(), groups.len());
        let height = if rows.len() == 1 { 190.0 } else { 130.0 };
        let width_of_sheet = figure.width.unwrap_or(match columns {
            1 => 1.2 * style::SINGLE,
            _ => style::DOUBLE,
        });
        let [x_range, y_range] = figure.ranges;
        let axes: Vec<Axis> = y
            .iter()
            .zip(&panels)
            .map(|(metric, groups_of_it)| {
                let series = groups_of_it.iter().flatten();
                let mut values = limits::heights(limits::points(series), x_range);
                let limits_of_all = groups.iter().flat_map(|group| limits_of(*metric, group));
                let ends = limits_of_all.flat_map(|limits| [limits.min, limits.max]);
                values.extend(ends.flatten());
                let title = &study.title(*metric);
                limits::axis(title, values.into_iter(), y_scale, y_range, height / 24.0)
            })
            .collect();
        let heights = vec![height; rows.len()];
        let grids = match arranged {
            Arrangement::QuantitiesAcross => layout::columns(width_of_sheet, &heights, &axes),
            Arrangement::Stack | Arrangement::GroupsAcross => {
                vec![layout::grid(width_of_sheet, columns, &heights, &axes, 4.0)]
            }
        };
        let values: Vec<f64> = cases.iter().filter_map(at).collect();
        let title = parameter.title();
        let in_pi = |v: &f64| number::of_pi(*v).is_some();
        let (low, high) = values
            .iter()
            .fold((0.0, 0.0), |(a, b): (f64, f64), v| (a.min(*v), b.max(*v)));
        let most = grids.first().map_or(1.0, |grid| grid.width / 40.0);
        let across = if low < high && x_scale == Scale::Linear && values.iter().all(in_pi) {
            let range = x_range.unwrap_or([1.05 * low, 1.05 * high]);
            ticks::in_pi(&title, range, most)
        } else {
            limits::axis(&title, values.into_iter(), x_scale, x_range, most)
        };

        let mut sheet = Sheet {
            width: width_of_sheet,
            ..Sheet::default()
        };
        let several = y.len() * groups.len() > 1;
        let mut limited = false;
        for (r, row) in rows.iter().enumerate() {
            for (column, cell) in row.iter().enumerate() {
                let (grid, frame) = match grids.get(column) {
                    Some(grid) if grids.len() > 1 => (grid, grid.frames[r][0]),
                    _ => (&grids[0], grids[0].frames[r][column]),
                };
                let x = across.clone().labelled(r + 1 == rows.len());
                let y_axis = axes[cell.quantity]
                    .clone()
                    .labelled(column == 0 || grids.len() > 1);
                let mut panel = Panel::new(frame, grid.margin, x, y_axis);
                panel.zero =
                    y_scale == Scale::Linear && panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
                panel.series = panels[cell.quantity][cell.group].clone();
                for limits in limits_of(y[cell.quantity], &groups[cell.group]) {
                    limits.draw(&mut panel);
                    limited = true;
                }
                if let (0, Some(first)) = (cell.quantity, groups[cell.group].first()) {
                    panel.caption =
                        label::caption(table, &cases, &bound, &cases[*first].case(), frame.width);
                }
                if orders {
                    order_lines(&mut panel);
                }
                if orders && several {
                    slope::write(&mut panel);
                }
                sheet.panels.push(panel);
            }
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, labels.len(), label_count);
        // The legend of a single panel gives the orders; in several panels they are at the curves.
        if let (true, [panel]) = (orders, &sheet.panels[..]) {
            for (label, series) in labels.iter_mut().zip(&panel.series) {
                if let Some(stretch) = slope::straight(&series.points) {
                    let slope = format!("{:.2}", stretch.slope).replace('-', "−");
                    *label = format!("{label}: slope {slope}");
                }
            }
        }
        let order = order.unwrap_or_else(|| (0..labels.len()).collect());
        let keys = order.into_iter().map(|index| Key {
            label: labels[index].clone(),
            stroke: strokes[index],
            width,
            marker: marker(index),
        });
        let series = sheet.panels.iter().flat_map(|panel| &panel.series);
        let exact = |label: &str| {
            let mut named = series.clone().filter(|series| series.label == label);
            named.next().map(Key::of)
        };
        let exact = exact(reference::SEVERAL).or_else(|| exact(reference::LABEL));
        // A single curve needs no legend.
        let mut keys: Vec<Key> = match labels.len() > 1 || exact.is_some() || limited {
            true => exact.into_iter().chain(keys).collect(),
            false => Vec::new(),
        };
        if orders {
            keys.push(Key {
                label: ORDERS.into(),
                stroke: Stroke::Dotted,
                width: style::EXACT_LINE,
                marker: None,
            });
        }
        if limited {
            keys.push(limits_of_checks::key());
        }
        // The first legend has what is no curve, too.
        let mut legends = vec![Vec::new(); parts];
        for key in keys {
            let index = labels.iter().position(|label| *label == key.label);
            legends[index.map_or(0, |index| index / per_part)].push(key);
        }
        layout::finish(&mut sheet, legends, figure.title.as_deref());
        sheet
    }
}
