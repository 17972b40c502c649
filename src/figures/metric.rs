//! Metrics against a parameter, or errors against the step: one panel a metric, one curve for each value of what else
//! varies.

use super::Shown;
use super::guides;
use super::label;
use super::layout;
use super::legend::Key;
use super::limits;
use super::number;
use super::reference;
use super::sheet::{Anchor, Axis, Panel, Series, Sheet, Words};
use super::slope;
use super::style::{self, Marker, Stroke};
use super::text;
use super::ticks;
use crate::study::{Figure, FigureKind, Scale, Study};

/// The sheet of a `metric` or `convergence` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let (x, y, by, x_scale, y_scale, orders) = match &figure.kind {
        FigureKind::Metric {
            x,
            y,
            by,
            x_scale,
            y_scale,
        } => (x, y, by, x_scale, y_scale, false),
        FigureKind::Convergence { x, y, by } => (x, y, by, &Scale::Log, &Scale::Log, true),
        _ => return Sheet::default(),
    };
    let parameter = &study.problem.parameters()[*x];
    let at = |shown: &Shown| shown.case.values[*x].and_then(|value| value.as_f64());
    let cases: Vec<Shown> = cases.iter().copied().filter(|c| at(c).is_some()).collect();
    let along = label::along(study, &cases, *x);
    let table = study.problem.parameters();
    let labels = label::labels(table, &cases, *by, &along);
    let (looks, mut labels) = label::numbered(&labels);
    let named = label::named(table, &cases, *by, &along);
    let all = labels.len();
    labels.truncate(style::MOST_LOOKS);
    let order = order(&named, &cases, &looks, labels.len());
    let (strokes, width, marked) = match &order {
        Some(order) => (graded(order), 1.3 * style::CASE_LINE, false),
        None => (
            (0..labels.len()).map(Stroke::of_case).collect(),
            style::CASE_LINE,
            true,
        ),
    };
    let marker = |look| marked.then_some(Marker::of_case(look));
    let curves = |metric: usize| -> Vec<Series> {
        let curve = |(look, label): (usize, &String)| {
            let mut points: Vec<[f64; 2]> = cases
                .iter()
                .zip(&looks)
                .filter(|(_, its)| **its == look)
                .filter_map(|(shown, _)| {
                    let value = shown.metrics.get(metric).copied().flatten();
                    Some([at(shown)?, value.unwrap_or(f64::NAN)])
                })
                .collect();
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            Series {
                label: label.clone(),
                marked: (0..points.len()).collect(),
                points,
                stroke: strokes[look],
                width,
                marker: marker(look),
            }
        };
        labels.iter().enumerate().map(curve).collect()
    };
    // The exact values below them.
    let exact = |metric: usize| {
        let row = reference::row(&study.measures, &study.columns, metric).filter(|_| !orders);
        row.map_or(Vec::new(), |row| {
            reference::lines(&cases, &looks, &strokes, at, row)
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
            limits::axis(title, values.into_iter(), *y_scale, y_range, height / 24.0)
        })
        .collect();
    let grid = layout::grid(width_of_sheet, 1, &vec![height; y.len()], &axes, 4.0);
    let values: Vec<f64> = cases.iter().filter_map(at).collect();
    let title = parameter.symbol.to_string();
    let in_pi = |v: &f64| number::of_pi(*v).is_some();
    let (low, high) = values
        .iter()
        .fold((0.0, 0.0), |(a, b): (f64, f64), v| (a.min(*v), b.max(*v)));
    let across = if low < high && *x_scale == Scale::Linear && values.iter().all(in_pi) {
        let range = x_range.unwrap_or([1.05 * low, 1.05 * high]);
        ticks::in_pi(&title, range, grid.width / 40.0)
    } else {
        let values = values.into_iter();
        limits::axis(&title, values, *x_scale, x_range, grid.width / 40.0)
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
        panel.zero = *y_scale == Scale::Linear && panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
        panel.series = series;
        if orders {
            order_lines(&mut panel);
        }
        if orders && count > 1 {
            slope::write(&mut panel);
        }
        sheet.panels.push(panel);
    }
    layout::letters(&mut sheet.panels);
    layout::left_out(&mut sheet, labels.len(), all);
    // In a panel alone the legend says the orders; in several they stand at the curves.
    if let (true, [panel]) = (orders, &sheet.panels[..]) {
        for (label, series) in labels.iter_mut().zip(&panel.series) {
            if let Some(stretch) = slope::straight(&series.points) {
                *label = format!("{label}: {:.2}", stretch.slope).replace('-', "−");
            }
        }
    }
    let order = order.unwrap_or_else(|| (0..labels.len()).collect());
    let keys = order.into_iter().map(|look| Key {
        label: labels[look].clone(),
        stroke: strokes[look],
        width,
        marker: marker(look),
    });
    let series = sheet.panels.iter().flat_map(|panel| &panel.series);
    let exact = |label: &str| {
        let mut named = series.clone().filter(|series| series.label == label);
        named.next().map(Key::of)
    };
    let exact = exact(reference::SEVERAL).or_else(|| exact(reference::LABEL));
    // A curve alone needs no name.
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

/// The looks by rising number, where one numeric parameter tells more curves apart than there are markers.
fn order(named: &[usize], cases: &[Shown], looks: &[usize], count: usize) -> Option<Vec<usize>> {
    let [row] = *named else {
        return None;
    };
    if count <= Marker::KINDS {
        return None;
    }
    let number = |look: usize| {
        let first = looks.iter().position(|its| *its == look)?;
        cases[first].case.values[row]?.as_f64()
    };
    let numbers: Vec<f64> = (0..count).map(number).collect::<Option<_>>()?;
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| numbers[*a].total_cmp(&numbers[*b]));
    Some(order)
}

/// The stroke of each look by its place in the order.
fn graded(order: &[usize]) -> Vec<Stroke> {
    let mut strokes = vec![Stroke::Solid; order.len()];
    for (place, look) in order.iter().enumerate() {
        strokes[*look] = Stroke::graded(place, order.len());
    }
    strokes
}

/// What the legend calls the lines of order 1 and 2.
const ORDERS: &str = "orders 1 and 2";

/// Thin lines of order 1 and 2 from the lower left corner, to compare with.
fn order_lines(panel: &mut Panel) {
    let [[left, right], [bottom, top]] = [panel.x.range, panel.y.range];
    for order in [1, 2] {
        let end = bottom * libm::pow(right / left, f64::from(order));
        let mut line = Series::rule([[left, bottom], [right, end]]);
        line.stroke = Stroke::Dotted;
        line.width = style::EXACT_LINE;
        panel.series.push(line);
        // Its name a little before the line leaves the frame.
        let reach = (top / bottom).min(end / bottom);
        let at = |part: f64| {
            let y = bottom * libm::pow(reach, part);
            [left * libm::pow(y / bottom, 1.0 / f64::from(order)), y]
        };
        let text = order.to_string();
        let edge = panel.frame.right() - style::MAJOR_TICK - text::width(&text, style::LABEL) - 4.0;
        let parts = (0..20).map(|i| panel.place(at(0.93 - 0.03 * f64::from(i))));
        if let Some([x, y]) = parts.into_iter().find(|[x, _]| *x <= edge) {
            panel.notes.push(Words {
                at: [x + 4.0, y + style::LABEL],
                anchor: Anchor::Start,
                text,
                size: style::LABEL,
            });
        }
    }
}
