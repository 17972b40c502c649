//! What metric and convergence figures share: metrics over a parameter, one panel for each
//! metric, one curve for each set of values of the other parameters that vary.

mod orders;
mod reference;

use crate::figures::label;
use crate::figures::{DrawnCase, FigureData};
use orders::{ORDERS, order_lines};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::guides;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::slope;
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_drawing::text::number;
use slipgap_study::Scale;

/// Metrics over a parameter.
pub struct Curves<'a> {
    /// Parameter along the horizontal axis.
    pub x: usize,
    /// Rows of the study's measures.
    pub y: &'a [usize],
    /// Parameter with one line style for each value; `None`: all others that vary.
    pub by: Option<usize>,
    /// Scales of the axes.
    pub scales: [Scale; 2],
    /// Whether it shows the observed orders, instead of exact values.
    pub orders: bool,
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
        } = *self;
        let parameter = &study.problem.parameters()[x];
        let at = |shown: &DrawnCase| shown.number(x);
        let cases: Vec<DrawnCase> = cases.iter().copied().filter(|c| at(c).is_some()).collect();
        let along = label::along(study, &cases, x);
        let table = study.problem.parameters();
        let labels = label::labels(table, &cases, by, &along);
        let (indices, mut labels) = label::numbered(&labels);
        let named = label::named(table, &cases, by, &along);
        let all = labels.len();
        labels.truncate(style::MOST_STYLES);
        let order = order(&named, &cases, &indices, labels.len());
        let (strokes, width, marked) = match &order {
            Some(order) => (graded(order), 1.3 * style::CASE_LINE, false),
            None => (
                (0..labels.len()).map(Stroke::of_case).collect(),
                style::CASE_LINE,
                true,
            ),
        };
        let marker = |index| marked.then_some(Marker::of_case(index));
        let curves = |metric: usize| -> Vec<Series> {
            let curve = |(index, label): (usize, &String)| {
                let mut points: Vec<[f64; 2]> = cases
                    .iter()
                    .zip(&indices)
                    .filter(|(_, its)| **its == index)
                    .filter_map(|(shown, _)| {
                        let value = shown.metric(metric);
                        Some([at(shown)?, value.unwrap_or(f64::NAN)])
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
            labels.iter().enumerate().map(curve).collect()
        };
        // The exact values under the curves.
        let exact = |metric: usize| {
            let row = reference::row(&study.measures, &study.columns, metric).filter(|_| !orders);
            row.map_or(Vec::new(), |row| {
                reference::lines(&cases, &indices, &strokes, at, row)
            })
        };
        let panel = |metric: &usize| [exact(*metric), curves(*metric)].concat();
        let panels: Vec<Vec<Series>> = y.iter().map(panel).collect();
        let height = if y.len() == 1 { 190.0 } else { 130.0 };
        let width_of_sheet = figure.width.unwrap_or(1.2 * style::SINGLE);
        let [x_range, y_range] = figure.ranges;
        let axes: Vec<Axis> = y
            .iter()
            .zip(&panels)
            .map(|(metric, series)| {
                let values = limits::heights(limits::points(series.iter()), x_range);
                let title = &study.measures[*metric].symbol;
                limits::axis(title, values.into_iter(), y_scale, y_range, height / 24.0)
            })
            .collect();
        let grid = layout::grid(width_of_sheet, 1, &vec![height; y.len()], &axes, 4.0);
        let values: Vec<f64> = cases.iter().filter_map(at).collect();
        let title = parameter.title();
        let in_pi = |v: &f64| number::of_pi(*v).is_some();
        let (low, high) = values
            .iter()
            .fold((0.0, 0.0), |(a, b): (f64, f64), v| (a.min(*v), b.max(*v)));
        let across = if low < high && x_scale == Scale::Linear && values.iter().all(in_pi) {
            let range = x_range.unwrap_or([1.05 * low, 1.05 * high]);
            ticks::in_pi(&title, range, grid.width / 40.0)
        } else {
            let values = values.into_iter();
            limits::axis(&title, values, x_scale, x_range, grid.width / 40.0)
        };

        let mut sheet = Sheet {
            width: width_of_sheet,
            ..Sheet::default()
        };
        let count = axes.len();
        for (i, (series, y)) in panels.into_iter().zip(axes).enumerate() {
            let mut x = across.clone();
            if i + 1 < grid.frames.len() {
                x.title.clear();
                x.numbered = false;
            }
            let mut panel = Panel::new(grid.frames[i][0], grid.margin, x, y);
            panel.zero =
                y_scale == Scale::Linear && panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
            panel.series = series;
            if orders {
                order_lines(&mut panel);
            }
            if orders && count > 1 {
                slope::write(&mut panel);
            }
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, labels.len(), all);
        // The legend of a single panel gives the orders; in several panels they are at the curves.
        if let (true, [panel]) = (orders, &sheet.panels[..]) {
            for (label, series) in labels.iter_mut().zip(&panel.series) {
                if let Some(stretch) = slope::straight(&series.points) {
                    let slope = format!("{:.2}", stretch.slope).replace('-', "−");
                    *label = format!("{label}: {slope}");
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
        let mut keys: Vec<Key> = match labels.len() > 1 || exact.is_some() {
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
        keys.extend(guides::key(&sheet.panels, None));
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        sheet
    }
}

/// The indices of the labels by rising number, if one numeric parameter distinguishes more curves than there are markers.
fn order(
    named: &[usize],
    cases: &[DrawnCase],
    indices: &[usize],
    count: usize,
) -> Option<Vec<usize>> {
    let [row] = *named else {
        return None;
    };
    if count <= Marker::KINDS {
        return None;
    }
    let number = |index: usize| {
        let first = indices.iter().position(|its| *its == index)?;
        cases[first].number(row)
    };
    let numbers: Vec<f64> = (0..count).map(number).collect::<Option<_>>()?;
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| numbers[*a].total_cmp(&numbers[*b]));
    Some(order)
}

/// The stroke of each curve by its place in the order.
fn graded(order: &[usize]) -> Vec<Stroke> {
    let mut strokes = vec![Stroke::Solid; order.len()];
    for (place, index) in order.iter().enumerate() {
        strokes[*index] = Stroke::graded(place, order.len());
    }
    strokes
}
